/**
 * Light that follows the fire and not its resolution: the width of a candle's flame, and the glow of embers.
 */
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { relativeLuminance } from './figures/colour.mjs';
import { Painter } from './painter.mjs';

const painter = new Painter();
after(() => painter.close());

/** Luminances of a picture. @param {Uint8Array} rgba */
function luminances(rgba) {
  return Float64Array.from({ length: rgba.length / 4 }, (_, at) =>
    relativeLuminance(rgba[4 * at], rgba[4 * at + 1], rgba[4 * at + 2]),
  );
}

test('the flame of a candle is as wide at low quality as at high', async () => {
  const areas = [];
  for (const [quality, particles] of /** @type {[string, number][]} */ ([
    ['low', 1200],
    ['high', 6700],
  ])) {
    const { width, rgba } = await painter.still({
      lit: 'candle',
      quality,
      particles,
      burnt: 4,
      width: 640,
      height: 800,
    });
    const lights = luminances(rgba);
    // Of rows of the flame, which are above the wax, the widest.
    const rows = Array.from({ length: 600 }, (_, row) => lights.subarray(row * width, (row + 1) * width));
    areas.push(Math.max(...rows.map((row) => row.filter((light) => light > 0.1).length)));
  }
  assert.ok(areas[0] > 0 && Math.abs(areas[0] / areas[1] - 1) < 0.12, `${areas}`);
});

test('embers are dark where no fire burns', async () => {
  const brightest = [];
  for (const fuel_power of [300, 0]) {
    await painter.ask('film', { lit: 'campfire', values: { fuel_power }, burnt: 2, width: 200, height: 200 });
    const { bytes } = await painter.call('picture', { time: 2, sparks: false });
    // The lowest rows show the bed and no flame.
    brightest.push(Math.max(...luminances(bytes).slice(185 * 200)));
  }
  assert.ok(brightest[0] > 0.1 && brightest[1] < 0.03, `${brightest}`);
});
