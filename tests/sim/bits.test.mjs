/**
 * The same seed and inputs give the same bits, in every simulation and natively.
 */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { promisify } from 'node:util';
import { burnEverything, fingerprint, fnv } from './fingerprint.mjs';
import { PRESETS, ROOT, createSimulation, everything, fires, load } from './library.mjs';

/** As in `tests/src/lib.rs`. */
const STEPS = 500;

/** What the native program prints: of a file that `cargo xtask test` writes, or of the program itself. */
async function nativeFingerprints() {
  const { CARGO = 'cargo', HEARTH_FINGERPRINTS } = process.env;
  if (HEARTH_FINGERPRINTS) return readFile(HEARTH_FINGERPRINTS, 'utf8');
  const example = ['run', '--quiet', '--package', 'hearth-tests', '--example', 'fingerprint'];
  return (await promisify(execFile)(CARGO, example, { cwd: ROOT, encoding: 'utf8' })).stdout;
}

test('the library burns every preset to the same bits as the native program', async () => {
  // The native program runs on another core.
  const printed = nativeFingerprints();
  /** @type {[string, string][]} */
  const burnt = [];
  for (const { name } of PRESETS) {
    const sim = await createSimulation({ preset: name });
    sim.step(STEPS);
    burnt.push([name, fingerprint(sim)]);
    sim.free();
  }
  for (const name of ['candle', 'classic']) {
    const sim = await createSimulation({ preset: name });
    for (let frame = 0; frame < 30; frame += 1) sim.advance(1 / 30);
    burnt.push([`${name} in frames`, fingerprint(sim)]);
    sim.free();
  }
  const lines = (await printed).trim().split('\n');
  const native = new Map(lines.map((line) => /** @type {any} */ (line.split(/ (?=\S+$)/))));
  for (const [name, print] of burnt) assert.equal(print, native.get(name), name);
});

test('the library makes the same samples as the native program', async () => {
  const { createSynthesis } = await load('sound.js');
  const sim = await createSimulation({ preset: 'fireside' });
  sim.series();
  sim.step(300);
  const sound = await createSynthesis({ halfWidth: sim.get('domain_width') / 2 });
  sound.push(sim.series());
  const samples = [0, 1].map(() => new Float32Array(Math.floor(sound.ahead * 48_000)));
  sound.render(samples[0], samples[1]);
  const hash = samples.reduce((sum, { buffer }) => fnv(new Uint8Array(buffer), sum), fnv(new Uint8Array()));
  const line = (await nativeFingerprints()).split('\n').find((text) => text.startsWith('sound '));
  assert.equal(`sound ${hash.toString(16).padStart(16, '0')}`, line);
});

test('the same calls give the same bits for any division of the steps', async () => {
  const [first, second] = [await fires(), await fires()];
  for (const [sim, other] of first.map((sim, at) => [sim, second[at]])) {
    sim.step(150);
    for (let left = 150; left > 0; left -= 1) other.step();
    assert.deepEqual(everything(sim), everything(other));
  }
  assert.deepEqual(await burnEverything(createSimulation), await burnEverything(createSimulation));
});
