/**
 * Values: set, read, put back; all or nothing, and refused in words.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PARAMETERS, PRESETS, createSimulation, everything, fires } from './library.mjs';

/** What a call throws, which must be an error of that kind. */
function thrown(kind, act) {
  try {
    act();
  } catch (error) {
    assert.ok(error instanceof kind, `${error}`);
    return error;
  }
  return assert.fail('it was taken');
}

/** As `thrown`, of a promise. */
async function rejected(kind, promise) {
  const error = await promise.then(() => undefined, (reason) => reason);
  return thrown(kind, () => {
    if (error) throw error;
  });
}

test('values that are set are those that it burns with', async () => {
  for (const sim of await fires()) {
    sim.set('gravity', 5);
    sim.set({ ambient_temperature: 280, model: sim.get('model'), turbulence: '1.5' });
    assert.equal(sim.get('gravity'), 5);
    assert.equal(sim.params.ambient_temperature, 280);
    assert.equal(sim.get('turbulence'), 1.5);
    sim.step(10);
    sim.restore('gravity', 'turbulence');
    assert.equal(sim.get('gravity'), 9.81);
    assert.equal(sim.get('ambient_temperature'), 280);
    sim.restore();
    assert.deepEqual(sim.params, (await createSimulation()).params);
  }
});

test('a simulation starts with its preset, the options, and params on top', async () => {
  const seed = PRESETS.find((preset) => preset.name === 'seed');
  const sim = await createSimulation({ preset: 'seed', seed: 3, params: { viscosity: 0.02 } });
  const wanted = { ...seed.values, seed: 3, viscosity: 0.02 };
  for (const [id, value] of Object.entries(wanted)) assert.equal(sim.get(id), value, id);
  // 100 particles are out of the range of the model that it would have without.
  const classic = await createSimulation({ model: 'classic', params: { emission_rate: 500, max_particles: 100 } });
  assert.deepEqual([classic.get('model'), classic.get('max_particles')], ['classic', 100]);
  const none = await createSimulation({ seed: undefined, params: undefined, preset: undefined });
  assert.deepEqual(none.params, (await createSimulation()).params);
});

test('a simulation starts with each scene by its name', async () => {
  for (const { name, values } of PRESETS) {
    const sim = await createSimulation({ preset: name });
    for (const [id, value] of Object.entries(values)) assert.equal(sim.get(id), value, `${id} of ${name}`);
    sim.step();
    assert.ok(sim.time > 0, name);
    sim.free();
  }
  const { message } = await rejected(RangeError, createSimulation({ preset: 'candel' }));
  for (const { name } of PRESETS) assert.ok(message.includes(name), message);
});

test('every number beyond its range is refused with id, value, min and max', async () => {
  for (const sim of await fires()) {
    const before = everything(sim);
    for (const { id, kind, domains, models } of PARAMETERS) {
      if (!['number', 'integer', 'seed'].includes(kind)) continue;
      const { min, max } = domains[sim.get('model')] ?? domains[models[0]];
      for (const value of [min - 1, 2 * max + 1, NaN, Infinity, -Infinity]) {
        const error = thrown(RangeError, () => sim.set(id, value));
        assert.deepEqual([error.id, error.value, error.min, error.max], [id, value, min, max]);
        for (const word of [id, min, max]) assert.ok(error.message.includes(word), error.message);
      }
    }
    assert.deepEqual(everything(sim), before);
  }
});

test('what is no value of a parameter is refused by every parameter', async () => {
  const [sim] = await fires();
  const before = everything(sim);
  const strange = [undefined, null, {}, [], [1], () => 1, Symbol('s'), 10n, 'nonsense', new Date(0), new Map()];
  for (const { id } of PARAMETERS) {
    for (const value of strange) {
      const error = thrown(RangeError, () => sim.set(id, value));
      assert.equal(error.id, id);
      assert.equal(error.value, value);
    }
  }
  assert.deepEqual(everything(sim), before);
});

test('one bad value refuses all, and every one of them is named', async () => {
  for (const sim of await fires()) {
    sim.step(50);
    const before = everything(sim);
    const error = thrown(RangeError, () => (
      sim.set({ gravity: 5, ambient_density: 99, seed: 8, gravty: 1, walls: 'glass' })
    ));
    assert.deepEqual(error.errors.map(({ id }) => id).sort(), ['ambient_density', 'gravty', 'walls']);
    assert.match(error.errors.find(({ id }) => id === 'gravty').message, /did you mean "gravity"/);
    assert.match(error.errors.find(({ id }) => id === 'walls').message, /open, solid, periodic/);
    thrown(RangeError, () => sim.restore('gravity', 'gravty'));
    assert.deepEqual(everything(sim), before);
  }
});

