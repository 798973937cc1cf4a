/** Every argument of the library and of its sound is refused by name where it is hostile, and nothing changes. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertRefuses } from '../hostile.mjs';
import { createSimulation, everything, load } from './library.mjs';

const { STEP_NUMBERS, createSynthesis } = await load('sound.js');

// The first call decides which wasm all of them have.
test('hostile values are refused by name: createSimulation({ wasm }), and the next call loads it', async () => {
  const call = (/** @type {any} */ wasm) => wasm !== undefined && wasm !== null && createSimulation({ wasm });
  await assertRefuses((wasm) => typeof wasm !== 'string' && call(wasm), /wasm/);
  assert.ok((await createSimulation({ wasm: null })).count >= 0);
});

/** @type {[named: RegExp, call: (sim: any, value: any) => unknown][]} */
const ARGUMENTS = [
  [/steps/, (sim, value) => sim.step(value)],
  [/seconds/, (sim, value) => sim.advance(value)],
  [/id|there is no parameter/, (sim, value) => sim.get(value)],
  [/values|there is no parameter/, (sim, value) => sim.set(value, 1)],
  [/wind/, (sim, value) => sim.set('wind', value)],
  [/objects/, (sim, value) => (sim.objects = value)],
  [/object|kind|there is no/, (sim, value) => sim.addObject(value)],
  [/id/, (sim, value) => sim.changeObject(value, { x: 0 })],
  [/propert|there is no/, (sim, value) => sim.changeObject(1, value)],
  [/id/, (sim, value) => sim.removeObject(value)],
  [/id|there is no parameter/, (sim, value) => sim.restore(value)],
  [/place/, (sim, value) => sim.ignite(value)],
  [/y|place/, (sim, value) => sim.ignite(0, value)],
  [/radius|place/, (sim, value) => sim.extinguish(0, 1, value)],
  [/x/, (sim, value) => sim.spray(value, 1)],
  [/grams/, (sim, value) => sim.spray(0, 1, 0, -4, value)],
  [/particles|positions/, (sim, value) => sim.setParticles(value)],
  [/positions|numbers/, (sim, positions) => sim.setParticles({ ...sim.particles(), positions })],
  [/age/, (sim, ages) => sim.setParticles({ ...sim.particles(), ages })],
];

for (const [named, call] of ARGUMENTS) {
  test(`hostile values are refused by name: ${call}`, async () => {
    const sim = await createSimulation({ seed: 1 });
    await assertRefuses((value) => call(sim, value), named);
    sim.step();
    assert.ok(sim.time > 0);
    sim.free();
  });
}

for (const name of ['model', 'preset', 'seed', 'params', 'objects']) {
  test(`hostile values are refused by name: createSimulation({ ${name} })`, () =>
    assertRefuses((value) => createSimulation({ [name]: value }), RegExp(`${name}|there is no`)));
}

test('hostile values are refused by name: createSimulation(options)', () => assertRefuses(createSimulation, /option/));

test('a refused call changes nothing', async () => {
  const sim = await createSimulation({ preset: 'campfire', seed: 1 });
  sim.step(20);
  const before = everything(sim);
  for (const [, call] of ARGUMENTS)
    for (const value of [Symbol('mine'), 10n, () => 1]) assert.throws(() => call(sim, value));
  assert.deepEqual(everything(sim), before);
});

for (const name of ['rate', 'seed', 'volume', 'roar', 'crackle', 'hiss', 'halfWidth']) {
  test(`hostile values are refused by name: createSynthesis({ ${name} })`, () =>
    assertRefuses((value) => createSynthesis({ [name]: value }), RegExp(name)));
}

test('hostile values are refused by name: createSynthesis(options)', () => assertRefuses(createSynthesis, /option/));

const samples = () => new Float32Array(8);

/** @type {[named: RegExp, call: (sound: any, value: any) => unknown][]} */
const SOUND_ARGUMENTS = [
  [/mix|option/, (sound, value) => sound.mix(value)],
  [/seconds/, (sound, value) => sound.trim(value)],
  [/series/, (sound, value) => sound.push(value)],
  [/series/, (sound, value) => sound.push(Array(STEP_NUMBERS).fill(value))],
  [/speed/, (sound, value) => sound.push([], value)],
  [/left/, (sound, value) => sound.render(value, samples())],
  [/right/, (sound, value) => sound.render(samples(), value)],
];

for (const [named, call] of SOUND_ARGUMENTS) {
  test(`hostile values are refused by name: ${call}`, async () => {
    const sound = await createSynthesis();
    await assertRefuses((value) => call(sound, value), named);
  });
}

test('the sound of a series is finite at the ends of all ranges', async () => {
  for (const options of [
    { rate: 8000, volume: 0, roar: 0, crackle: 0, hiss: 0, halfWidth: 0.001 },
    { rate: 768_000, volume: 1, roar: 2, crackle: 2, hiss: 2, halfWidth: 1000, seed: 2 ** 32 - 1 },
  ]) {
    const sound = await createSynthesis(options);
    for (const number of [0, 1e-12, 1, 1e6])
      for (const speed of [0.01, 100]) sound.push(Array(STEP_NUMBERS * 4).fill(number), speed);
    const [left, right] = [new Float32Array(4096), new Float32Array(4096)];
    sound.render(left, right);
    assert.ok([...left, ...right].every(Number.isFinite));
  }
});
