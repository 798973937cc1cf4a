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

test('embers, free solids, fuels and the power are read by name', async () => {
  const [combustion, classic] = await fires();
  combustion.step(600);
  assert.ok(combustion.power > 0);
  const { count, ...embers } = combustion.embers();
  assert.ok(count > 0);
  for (const [name, array] of Object.entries(embers))
    assert.equal(array.length, (/^(positions|velocities)$/.test(name) ? 2 : 1) * count, name);
  classic.step(20);
  assert.deepEqual([classic.power, classic.embers().count], [undefined, 0]);
  assert.deepEqual(Object.keys(classic.particles()), ['positions', 'velocities', 'temperatures', 'ages', 'lifetimes']);
  const box = { kind: 'solid', shape: 'box', x: 0.3, y: 0.4, angle: 20, width: 0.2, height: 0.1, motion: 'free' };
  const id = combustion.addObject({ ...box, fuel: 'wood' });
  const [{ x, angle, mass, ...solid }] = combustion.freeSolids();
  assert.ok(Math.abs(x - 0.3) < 1e-6 && Math.abs(angle - 20) < 1e-3 && mass > 0);
  assert.deepEqual([solid.id, solid.object, solid.u, solid.asleep], [id, id, 0, false]);
  assert.equal(combustion.fuels().length, 1);
  combustion.ignite(id);
  combustion.extinguish(id);
  combustion.spray(0, 1, 0, -4, 60);
  assert.throws(() => combustion.spray(Number.NaN, 1), RangeError);
  const refused = { name: 'RangeError', message: /model = "classic" is refused: it must be combustion/ };
  assert.throws(() => classic.spray(0, 0.5), refused);
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
