/**
 * Writes the sound of a scene to a WAV file, in Node 20: `node examples/sound/wav.mjs fire.wav campfire 10`. The same
 * scene gives the same samples.
 *
 * With the npm package, import from 'hearth-fire/sim' and 'hearth-fire/sound' instead. `HEARTH_WEB` names the folder
 * `web` of a built site, `dist/site/web` by default.
 */

import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const web = process.env.HEARTH_WEB ?? 'dist/site/web';
const load = (name) => import(pathToFileURL(path.resolve(web, name)).href);
const { createSimulation } = await load('sim.js');
const { createSynthesis } = await load('sound.js');

const [file = 'fire.wav', preset = 'campfire', seconds = '10'] = process.argv.slice(2);
const RATE = 48_000;

const simulation = await createSimulation({ preset });
const speed = simulation.get('time_scale');
const sound = await createSynthesis({ rate: RATE, halfWidth: simulation.get('domain_width') / 2 });
const samples = new Int16Array(2 * Math.round(Number(seconds) * RATE));

// The first call starts to record.
simulation.series();
for (let filled = 0; filled < samples.length; ) {
  simulation.step(10);
  sound.push(simulation.series(), speed);
  const frames = Math.min(Math.floor(sound.ahead * RATE), (samples.length - filled) / 2);
  const [left, right] = [new Float32Array(frames), new Float32Array(frames)];
  sound.render(left, right);
  for (let at = 0; at < frames; at += 1) {
    samples[filled] = Math.round(32_767 * left[at]);
    samples[filled + 1] = Math.round(32_767 * right[at]);
    filled += 2;
  }
}
simulation.free();

/** The header of stereo samples of 16 bits. */
function header(bytes) {
  const made = Buffer.alloc(44);
  made.write('RIFF', 0);
  made.writeUInt32LE(36 + bytes, 4);
  made.write('WAVEfmt ', 8);
  for (const [at, value] of [
    [16, 16],
    [24, RATE],
    [28, 4 * RATE],
    [40, bytes],
  ])
    made.writeUInt32LE(value, at);
  for (const [at, value] of [
    [20, 1],
    [22, 2],
    [32, 4],
    [34, 16],
  ])
    made.writeUInt16LE(value, at);
  made.write('data', 36);
  return made;
}
writeFileSync(file, Buffer.concat([header(samples.byteLength), Buffer.from(samples.buffer)]));
