/**
 * Readers: copies of all particles in the order of birth.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inspect } from 'node:util';
import { ARRAYS, PARAMETERS, createSimulation, everything, fires } from './library.mjs';

/** What only the gas of the combustion model has. */
const OF_MIXTURE = ['fuel', 'oxygen', 'soot', 'burnRates'];

test('every array of the model has finite numbers for every particle', async () => {
  for (const sim of await fires()) {
    // Open air reaches beyond its domain.
    sim.set('edges', 'periodic');
    sim.step(200);
    assert.ok(sim.count > 100 && sim.time > 0 && sim.stepLength > 0);
    const burns = sim.get('model') === 'combustion';
    for (const [name, width] of Object.entries(ARRAYS)) {
      const array = sim[name]();
      if (!burns && OF_MIXTURE.includes(name)) {
        assert.equal(array, undefined, name);
        continue;
      }
      assert.ok(array instanceof Float32Array);
      assert.equal(array.length, width * sim.count, name);
      assert.ok(
        array.every((number) => !Number.isNaN(number)),
        name,
      );
    }
    const [width, height] = [sim.get('domain_width'), sim.get('domain_height')];
    const inside = sim
      .positions()
      .every((at, i) => (i % 2 === 0 ? Math.abs(at) <= Math.fround(width / 2) : at >= 0 && at <= Math.fround(height)));
    assert.ok(inside, 'every particle is in the domain');
  }
});

test('a fire is hot, burns and emits embers; the classic one has neither power nor fuel', async () => {
  const [combustion, classic] = await fires();
  combustion.step(600);
  assert.ok(combustion.power > 0);
  assert.ok(combustion.temperatures().some((kelvin) => kelvin > 1000));
  assert.ok(combustion.burnRates().some((rate) => rate > 0));
  const embers = combustion.embers();
  assert.ok(embers.count > 0);
  for (const [name, width] of Object.entries({
    positions: 2,
    velocities: 2,
    temperatures: 1,
    sizes: 1,
    ages: 1,
    lifetimes: 1,
  })) {
    assert.equal(embers[name].length, width * embers.count, name);
  }
  assert.ok(embers.ages.every((age, i) => age >= 0 && age < embers.lifetimes[i]));
  assert.ok(embers.temperatures.every((kelvin) => kelvin > 250 && kelvin < 2000));
  assert.ok(embers.sizes.every((size) => size > 0 && size <= Math.fround(combustion.get('ember_size'))));
  classic.step(200);
  assert.equal(classic.power, 0);
  assert.equal(classic.embers().count, 0);
  assert.deepEqual(Object.keys(classic.particles()), ['positions', 'velocities', 'temperatures', 'ages', 'lifetimes']);
});

test('frames stand at exactly the time that is asked for', async () => {
  for (const sim of await fires()) {
    for (let frame = 1; frame <= 12; frame += 1) {
      const before = sim.time;
      sim.advance(1 / 30);
      assert.equal(sim.time, before + 1 / 30);
      assert.ok(Math.abs(sim.time - frame / 30) < 1e-14);
    }
    const { time } = sim;
    sim.advance(0);
    assert.equal(sim.time, time);
    sim.free();
  }
});

test('a console prints the state of a simulation, not how it is made', async () => {
  const [sim] = await fires();
  sim.advance(0.1);
  assert.equal(String(sim), '[object Simulation]');
  assert.match(inspect(sim), /^Simulation \(combustion, 0\.100 s, \d+ particles, \d+ kW\/m\)$/);
  sim.free();
  assert.equal(inspect(sim), 'Simulation (this simulation was freed)');
});

test('particles stay in the order of birth', async () => {
  const [combustion, classic] = await fires();
  classic.step(300);
  const ages = classic.ages();
  // Those of one step are born at different times of it, in any order; a step lasts 4 ms.
  const step = classic.stepLength;
  assert.ok(
    ages.every((age, i) => i === 0 || age <= ages[i - 1] + 1.01 * step),
    'the oldest come first',
  );
  const lifetimes = classic.lifetimes();
  classic.step();
  const known = new Set(classic.lifetimes());
  const survivors = lifetimes.filter((life) => known.has(life));
  assert.ok(survivors.length > 0.9 * lifetimes.length);
  assert.deepEqual(classic.lifetimes().slice(0, survivors.length), survivors);

  combustion.step(200);
  const before = combustion.positions();
  combustion.step();
  const height = combustion.get('domain_height');
  const moved = combustion.positions().map((at, i) => Math.abs(at - before[i]));
  const jumps = moved.filter((far) => far > 0.05 && far < 0.5 * height);
  assert.equal(jumps.length, 0, 'in a step a particle moves a little, or over an edge');
});

