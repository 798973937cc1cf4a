/** Every argument of the library and of its sound is refused by name where it is hostile, and nothing changes. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { answers, assertRefused, hostileValues } from '../hostile.mjs';
import { createSimulation, everything, fires, load } from './library.mjs';

const { STEP_NUMBERS, createSynthesis } = await load('sound.js');

const NUMBERS = ['-0', '-1', '1.5', '1e300'];
const FIELDS = ['{}', 'an object without a prototype', 'a throwing iterator'];

/** @type {[name: string, named: RegExp, call: (sim: any, value: any) => unknown, taken: string[]][]} */
const ARGUMENTS = [
  ['step(steps)', /steps/, (sim, value) => sim.step(value), ['undefined', '-0']],
  ['get(id)', /id|there is no parameter/, (sim, value) => sim.get(value), []],
  ['set(ids)', /values|there is no parameter/, (sim, value) => sim.set(value, 1), FIELDS],
  ["set('wind', value)", /wind/, (sim, value) => sim.set('wind', value), ['undefined', 'null', '-0', '-1', '1.5']],
  ['objects', /objects/, (sim, value) => (sim.objects = value), ['undefined', 'null', '[]']],
  ['addObject(object)', /object|kind|there is no/, (sim, value) => sim.addObject(value), []],
  ['changeObject(id)', /id/, (sim, value) => sim.changeObject(value, { x: 0 }), []],
  ['changeObject(1, properties)', /propert|there is no/, (sim, value) => sim.changeObject(1, value), FIELDS],
  ['removeObject(id)', /id/, (sim, value) => sim.removeObject(value), []],
  ['restore(id)', /id|there is no parameter/, (sim, value) => sim.restore(value), []],
  ['ignite(place)', /place/, (sim, value) => sim.ignite(value), []],
  ['ignite(0, y)', /y|place/, (sim, value) => sim.ignite(0, value), []],
  ['extinguish(0, 1, radius)', /radius|place/, (sim, value) => sim.extinguish(0, 1, value), []],
  ['spray(x)', /x/, (sim, value) => sim.spray(value, 1), NUMBERS],
  ['spray(0, 1, 0, -4, grams)', /grams/, (sim, value) => sim.spray(0, 1, 0, -4, value), ['undefined', ...NUMBERS]],
  ['setParticles(particles)', /particles|positions/, (sim, value) => sim.setParticles(value), []],
  [
    'setParticles({ positions })',
    /positions|numbers/,
    (sim, positions) => sim.setParticles({ ...sim.particles(), positions }),
    [],
  ],
  [
    'setParticles({ ages })',
    /age/,
    (sim, ages) => sim.setParticles({ ...sim.particles(), ages }),
    ['undefined', '-0', '1.5'],
  ],
];

for (const [name, named, call, taken] of ARGUMENTS) {
  test(`hostile values are refused by name: ${name}`, async () => {
    const sim = await createSimulation({ seed: 1 });
    assertRefused(await answers((value) => call(sim, value), hostileValues()), named, taken);
    sim.step();
    assert.ok(sim.time > 0);
    sim.free();
  });
}

/** @type {[name: string, taken: string[]][]} */
const OPTIONS = [
  ['model', ['undefined', 'null']],
  ['preset', ['undefined']],
  ['seed', ['undefined', 'null', '-0']],
  ['params', ['undefined', ...FIELDS]],
  ['objects', ['undefined', 'null', '[]']],
  ['wasmParts', ['undefined', ...FIELDS]],
];

for (const [name, taken] of OPTIONS) {
  test(`hostile values are refused by name: createSimulation({ ${name} })`, async () => {
    assertRefused(
      await answers((value) => createSimulation({ [name]: value }), hostileValues()),
      RegExp(`${name}|there is no`),
      taken,
    );
  });
}

