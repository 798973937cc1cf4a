/**
 * Particles that are put in: exactly, or not at all.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createSimulation, everything, fires } from './library.mjs';

/** Positions of particles, evenly distributed over the default domain. */
function lattice(side) {
  return Float32Array.from({ length: 2 * side * side }, (_, at) => {
    const i = Math.floor(at / 2);
    return at % 2 === 0 ? 1.1 * ((i % side) / side - 0.45) : 1.4 * (Math.floor(i / side) / side) + 0.05;
  });
}

test('particles that are read can be put in again to the last bit', async () => {
  for (const sim of await fires()) {
    sim.step(150);
    const particles = sim.particles();
    sim.setParticles(particles);
    assert.deepEqual(sim.particles(), particles);
    const again = await createSimulation({ params: sim.params });
    again.setParticles(particles);
    const { ages, ...rest } = again.particles();
    const { ages: known, ...read } = particles;
    assert.deepEqual(rest, read);
    // The gas of the combustion model is as old as the fire.
    assert.deepEqual(ages, sim.get('model') === 'classic' ? known : new Float32Array(again.count));
  }
});

test('particles that are put in burn the same in every simulation', async () => {
  for (const model of ['combustion', 'classic']) {
    const positions = lattice(32);
    const sims = await Promise.all(
      [0, 1].map(() =>
        createSimulation({ params: { model, [model === 'classic' ? 'max_particles' : 'particles']: 1000 } }),
      ),
    );
    for (const sim of sims) {
      sim.step(20);
      sim.setParticles({ positions, temperatures: 1500, lifetimes: 5 });
      assert.equal(sim.count, 1024);
      assert.deepEqual(sim.positions(), positions);
      assert.ok(sim.velocities().every((speed) => speed === 0));
      assert.ok(sim.temperatures().every((kelvin) => kelvin === 1500));
      assert.ok(model === 'classic' || sim.oxygen().every((share) => share === 1));
    }
    for (const sim of sims) sim.step(50);
    assert.notDeepEqual(sims[0].positions().slice(0, positions.length), positions);
    assert.deepEqual(sims[0].positions(), sims[1].positions());
  }
});

test('arrays of every kind are accepted, and missing properties are those of air at rest', async () => {
  const floats = lattice(32);
  for (const positions of [floats, Float64Array.from(floats), Array.from(floats)]) {
    const [sim] = await fires({ ambient_temperature: 280 });
    sim.setParticles({ positions, velocities: undefined });
    assert.deepEqual(sim.positions(), floats);
    assert.ok(sim.temperatures().every((kelvin) => kelvin === 280));
    assert.ok(sim.soot().every((amount) => amount === 0));
  }
  const [, classic] = await fires();
  classic.setParticles({ positions: [] });
  assert.equal(classic.count, 0);
  classic.setParticles({ positions: [0, 1], temperatures: new Uint16Array([900]) });
  assert.deepEqual([...classic.temperatures()], [900]);
});

test('invalid particles are errors and change nothing', async () => {
  const positions = lattice(32);
  const some = (at, value) => Object.assign(new Float32Array(1024).fill(0.5), { [at]: value });
  const own = new Error('mine');
  const hostile = new Proxy([], {
    get() {
      throw own;
    },
  });
  const shrinking = () => {
    const array = Array.from(positions);
    return Object.defineProperty(array, 0, {
      get() {
        array.length = 1;
        return 0;
      },
    });
  };
  const wrong = () => [
    [undefined, /particles must be a plain object, not undefined/],
    [[], /particles must be a plain object, not an array/],
    [{}, /positions must be an array of numbers, not undefined/],
    [{ positions: 5 }, /positions must be an array of numbers, not 5/],
    [{ positions: '0 1' }, /positions must be an array of numbers/],
    [{ positions: new DataView(new ArrayBuffer(8)) }, /positions must be an array of numbers/],
    [{ positions: [0, 1, 2] }, /positions has 3 numbers: it must have two for each particle/],
    [{ positions, velocities: [0, 1] }, /velocities has 2 numbers: it must have two for each of 1024 particles/],
    [{ positions, fuel: positions }, /fuel has 2048 numbers: it must have one for each of 1024 particles/],
    [{ positions, ages: null }, /ages must be an array of numbers, not null/],
    [{ positions, speeds: 1 }, /no property of particles "speeds"; there are positions, velocities/],
    [JSON.parse('{"positions": [0, 1], "__proto__": [1]}'), /no property of particles "__proto__"/],
    [{ positions, soot: some(7, NaN) }, /particle 7 is refused: soot/],
    [{ positions, soot: some(1023, -1) }, /particle 1023 is refused: soot/],
    [{ positions, fuel: 1.5 }, /particle 0 is refused: fuel and oxygen must be from 0 to 1/],
    [{ positions, oxygen: NaN }, /particle 0 is refused: fuel and oxygen/],
    [{ positions, temperatures: some(3, Infinity) }, /particle 0 is refused: temperature/],
    [{ positions, temperatures: 0 }, /temperature must be from 1 to 100000 K/],
    [{ positions, velocities: 900 }, /velocity must be at most 1000 m\/s/],
    [{ positions, velocities: 1e40 }, /velocity must be at most 1000 m\/s/],
    [{ positions, ages: 2, lifetimes: 1 }, /age must be at least 0 and less than the lifetime/],
    [{ positions: positions.map((at, i) => (i === 9 ? 50 : at)) }, /particle 4 is refused: position/],
    [{ positions: Array.from(positions, (at, i) => (i === 9 ? NaN : at)) }, /particle 4 is refused: position/],
    [{ positions: Array.from(positions, (at, i) => (i === 9 ? '0' : at)) }, /positions\[9\] must be a number, not "0"/],
    [{ positions: new BigInt64Array(2048) }, /positions\[0\] must be a number, not a big integer/],
    [{ positions: new Array(2048) }, /positions\[0\] must be a number, not undefined/],
    [{ positions: new Array(2 ** 32 - 2) }, /there may be 400000 of them at most/],
    [{ positions: hostile }, /positions cannot be read/],
    [{ positions: shrinking() }, /must be a number, not undefined/],
    [
      {
        get positions() {
          throw own;
        },
      },
      /particles cannot be read/,
    ],
  ];
  for (const sim of await fires()) {
    sim.step(30);
    const before = everything(sim);
    for (const [particles, words] of wrong()) {
      assert.throws(
        () => sim.setParticles(particles),
        (error) => {
          assert.ok(error instanceof RangeError || error instanceof TypeError, `${error}`);
          assert.match(error.message, words);
          return true;
        },
      );
    }
    assert.throws(() => sim.setParticles({ positions, soot: some(7, NaN) }), { index: 7 });
    assert.deepEqual(everything(sim), before);
  }
});

test('in a closed domain of the combustion model their number must match particles', async () => {
  const [sim] = await fires();
  sim.set({ edges: 'periodic', particles: 1000 });
  for (const side of [10, 50]) {
    assert.throws(
      () => sim.setParticles({ positions: lattice(side) }),
      /there must be from half to twice particles of them/,
    );
  }
  sim.set('particles', 2500);
  sim.setParticles({ positions: lattice(50) });
  assert.equal(sim.count, 2500);
});
