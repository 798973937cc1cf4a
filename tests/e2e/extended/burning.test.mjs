/**
 * A word that burns by the attributes `burning` and `text` is read. `web/children.test.mjs` has the recipe.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { decoded } from '../masks.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

/** The solid of the fire and its box in the picture. */
const solidOf = (tab) =>
  tab.fire((fire) => {
    const { mask, x, y, width, height } = fire.objects.find(({ shape }) => shape === 'mask');
    const [a, b] = [fire.toPixels(x - width / 2, y + height / 2), fire.toPixels(x + width / 2, y - height / 2)];
    return { mask, left: a.x, top: a.y, right: b.x, bottom: b.y };
  });
const hasMask = () =>
  /** @type {any} */ (document.querySelector('hearth-fire')).objects.some(({ shape }) => shape === 'mask');

/** Luma of the pixels of a picture; 0 outside. */
function lumaOf({ width, height, rgb }) {
  return (x, y) => {
    if (x < 0 || y < 0 || x >= width || y >= height) return 0;
    const [r, g, b] = rgb.subarray(3 * (y * width + x), 3 * (y * width + x) + 3);
    return 0.3 * r + 0.6 * g + 0.1 * b;
  };
}

/** Whether a pixel is in the mask. */
function insideOf({ mask, left, top, right, bottom }) {
  const pixels = decoded(mask);
  return (x, y) => {
    const [across, down] = [(x + 0.5 - left) / (right - left), (y + 0.5 - top) / (bottom - top)];
    return across >= 0 && across < 1 && down >= 0 && down < 1 && pixels.at(across, down) > 7;
  };
}

/** Luma of embers in coal, on average over its veins: flames are brighter, and gaps without a flame are darker. */
const COAL = [30, 90];
const VEINS = 3;

/** Correlation of the mask with what looks like coal in its box. */
function correlation(picture, solid) {
  const [luma, isIn] = [lumaOf(picture), insideOf(solid)];
  const pairs = [];
  for (let y = Math.round(solid.top); y < solid.bottom; y += 2) {
    for (let x = Math.round(solid.left); x < solid.right; x += 2) {
      let sum = 0;
      for (let dy = -VEINS; dy <= VEINS; dy += 1)
        for (let dx = -VEINS; dx <= VEINS; dx += 1) sum += luma(x + dx, y + dy);
      const mean = sum / (2 * VEINS + 1) ** 2;
      pairs.push([Number(isIn(x, y)), Number(mean > COAL[0] && mean < COAL[1])]);
    }
  }
  const mean = (at) => pairs.reduce((sum, pair) => sum + pair[at], 0) / pairs.length;
  const [a, b] = [mean(0), mean(1)];
  const total = (of) => pairs.reduce((sum, pair) => sum + of(pair[0] - a, pair[1] - b), 0);
  return total((p, q) => p * q) / Math.sqrt(total((p) => p * p) * total((_, q) => q * q));
}

for (const [script, word] of Object.entries({ Latin: 'FIRE', Arabic: 'نار' })) {
  test(`a ${script} word that an attribute states is read after ten seconds`, async () => {
    const tab = await browser.open(
      `<style>body { margin: 0; background: black } hearth-fire { width: 504px; height: 420px }</style>
      <hearth-fire preset="burning-word" objects="[]"><hearth-solid text="${word}" width="1" burning></hearth-solid></hearth-fire>`,
      { width: 504, height: 420 },
    );
    await tab.ready();
    await tab.until('the word', hasMask);
    await tab.burnt(10);
    const found = correlation(await tab.picture(), await solidOf(tab));
    assert.ok(found >= 0.6, `correlation ${found.toFixed(2)}`);
  });
}
