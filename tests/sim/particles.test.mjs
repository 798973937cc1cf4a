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
  const wrong = () => [
    [undefined, /particles must be a plain object, not undefined/],
    [[], /particles must be a plain object, not an array/],
    [{}, /positions must be an array of numbers, not undefined/],
    [{ positions: 5 }, /positions must be an array of numbers, not 5/],
    [{ positions: new DataView(new ArrayBuffer(8)) }, /positions must be an array of numbers/],
    [{ positions: [0, 1, 2] }, /positions has 3 numbers: it must have two for each particle/],
    [{ positions, velocities: [0, 1] }, /velocities has 2 numbers: it must have two for each of 1024 particles/],
    [{ positions, ages: null }, /ages must be an array of numbers, not null/],
    [{ positions, speeds: 1 }, /no property of particles "speeds"; there are positions, velocities/],
    [{ positions, soot: some(7, NaN) }, /particle 7 is refused: soot/],
    [{ positions, fuel: 1.5 }, /particle 0 is refused: fuel and oxygen must be from 0 to 1/],
    [{ positions, temperatures: some(3, Infinity) }, /particle 0 is refused: temperature/],
    [{ positions, velocities: 1e40 }, /velocity must be at most 1000 m\/s/],
    [{ positions, ages: 2, lifetimes: 1 }, /age must be at least 0 and less than the lifetime/],
    [{ positions: Array.from(positions, (at, i) => (i === 9 ? NaN : at)) }, /particle 4 is refused: position/],
    [{ positions: Array.from(positions, (at, i) => (i === 9 ? '0' : at)) }, /positions\[9\] must be a number, not "0"/],
    [{ positions: new Array(2048) }, /positions\[0\] must be a number, not undefined/],
    [{ positions: new Array(2 ** 32 - 2) }, /there may be 400000 of them at most/],
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
