/**
 * Many fires, and one with many particles: memory that they leave, the cost of fires out of
 * sight, and the load of the page's thread.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser, THREAD, THREADS, eventually, except } from '../driver.mjs';
import { held } from '../held.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** Inserts so many fires in groups, waits until each group burns, and removes it. */
function comeAndGo(tab, count) {
  return tab.evaluate(async (wanted) => {
    const group = 20;
    for (let done = 0; done < wanted; done += group) {
      const fires = Array.from({ length: group }, () => document.createElement('hearth-fire'));
      document.body.append(...fires);
      // Some are removed before they burn.
      if (done % (5 * group) !== 0) await Promise.all(fires.map((fire) => /** @type {any} */ (fire).ready));
      for (const fire of fires) fire.remove();
    }
  }, count);
}

for (const engine of THREADS) {
  test(`hundreds of fires that come and go leave nothing behind, with the engine in: ${engine}`, async () => {
    const tab = await browser.open(`
      <script type="module">
        import { HearthFire } from '/web/hearth-fire.js';
        HearthFire.engine = '${engine}';
      </script>
      <style>hearth-fire { width: 40px; height: 40px; float: left }</style>
      <hearth-fire></hearth-fire>`);
    await tab.burnt(0.2);
    await tab.fire((fire) => fire.pause());
    // V8 keeps what it compiles during the first ones.
    await comeAndGo(tab, 1000);
    const first = await held(tab);
    const memory = [first.memory];
    for (let round = 0; round < 3; round += 1) {
      await comeAndGo(tab, 200);
      memory.push((await tab.living()).memory);
    }
    // A removed fire is kept for half a second, in case it only moves.
    const counts = /** @type {const} */ (['objects', 'nodes', 'jsEventListeners']);
    const last = await eventually(
      `no more is held than ${JSON.stringify(first)}`,
      () => held(tab),
      (now) => counts.every((what) => now[what] <= first[what]),
    );
    assert.deepEqual([last.contexts, last.workers], [1, engine === 'worker' ? 1 : 0]);
    const more = last.bytes / first.bytes - 1;
    assert.ok(more < 0.05, `${(100 * more).toFixed(1)} % more than ${first.bytes} bytes are held`);
    // Memory of wasm never shrinks, and grows with the most fires at one time, which are more on a busy machine. What
    // is left behind grows in every round: a fire has a megabyte.
    const growth = memory.slice(1).map((bytes, round) => bytes - memory[round]);
    assert.ok(Math.min(...growth) < 8e6, `wasm holds ${growth.join(', ')} bytes more after each 200 fires`);
    assert.deepEqual(tab.problems, []);
  });
}

test('of thirty fires, those out of sight cost nothing', async () => {
  const tab = await browser.show(`
    <style>hearth-fire { width: 160px; height: 150px; float: left }</style>
    ${'<hearth-fire></hearth-fire>'.repeat(30)}`);
  const times = () =>
    tab.evaluate(() =>
      [...document.querySelectorAll('hearth-fire')].map((fire) => /** @type {any} */ (fire).stats?.time ?? 0),
    );
  await tab.until('the twelve in sight burn', () =>
    [...document.querySelectorAll('hearth-fire')]
      .slice(0, 12)
      .every((fire) => /** @type {any} */ (fire).stats?.time > 0.3),
  );
  await tab.evaluate(() => {
    const pictures = new Map();
    /** @type {any} */ (window).pictures = pictures;
    const original = ImageBitmapRenderingContext.prototype.transferFromImageBitmap;
    ImageBitmapRenderingContext.prototype.transferFromImageBitmap = function counted(...args) {
      pictures.set(this.canvas, (pictures.get(this.canvas) ?? 0) + 1);
      return original.apply(this, args);
    };
  });
  const before = await times();
  await tab.burnt(before[0] + 0.5);
  const passed = (await times()).map((time, at) => time - before[at]);
  assert.ok(
    passed.slice(0, 12).every((time) => time > 0),
    `${passed.slice(0, 12)}`,
  );
  assert.deepEqual(passed.slice(12), Array(18).fill(0));
  assert.deepEqual(tab.problems, []);
  // An engine of the page's thread transfers no picture.
  if (THREAD === 'main') return;
  const shown = await tab.evaluate(() => {
    const { pictures } = /** @type {any} */ (window);
    return [...document.querySelectorAll('hearth-fire')].map(
      (fire) => pictures.get(fire.shadowRoot?.querySelector('canvas')) ?? 0,
    );
  });
  assert.ok(
    shown.slice(0, 12).every((pictures) => pictures > 0),
    `${shown.slice(0, 12)}`,
  );
  assert.deepEqual(shown.slice(12), Array(18).fill(0));
});

test(
  'the page’s thread hardly works while ten thousand particles burn',
  except({ webkit: 'its engine runs there' }),
  async () => {
    const tab = await browser.show('<hearth-fire edges="periodic" particles="10000"></hearth-fire>');
    await tab.burnt(0.3);
    const { engine, particles } = await tab.fire((fire) => fire.stats);
    assert.equal(engine, 'worker');
    assert.ok(particles > 9000, `${particles} particles burn`);
    // CPU time, which other programs do not lengthen.
    const session = await tab.page.createCDPSession();
    await session.send('Performance.enable');
    const worked = async () => {
      const { metrics } = await session.send('Performance.getMetrics');
      return 1000 * metrics.find(({ name }) => name === 'ThreadTime').value;
    };
    const start = await worked();
    const pictures = 40;
    await tab.evaluate(
      (wanted) =>
        new Promise((resolve) => {
          const { prototype } = ImageBitmapRenderingContext;
          const original = prototype.transferFromImageBitmap;
          let count = 0;
          prototype.transferFromImageBitmap = function counted(bitmap) {
            original.call(this, bitmap);
            count += 1;
            if (count < wanted) return;
            prototype.transferFromImageBitmap = original;
            resolve(undefined);
          };
        }),
      pictures,
    );
    const pageMs = ((await worked()) - start) / pictures;
    const { drawMs, stepMs, stepsPerFrame } = await tab.fire((fire) => fire.stats);
    const engineMs = drawMs + stepMs * stepsPerFrame;
    assert.ok(pageMs < 0.5 * engineMs, `the page works ${pageMs} ms for a picture, the engine ${engineMs} ms`);
    assert.deepEqual(tab.problems, []);
  },
);
