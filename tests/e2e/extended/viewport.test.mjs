/**
 * The viewport: `toMetres` and `toPixels` agree with the picture.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { table } from '../site.mjs';

const { DEFAULTS } = await table();

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

test('the height of the world fits the picture, its origin is the lower middle', async () => {
  const tab = await browser.show(`<hearth-fire paused
    style="width: 300px; height: 200px; border: 10px solid; margin: 20px"></hearth-fire>`);
  await tab.ready();
  const height = DEFAULTS.domain_height;
  for (const [pixels, metres] of [
    [
      { x: 160, y: 210 },
      { x: 0, y: 0 },
    ],
    [
      { x: 160, y: 10 },
      { x: 0, y: height },
    ],
    [
      { x: 260, y: 110 },
      { x: height / 2, y: height / 2 },
    ],
    [
      { x: 10, y: 210 },
      { x: -0.75 * height, y: 0 },
    ],
  ]) {
    const there = await tab.fire((fire, { x, y }) => fire.toMetres(x, y), pixels);
    assertNear(there, metres, `toMetres(${pixels.x}, ${pixels.y})`);
    const back = await tab.fire((fire, { x, y }) => fire.toPixels(x, y), metres);
    assertNear(back, pixels, `toPixels(${metres.x}, ${metres.y})`);
  }
});

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

test('particles appear where toPixels puts their source', async () => {
  const tab = await browser.show(`<hearth-fire paused model="classic" display-mode="paper"
    source-width="0.05" source-height="0.1" emission-speed="0"></hearth-fire>`);
  await tab.ready();
  await tab.fire((fire) => fire.step(10));
  await tab.frames(4);
  const source = await tab.fire((fire) => fire.toPixels(0, fire.params.source_height));
  const picture = await tab.firePicture();
  const reach = 16;
  const { width, height } = picture;
  const around = picture.crop(
    (source.x - reach) / width,
    (source.y - reach) / height,
    (source.x + reach) / width,
    (source.y + reach) / height,
  );
  const lit = (crop) => Math.round((1 - crop.dark()) * crop.width * crop.height);
  assert.ok(lit(around) > 10, `${lit(around)} pixels are lit around the source`);
  assert.equal(lit(picture), lit(around), 'nothing is lit elsewhere');
});
