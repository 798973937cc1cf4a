/**
 * The landing page: it loads without a warning, its fire burns in the lower middle, and its
 * address follows the fire.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { assertBurns } from '../assertions.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

test('fire burns in the lower middle and nowhere else, and it moves', async () => {
  // A taller flame, or a spark, may reach the upper edge at any time.
  const page = 'index.html?scene=default&fuel-power=120&ember-rate=0';
  const tab = await browser.open(page, { draws: true, width: 1000, height: 500, pixels: Infinity });
  await tab.burnt(1.5);
  await assertBurns(tab);
  const picture = await tab.firePicture();
  // Between the name and the scenes, which stand at the edges.
  assert.ok(picture.crop(0, 0.3, 0.15, 0.85).dark() > 0.98, 'the left edge is dark');
  assert.ok(picture.crop(0.4, 0, 0.6, 0.05).dark() > 0.95, 'the upper edge is dark');
});

test('the address follows the fire: its scene and its changed values, and nothing else', async () => {
  const tab = await browser.open('index.html?quality=low#hearth');
  await tab.ready();
  const opened = await tab.evaluate(() => [location.search + location.hash, history.length]);
  assert.equal(opened[0], '?quality=low#hearth');
  const follows = (/** @type {string} */ address) =>
    tab.until(`the address ends in ${address}`, (end) => location.href.endsWith(`/index.html${end}`), address);
  await tab.fire((fire) => fire.set({ exposure: 0.25, seed: 7 }));
  await follows('?scene=fireside&exposure=0.25&seed=7&quality=low#hearth');
  await tab.fire((fire) => fire.importConfig({ hearth: 3, values: { seed: 7 } }));
  await follows('?scene=default&seed=7&quality=low#hearth');
  await tab.fire((fire) => fire.importConfig({ hearth: 3, preset: 'seed', values: { viscosity: 0.02 } }));
  await follows('?scene=seed&viscosity=0.02&quality=low#hearth');
  const shown = await tab.fire((fire) => fire.exportConfig());
  const length = await tab.evaluate(() => history.length);
  assert.equal(length, opened[1], 'no entry of the history was made');

  const again = await browser.open(`index.html${await tab.evaluate(() => location.search)}`);
  await again.ready();
  assert.deepEqual(await again.fire((fire) => fire.exportConfig()), shown);
  await again.fire((fire) => fire.restore());
  await again.until('the address names the scene', () => location.search === '?scene=default&quality=low');
  await again.fire((fire) => fire.importConfig({ hearth: 3, preset: 'fireside', values: {} }));
  await again.until('the address is clean', () => location.search === '?quality=low');
  assert.deepEqual([...tab.problems, ...again.problems], []);
});

test('a change right before a reload survives it, and the address has it then', async () => {
  const tab = await browser.open('index.html?scene=candle&paused');
  await tab.ready();
  await tab.evaluate(async () => {
    const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
    const changed = new Promise((resolve) => fire.addEventListener('params-change', resolve, { once: true }));
    fire.set('wind', 0.25);
    await changed;
  });
  await tab.page.reload();
  await tab.ready();
  await tab.until('the address', () => location.search.includes('wind=0.25') && location.hash === '');
  const config = await tab.fire((fire) => fire.exportConfig());
  assert.deepEqual([config.preset, config.values], ['candle', { wind: 0.25 }]);
});

test('a drawing that is too long for an address or for its fragment survives a reload', async () => {
  const tab = await browser.open('index.html?scene=default&paused');
  const kept = async (/** @type {string} */ hash, /** @type {number} */ strokes) => {
    const drawn = await tab.fire(async (fire, count) => {
      const points = (seed) =>
        Array.from({ length: 160 }, (_, at) =>
          [Math.sin(at * seed), Math.cos(at * seed + at)].map((x) => (0.3 * x).toFixed(4)).join(),
        ).join(' ');
      for (let at = fire.objects.length; at < count; at += 1)
        await fire.addObject({ kind: 'solid', shape: 'stroke', points: points(at), y: 0.5 });
      return fire.exportConfig();
    }, strokes);
    await tab.until(`the address has ${hash}`, (start) => location.hash.startsWith(start), hash);
    await tab.page.reload();
    await tab.ready();
    assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), drawn);
    assert.equal(await tab.evaluate(() => location.search), '?paused');
    return tab.evaluate(() => location.href);
  };
  await tab.ready();
  const link = await kept('#fire=', 14);
  await kept('#fire-of-this-tab', 60);
  // Another address of the same page in the same tab loads nothing.
  await tab.page.goto(link);
  await tab.until(
    'the first drawing',
    () => /** @type {any} */ (document.querySelector('hearth-fire')).objects.length === 14,
  );
  assert.deepEqual(tab.problems, []);
});

