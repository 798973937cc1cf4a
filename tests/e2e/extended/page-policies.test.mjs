/**
 * Page policies: where the engine runs, when it loads, posters, drawing limits, touch
 * actions, copies of the picture, and removal.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser, THREADS } from '../driver.mjs';
import { assertBurns, assertStands } from '../assertions.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** A page that states where its fires run. */
const at = (/** @type {string} */ thread, /** @type {string} */ body) => `${body}<script type="module">
  import { HearthFire } from '/web/hearth-fire.js';
  HearthFire.engine = '${thread}';
</script>`;

/** Whether the engine's files were asked for. */
const loaded = (tab) =>
  tab.evaluate(() =>
    performance.getEntriesByType('resource').some(({ name }) => name.endsWith('hearth-engine_bg.wasm')),
  );

for (const thread of THREADS) {
  test(`with the engine in: ${thread}, a fire burns, pauses, survives a lost context and is destroyed`, async () => {
    const tab = await browser.open(at(thread, '<hearth-fire></hearth-fire>'), { draws: true });
    await tab.burnt(1);
    assert.equal(await tab.fire((fire) => fire.stats.engine), thread);
    const { contexts, workers } = await tab.living();
    assert.deepEqual({ contexts, workers }, { contexts: 1, workers: thread === 'worker' ? 1 : 0 });
    await assertBurns(tab);
    await tab.fire((fire) => fire.pause());
    await assertStands(tab);
    assert.equal((await tab.firePicture()).difference(await tab.firePicture()), 0);
    await tab.loseContext(200);
    await tab.fire((fire) => fire.play());
    await assertBurns(tab);
    await tab.fire((fire) => fire.destroy());
    assert.equal((await tab.firePicture()).glowing(), 0, 'there is no picture left');
    await tab.until('nothing of the engine is left', async () => {
      const { driver } = /** @type {any} */ (window);
      return (await driver.contexts()) === 0 && driver.workers() === 0;
    });
    await tab.fire((fire) => document.body.append(fire));
    await tab.burnt(0.5);
    assert.deepEqual(
      tab.problems.filter((problem) => problem.startsWith('uncaught')),
      [],
    );
  });
}

test('the main thread draws where a worker cannot', async () => {
  const tab = await browser.open('<hearth-fire></hearth-fire>', {
    beforeWorker: () => {
      OffscreenCanvas.prototype.getContext = () => null;
    },
  });
  await tab.burnt(0.5);
  assert.equal(await tab.fire((fire) => fire.stats.engine), 'main');
  await assertBurns(tab);
  assert.deepEqual(tab.problems, []);
});

test('the engine draws on a canvas of the page where no offscreen canvas has WebGL2', async () => {
  const tab = await browser.open('<hearth-fire></hearth-fire>', {
    draws: true,
    before: () => {
      const original = OffscreenCanvas.prototype.getContext;
      OffscreenCanvas.prototype.getContext = function getContext(kind, ...rest) {
        return kind === 'webgl2' ? null : original.call(this, kind, ...rest);
      };
    },
    beforeWorker: () => {
      OffscreenCanvas.prototype.getContext = () => null;
    },
  });
  await tab.burnt(1);
  await assertBurns(tab);
  const blob = await tab.fire(async (fire) => (await fire.toBlob()).size);
  assert.ok(blob > 1000);
  assert.deepEqual(tab.problems, []);
});

test('an eager fire loads at once, a lazy one when it comes near the viewport', async () => {
  const far = (/** @type {string} */ loading) =>
    `<div style="height: 3000px"></div><hearth-fire loading="${loading}"></hearth-fire>`;
  const lazy = await browser.open(far('lazy'));
  await lazy.frames(20);
  assert.equal(await loaded(lazy), false, 'nothing is loaded for a fire out of sight');
  await lazy.evaluate(() => window.scrollTo(0, 3000));
  await lazy.burnt(0.2);
  const eager = await browser.show(far('eager'));
  await eager.ready();
  const auto = await browser.show(far('auto'));
  await auto.ready();
  assert.equal(await auto.fire((fire) => fire.loading), 'auto');
});

test('the poster is shown until the first picture, and while there is no picture', async () => {
  const image =
    'data:image/svg+xml,<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"><rect width="1" height="1" fill="lime"/></svg>';
  // The message and its button cover a part of it.
  const body = `<hearth-fire poster='${image}' style="width: 320px; height: 400px"></hearth-fire>`;
  const late = await browser.open(body, { draws: true, without: 'hearth-engine_bg.wasm' });
  await late.fire((fire) => fire.ready.catch(() => {}));
  const lime = (picture) => picture.share((r, g) => g > 200 && r < 100);
  assert.ok(lime(await late.firePicture()) > 0.5, 'the poster is seen');
  const good = await browser.show(body, { draws: true });
  await good.burnt(0.5);
  await good.frames(4);
  assert.equal(lime(await good.firePicture()), 0, 'the poster is gone');
});

test('`toBlob` draws another width and background for the file, and the element stays as it is', async () => {
  const tab = await browser.show('<hearth-fire preset="fireside" paused warm max-pixels="60000"></hearth-fire>', {
    draws: true,
    height: 400,
  });
  await tab.ready();
  const seen = await tab.fire(async (fire) => {
    const events = [];
    for (const type of ['params-change', 'objects-change', 'error'])
      fire.addEventListener(type, () => events.push(type));
    const values = JSON.stringify(fire.params);
    const saved = async (how) => {
      const bitmap = await createImageBitmap(await fire.toBlob(how));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = /** @type {any} */ (canvas.getContext('2d'));
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      let glow = 0;
      for (let at = 0; at < data.length; at += 4) glow += data[at] > 200 ? 1 : 0;
      return {
        size: [bitmap.width, bitmap.height],
        corner: [...data.slice(0, 4)],
        glow: glow / (bitmap.width * bitmap.height),
      };
    };
    const before = await saved();
    const [wide, cut, black] = await Promise.all([
      saved({ width: 3 * before.size[0] }),
      saved({ background: 'transparent' }),
      saved({ background: 'black', type: 'image/webp', width: 64 }),
    ]);
    const refused = await fire.toBlob({ width: 9000 }).then(
      () => '',
      (error) => `${error.name}: ${error.message}`,
    );
    const { width, height } = /** @type {any} */ (fire.shadowRoot).querySelector('canvas');
    return {
      before,
      wide,
      cut,
      black,
      refused,
      after: await saved(),
      canvas: [width, height],
      events,
      kept: JSON.stringify(fire.params) === values,
    };
  });
  const { before, wide, cut, black } = seen;
  assert.deepEqual(
    wide.size,
    before.size.map((side) => 3 * side),
  );
  assert.ok(
    Math.abs(wide.glow / before.glow - 1) < 0.2,
    `${wide.glow} of the wide picture glow, ${before.glow} of the frame`,
  );
  assert.equal(before.corner[3], 255, 'the wall is opaque');
  assert.deepEqual([cut.size, cut.corner], [before.size, [0, 0, 0, 0]]);
  assert.ok(cut.glow > 0.01, 'a transparent picture shows the fire');
  assert.deepEqual([black.size[0], black.corner[3]], [64, 255]);
  // The fire's glow may reach the corner.
  assert.ok(Math.max(...black.corner.slice(0, 3)) < 8, `${black.corner}`);
  assert.match(seen.refused, /RangeError: width 9000: .*8192/);
  assert.deepEqual(seen.after, before, 'the paused fire is shown as before');
  assert.deepEqual(seen.canvas, before.size);
  assert.ok(seen.kept, 'the values stay');
  assert.deepEqual(seen.events, []);
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});
