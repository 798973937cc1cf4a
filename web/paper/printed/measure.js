/** Means of the paper's fire, with or without an equation as printed. */

import { burn } from '../burn.js';

/**
 * Mean density [kg/m³], mean speed and root mean square of the sideways speed [m/s].
 * @param {string} flag  The parameter of the equation as printed; empty for none.
 * @param {() => Promise<unknown>} pause  Lets others run.
 */
export async function measure(flag, pause) {
  const params = flag ? { [flag]: true } : {};
  const sum = { particles: 0, density: 0, speed: 0, square: 0 };
  await burn({ preset: 'paper-fire', params }, pause, (sim) => {
    const velocities = sim.velocities();
    for (const [at, density] of sim.densities().entries()) {
      const [u, v] = [velocities[2 * at], velocities[2 * at + 1]];
      sum.particles += 1;
      sum.density += density;
      sum.speed += Math.sqrt(u * u + v * v);
      sum.square += u * u;
    }
  });
  const { particles, density, speed, square } = sum;
  return { density: density / particles, speed: speed / particles, sideways: Math.sqrt(square / particles) };
}
