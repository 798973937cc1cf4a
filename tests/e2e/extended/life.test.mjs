/**
 * The life of `<hearth-fire>`, with the engine in a worker or on the page's thread.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { BROWSER, Browser, THREAD } from '../driver.mjs';
import { assertBurns, assertStands, events, recording } from '../assertions.mjs';
import { Panel, along, controlOf } from '../panel.mjs';
import { table } from '../site.mjs';
import { drag } from '../tools.mjs';
import { objectsUntil } from '../waits.mjs';

const { DEFAULTS, defaultsOf } = await table();

const FIRE = '<hearth-fire></hearth-fire>';
const BLUE = [32, 64, 128];

/** The age of a fire that plays, as it reports it next. */
function age(tab) {
  return tab.fire(
    (fire) =>
      new Promise((resolve) => {
        fire.addEventListener('stats', ({ detail }) => resolve(detail.time), { once: true });
      }),
  );
}

/** Asserts that the page has no problems. */
async function assertSilent(tab) {
  assert.deepEqual(await tab.problemsAfterFrame(), []);
}

/** Asserts that no error of a script is uncaught, whatever other problems the page has. */
async function assertCaught(tab) {
  const problems = await tab.problemsAfterFrame();
  assert.deepEqual(
    problems.filter((problem) => /uncaught|in a worker/.test(problem)),
    [],
  );
}

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

test('solids take the glyphs of a text, an image, an SVG element and a canvas', async () => {
  const disc = encodeURIComponent(
    '<svg xmlns="http://www.w3.org/2000/svg" width="50" height="50"><circle cx="25" cy="25" r="20"/></svg>',
  );
  const tab = await browser.show(`<h1 id="word">Fire</h1><img id="image" src="data:image/svg+xml,${disc}">
    <svg id="drawing" viewBox="0 0 10 10" width="50" height="50"><circle r="5"/></svg><canvas id="canvas" width="50" height="50"></canvas>
    <hearth-fire autoplay="false">${['word" of-text="', 'image', 'drawing', 'canvas'].map((id) => `<hearth-solid of="#${id}"></hearth-solid>`).join('')}</hearth-fire>
    <script>document.querySelector('#canvas').getContext('2d').fillRect(10, 10, 20, 20)</script>`);
  await tab.ready();
  await tab.until(
    'four masks',
    () =>
      /** @type {any} */ (document.querySelector('hearth-fire')).objects.filter(({ shape }) => shape === 'mask')
        .length === 4,
  );
  await assertSilent(tab);
});

test('a fire becomes ready and burns, and the page shows through around it', async () => {
  const tab = await browser.show(
    recording(`
    <style>body { background: rgb(${BLUE}) }</style>${FIRE}`),
  );
  await tab.burnt(1.5);
  await assertBurns(tab);
  const picture = await tab.firePicture();
  for (const corner of [picture.crop(0, 0, 0.15, 0.3), picture.crop(0.85, 0, 1, 0.3)]) {
    const seen = corner.share((...rgb) => rgb.every((channel, at) => Math.abs(channel - BLUE[at]) <= 2));
    assert.ok(seen > 0.97, `${seen} of an upper corner is the page`);
  }
  assert.equal((await events(tab, 'ready')).length, 1);
  assert.equal(await tab.fire((fire) => fire.stats.engine), THREAD);
  await assertSilent(tab);
});

test('attributes are live, and properties set before the element is defined are kept', async () => {
  const tab = await browser.show(`<hearth-fire id="fire" buoyancy="1.5"></hearth-fire>
    <script>fire.wind = 0.3;</script>`);
  await tab.ready();
  const values = () => tab.fire((fire) => [fire.params.wind, fire.params.buoyancy]);
  assert.deepEqual(await values(), [0.3, 1.5]);
  const becomes = (value) =>
    tab.until(
      `a buoyancy of ${value}`,
      (wanted) => /** @type {any} */ (document.querySelector('hearth-fire')).params.buoyancy === wanted,
      value,
    );
  await tab.fire((fire) => fire.setAttribute('buoyancy', '0.8'));
  await becomes(0.8);
  await tab.fire((fire) => fire.removeAttribute('buoyancy'));
  await becomes(DEFAULTS.buoyancy);
  await assertSilent(tab);
});

