/**
 * Figures of a few seconds of a fire's pixels. `cargo measure look` measures a minute of
 * every scene.
 */
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { BARS } from './measurements.mjs';
import { Film } from './figures/film.mjs';
import { rising } from './figures/motion.mjs';
import { Painter } from './painter.mjs';

const painter = new Painter();
after(() => painter.close());

/** The figures of so many seconds. @param {import('./painter.mjs').PictureRequest} request @param {number} seconds */
async function seen(request, seconds) {
  const film = await Film.of(painter, request);
  await film.until(seconds);
  return film.found();
}

for (const lit of ['default', 'classic']) {
  test(`the pixels of ${lit} are those of a fire`, async () => {
    const found = await seen({ lit, burnt: 2 }, 2.5);
    for (const { words, figure, holds, brief } of BARS) {
      if (brief) assert.ok(holds(figure(found)), `${words}: ${JSON.stringify(figure(found))}`);
    }
    assert.ok(found.luminous > 0.02, `${found.luminous} of it is luminous`);
  });
}

test('light that no black body emits is recognised', async () => {
  const found = await seen({ lit: 'default', burnt: 1, values: { palette: 'copper' } }, 0.5);
  for (const id of ['locus', 'warm']) {
    const { figure, holds } = BARS.find((bar) => bar.id === id) ?? assert.fail(id);
    assert.ok(!holds(figure(found)), `${id}: ${figure(found)}`);
  }
});

/** Blobs at places that do not repeat, moved down by so many pixels. */
function blobs(/** @type {number} */ down) {
  const [width, height] = [96, 96];
  return Float32Array.from({ length: width * height }, (_, at) => {
    const [x, y] = [at % width, Math.floor(at / width) - down];
    return 0.4 + 0.2 * Math.sin(0.31 * x + 0.017 * y * y * 0.1) * Math.cos(0.27 * y + 0.011 * x * x * 0.1);
  });
}

test('the direction of motion is measured', () => {
  const see = (/** @type {number} */ down) => rising(blobs(0), blobs(down), 96, 96, 0.03);
  for (const down of [-9, -4, -1]) {
    const [up, moving, all] = see(down);
    assert.ok(all > 20 && up > 0.95 * moving && moving > 0.9 * all, `${[down, up, moving, all]}`);
  }
  for (const down of [1, 4]) {
    const [up, moving] = see(down);
    assert.ok(moving > 20 && up < 0.05 * moving, `${[down, up, moving]}`);
  }
  const [up, moving, all] = see(0);
  assert.ok(up === 0 && moving === 0 && all > 20);
});

test('the direction of flicker is measured', () => {
  // A flame that fades towards its tip, with streaks in it that go down by so many pixels
  // while it grows darker, or brighter, as a whole.
  const flame = (/** @type {number} */ down, /** @type {number} */ lightness) =>
    blobs(down).map((streaks, at) => (lightness + 0.008 * Math.floor(at / 96) + 0.5 * (streaks - 0.4)) ** 3);
  for (const later of [0.37, 0.43]) {
    const see = (/** @type {number} */ down) => rising(flame(0, 0.4), flame(down, later), 96, 96, 0.03);
    const [up, moving, all] = see(-4);
    assert.ok(all > 20 && up > 0.95 * moving && moving > 0.9 * all, `${[later, up, moving, all]}`);
    const [falls, moves] = see(4);
    assert.ok(moves > 20 && falls < 0.05 * moves, `${[later, falls, moves]}`);
  }
});
