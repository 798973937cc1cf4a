/**
 * Light that follows the fire and not its resolution: the width and brightness of a candle's flame, the glow of embers,
 * wax in a lit room, a wall at low quality, what is above a ground, and several sources.
 */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { after, test } from 'node:test';
import { Picture } from '../e2e/picture.mjs';
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

test('at low quality a wall has the same light in a large picture, which enlarges it, as in a small one', async () => {
  const values = { backdrop: 'bricks', heat_haze: 0 };
  // Means of twelve rows of blocks at either edge of the picture, beside the fire.
  const [small, large] = await Promise.all(
    [1, 3].map(async (scale) => {
      const [width, height] = [240 * scale, 240 * scale];
      const lights = luminances((await painter.still({ lit: 'default', quality: 'low', values, width, height })).rgba);
      const side = 20 * scale;
      return Array.from({ length: 48 }, (_, block) => {
        const top = Math.floor(block / 4) * side;
        const left = [0, 1, 10, 11][block % 4] * side;
        let sum = 0;
        for (let y = top; y < top + side; y += 1) {
          for (let x = left; x < left + side; x += 1) sum += lights[y * width + x];
        }
        return sum / (side * side);
      });
    }),
  );
  for (const [block, mean] of small.entries()) {
    assert.ok(mean > 0.001 && Math.abs(large[block] / mean - 1) < 0.1, `${block}: ${large[block]} for ${mean}`);
  }
});

test('a ground leaves the air above its horizon as it is', async () => {
  const [bare, ground] = await Promise.all(
    ['none', 'stone'].map((ground) => painter.still({ lit: 'default', values: { ground, smoke_opacity: 0 } })),
  );
  const differs = (/** @type {number} */ row) => {
    const of = ({ width, rgba }) => rgba.subarray(4 * width * row, 4 * width * (row + 1));
    return Buffer.compare(of(bare), of(ground)) !== 0;
  };
  const rows = Array.from({ length: bare.height }, (_, row) => row).filter(differs);
  assert.ok(rows[0] > 0.75 * bare.height, `the highest row that a ground changes: ${rows[0]}`);
  assert.ok(rows.length > 0.1 * bare.height, `${rows.length} rows of ground`);
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

test('a flame below the first source is as bright as the first', () => {
  const side = 160;
  const source = { kind: 'source', width: 0.2, power: 120 };
  const [high, low] = [
    { ...source, x: -0.5, y: 0.8 },
    { ...source, x: 0.5, y: 0.1 },
  ];
  const values = { domain_width: 2, domain_height: 2, particles: 3000, ember_rate: 0, bloom: 0 };
  const options = ['render', '-', '--at', '3', '--size', `${side}x${side}`, '--quality', 'medium', '--out', '-'];
  // Light below the higher source, on the side of the lower one.
  const [second, first] = [
    [high, low],
    [low, high],
  ].map((objects) => {
    const input = JSON.stringify({ hearth: 3, values, objects });
    const { rgb } = Picture.decode(execFileSync(process.env.HEARTH_COMMAND ?? '', options, { input }));
    let sum = 0;
    for (let at = 0; at < side * side; at += 1) {
      const below = at >= 0.6 * side * side && at % side > 0.5 * side;
      if (below) sum += relativeLuminance(rgb[3 * at], rgb[3 * at + 1], rgb[3 * at + 2]);
    }
    return sum;
  });
  assert.ok(first > 10 && second > 0.5 * first, `${second} of ${first}`);
});

test('each candle on a cake has its flame, and the wide wax under them is lit without a jump', async () => {
  const [width, height] = [340, 250];
  const lights = luminances((await painter.still({ lit: 'community/birthday-cake', burnt: 3, width, height })).rgba);
  const row = (/** @type {number} */ metres) =>
    lights.subarray(...[0, 1].map((k) => width * (Math.round((0.5 - metres) * 500) + k)));
  const flames = row(0.29);
  for (const x of [-0.2, 0, 0.2]) {
    const middle = Math.round((x + 0.34) * 500);
    assert.ok(Math.max(...flames.subarray(middle - 30, middle + 30)) > 0.3, `the flame at ${x} m`);
  }
  const wax = row(0.1).subarray(45, width - 45);
  for (const [at, light] of wax.subarray(1).entries()) {
    assert.ok(light > 0.01 && light < 0.9 && Math.abs(light - wax[at]) < 0.02, `${light} after ${wax[at]} at ${at}`);
  }
});