test('children are objects with live attributes, and `of` follows an element', async () => {
  const tab =
    await browser.show(`<i id="box" style="position: absolute; left: 40px; top: 40px; width: 50px; height: 20px"></i>
    <hearth-fire paused><hearth-source x="0.1"></hearth-source><hearth-solid x="0.2"></hearth-solid>
    <hearth-solid id="of" of="#box"></hearth-solid></hearth-fire>`);
  await tab.ready();
  await tab.fire((fire) => fire.querySelector('hearth-solid').setAttribute('x', '0.3'));
  const has = (what, holds) =>
    tab.until(
      what,
      new Function(`
    const fire = document.querySelector('hearth-fire');
    const all = [...fire.children].map(({ objectId }) => fire.objects.find(({ id }) => id === objectId));
    return all.every(Boolean) && (${holds})(all, fire);
  `),
    );
  await has(
    'the values of the attributes',
    String(([source, solid]) => source.x === 0.1 && solid.x === 0.3),
  );
  await tab.evaluate(() => document.getElementById('box')?.style.setProperty('top', '90px'));
  await has(
    'the box of the element',
    String(([, , body], fire) => {
      const box = /** @type {Element} */ (document.getElementById('box')).getBoundingClientRect();
      const outer = fire.getBoundingClientRect();
      const { x, y } = fire.toPixels(body.x, body.y);
      return Math.abs(x + outer.left - box.left - 25) < 0.1 && Math.abs(y + outer.top - box.top - 10) < 0.1;
    }),
  );
  await assertSilent(tab);
});

test('pause stops the fire, step advances it, play continues it, reset restarts it', async () => {
  const tab = await browser.show('<hearth-fire model="classic"></hearth-fire>');
  await tab.burnt(0.8);
  await tab.fire((fire) => fire.pause());
  const still = await assertStands(tab);
  const picture = await tab.firePicture();
  assert.equal(picture.difference(await tab.firePicture()), 0);
  await tab.fire((fire) => fire.step(30));
  const stepped = await assertStands(tab);
  assert.ok(Math.abs(stepped - still - 30 * defaultsOf('classic').time_step) < 1e-3, `${stepped - still} s`);
  assert.ok(picture.difference(await tab.firePicture()) > 0.1, 'the picture has moved');
  await tab.fire((fire) => fire.play());
  await tab.plays(stepped + 0.1);
  await tab.fire((fire) => fire.reset());
  await tab.until(
    'the fire has restarted',
    (before) => /** @type {any} */ (document.querySelector('hearth-fire')).stats.time < before,
    stepped,
  );
  await assertSilent(tab);
});

test('two fires burn, each at its own size', async () => {
  const tab = await browser.show(FIRE.repeat(2));
  await tab.burnt(1.2);
  await tab.fire((fire) => {
    fire.style.cssText = 'width: 120px; height: 180px';
  });
  await tab.until('a drawing of 120 × 180 pixels', () => {
    const canvas = document.querySelector('hearth-fire')?.shadowRoot?.querySelector('canvas');
    return canvas?.width === 120 && canvas?.height === 180;
  });
  await assertBurns(tab);
  const second = await tab.picture(await tab.rectangle('hearth-fire:last-of-type'));
  const glow = second.crop(0.3, 0.5, 0.7, 1).glowing();
  assert.ok(glow > 0.01, `${glow} of the second fire’s lower middle glows`);
  await assertSilent(tab);
});