test('hostile values are refused by name: createSimulation(options)', async () => {
  assertRefused(await answers(createSimulation, hostileValues()), /option/, ['undefined', ...FIELDS]);
});

test('hostile values are refused by name: createSimulation({ wasm }), and the next call loads it', () => {
  // The wasm is loaded once for all simulations and sounds of a program.
  const [helper, library] = ['../hostile.mjs', './library.mjs'].map((name) => new URL(name, import.meta.url).href);
  const program = `
    const { answers, assertRefused, hostileValues } = await import(${JSON.stringify(helper)});
    const { createSimulation } = await import(${JSON.stringify(library)});
    const texts = ["''", "'x'", 'a long text', 'undefined', 'null'];
    const values = Object.entries(hostileValues()).filter(([name]) => !texts.includes(name));
    assertRefused(await answers((wasm) => createSimulation({ wasm }), Object.fromEntries(values)), /wasm/, []);
    console.log((await createSimulation({ wasm: null })).count >= 0);
  `;
  const printed = execFileSync(process.execPath, ['--input-type=module', '-e', program], { encoding: 'utf8' });
  assert.equal(printed.trim(), 'true');
});

test('a refused call changes nothing', async () => {
  for (const sim of await fires()) {
    sim.step(20);
    const before = everything(sim);
    const hostile = Object.entries(hostileValues()).filter(([name]) => /throwing|revoked|symbol|function/.test(name));
    for (const [, , call] of ARGUMENTS) {
      await answers(
        (value) => call(sim, value),
        Object.fromEntries(hostile.filter(([name]) => !/iterator/.test(name))),
      );
    }
    assert.deepEqual(everything(sim), before);
  }
});

/** @type {[name: string, taken: string[]][]} */
const SOUND_OPTIONS = [
  ['rate', ['undefined']],
  ['seed', ['undefined', '-0']],
  ['volume', ['undefined', '-0']],
  ['roar', ['undefined', '-0', '1.5']],
  ['crackle', ['undefined', '-0', '1.5']],
  ['hiss', ['undefined', '-0', '1.5']],
  ['halfWidth', ['undefined', '1.5']],
];

for (const [name, taken] of SOUND_OPTIONS) {
  test(`hostile values are refused by name: createSynthesis({ ${name} })`, async () => {
    assertRefused(await answers((value) => createSynthesis({ [name]: value }), hostileValues()), RegExp(name), taken);
  });
}

test('hostile values are refused by name: createSynthesis(options) and mix(mix)', async () => {
  assertRefused(await answers(createSynthesis, hostileValues()), /option/, ['undefined', ...FIELDS]);
  const sound = await createSynthesis();
  assertRefused(await answers((value) => sound.mix(value), hostileValues()), /mix|option/, FIELDS);
});

const samples = () => new Float32Array(8);

/** @type {[name: string, named: RegExp, call: (sound: any, value: any) => unknown, taken: string[]][]} */
const SOUND_ARGUMENTS = [
  ['trim(seconds)', /seconds/, (sound, value) => sound.trim(value), ['-0', '1.5', '1e300', 'Infinity']],
  ['push(series)', /series/, (sound, value) => sound.push(value), ['[]']],
  [
    'push([number])',
    /series/,
    (sound, value) => sound.push(Array(STEP_NUMBERS).fill(value)),
    ['null', '-0', '1.5', 'true', "''", '[]'],
  ],
  ['push(, speed)', /speed/, (sound, value) => sound.push([], value), ['undefined', '1.5']],
  ['render(left)', /left/, (sound, value) => sound.render(value, samples()), []],
  ['render(, right)', /right/, (sound, value) => sound.render(samples(), value), []],
];

for (const [name, named, call, taken] of SOUND_ARGUMENTS) {
  test(`hostile values are refused by name: ${name} of a sound`, async () => {
    const sound = await createSynthesis();
    assertRefused(await answers((value) => call(sound, value), hostileValues()), named, taken);
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
