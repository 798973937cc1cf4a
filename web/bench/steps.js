/**
 * Steps with nothing to draw: Hearth's, by the headless library, and those of the paper's loop.
 *
 * @typedef {object} Stepper
 * @property {(steps: number) => void} step
 * @property {() => void} rewind
 */

import { createSimulation } from '../sim.js';
import { PaperLoop } from './paper-loop.js';

/** Batches whose median is the result. */
const BATCHES = 7;
/** Least time of a batch [ms]: browsers' clocks are as coarse as a millisecond. */
const BATCH_MS = 40;
/** Most steps of a batch: a square of gas at rest drifts apart. */
const MOST_STEPS = 1000;
/** Steps before anything is measured, for code that is still being compiled. */
const WARM_STEPS = 3;

/** Steps of the combustion model after which its number of particles is steady. */
const COMBUSTION_STEPS = 100;
/** Largest deviation of its mean number of particles. */
const TOLERANCE = 0.05;

/** The square of gas: as in the project's own benchmarks. */
const SMOOTHING = 0.012;
const REST_DENSITY = 2;
const NEIGHBOURS = 20;
const SPACING = 2 * SMOOTHING * Math.sqrt(Math.PI / (NEIGHBOURS + 1));
/** Space around the square, in distances of particles. */
const MARGIN = 6;

const GAS = {
  smoothing: SMOOTHING,
  mass: REST_DENSITY * SPACING * SPACING,
  restDensity: REST_DENSITY,
  ambientDensity: 1.2,
  gasConstant: 0.6,
  viscosity: 0.001,
  buoyancy: 0.12,
  gravity: 0,
  timeStep: 1 / 480,
};

/** Particles on a lattice, in a square above the floor: x and y of each [m]. @param {number} count */
function square(count) {
  const columns = Math.ceil(Math.sqrt(count));
  return Float32Array.from({ length: 2 * count }, (_, at) => {
    const one = at >> 1;
    return SPACING * (at % 2 === 0 ? (one % columns) - 0.5 * (columns - 1) : Math.floor(one / columns) + MARGIN);
  });
}

/**
 * A step of the classic model with exactly so many particles [ms].
 * @param {number} count
 * @param {() => Promise<void>} pause
 */
export async function classicStep(count, pause) {
  const positions = square(count);
  const side = SPACING * (Math.ceil(Math.sqrt(count)) + 2 * MARGIN);
  const sim = await createSimulation({
    model: 'classic',
    params: {
      domain_width: side,
      domain_height: side,
      smoothing_radius: GAS.smoothing,
      rest_density: GAS.restDensity,
      particle_mass: GAS.mass,
      gas_constant: GAS.gasConstant,
      viscosity: GAS.viscosity,
      gravity: GAS.gravity,
      time_step: GAS.timeStep,
      walls: 'solid',
      // Nothing is born.
      max_particles: 100,
    },
  });
  try {
    const rewind = () => sim.setParticles({ positions, temperatures: 1000, lifetimes: 1e6 });
    const ms = await median({ step: (steps) => sim.step(steps), rewind }, pause);
    if (sim.count !== count) throw new Error(`${sim.count} of ${count} particles are left`);
    return ms;
  } finally {
    sim.free();
  }
}

/**
 * A step of the combustion model with about so many particles [ms], and their mean number.
 * @param {number} count
 * @param {() => Promise<void>} pause
 */
export async function combustionStep(count, pause) {
  const sim = await createSimulation({ model: 'combustion', params: { edges: 'periodic', max_particles: count } });
  try {
    for (let left = COMBUSTION_STEPS; left > 0; left -= 10) {
      sim.step(10);
      await pause();
    }
    /** @type {number[]} */
    const counts = [];
    const step = (/** @type {number} */ steps) => {
      sim.step(steps);
      counts.push(sim.count);
    };
    const ms = await median({ step, rewind: () => {} }, pause);
    const alive = counts.reduce((sum, one) => sum + one, 0) / counts.length;
    if (Math.abs(alive - count) > TOLERANCE * count) {
      throw new Error(`${alive} particles burn instead of ${count}`);
    }
    return { ms, alive };
  } finally {
    sim.free();
  }
}

/**
 * A loop of the paper with exactly so many particles [ms].
 * @param {number} count
 * @param {() => Promise<void>} pause
 */
export function paperStep(count, pause) {
  const loop = new PaperLoop(GAS, square(count));
  const step = (/** @type {number} */ steps) => {
    for (let left = steps; left > 0; left -= 1) loop.step();
  };
  return median({ step, rewind: () => loop.rewind() }, pause);
}

/**
 * The median time of a step [ms].
 * @param {Stepper} fire
 * @param {() => Promise<void>} pause  Lets the page show something; throws once it is cancelled.
 */
async function median({ step, rewind }, pause) {
  rewind();
  step(WARM_STEPS);
  let batch = 1;
  /** @type {number[]} */
  const times = [];
  while (times.length < BATCHES) {
    await pause();
    rewind();
    const start = performance.now();
    step(batch);
    const time = performance.now() - start;
    if (time < BATCH_MS && batch < MOST_STEPS) batch = Math.min(2 * batch, MOST_STEPS);
    else times.push(time / batch);
  }
  return times.sort((a, b) => a - b)[times.length >> 1];
}
