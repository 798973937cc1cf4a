/**
 * A hash of every bit of a fire: time, particles and embers. `tests/src/lib.rs` computes the
 * same hash natively. It runs in Node and on a page.
 */

/**
 * @param {any} sim
 * @returns {string} 16 hexadecimal digits
 */
export function fingerprint(sim) {
  const { positions, velocities, temperatures, ages, lifetimes, fuel, oxygen, soot } = sim.particles();
  const numbers = [];
  for (let i = 0; i < sim.count; i += 1) {
    const [x, y] = [2 * i, 2 * i + 1];
    numbers.push(positions[x], positions[y], velocities[x], velocities[y]);
    // A particle of the classic model has the mixture of air natively.
    numbers.push(temperatures[i], ages[i], lifetimes[i], fuel?.[i] ?? 0, oxygen?.[i] ?? 1, soot?.[i] ?? 0);
  }
  const embers = sim.embers();
  for (let i = 0; i < embers.count; i += 1) {
    const [x, y] = [2 * i, 2 * i + 1];
    const { positions: at, velocities: flies } = embers;
    numbers.push(at[x], at[y], flies[x], flies[y], embers.temperatures[i], embers.sizes[i]);
    // What the renderer gets natively: its age, and how much of its life is left.
    const lived = Math.fround(embers.ages[i] / embers.lifetimes[i]);
    numbers.push(embers.ages[i], Math.fround(1 - lived));
  }
  const hash = fnv(
    new Uint8Array(Float32Array.from(numbers).buffer),
    fnv(new Uint8Array(Float64Array.of(sim.time).buffer)),
  );
  return hash.toString(16).padStart(16, '0');
}

/** FNV-1a with 64 bits. */
export function fnv(/** @type {Uint8Array} */ bytes, hash = 0xcbf29ce484222325n) {
  for (const byte of bytes) {
    hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
  }
  return hash;
}

/**
 * A run of every method of the library in both models, to compare Node with a page.
 * @param {(options?: object) => Promise<any>} createSimulation
 * @returns {Promise<string[]>} the fingerprint after each part
 */
export async function burnEverything(createSimulation) {
  const prints = [];
  for (const model of ['combustion', 'classic']) {
    const number = model === 'classic' ? 'max_particles' : 'particles';
    const sim = await createSimulation({ model, seed: 7, params: { [number]: 1000, turbulence: 2 } });
    sim.step(200);
    prints.push(fingerprint(sim));
    sim.set({ gravity: 5, buoyancy: 0.4 });
    sim.set(number, 1500);
    sim.step(100);
    prints.push(fingerprint(sim));
    const particles = sim.particles();
    for (let i = 0; i < sim.count; i += 3) particles.velocities[2 * i + 1] = 1.5;
    sim.setParticles(particles);
    sim.step(100);
    prints.push(fingerprint(sim));
    sim.restore();
    sim.reset();
    sim.step(10);
    prints.push(fingerprint(sim));
    sim.free();
  }
  return prints;
}
