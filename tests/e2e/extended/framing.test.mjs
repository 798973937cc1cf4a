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
  browser = await Browser.launch();
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

test('the flame of the landing page fills its stage', async () => {
  const tab = await browser.open('index.html?paused&quality=low', { width: 320, height: 568, touch: true });
  await tab.ready();
  const shares = await tab.fire(async (fire) => {
    const all = [];
    for (let moment = 0; moment < 20; moment += 1) {
      await fire.step(60);
      const { height } = await fire.measure(0, 0);
      all.push((fire.toPixels(0, 0).y - fire.toPixels(0, height).y) / fire.clientHeight);
    }
    return all.sort((a, b) => a - b);
  });
  const median = shares[shares.length / 2];
  assert.ok(median > 0.3 && median < 0.7, `${shares}`);
});