test('an address with mistakes breaks nothing, and each is reported on the page and in the console', async () => {
  const query = 'viscosty=1&exposure=%3Cimg+src=x+onerror=alert(1)%3E&scene=nowhere&src=/secret.json&seed=7&%zz=%ff';
  const tab = await browser.open(`index.html?${query}`);
  await tab.ready();
  const toast = await tab.evaluate(() => document.getElementById('toast')?.textContent ?? '');
  const console = tab.problems.join('\n');
  for (const words of [/viscosty.*viscosity/, /exposure.*<img/, /nowhere/, /cannot set “src”/]) {
    assert.match(console, words);
    assert.match(toast, words);
  }
  assert.ok(
    tab.problems.every((problem) => problem.startsWith('console.warn')),
    console,
  );
  assert.equal(await tab.evaluate(() => document.querySelectorAll('#toast *, img[src=x]').length), 0);
  assert.equal(await tab.fire((fire) => fire.params.seed), 7);
  await tab.burnt(0.1);
});

for (const [about, sizes] of /** @type {[string, number[][]][]} */ ([
  ['a phone', [[360, 640, 3]]],
  ['a tablet', [[768, 1024, 2]]],
  [
    'screens',
    [
      [1280, 720, 1],
      [2560, 1440, 1],
    ],
  ],
])) {
  test(`the page fits ${about}`, async () => {
    const [[width, height, ratio]] = sizes;
    const tab = await browser.open('index.html', { width, height, ratio, touch: width < 720, pixels: Infinity });
    await tab.burnt(0.5);
    for (const size of sizes) await assertFits(tab, ...size);
    assert.deepEqual(tab.problems, []);
  });
}

/** The page is as wide as its window, and the fire has at most as many pixels as that has. */
async function assertFits(tab, width, height, ratio) {
  const { isMobile, hasTouch } = tab.page.viewport();
  await tab.page.setViewport({ width, height, deviceScaleFactor: ratio, isMobile, hasTouch });
  await tab.until(
    'the fire is drawn at this size',
    ([pixels, ratio]) => {
      const fire = /** @type {Element} */ (document.querySelector('hearth-fire'));
      const canvas = /** @type {any} */ (fire.shadowRoot?.querySelector('canvas'));
      const { width: across, height: up } = fire.getBoundingClientRect();
      const isAlike = Math.abs(canvas.width / canvas.height / (across / up) - 1) < 0.02;
      // A picture of another size may have the same shape, but too few or too many pixels. The lowest quality allows so many.
      const least = Math.min(1, Math.sqrt((1280 * 720) / (across * up)));
      const scale = canvas.width / across;
      return innerWidth === pixels && isAlike && scale >= 0.99 * least && scale <= ratio + 0.01;
    },
    [width, ratio],
  );
  const seen = await tab.evaluate(() => {
    const root = document.documentElement;
    const fire = /** @type {Element} */ (document.querySelector('hearth-fire'));
    const { width: cssWidth, height: cssHeight } = fire.getBoundingClientRect();
    const canvas = /** @type {any} */ (fire.shadowRoot?.querySelector('canvas'));
    return {
      overflow: root.scrollWidth - root.clientWidth,
      cssWidth,
      cssHeight,
      pixelWidth: canvas.width,
      pixelHeight: canvas.height,
    };
  });
  assert.ok(seen.overflow <= 0, 'no horizontal scroll bar');
  assert.ok(seen.cssWidth > width / 2, `the fire is ${seen.cssWidth} wide`);
  assert.ok(seen.cssHeight > height / 2, `the fire is ${seen.cssHeight} high`);
  const scale = seen.pixelWidth / seen.cssWidth;
  // A cap on the pixels may lower both sides, never one.
  const otherScale = seen.pixelHeight / seen.cssHeight;
  assert.ok(Math.abs(scale / otherScale - 1) < 0.02, 'pixels are square');
}
