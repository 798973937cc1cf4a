/**
 * Values and objects: set, read and restored, all or none, with errors for invalid ones.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PARAMETERS, PRESETS, createSimulation, everything, fires } from './library.mjs';

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

test('a simulation starts with each scene by name', async () => {
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

test('every number out of range throws with id, value, min and max', async () => {
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

test('other values throw for every parameter', async () => {
  const [sim] = await fires();
  const before = everything(sim);
  const strange = [{}, [], [1], () => 1, Symbol('s'), 10n, 'nonsense', new Date(0), new Map()];
  for (const { id } of PARAMETERS) {
    for (const value of strange) {
      const error = thrown(RangeError, () => sim.set(id, value));
      assert.equal(error.id, id);
      assert.equal(error.value, value);
    }
  }
  assert.deepEqual(everything(sim), before);
});

test('undefined states nothing, and null restores', async () => {
  for (const sim of await fires()) {
    sim.set({ gravity: 5, objects: [source(), source()] });
    const before = everything(sim);
    sim.set('gravity', undefined);
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
      sim.set({ gravity: 5, ambient_density: 99, seed: 8, gravty: 1, walls: 'glass' }),
    );
    assert.deepEqual(error.errors.map(({ id }) => id).sort(), ['ambient_density', 'gravty', 'walls']);
    assert.match(error.errors.find(({ id }) => id === 'gravty').message, /did you mean "gravity"/);
    assert.match(error.errors.find(({ id }) => id === 'walls').message, /open, solid, periodic/);
    thrown(RangeError, () => sim.restore('gravity', 'gravty'));
    assert.deepEqual(everything(sim), before);
  }
});

test('unknown ids throw, inherited names included', async () => {
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

test('arguments that are not plain data throw, with their error as the cause', async () => {
  const [sim] = await fires();
  const before = everything(sim);
  const own = new Error('mine');
  const throwing = {
    gravity: 5,
    get wind() {
      throw own;
    },
  };
  assert.equal(thrown(TypeError, () => sim.set(throwing)).cause, own);
  const trap = new Proxy(
    {},
    {
      ownKeys() {
        throw own;
      },
    },
  );
  assert.equal(thrown(TypeError, () => sim.set(trap)).cause, own);
  for (const bad of [
    [],
    [['gravity', 5]],
    new Map([['gravity', 5]]),
    new (class {
      gravity = 5;
    })(),
    5,
    true,
  ]) {
    thrown(TypeError, () => sim.set(bad));
  }
  const many = Object.fromEntries(Array.from({ length: 2000 }, (_, at) => [`id${at}`, 1]));
  thrown(RangeError, () => sim.set(many));
  // A getter runs before the values are set.
  sim.set({
    get gravity() {
      sim.step(5);
      return 5;
    },
  });
  assert.ok(sim.time > before.time);
  assert.equal(sim.get('gravity'), 5);
  const freeing = {
    get gravity() {
      sim.free();
      return 4;
    },
  };
  assert.match(thrown(Error, () => sim.set(freeing)).message, /was freed/);
});

test('options are checked as values are', async () => {
  const wrong = [
    [{ preset: 'sed' }, RangeError, /one of default, .*classic, .*seed/],
    [{ preset: '__proto__' }, RangeError, /one of default, .*classic, .*seed/],
    [{ preset: 5 }, TypeError, /preset must be a text, not 5/],
    [{ model: 'fire' }, RangeError, /classic, combustion/],
    [{ seed: -1 }, RangeError, /0 to 4294967295/],
    [{ seed: NaN }, RangeError, /seed = NaN/],
    [{ params: { gravty: 1 } }, RangeError, /did you mean "gravity"/],
    [{ params: [] }, TypeError, /params must be a plain object, not an array/],
    [{ params: { seed: 1 }, seed: 1 }, TypeError, /seed is given twice/],
    [{ sed: 1 }, TypeError, /no option "sed"; there are model, preset, seed, params, objects, wasm/],
    [JSON.parse('{"__proto__": {}}'), TypeError, /no option "__proto__"/],
    [null, TypeError, /options must be a plain object, not null/],
    ['classic', TypeError, /options must be a plain object, not "classic"/],
    [
      {
        get seed() {
          throw new Error('mine');
        },
      },
      TypeError,
      /options cannot be read/,
    ],
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

/** A source with these properties. */
const source = (properties = {}) => ({ kind: 'source', ...properties });

/** The properties of the objects of a simulation that these objects name. */
const named = (sim, wanted) =>
  sim.objects.map((object, at) =>
    Object.fromEntries(Object.keys(wanted[at] ?? {}).map((name) => [name, object[name]])),
  );

test('the first source and the parameters are the same values', async () => {
  const sim = await createSimulation({ params: { source_x: 0.2 } });
  assert.deepEqual(named(sim, [source({ id: 1, x: 0.2 })]), [source({ id: 1, x: 0.2 })]);
  sim.changeObject(1, { x: -0.1, power: 50 });
  assert.deepEqual([sim.get('source_x'), sim.get('fuel_power')], [-0.1, 50]);
  sim.set('fuel_power', 70);
  assert.equal(sim.objects[0].power, 70);
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
  // An object without an id is the one in its place.
  sim.objects = [source({ x: 0.1 }), source({ power: 30 })];
  assert.deepEqual(
    sim.objects.map(({ id }) => id),
    [2, 9],
  );
  sim.set({ wind: 1, objects: [source({ y: 0.4 })] });
  assert.deepEqual([sim.objects.length, sim.get('wind'), sim.get('source_height')], [1, 1, 0.4]);
  sim.objects = [];
  assert.deepEqual(sim.objects, []);
  sim.step(20);
  sim.restore('objects');
  assert.deepEqual(
    sim.objects.map(({ id, y }) => [id, y]),
    [[10, 0.4]],
  );
  sim.restore();
  const [first] = (await createSimulation()).objects;
  assert.deepEqual(sim.objects, [{ ...first, id: 11 }]);
});