test('ids that there are not are refused, whatever an object inherits', async () => {
  const [sim] = await fires();
  const before = everything(sim);
  for (const id of ['__proto__', 'constructor', 'toString', '', 'Gravity', 'x'.repeat(1e6), '\u{1f525}', '\ud800']) {
    for (const act of [() => sim.get(id), () => sim.set(id, 1), () => sim.restore(id)]) {
      const error = thrown(RangeError, act);
      assert.match(error.message, /there is no parameter/);
      assert.ok(error.message.length < 200);
    }
  }
  const hostile = JSON.parse('{"__proto__": {"gravity": 5}, "gravity": 4}');
  assert.equal(thrown(RangeError, () => sim.set(hostile)).id, '__proto__');
  assert.equal({}.gravity, undefined);
  for (const id of [undefined, null, 1, {}, Symbol('s')]) {
    thrown(TypeError, () => sim.get(id));
    thrown(TypeError, () => sim.restore(id));
  }
  for (const id of [undefined, null, 1, Symbol('s')]) thrown(TypeError, () => sim.set(id));
  assert.deepEqual(everything(sim), before);
});

test('objects that are no plain data are refused, and what they throw is the cause', async () => {
  const [sim] = await fires();
  const before = everything(sim);
  const own = new Error('mine');
  const throwing = { gravity: 5, get wind() { throw own; } };
  assert.equal(thrown(TypeError, () => sim.set(throwing)).cause, own);
  const trap = new Proxy({}, { ownKeys() { throw own; } });
  assert.equal(thrown(TypeError, () => sim.set(trap)).cause, own);
  for (const bad of [[], [['gravity', 5]], new Map([['gravity', 5]]), new (class { gravity = 5; })(), 5, true]) {
    thrown(TypeError, () => sim.set(bad));
  }
  const many = Object.fromEntries(Array.from({ length: 2000 }, (_, at) => [`id${at}`, 1]));
  thrown(RangeError, () => sim.set(many));
  // A getter that steps while it is read is over before the values count.
  sim.set({ get gravity() { sim.step(5); return 5; } });
  assert.ok(sim.time > before.time);
  assert.equal(sim.get('gravity'), 5);
  const freeing = { get gravity() { sim.free(); return 4; } };
  assert.match(thrown(Error, () => sim.set(freeing)).message, /was freed/);
});

test('options are checked as values are', async () => {
  const wrong = [
    [{ preset: 'sed' }, RangeError, /one of default, .*classic, .*seed/],
    [{ preset: '__proto__' }, RangeError, /one of default, .*classic, .*seed/],
    [{ preset: 5 }, TypeError, /preset must be a text, not 5/],
    [{ model: 'fire' }, RangeError, /classic, combustion/],
    [{ model: null }, RangeError, /classic, combustion/],
    [{ seed: -1 }, RangeError, /0 to 4294967295/],
    [{ seed: NaN }, RangeError, /seed = NaN/],
    [{ params: { gravty: 1 } }, RangeError, /did you mean "gravity"/],
    [{ params: [] }, TypeError, /params must be a plain object, not an array/],
    [{ params: { seed: 1 }, seed: 1 }, TypeError, /seed is given twice/],
    [{ sed: 1 }, TypeError, /no option "sed"; there are model, preset, seed, params, wasm/],
    [JSON.parse('{"__proto__": {}}'), TypeError, /no option "__proto__"/],
    [null, TypeError, /options must be a plain object, not null/],
    ['classic', TypeError, /options must be a plain object, not "classic"/],
    [{ get seed() { throw new Error('mine'); } }, TypeError, /options cannot be read/],
  ];
  for (const [options, kind, words] of wrong) {
    assert.match((await rejected(kind, createSimulation(options))).message, words);
  }
});

test('steps are a whole number, and not a huge one', async () => {
  const [sim] = await fires();
  for (const steps of [-1, 0.5, NaN, Infinity, 1e5 + 1, 2 ** 32, '3', null, 5n, {}]) {
    const error = thrown(RangeError, () => sim.step(steps));
    assert.deepEqual([error.id, error.value, error.min, error.max], ['steps', steps, 0, 1e5]);
  }
  assert.equal(sim.time, 0);
});
