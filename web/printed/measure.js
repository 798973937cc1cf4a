/** Means of the paper's fire, with or without an equation as printed. The same seed gives the same numbers everywhere. */

import { createSimulation } from '../sim.js';

/** The fire's own time over which is averaged [s]. */
const FROM = 1;
const TO = 3;

/** Steps between two looks. */
const STEPS = 12;

/**
 * Mean density [kg/m³], mean speed and root mean square of the sideways speed [m/s].
 * @param {string} flag  The parameter of the equation as printed; empty for none.
 * @param {() => Promise<unknown>} pause  Lets others run.
 */
export async function measure(flag, pause) {
  const params = flag ? { [flag]: true } : {};
  const sim = await createSimulation({ preset: 'paper-fire', params });
  const sum = { particles: 0, density: 0, speed: 0, square: 0 };
  try {
    while (sim.time < TO) {
      sim.step(STEPS);
      await pause();
      if (sim.time < FROM) continue;
      const velocities = sim.velocities();
      for (const [at, density] of sim.densities().entries()) {
        const [u, v] = [velocities[2 * at], velocities[2 * at + 1]];
        sum.particles += 1;
        sum.density += density;
        sum.speed += Math.sqrt(u * u + v * v);
        sum.square += u * u;
      }
    }
  } finally {
    sim.free();
  }
  const { particles, density, speed, square } = sum;
  return { density: density / particles, speed: speed / particles, sideways: Math.sqrt(square / particles) };
}
