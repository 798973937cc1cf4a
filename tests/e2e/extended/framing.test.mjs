/**
 * The framing of the landing page's fire: the flame fills its stage, and the floor and the heights above it have the same
 * places in pages of all sizes.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** The sizes of a page. @type {[number, number][]} */
const SIZES = [
  [320, 568],
  [390, 844],
  [844, 390],
  [768, 1024],
  [1280, 800],
  [1920, 1080],
  [3440, 1440],
];

test('the floor and the height above it have the same places on the stage in pages of all sizes', async () => {
  /** @type {{[size: string]: number[]}} */
  const places = {};
  /** @type {import('../driver.mjs').Tab | undefined} */
  let tab;
  for (const [width, height] of [...SIZES].sort((a, b) => Math.min(...a) - Math.min(...b))) {
    const touch = Math.min(width, height) < 500;
    if (!tab || tab.page.viewport()?.hasTouch !== touch) {
      tab = await browser.open('index.html?paused', { width, height, touch });
      await tab.ready();
    }
    await tab.page.setViewport({ width, height, isMobile: touch, hasTouch: touch });
    await tab.frames(4);
    places[`${width} × ${height}`] = await tab.fire((fire) => {
      const stage = fire.getBoundingClientRect();
      const shown = /** @type {HTMLElement} */ (fire.shadowRoot.querySelector('canvas')).getBoundingClientRect();
      const heights = [0, 0.5, 1].map((up) => 1 - fire.toPixels(0, up).y / stage.height);
      // The flame is in the middle, and the stage in the window.
      return [
        ...heights,
        fire.toPixels(0, 0).x / stage.width,
        shown.height / stage.height,
        Number(stage.bottom <= innerHeight),
      ];
    });
  }
  const [first, ...others] = Object.entries(places);
  for (const [size, shares] of others) {
    assert.ok(
      shares.every((share, at) => Math.abs(share - first[1][at]) < 0.005),
      `${size}: ${shares}; ${first[0]}: ${first[1]}`,
    );
  }
  assert.ok(Math.abs(first[1][3] - 0.5) < 0.005 && first[1][5] === 1, `${first[1]}`);
});

test('the bright part of the flame fills its stage, from near the lower edge on', async () => {
  const query = 'paused&quality=low&max-pixels=20000';
  const tab = await browser.open(`index.html?${query}`, { width: 320, height: 568, touch: true, draws: true });
  await tab.ready();
  const { heights, bases } = await tab.fire(async (fire) => {
    // Sparks are bright and fly to the top, and are no flame.
    await fire.set('ember_rate', 0);
    const linear = (code) => (code <= 10 ? code / 3295 : ((code / 255 + 0.055) / 1.055) ** 2.4);
    const [heights, bases] = [[], []];
    for (let moment = 0; moment < 15; moment += 1) {
      await fire.step(120);
      const image = await createImageBitmap(await fire.toBlob());
      const { width, height } = image;
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, width, height);
      const isBright = (at) =>
        0.2126 * linear(data[at]) + 0.7152 * linear(data[at + 1]) + 0.0722 * linear(data[at + 2]) > 0.5;
      const rows = Array.from({ length: height }, (_, row) => row).filter((row) =>
        Array.from({ length: width }, (_, column) => 4 * (row * width + column)).some(isBright),
      );
      heights.push((rows.at(-1) + 1 - rows[0]) / height);
      bases.push(1 - (rows.at(-1) + 1) / height);
    }
    const sorted = (list) => list.sort((a, b) => a - b);
    return { heights: sorted(heights), bases: sorted(bases) };
  });
  const [height, base] = [heights[7], bases[7]];
  assert.ok(height >= 0.42 && height <= 0.7, `it is bright on ${height} of the stage's height: ${heights}`);
  assert.ok(base >= 0.02 && base <= 0.1, `its base is ${base} of it above the lower edge`);
});
