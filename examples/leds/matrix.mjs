/**
 * A fire for a matrix of 16 × 16 lamps, in Node 20: `node examples/leds/matrix.mjs campfire 60 30`, a scene, seconds and
 * pictures a second. Each picture is 16 rows of 16 colours (sRGB) on standard output, from the top, and an empty row:
 *
 *     node examples/leds/matrix.mjs | python3 send-to-lamps.py
 *
 * With the npm package, import from 'hearth-fire/sim' instead. `HEARTH_WEB` names the folder `web` of a built site,
 * `dist/site/web` by default.
 */

import path from 'node:path';
import { setTimeout } from 'node:timers/promises';
import { pathToFileURL } from 'node:url';

const web = process.env.HEARTH_WEB ?? 'dist/site/web';
const { createSimulation } = await import(pathToFileURL(path.resolve(web, 'sim.js')).href);

const [preset, seconds = '60', rate = '30'] = process.argv.slice(2);
const SIDE = 16;
/** Side of what the lamps show, from the floor [m]. */
const METRES = 1.4;
/** Brightness of a lamp before a particle of 1500 K. */
const BRIGHT = 1;

const sim = await createSimulation({ ...(preset && { preset }), seed: 7 });
// A fire that has not begun is dark.
sim.advance(2);

/** Linear light of hot soot, for a temperature [K]. */
function light(kelvin) {
  const glow = BRIGHT * (kelvin / 1500) ** 5;
  return [glow, glow * Math.max(0, kelvin / 2400 - 0.22), glow * Math.max(0, kelvin / 5000 - 0.22)];
}

/** The sum of the light on each lamp; a particle shines on the four around it. */
function picture() {
  const lamps = new Float32Array(3 * SIDE * SIDE);
  const positions = sim.positions();
  const middle = sim.get('source_x');
  sim.temperatures().forEach((kelvin, i) => {
    if (kelvin < 700) return;
    const x = ((positions[2 * i] - middle) / METRES + 0.5) * SIDE - 0.5;
    const y = (1 - positions[2 * i + 1] / METRES) * SIDE - 0.5;
    const [left, top] = [Math.floor(x), Math.floor(y)];
    const rgb = light(kelvin);
    for (const [column, row] of [
      [left, top],
      [left + 1, top],
      [left, top + 1],
      [left + 1, top + 1],
    ]) {
      if (column < 0 || column >= SIDE || row < 0 || row >= SIDE) continue;
      const share = (1 - Math.abs(x - column)) * (1 - Math.abs(y - row));
      for (const channel of [0, 1, 2]) lamps[3 * (SIDE * row + column) + channel] += share * rgb[channel];
    }
  });
  return lamps;
}

/** Two hexadecimal digits of linear light as a display shows it. */
const shown = (light) =>
  Math.round(255 * (1 - Math.exp(-light)) ** (1 / 2.2))
    .toString(16)
    .padStart(2, '0');

// Who reads may stop.
process.stdout.on('error', () => process.exit());
const start = performance.now();
for (let at = 0; at < Number(seconds) * Number(rate); at += 1) {
  const lamps = Array.from(picture(), shown);
  const rows = Array.from({ length: SIDE }, (_, row) =>
    Array.from({ length: SIDE }, (_, column) => {
      const first = 3 * (SIDE * row + column);
      return lamps.slice(first, first + 3).join('');
    }).join(' '),
  );
  process.stdout.write(`${rows.join('\n')}\n\n`);
  sim.advance(1 / Number(rate));
  await setTimeout(Math.max(0, start + (1000 * (at + 1)) / Number(rate) - performance.now()));
}
sim.free();
