/**
 * Interruptions: a fire is removed while it loads, its context is lost within a frame, its
 * engine ends, its document changes. It recovers or reports an error.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser, except } from '../driver.mjs';
import { assertBurns, events, recording } from '../assertions.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

const FIRE = '<hearth-fire id="fire"></hearth-fire>';

const uncaught = (tab) => tab.problems.filter((problem) => problem.startsWith('uncaught'));

/** Waits until the fire reports that its context is back, and asserts that it reports nothing worse. */
async function assertComesBack(tab) {
  await tab.until('the context is back', () => /** @type {any} */ (window).back > 0);
  const kinds = (await events(tab, 'error')).map(({ kind }) => kind);
  assert.ok(kinds.length > 0 && kinds.every((kind) => kind === 'context-lost'), `${kinds}`);
  const time = await tab.fire((fire) => fire.stats.time);
  await tab.burnt(time + 0.5);
  await assertBurns(tab);
  assert.deepEqual(uncaught(tab), []);
}

const BACK = `<script>
  window.back = 0;
  document.querySelector('hearth-fire').addEventListener('restored', () => (window.back += 1));
</script>`;

/** Loses the context between drawing and taking the picture away, once. */
function loseWithinFrame() {
  const { prototype } = OffscreenCanvas;
  const original = prototype.transferToImageBitmap;
  let frames = 0;
  prototype.transferToImageBitmap = function transferToImageBitmap() {
    frames += 1;
    if (frames === 20) {
      const extension = /** @type {any} */ (this.getContext('webgl2')).getExtension('WEBGL_lose_context');
      extension.loseContext();
      setTimeout(() => extension.restoreContext(), 200);
    }
    return original.call(this);
  };
}

const WITHIN_FRAME = except({ webkit: 'a fire draws on a canvas of the page, which transfers no picture' });

test('a context lost within a frame of the worker is restored with its fire', WITHIN_FRAME, async () => {
  const tab = await browser.open(recording(FIRE) + BACK, { beforeWorker: loseWithinFrame });
  await assertComesBack(tab);
});

test('a context lost within a frame of the main thread is restored with its fire', WITHIN_FRAME, async () => {
  const tab = await browser.open(
    `${recording(FIRE)}${BACK}<script type="module">
      import { HearthFire } from '/web/hearth-fire.js';
      HearthFire.engine = 'main';
    </script>`,
    { before: loseWithinFrame },
  );
  await assertComesBack(tab);
});

test('a context that is lost again during its restoration is restored in the end', async () => {
  const tab = await browser.open(recording(FIRE) + BACK, {
    beforeWorker: () => {
      const { prototype } = WebGL2RenderingContext;
      const original = prototype.linkProgram;
      let restored = false;
      let again = false;
      addEventListener('message', ({ data }) => {
        if (data[2] === 'reset') restored = true;
      });
      prototype.linkProgram = function linkProgram(program) {
        if (restored && !again) {
          again = true;
          const extension = /** @type {any} */ (this.getExtension('WEBGL_lose_context'));
          extension.loseContext();
          setTimeout(() => extension.restoreContext(), 300);
        }
        return original.call(this, program);
      };
    },
  });
  await tab.burnt(0.3);
  // From now on the hook waits for the next start of the passes.
  await tab.fire((fire) => fire.reset());
  await tab.loseContext(200);
  await assertComesBack(tab);
});

test('while the context is lost, `toBlob` rejects with the reason; then it works again', async () => {
  const tab = await browser.show(recording(FIRE));
  await tab.burnt(0.2);
  await tab.fire((fire) => {
    fire.lost = new Promise((resolve) => fire.addEventListener('error', resolve, { once: true }));
    fire.back = new Promise((resolve) => fire.addEventListener('restored', resolve, { once: true }));
  });
  await tab.loseContext(2000);
  const [message, size] = await tab.fire(async (fire) => {
    await fire.lost;
    const message = await fire.toBlob().then(String, (error) => error.message);
    await fire.back;
    return [message, (await fire.toBlob()).size];
  });
  assert.match(message, /graphics context is lost/);
  assert.ok(size > 100, `${size} bytes`);
});

test('an unused engine ends, even if its fire never started', async () => {
  const tab = await browser.show('<p>Nothing yet</p>');
  const living = await tab.evaluate(async () => {
    const { driver } = /** @type {any} */ (window);
    const fire = document.createElement('hearth-fire');
    document.body.append(fire);
    while (driver.workers() === 0) await new Promise((resolve) => setTimeout(resolve, 1));
    fire.remove();
    return driver.workers();
  });
  assert.equal(living, 1);
  await tab.until('the worker is gone', () => /** @type {any} */ (window).driver.workers() === 0);
});

test('an engine that ends while a fire waits for its file is followed by another', async () => {
  const tab = await browser.open('<hearth-fire id="first"></hearth-fire>', {
    files: { 'slow.json': { body: '{"values": {"exposure": 0.5}}', type: 'application/json' } },
    before: () => {
      const original = window.fetch;
      window.fetch = async (input, ...rest) => {
        const { driver } = /** @type {any} */ (window);
        while (String(input).endsWith('slow.json') && driver.workers() > 0) await new Promise(requestAnimationFrame);
        return original(input, ...rest);
      };
      // The life of an engine without fires is longer than a fire waits for its file.
      const { setTimeout } = window;
      window.setTimeout = /** @type {any} */ (
        (act, time, ...rest) => {
          const ends = time === 5000 && /** @type {any} */ (window).ends;
          return setTimeout(act, ends ? 0 : time, ...rest);
        }
      );
    },
  });
  await tab.burnt(0.2);
  const exposure = await tab.evaluate(async () => {
    const page = /** @type {any} */ (window);
    page.ends = true;
    const first = /** @type {any} */ (document.querySelector('#first'));
    const fire = /** @type {any} */ (document.createElement('hearth-fire'));
    fire.src = '/slow.json';
    document.body.append(fire);
    await first.destroy();
    first.remove();
    page.ends = false;
    await fire.ready;
    return fire.params.exposure;
  });
  assert.equal(exposure, 0.5);
  await tab.burnt(0.2);
});

