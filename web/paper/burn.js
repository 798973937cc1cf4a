/** Burns a fire without a picture, for numbers in a text. The same seed gives the same numbers everywhere. */

import { createSimulation } from '../sim.js';

/** The fire's own time over which is averaged [s]. */
const FROM = 1;
const TO = 3;

/** Steps between two samples. */
const STEPS = 12;

/**
 * Samples a fire during its second and third second.
 * @param {import('../sim.js').SimulationOptions} options
 * @param {() => Promise<unknown>} pause  Lets others run; throws once the result is no longer needed.
 * @param {(sim: import('../sim.js').Simulation) => void} sample
 */
export async function burn(options, pause, sample) {
  const sim = /** @type {import('../sim.js').Simulation} */ (/** @type {unknown} */ (await createSimulation(options)));
  try {
    while (sim.time < TO) {
      sim.step(STEPS);
      await pause();
      if (sim.time >= FROM) sample(sim);
    }
  } finally {
    sim.free();
  }
}