test('an id belongs to one particle for its life', async () => {
  for (const sim of await fires()) {
    /** Lifetime and number belong together; those of gas are all infinite. */
    const known = new Map();
    for (let i = 0; i < 100; i += 1) {
      sim.step(5);
      const ids = sim.ids();
      assert.ok(ids instanceof Float64Array);
      assert.equal(ids.length, sim.count);
      assert.ok(
        ids.every((id, at) => at === 0 || id > ids[at - 1]),
        'they rise',
      );
      sim.lifetimes().forEach((life, at) => {
        assert.equal(known.get(ids[at]) ?? life, life);
        known.set(ids[at], life);
      });
    }
    sim.setParticles(sim.particles());
    assert.deepEqual(
      sim.ids(),
      Float64Array.from({ length: sim.count }, (_, at) => at),
    );
  }
});

test('readers return copies that later steps do not change', async () => {
  for (const sim of await fires()) {
    sim.step(100);
    const [kept, changed] = [sim.positions(), sim.positions()];
    const copy = kept.slice();
    changed.fill(NaN);
    const { params } = sim;
    params.gravity = NaN;
    sim.embers().positions.fill(NaN);
    assert.deepEqual(sim.positions(), copy);
    assert.notEqual(sim.params.gravity, NaN);
    sim.step(100);
    assert.deepEqual(kept, copy);
    assert.notDeepEqual(sim.positions(), copy);
  }
});

test('all parameters have the defaults of the table', async () => {
  const sim = await createSimulation();
  const defaults = PARAMETERS.map((parameter) => [parameter.id, parameter.default]);
  assert.deepEqual(sim.params, Object.fromEntries(defaults));
  for (const { id } of PARAMETERS) assert.equal(sim.get(id), sim.params[id]);
});

test('zero steps change nothing', async () => {
  for (const sim of await fires()) {
    sim.step(3);
    const before = everything(sim);
    sim.step(0);
    assert.deepEqual(everything(sim), before);
    const { time } = sim;
    sim.step();
    assert.ok(Math.abs(sim.time - time - sim.stepLength) < 1e-9);
  }
});

test('a free solid falls, turns and comes to rest', async () => {
  for (const sim of await fires()) {
    sim.set({ floor: 'solid', walls: 'solid' });
    const id = sim.addObject({
      kind: 'solid',
      shape: 'box',
      x: 0.3,
      y: 0.4,
      angle: 20,
      width: 0.2,
      height: 0.1,
      motion: 'free',
    });
    const start = sim.freeSolids();
    assert.equal(start.length, 1);
    const [{ x, y, angle, u, v, asleep }] = start;
    assert.ok(Math.abs(x - 0.3) < 1e-6 && Math.abs(y - 0.4) < 1e-6 && Math.abs(angle - 20) < 1e-3);
    assert.deepEqual([start[0].id, u, v, asleep], [id, 0, 0, false]);
    assert.ok(Math.abs(start[0].mass - 500 * 0.02) < 0.01, `${start[0].mass} kg/m`);
    while (sim.time < 0.1) sim.step();
    assert.ok(sim.freeSolids()[0].v < -0.5);
    while (sim.time < 4) sim.step();
    const [rest] = sim.freeSolids();
    assert.ok(rest.asleep && Math.abs(rest.y - 0.05) < 0.003 && Math.abs(rest.angle) < 1, JSON.stringify(rest));
    assert.equal(sim.objects.at(-1).y, 0.4);
  }
});

test('a free solid that burns through is read as its object and a fragment', async () => {
  const sim = await createSimulation({ params: { spacing: 0.06, max_particles: 1500, gravity: 0, fuel_power: 0 } });
  const id = sim.addObject({
    kind: 'solid',
    shape: 'box',
    y: 0.8,
    width: 0.8,
    height: 0.04,
    motion: 'free',
    fuel: 'paper',
    load: 0.6,
    moisture: 0,
  });
  const [whole] = sim.freeSolids();
  assert.equal(whole.object, id);
  const objects = structuredClone(sim.objects);
  sim.ignite(0, 0.8, 0.07);
  while (sim.freeSolids().length < 2 && sim.time < 3) sim.step();
  const [original, fragment] = sim.freeSolids();
  assert.deepEqual([original.id, original.object, fragment.object], [id, id, id]);
  assert.ok(fragment.id > 1e6 && fragment.mass < 0.5 * whole.mass && original.mass < 0.5 * whole.mass);
  assert.equal(sim.fuels().length, 1);
  assert.deepEqual(sim.objects, objects);
  sim.reset();
  assert.deepEqual(sim.freeSolids(), [whole]);
});

test('a spray puts a fire out; values out of range and the classic model are refused with a message', async () => {
  const [combustion, classic] = await fires();
  combustion.set({ edges: 'open', floor: 'solid', ember_rate: 0 });
  combustion.step(200);
  assert.ok(combustion.power > 10);
  for (let call = 0; call < 60; call += 1) {
    combustion.spray(0, 1, 0, -4, 60);
    combustion.step(8);
  }
  combustion.step(200);
  assert.ok(combustion.power < 1, `${combustion.power} kW/m`);
  assert.throws(() => combustion.spray(Number.NaN, 1), RangeError);
  const refused = { name: 'RangeError', message: /model = "classic" is refused: it must be combustion/ };
  assert.throws(() => classic.spray(0, 0.5), refused);
});
