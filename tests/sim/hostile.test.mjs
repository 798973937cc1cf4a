/** Every argument of the library is refused by name where it is hostile, and nothing changes. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { answers, assertRefused, hostileValues } from '../hostile.mjs';
import { createSimulation, everything, fires, load } from './library.mjs';

const NUMBERS = ['-0', '-1', '1.5', '1e300'];
const FIELDS = ['{}', 'an object without a prototype', 'a throwing iterator'];

/** @type {[name: string, named: RegExp, call: (sim: any, value: any) => unknown, taken: string[]][]} */
const ARGUMENTS = [
  ['step(steps)', /steps/, (sim, value) => sim.step(value), ['undefined', '-0']],
  ['advance(seconds)', /seconds/, (sim, value) => sim.advance(value), ['-0', '1.5']],
  ['get(id)', /id|there is no parameter/, (sim, value) => sim.get(value), []],
  ['set(ids)', /values|there is no parameter/, (sim, value) => sim.set(value, 1), FIELDS],
  ["set('wind', value)", /wind/, (sim, value) => sim.set('wind', value), ['null', '-0', '-1', '1.5']],
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

test('hostile values are refused by name: createSimulation({ wasm }), and the next call loads it', async () => {
  const texts = ["''", "'x'", 'a long text'];
  const values = Object.entries(hostileValues()).filter(([name]) => !texts.includes(name));
  // The wasm is loaded once for all simulations of a module.
  const { createSimulation: first } = await load('sim.js', '?hostile');
  const refused = values.filter(([name]) => !/undefined|null/.test(name));
  assertRefused(await answers((wasm) => first({ wasm }), Object.fromEntries(refused)), /wasm/, []);
  assert.ok((await first({ wasm: null })).count >= 0);
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
