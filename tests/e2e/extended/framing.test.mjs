/**
 * The framing of the landing page's fire: measured on pictures of the narrowest and of the widest page, and at all
 * sizes as the place of the floor and of a height above it, from which the same measures follow. `node framing.mjs`
 * measures pictures of all sizes.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { BARS, SIZES, measure } from '../framing.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

for (const size of [SIZES[0], /** @type {[number, number]} */ (SIZES.at(-1))]) {
  test(`the fire of a page of ${size.join(' × ')} fills its stage`, async () => {
    const {
      linear: { height, base },
    } = await measure(browser, size);
    const [[low, high], [near, far]] = [BARS.height, BARS.base];
    assert.ok(height >= low && height <= high, `it is bright on ${height} of the stage's height`);
    assert.ok(base >= near && base <= far, `its base is ${base} of it above the lower edge`);
  });
}

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
