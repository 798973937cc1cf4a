/**
 * Light that follows the fire and not its resolution: the width and brightness of a candle's flame, the glow of embers, and
 * wax in a lit room.
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

test('the flame of a candle is as wide and as bright at low quality as at high', async () => {
  const [widths, brightness] = [/** @type {number[]} */ ([]), /** @type {number[]} */ ([])];
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
    widths.push(Math.max(...rows.map((row) => row.filter((light) => light > 0.1).length)));
    brightness.push(Math.max(...rows.map((row) => Math.max(...row))));
  }
  assert.ok(widths[0] > 0 && Math.abs(widths[0] / widths[1] - 1) < 0.12, `${widths}`);
  assert.ok(Math.abs(brightness[0] / brightness[1] - 1) < 0.05, `${brightness}`);
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

test('wax on a white page in a lit room is ivory', async () => {
  const values = { ambient_light: 1, smoke_opacity: 0, background: '#ffffff' };
  const { width, rgba } = await painter.still({ lit: 'candle', burnt: 2, values });
  const mean = [0, 0, 0];
  // The wax below its bright top.
  for (let row = 345; row < 390; row += 1) {
    for (let column = 140; column < 180; column += 1) {
      for (const channel of mean.keys()) mean[channel] += rgba[4 * (row * width + column) + channel] / 45 / 40;
    }
  }
  const [r, g, b] = mean;
  assert.ok(r > 225 && r >= g && g >= b && b > 0.83 * r, `${mean}`);
});
