/**
 * The viewport: `toMetres` and `toPixels` agree with the picture.
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

/** Two points that are the same up to rounding. */
function assertNear(found, expected, what) {
  const near = Math.abs(found.x - expected.x) < 1e-3 && Math.abs(found.y - expected.y) < 1e-3;
  assert.ok(near, `${what} is ${JSON.stringify(found)}, not ${JSON.stringify(expected)}`);
}

test('they follow the height of the world, and have no value without a picture', async () => {
  const tab = await browser.show('<hearth-fire paused></hearth-fire>');
  await tab.ready();
  await tab.fire((fire) => fire.set('domain_height', 3));
  assertNear(await tab.fire((fire) => fire.toMetres(120, 0)), { x: 0, y: 3 }, 'the top');
  const without = await tab.fire((fire) => {
    fire.style.display = 'none';
    const hidden = [fire.toMetres(0, 0), fire.toPixels(0, 0)];
    fire.remove();
    return [...hidden, fire.toMetres(0, 0), fire.toPixels(0, 0)];
  });
  assert.deepEqual(without, [null, null, null, null]);
});

/** Transforms of an ancestor, and of the element. */
const TRANSFORMS = [
  ['turned', 'transform: rotate(90deg)', ''],
  ['turned a little, on both', 'transform: rotate(20deg)', 'rotate: 15deg'],
  ['mirrored', 'transform: scaleX(-1)', ''],
  ['upside down', 'transform: scaleY(-1)', ''],
  ['enlarged and moved', 'scale: 1.5 0.7; translate: 30px 10px', ''],
  ['skewed', 'transform: skew(20deg, 5deg)', ''],
  ['in three dimensions', 'transform: perspective(600px) rotateY(40deg) rotateX(20deg)', ''],
  ['in the space of its parent', 'perspective: 500px', 'transform: rotateX(40deg)'],
  ['along a path', 'offset-path: path("M0,0 L200,100"); offset-distance: 60%', ''],
  ['zoomed', 'zoom: 1.5', ''],
  ['scrolled', 'overflow: auto; height: 150px; transform: rotate(-30deg)', 'margin-top: 40px'],
];

for (const [about, outer, inner] of TRANSFORMS) {
  test(`points of an element are those that the page shows there: ${about}`, async () => {
    const tab = await browser.show(`<div style="width: 300px; margin: 60px; ${outer}">
      <hearth-fire paused style="width: 300px; height: 200px; ${inner}"></hearth-fire></div>`);
    await tab.ready();
    const seen = await tab.fire((fire) => {
      const canvas = /** @type {HTMLElement} */ (fire.shadowRoot.querySelector('canvas'));
      // What the browser puts at a quarter of the picture's width and a tenth of its height.
      const mark = document.createElement('i');
      mark.style.cssText = 'position: absolute; left: 25%; top: 10%';
      canvas.after(mark);
      const [{ x, y }, { left, top }] = [mark, fire].map((node) => node.getBoundingClientRect());
      mark.remove();
      const metres = fire.toMetres(x - left, y - top);
      const { domain_height: height } = fire.params;
      return { metres, height, back: fire.toPixels(metres.x, metres.y), at: { x: x - left, y: y - top } };
    });
    assertNear(seen.metres, { x: (-0.25 * 300 * seen.height) / 200, y: 0.9 * seen.height }, 'the point');
    assertNear(seen.back, seen.at, 'its pixel');
  });
}

test('a drag moves the source under a transform, where the pointer is', async () => {
  for (const [, outer, inner] of TRANSFORMS.slice(0, 8)) {
    const tab = await browser.show(`<div style="width: 300px; margin: 60px; ${outer}">
      <hearth-fire interactive preset="candle" style="width: 300px; height: 300px; ${inner}"></hearth-fire></div>`);
    await tab.ready();
    const [from, to] = await tab.fire((fire) => {
      const { left, top } = fire.getBoundingClientRect();
      const { source_x: x, source_height: y } = fire.params;
      return [x, x + 0.1].map((across) => {
        const at = fire.toPixels(across, y + 0.005);
        return { x: at.x + left, y: at.y + top };
      });
    });
    await tab.drag(from, to);
    await tab.until(
      `the source has moved: ${outer} ${inner}`,
      (expected) =>
        Math.abs(/** @type {any} */ (document.querySelector('hearth-fire')).params.source_x - expected) < 0.02,
      0.1,
    );
  }
});