test('a preset counts for a fire that is taken off and put back while it loads', async () => {
  const tab = await browser.show('<p>Nothing yet</p>');
  const seen = await tab.evaluate(async () => {
    const fire = /** @type {any} */ (document.createElement('hearth-fire'));
    fire.setAttribute('preset', 'seed');
    fire.paused = true;
    for (let round = 0; round < 30; round += 1) {
      document.body.append(fire);
      await new Promise((resolve) => setTimeout(resolve, 4 * round));
      if (round < 29) fire.remove();
      await new Promise((resolve) => setTimeout(resolve, 2));
    }
    await fire.ready;
    return { model: fire.params.model, ...(await fire.exportConfig()) };
  });
  assert.deepEqual(seen, { model: 'classic', hearth: 3, preset: 'seed', values: {} });
});

test('with reduced motion a fire is paused again when it is inserted again, and a playing one can be paused', async () => {
  const tab = await browser.open(FIRE, { reducedMotion: true });
  await tab.ready();
  await tab.frames(10);
  const button = () =>
    tab.fire((fire) => {
      const found = fire.shadowRoot.querySelector('button');
      const { x, y, width, height } = found.getBoundingClientRect();
      return found.hidden ? null : { label: found.ariaLabel, x: x + width / 2, y: y + height / 2 };
    });
  assert.match((await button()).label, /play/i);
  assert.equal(await tab.fire((fire) => fire.hasAttribute('paused')), false, 'the page has not paused it');
  await tab.fire(async (fire) => {
    fire.remove();
    for (let left = 5; left > 0; left -= 1) await new Promise(requestAnimationFrame);
    document.body.append(fire);
    await fire.ready;
  });
  await tab.frames(10);
  assert.match((await button()).label, /play/i);
  assert.ok((await tab.firePicture()).crop(0.3, 0.4, 0.7, 1).glowing() > 0.02, 'the still shows a fire');
  await tab.click(await button());
  await assertBurns(tab);
  const pause = await button();
  assert.match(pause.label, /pause/i);
  await tab.click(pause);
  await tab.until('it stands still', () => /** @type {any} */ (document.querySelector('hearth-fire')).paused);
  await tab.frames(10);
  const still = await tab.firePicture();
  await tab.frames(10);
  assert.equal(still.difference(await tab.firePicture()), 0);
  assert.match((await button()).label, /play/i);
});

test('a fire that moves to another document keeps its styles and burns', async () => {
  const tab = await browser.show(`${FIRE}<iframe style="width: 240px; height: 240px; border: 0"></iframe>`);
  await tab.burnt(0.3);
  const looks = await tab.evaluate(async () => {
    const fire = /** @type {any} */ (document.querySelector('#fire'));
    const inside = /** @type {any} */ (document.querySelector('iframe')?.contentDocument);
    inside.body.append(fire);
    await fire.ready;
    const canvas = fire.shadowRoot.querySelector('canvas');
    const { getComputedStyle } = inside.defaultView;
    while (!(fire.stats?.time > 0.3)) await new Promise((resolve) => setTimeout(resolve, 50));
    return [getComputedStyle(fire).display, getComputedStyle(canvas).position];
  });
  assert.deepEqual(looks, ['block', 'absolute']);
  assert.deepEqual(uncaught(tab), []);
});

test('a failed fire tries again when it is inserted again', async () => {
  const tab = await browser.open(FIRE, {
    before: () => {
      const original = window.fetch;
      let refused = 0;
      window.fetch = async (...request) => {
        refused += 1;
        if (refused === 1) throw new TypeError('no network');
        return original(...request);
      };
    },
  });
  const kind = await tab.fire((fire) =>
    fire.ready.then(
      () => '',
      (error) => error.kind,
    ),
  );
  assert.equal(kind, 'load');
  await tab.fire((fire) => {
    fire.remove();
    document.body.append(fire);
  });
  await tab.burnt(0.3);
  await assertBurns(tab);
});

test('no pointer event causes an error', async () => {
  const tab = await browser.show(recording('<hearth-fire interactive></hearth-fire>'));
  await tab.burnt(0.2);
  await tab.fire((fire) => {
    for (let at = 0; at < 40; at += 1) {
      const position = { clientX: at % 2 ? 1e6 : -1e6, clientY: 10 * at, pointerId: 1 };
      fire.dispatchEvent(new PointerEvent('pointermove', position));
    }
  });
  await tab.burnt(0.5);
  assert.deepEqual(await events(tab, 'error'), []);
});

test('a lazy fire that becomes eager loads', async () => {
  const tab = await browser.show('<div style="height: 3000px"></div><hearth-fire loading="lazy"></hearth-fire>');
  await tab.frames(10);
  await tab.fire((fire) => {
    fire.loading = 'eager';
    return fire.ready;
  });
});

test('a rejected preset is not reported as the current one', async () => {
  const tab = await browser.show('<hearth-fire paused preset="seed"></hearth-fire>');
  await tab.ready();
  await tab.fire((fire) => {
    fire.preset = 'sead';
    return fire.step(1);
  });
  assert.equal(await tab.fire((fire) => fire.preset), 'seed');
});