test('parameters of the source and properties of the first source start the same fire', async () => {
  const preset = 'ghost-fire';
  const [parameters, properties] = await Promise.all([
    createSimulation({ preset, params: { wind: 0.5, fuel_power: 30, source_x: 0.05 } }),
    createSimulation({ preset, params: { wind: 0.5 }, objects: [source({ power: 30, x: 0.05 })] }),
  ]);
  for (const sim of [parameters, properties]) sim.step(20);
  assert.deepEqual(everything(parameters), everything(properties));
  assert.deepEqual(parameters.objects, properties.objects);
});

test('of a parameter and a property of the first source, the later one wins', async () => {
  const params = { fuel_power: 100 };
  const objects = [source({ power: 50 })];
  for (const [options, power] of [
    [{ params, objects }, 50],
    [{ objects, params }, 100],
  ]) {
    assert.equal((await createSimulation(options)).get('fuel_power'), power);
    const sim = await createSimulation();
    sim.set(
      Object.fromEntries(
        Object.entries(options).flatMap(([name, value]) =>
          name === 'params' ? Object.entries(value) : [[name, value]],
        ),
      ),
    );
    assert.equal(sim.get('fuel_power'), power);
  }
});

test('two sources heat the gas where they stand', async () => {
  for (const model of ['combustion', 'classic']) {
    const sim = await createSimulation({
      params: { model, [model === 'classic' ? 'max_particles' : 'particles']: 1500 },
      objects: [source({ x: -0.3, width: 0.2 }), source({ x: 0.3, width: 0.2 })],
    });
    while (sim.time < 0.3) sim.step();
    const positions = sim.positions();
    const hot = [...sim.temperatures()].map((kelvin, i) => (kelvin > 600 ? positions[2 * i] : 0));
    assert.ok(hot.some((x) => x < -0.1) && hot.some((x) => x > 0.1), model);
  }
});

test('an invalid object changes nothing, and the error names its property', async () => {
  const sim = await createSimulation();
  sim.addObject(source({ x: 0.3 }));
  sim.step(10);
  const before = [everything(sim), sim.objects];
  const cases = [
    [() => sim.addObject({}), 'objects[2].kind', /must be source or solid/],
    [() => sim.addObject({ kind: 'stone' }), 'objects[2].kind', /"stone"/],
    [() => sim.addObject({ kind: 'solid', shape: 'cone' }), 'objects[2].shape', /circle/],
    [() => sim.addObject({ kind: 'solid', width: -1 }), 'objects[2].width', /0.002 to 10 m/],
    [() => sim.addObject(source({ id: 1 })), 'objects[2].id', /no other object/],
    [
      () => sim.addObject(source({ pwer: 9 })),
      'objects[2].property',
      /one of name, enabled, shape, solid, x, y, angle, width, power/,
    ],
    [() => sim.changeObject(2, { x: 9 }), 'objects[1].x', /from -3 to 3 m/],
    [() => sim.changeObject(2, { x: {} }), 'objects[1].x', /an object/],
    [() => sim.changeObject(7, { x: 0 }), 'id', /id of an object/],
    [() => sim.removeObject(7), 'id', /id of an object/],
    [() => sim.set({ wind: 1, objects: [source(), source({ power: -1 })] }), 'objects[1].power', /0 to 600/],
    [() => sim.set('objects', 5), 'objects', /an array of objects/],
    [
      () => sim.set('objects', Array.from({ length: 65 }, source)),
      'objects',
      /65 sources is refused: it must be at most 64 sources/,
    ],
    [() => sim.changeObject(1.5, {}), 'id', /whole number from 1 to 1000000/],
    [() => sim.removeObject('1'), 'id', /whole number/],
  ];
  for (const [act, id, words] of cases) {
    const error = thrown(RangeError, act);
    assert.equal(error.id, id);
    assert.match(error.message, words);
    assert.equal(error.errors[0].id, id);
  }
  const loop = source();
  loop.objects = [loop];
  const own = new Error('mine');
  thrown(RangeError, () => sim.set('objects', [loop]));
  thrown(RangeError, () => sim.set('objects', Array.from({ length: 2000 }, source)));
  for (const bad of [
    [5],
    [null],
    [[source()]],
    [new Map()],
    new Proxy([], {
      get() {
        throw own;
      },
    }),
  ]) {
    thrown(TypeError, () => sim.set('objects', bad));
  }
  for (const bad of [undefined, null, 5, [], [source()]]) thrown(TypeError, () => sim.addObject(bad));
  assert.deepEqual([everything(sim), sim.objects], before);
  assert.match(
    (await rejected(RangeError, createSimulation({ objects: [source({ x: 9 })] }))).message,
    /objects\[0\].x = 9/,
  );
  assert.match(
    (await rejected(TypeError, createSimulation({ params: { objects: [] }, objects: [] }))).message,
    /given twice/,
  );
});
