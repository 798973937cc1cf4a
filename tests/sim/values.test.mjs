/**
 * Values and objects are set, read and restored, all or none. Which values a parameter takes is tested in
 * `crates/hearth-core` and `hearth-settings`.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { DEFAULT, REFUSED, RULE } from '../value-rule.mjs';
import { PRESETS, createSimulation, everything, fires } from './library.mjs';

/** The error of a call, of this class. */
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
  const error = await promise.then(
    () => undefined,
    (reason) => reason,
  );
  return thrown(kind, () => {
    if (error) throw error;
  });
}

/** A source with these properties. */
const source = (properties = {}) => ({ kind: 'source', ...properties });

test('set values are read back', async () => {
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

test('a simulation starts with its preset, options and params', async () => {
  const seed = PRESETS.find((preset) => preset.name === 'seed');
  const sim = await createSimulation({ preset: 'seed', seed: 3, params: { viscosity: 0.02 } });
  const wanted = { ...seed.values, seed: 3, viscosity: 0.02 };
  for (const [id, value] of Object.entries(wanted)) assert.equal(sim.get(id), value, id);
  // 100 particles are out of the range of the default model.
  const classic = await createSimulation({ model: 'classic', params: { emission_rate: 500, max_particles: 100 } });
  assert.deepEqual([classic.get('model'), classic.get('max_particles')], ['classic', 100]);
  const none = await createSimulation({ seed: undefined, params: undefined, preset: undefined });
  assert.deepEqual(none.params, (await createSimulation()).params);
});

test('one rule says what a value of another type is, wherever it is given', async () => {
  const before = (await createSimulation()).params;
  for (const [id, rows] of Object.entries(RULE)) {
    for (const [value, becomes] of rows) {
      const words = `${id} = ${JSON.stringify(value)}`;
      const wanted = becomes === DEFAULT ? before[id] : becomes;
      /** @type {[way: string, give: (sim: any) => any][]} */
      const ways = [
        ['set(id, value)', (sim) => sim.set(id, value)],
        ['set({ id: value })', (sim) => sim.set({ [id]: value })],
        ['params', () => createSimulation({ params: { [id]: value } })],
      ];
      for (const [way, give] of ways) {
        const sim = await createSimulation();
        if (becomes === DEFAULT) sim.set(id, rows[0][0]);
        const made = await Promise.resolve(sim)
          .then(give)
          .catch((error) => error);
        if (becomes === REFUSED) {
          assert.ok(made instanceof RangeError, `${words} by ${way}: ${made}`);
          assert.deepEqual([made.id, made.value], [id, value]);
          assert.deepEqual(sim.params, before);
        } else {
          assert.ok(!(made instanceof Error), `${words} by ${way}: ${made}`);
          assert.equal((made ?? sim).get(id), wanted, `${words} by ${way}`);
        }
        sim.free();
      }
    }
  }
});

test('a parameter without a value is refused, and among several it states nothing', async () => {
  for (const sim of await fires()) {
    for (const act of [() => sim.set('gravity'), () => sim.set('gravity', undefined)]) {
      const error = thrown(RangeError, act);
      assert.deepEqual([error.id, error.value], ['gravity', undefined]);
      assert.match(error.message, /gravity = "undefined" is refused: it must be a number from 0 to 20/);
    }
  }
});

test('undefined among several values states nothing, and null restores', async () => {
  for (const sim of await fires()) {
    sim.set({ gravity: 5, objects: [source(), source()] });
    const before = everything(sim);
    sim.set({ gravity: undefined, turbulence: undefined, objects: undefined });
    sim.changeObject(1, { x: undefined });
    sim.objects = undefined;
    assert.deepEqual(everything(sim), before);
    sim.set({ gravity: null });
    sim.objects = null;
    assert.deepEqual([sim.get('gravity'), sim.objects.length], [9.81, 1]);
  }
  const given = await createSimulation({ preset: 'campfire', params: { exposure: undefined, fuel_power: undefined } });
  assert.deepEqual(given.params, (await createSimulation({ preset: 'campfire' })).params);
});

test('one invalid value changes nothing, and the error lists all', async () => {
  for (const sim of await fires()) {
    sim.step(50);
    const before = everything(sim);
    const error = thrown(RangeError, () =>
      sim.set({ gravity: 5, ambient_density: 99, seed: 8, gravty: 1, palette: 'glass' }),
    );
    assert.deepEqual(error.errors.map(({ id }) => id).sort(), ['ambient_density', 'gravty', 'palette']);
    assert.match(error.errors.find(({ id }) => id === 'gravty').message, /did you mean "gravity"/);
    assert.match(error.errors.find(({ id }) => id === 'palette').message, /blackbody/);
    assert.deepEqual([error.id, error.value, error.max], ['ambient_density', 99, error.errors[0].max]);
    thrown(RangeError, () => sim.restore('gravity', 'gravty'));
    for (const wrong of [{}, [1], Symbol('s'), 10n, NaN]) {
      const refused = thrown(RangeError, () => sim.set('gravity', wrong));
      assert.deepEqual([refused.id, refused.value], ['gravity', wrong]);
    }
    for (const id of ['__proto__', 'constructor', 'x'.repeat(1e6), '\ud800'])
      for (const act of [() => sim.get(id), () => sim.set(id, 1), () => sim.restore(id)])
        assert.match(thrown(RangeError, act).message, /^there is no parameter .{0,150}$/);
    for (const bad of [[['gravity', 5]], new Map([['gravity', 5]]), new (class {})(), true])
      thrown(TypeError, () => sim.set(bad));
    assert.deepEqual(everything(sim), before);
  }
});

test('options are checked as values are', async () => {
  const wrong = [
    [{ preset: 'sed' }, RangeError, /did you mean "seed"/],
    [{ preset: '__proto__' }, RangeError, /there are default, .{10,200} and \d+ more$/],
    [{ preset: 5 }, TypeError, /preset must be a text, not 5/],
    [{ model: 'fire' }, RangeError, /classic, combustion/],
    [{ seed: -1 }, RangeError, /0 to 4294967295/],
    [{ seed: NaN }, RangeError, /seed = NaN/],
    [{ params: { gravty: 1 } }, RangeError, /did you mean "gravity"/],
    [{ params: [] }, TypeError, /params must be a plain object, not an array/],
    [{ params: { seed: 1 }, seed: 1 }, TypeError, /seed is given twice/],
    [{ sed: 1 }, TypeError, /no option "sed"; there are model, preset, seed, params, objects, wasm/],
    [null, TypeError, /options must be a plain object, not null/],
    [{ objects: [source({ x: 9 })] }, RangeError, /objects\[0\]\.x = 9/],
    [{ params: { objects: [] }, objects: [] }, TypeError, /given twice/],
  ];
  for (const [options, kind, words] of wrong) {
    assert.match((await rejected(kind, createSimulation(options))).message, words);
  }
});

test('the number of steps is an integer with a limit', async () => {
  const [sim] = await fires();
  for (const steps of [-1, 0.5, NaN, Infinity, 1e5 + 1, 2 ** 32, '3', null, 5n, {}]) {
    const error = thrown(RangeError, () => sim.step(steps));
    assert.deepEqual([error.id, error.value, error.min, error.max], ['steps', steps, 0, 1e5]);
  }
  assert.equal(sim.time, 0);
});

test('objects are added, changed, removed, replaced and restored', async () => {
  const sim = await createSimulation({ params: { particles: 1000 } });
  assert.equal(sim.addObject(source({ x: 0.3, width: 0.1 })), 2);
  assert.equal(sim.addObject(source({ id: 9 })), 9);
  sim.step(20);
  sim.removeObject(1);
  assert.deepEqual(
    sim.objects.map(({ id }) => id),
    [2, 9],
  );
  assert.equal(sim.get('source_x'), 0.3);
  sim.objects = [source({ x: 0.1 }), source({ power: 30 })];
  assert.deepEqual(
    sim.objects.map(({ id }) => id),
    [1, 2],
  );
  sim.set({ wind: 1, objects: [source({ y: 0.4 })] });
  assert.deepEqual([sim.objects.length, sim.get('wind'), sim.get('source_height')], [1, 1, 0.4]);
  sim.objects = [];
  assert.deepEqual(sim.objects, []);
  sim.step(20);
  sim.restore('objects');
  assert.deepEqual(
    sim.objects.map(({ id, y }) => [id, y]),
    [[1, 0.25]],
  );
  sim.restore();
  assert.deepEqual(sim.objects, (await createSimulation()).objects);
});

test('an invalid object changes nothing, and the error names its property', async () => {
  const sim = await createSimulation();
  sim.addObject(source({ x: 0.3 }));
  const before = everything(sim);
  for (const [act, id, words] of [
    [() => sim.addObject({ kind: 'stone' }), 'objects[2].kind', /"stone"/],
    [() => sim.changeObject(2, { x: {} }), 'objects[1].x', /an object/],
    [() => sim.removeObject(7), 'id', /id of an object/],
    [() => sim.set({ wind: 1, objects: [source(), source({ power: -1 })] }), 'objects[1].power', /0 to 3000/],
    [() => sim.set('objects', 5), 'objects', /an array of objects/],
    [() => sim.set('objects', Array.from({ length: 2000 }, source)), 'objects', /more than 1000 elements/],
  ]) {
    const error = thrown(RangeError, act);
    assert.match(error.message, words);
    assert.equal(error.id ?? 'objects', id);
  }
  for (const bad of [[5], [null], [[source()]], [new Map()]]) thrown(TypeError, () => sim.set('objects', bad));
  assert.deepEqual(everything(sim), before);
});