test('a fire burns on when it is moved, and when it is removed and inserted again', async () => {
  const tab = await browser.show('<hearth-fire wind="0.2"></hearth-fire><section></section>');
  await tab.burnt(0.5);
  const before = await age(tab);
  await tab.fire((fire) => document.querySelector('section')?.append(fire));
  assert.ok((await age(tab)) >= before, 'a fire that is moved does not start again');
  await tab.plays(before + 0.1);
  await tab.fire(async (fire) => {
    fire.remove();
    for (let left = 5; left > 0; left -= 1) await new Promise(requestAnimationFrame);
    document.body.append(fire);
    await fire.ready;
  });
  await tab.burnt(0.7);
  await assertBurns(tab);
  assert.equal(await tab.fire((fire) => fire.params.wind), 0.2);
  await assertSilent(tab);
});

test('a fire out of sight makes no steps and burns on when it is visible again', async () => {
  const tab = await browser.show(`${FIRE}<div style="height: 3000px"></div>`);
  await tab.burnt(0.5);
  await tab.evaluate(() => window.scrollTo(0, 2000));
  const gone = await assertStands(tab);
  await tab.evaluate(() => window.scrollTo(0, 0));
  await tab.burnt(gone + 0.7);
  await assertBurns(tab);
  await assertSilent(tab);
});

test('a picture of the fire is a PNG that is transparent outside the fire', async () => {
  const tab = await browser.show(FIRE);
  await tab.burnt(1.2);
  const { type, size, clear, half, full } = await tab.fire(async (fire) => {
    const blob = await fire.toBlob('image/png');
    const bitmap = await createImageBitmap(blob);
    const { width, height } = bitmap;
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    const context = canvas.getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    const alphas = Array.from({ length: width * height }, (_, at) => data[4 * at + 3]);
    const share = (holds) => alphas.filter(holds).length / alphas.length;
    return {
      type: blob.type,
      size: [width, height],
      clear: share((alpha) => alpha === 0),
      half: share((alpha) => alpha > 8 && alpha < 248),
      full: share((alpha) => alpha > 200),
    };
  });
  assert.deepEqual([type, ...size], ['image/png', 240, 240]);
  assert.ok(clear > 0.3, `${clear} of it is clear`);
  assert.ok(half > 0.02, `${half} of it is half clear`);
  assert.ok(full > 0.005, `${full} of it is not`);
  await assertSilent(tab);
});

test('`captureStream` gives a video of the fire', async () => {
  const tab = await browser.show(FIRE);
  await tab.burnt(0.5);
  const film = await tab.fire(async (fire, plays) => {
    const stream = await fire.captureStream(20);
    const tracks = stream.getVideoTracks();
    const { width, height } = tracks[0].getSettings();
    const video = Object.assign(document.createElement('video'), { muted: true, srcObject: stream });
    if (plays) await video.play();
    tracks[0].stop();
    return [tracks.length, plays ? video.videoWidth : width, plays ? video.videoHeight : height];
    // WebKit ends by an assertion of its own, once in dozens of runs, while it plays a stream or leaves its page.
  }, BROWSER !== 'webkit');
  assert.deepEqual(film, [1, 240, 240]);
  await assertSilent(tab);
});

test('a visitor drags a slider and draws a solid, undoes and redoes both, and the address opens the same fire', async () => {
  const tab = await browser.open('index.html?scene=default&paused&quality=low', { width: 1000, height: 700 });
  await tab.ready();
  const panel = await new Panel(tab).mounted();
  const act = (/** @type {string} */ selector, /** @type {'click' | 'focus' | 'blur'} */ name) =>
    tab.evaluate(
      (selector, name) => /** @type {HTMLElement} */ (document.querySelector(selector))[name](),
      selector,
      name,
    );
  await act(controlOf('wind'), 'focus');
  const slider = await panel.standing(controlOf('wind'));
  await act(controlOf('wind'), 'blur');
  await tab.drag(along(slider, 0.5), along(slider, 0.8));
  const wind = await panel.value('wind', 'where the mouse let go', (value) => value > 1.5 && value < 2.1);

  await tab.until('the button of the tools', () => document.querySelector('#draw:not([hidden])'));
  await act('#draw', 'click');
  await tab.until('the tools', () => document.querySelector('.hearth-toolbar [data-tool="box"]'));
  await act('[data-tool="box"]', 'click');
  // A new solid of wood would be two objects.
  await act('.hearth-toolbar input[type=checkbox]', 'click');
  await drag(tab, [-0.1, 1.1], [0.1, 0.9]);
  await objectsUntil(tab, 'two', (all) => all.length === 2 && all[1].shape === 'box');

  await act('[data-tool="undo"]', 'click');
  await objectsUntil(tab, 'one', (all) => all.length === 1);
  await act('[data-action="undo"]', 'click');
  await panel.value('wind', 'as before', (value) => value === 0);
  await act('[data-action="redo"]', 'click');
  await panel.value('wind', 'as dragged', (value) => value === wind);
  await act('[data-tool="redo"]', 'click');
  await objectsUntil(tab, 'two again', (all) => all.length === 2);
  const config = await tab.fire((fire) => fire.exportConfig());
  const search = await tab.until('the address', () => {
    const { search } = location;
    return search.includes('wind=') && search.includes('objects=') && search;
  });
  await assertSilent(tab);
  const other = await browser.open(`index.html${search}`, { width: 1000, height: 700 });
  await other.ready();
  assert.deepEqual(await other.fire((fire) => fire.exportConfig()), config);
  await assertSilent(other);
});

test('thirty fires on one page all burn', async () => {
  const tab = await browser.show(
    `<style>hearth-fire { width: 80px; height: 80px; float: left }</style>${FIRE.repeat(30)}`,
  );
  await tab.evaluate(async () => {
    const fires = /** @type {any[]} */ ([...document.querySelectorAll('hearth-fire')]);
    await Promise.all(fires.map((fire) => fire.ready));
    await Promise.all(fires.map((fire) => fire.step(300)));
  });
  await tab.until('each plays', () =>
    [...document.querySelectorAll('hearth-fire')].every((fire) => /** @type {any} */ (fire).stats?.time > 0),
  );
  const page = await tab.picture();
  for (let at = 0; at < 30; at += 1) {
    const [x, y] = [80 * (at % 6), 80 * Math.floor(at / 6)];
    const fire = page.crop(
      (x + 20) / page.width,
      (y + 30) / page.height,
      (x + 60) / page.width,
      (y + 80) / page.height,
    );
    assert.ok(fire.glowing() > 0.02, `${fire.glowing()} of fire ${at + 1} glows`);
  }
  assert.equal((await tab.living()).contexts, 1);
  await assertSilent(tab);
});

test('a hundred fires that come and go leave the one context, and nothing in it', async () => {
  // Of one quality, since another one has more copies of the glow.
  const low = FIRE.replace('<hearth-fire', '<hearth-fire quality="low"');
  const tab = await browser.show(`<style>hearth-fire { width: 40px; height: 40px }</style>${low}`);
  // Later slices of a fire need more targets than its first one.
  await tab.burnt(3);
  const before = await tab.living();
  await tab.evaluate(async () => {
    for (let round = 0; round < 10; round += 1) {
      const fires = Array.from({ length: 10 }, () => document.createElement('hearth-fire'));
      document.body.append(...fires);
      await Promise.all(fires.map((fire) => /** @type {any} */ (fire).ready));
      for (const fire of fires) fire.remove();
    }
  });
  // The engine hears of the last removals after this.
  await age(tab);
  const { contexts, objects, workers } = await tab.living();
  assert.deepEqual([contexts, workers], [1, before.workers]);
  assert.ok(objects <= before.objects, `${objects} things are held, and were ${before.objects}`);
  await assertSilent(tab);
});

test('a lost context is reported, and the fire burns on when it is restored', async () => {
  const tab = await browser.open(recording(FIRE));
  await tab.burnt(1);
  await tab.fire((fire) => {
    fire.restored = new Promise((resolve) => fire.addEventListener('restored', resolve, { once: true }));
  });
  await tab.loseContext(500);
  await tab.until('an error event', () => /** @type {any} */ (window).events.some(({ type }) => type === 'error'));
  assert.deepEqual(
    (await events(tab, 'error')).map((error) => error.kind),
    ['context-lost'],
  );
  if (BROWSER === 'chromium') {
    const glow = (await tab.firePicture()).crop(0.3, 0.4, 0.7, 1).glowing();
    assert.ok(glow > 0.01, 'its last picture stays meanwhile');
  }
  await tab.fire((fire) => fire.restored.then(() => undefined));
  await tab.burnt((await tab.fire((fire) => fire.stats.time)) + 0.3);
  await assertBurns(tab);
  assert.equal(await tab.fire((fire) => fire.stats.engine), THREAD);
  await assertCaught(tab);
});

test('the engine runs on the page’s own thread if a page selects it', async () => {
  const tab = await browser.open(`<script type="module">
    import { HearthFire } from '/web/hearth-fire.js';
    HearthFire.engine = 'main';
  </script>${FIRE}`);
  await tab.burnt(1.2);
  await assertBurns(tab);
  assert.equal(await tab.fire((fire) => fire.stats.engine), 'main');
  assert.equal((await tab.living()).workers, 0);
  await assertSilent(tab);
});

test('without the engine the poster stays, and an error has the reason', async () => {
  for (const instead of [{ status: 404 }, { keep: 5000 }, { type: 'text/html', body: '<p>' }]) {
    const tab = await browser.open(recording('<hearth-fire><p slot="poster">A poster</p></hearth-fire>'), {
      files: { 'hearth-engine_bg.wasm': instead },
    });
    await tab.until('an error event', () => /** @type {any} */ (window).events.length > 0);
    assert.deepEqual(
      (await events(tab, 'error')).map((error) => error.kind),
      ['load'],
    );
    assert.ok((await tab.rectangle('p')).height > 0, 'the poster is shown');
    await assertCaught(tab);
  }
});

test('without the worker’s script a fire burns on the page’s own thread', async () => {
  const tab = await browser.open(FIRE, { files: { 'engine/worker.js': { status: 404 } } });
  await tab.burnt(1);
  await assertBurns(tab);
  assert.equal(await tab.fire((fire) => fire.stats.engine), 'main');
  await assertCaught(tab);
});

test('a content security policy with own scripts and wasm is enough; without wasm, an error reports it', async () => {
  const page = `<!doctype html><html lang="en"><title>A strict page</title>
    <link rel="icon" href="data:,"><script type="module" src="/web/hearth-fire.js"></script>
    <body bgcolor="black">${FIRE}`;
  const policy = (scripts) => ({
    'content-security-policy': `default-src 'none'; img-src data:; connect-src 'self'; worker-src 'self'; script-src ${scripts}`,
  });
  const tab = await browser.open(page, { headers: policy("'self' 'wasm-unsafe-eval'") });
  await tab.burnt(1.2);
  await assertBurns(tab);
  assert.equal(await tab.fire((fire) => fire.stats.engine), THREAD);
  await assertSilent(tab);
  const without = await browser.open(page, { headers: policy("'self'") });
  const refused = await without.fire((fire) => fire.ready.catch((error) => error.kind));
  assert.equal(refused, 'load');
});

test('with reduced motion a fire is paused until a visitor plays it', async () => {
  const tab = await browser.open(FIRE, { reducedMotion: true });
  await tab.ready();
  const still = await tab.firePicture();
  await tab.frames(10);
  assert.equal(still.difference(await tab.firePicture()), 0);
  assert.ok(still.crop(0.3, 0.4, 0.7, 1).glowing() > 0.02, 'the still shows a fire');
  await tab.click({ x: 120, y: 120 });
  await assertBurns(tab);
  await assertSilent(tab);
});
