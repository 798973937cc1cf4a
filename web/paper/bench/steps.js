/**
 * Steps with nothing to draw: Hearth's, by the headless library, and those of the paper's loop.
 *
 * @typedef {object} Stepper
 * @property {(steps: number) => void} step
 * @property {() => void} rewind
 */

import { createSimulation } from '../../sim.js';
import { GAS, MASS, SPACING } from './gas.js';
import { PaperLoop } from './paper-loop.js';

/** Batches of each program whose median is the result. */
const BATCHES = 11;
/** Least time of a batch [ms]: browsers' clocks are as coarse as a millisecond. */
const BATCH_MS = 40;
/** Most steps of a batch: a square of gas at rest drifts apart. */
const MOST_STEPS = 1000;
/** How long a program runs before it is measured [ms], for code that is still being compiled. */
const WARM_MS = 300;
/** How long nothing runs before a row [ms]: the fire of the last one still uses the processor when it is removed. */
const REST_MS = 500;

/** Steps of the combustion model after which its number of particles is steady. */
const COMBUSTION_STEPS = 100;
/** Largest deviation of its mean number of particles. */
const TOLERANCE = 0.05;

/** Space around the square, in distances of particles. */
const MARGIN = 6;

/** Particles on a lattice, in a square above the floor: x and y of each [m]. @param {number} count */
function square(count) {
  const columns = Math.ceil(Math.sqrt(count));
  return Float32Array.from({ length: 2 * count }, (_, at) => {
    const cell = at >> 1;
    return SPACING * (at % 2 === 0 ? (cell % columns) - 0.5 * (columns - 1) : Math.floor(cell / columns) + MARGIN);
  });
}

/**
 * A step of the classic model with exactly so many particles [ms] and, unless it would take too long, a loop of the
 * paper with the same particles.
 * @param {number} count
 * @param {boolean} paper  Whether the paper's loop runs beside it.
 * @param {() => Promise<void>} pause
 */
export async function classicSteps(count, paper, pause) {
  const positions = square(count);
  const side = SPACING * (Math.ceil(Math.sqrt(count)) + 2 * MARGIN);
  const sim = await createSimulation({
    model: 'classic',
    params: {
      domain_width: side,
      domain_height: side,
      smoothing_radius: GAS.h,
      rest_density: GAS.restDensity,
      particle_mass: MASS,
      gas_constant: GAS.gasConstant,
      viscosity: GAS.viscosity,
      gravity: GAS.gravity,
      time_step: GAS.timeStep,
      // The paper's loop has no walls either.
      walls: 'open',
      // Nothing is born.
      max_particles: 100,
    },
  });
  try {
    const rewind = () => sim.setParticles({ positions, temperatures: 1000, lifetimes: 1e6 });
    const fires = [{ step: (/** @type {number} */ steps) => sim.step(steps), rewind }];
    if (paper) fires.push(paperStepper(positions));
    const [stepMs, paperMs] = await medians(fires, pause);
    if (sim.count !== count) throw new Error(`${sim.count} of ${count} particles are left`);
    return { alive: count, stepMs, paperMs };
  } finally {
    sim.free();
  }
}

/** The paper's loop with particles there. @param {Float32Array} positions */
function paperStepper(positions) {
  const loop = new PaperLoop({ positions });
  return {
    step: (/** @type {number} */ steps) => {
      for (let left = steps; left > 0; left -= 1) loop.step();
    },
    rewind: () => loop.rewind(),
  };
}

/**
 * A step of the combustion model with about so many particles [ms], and their mean number.
 * @param {number} count
 * @param {() => Promise<void>} pause
 */
export async function combustionSteps(count, pause) {
  const sim = await createSimulation({ model: 'combustion', params: { edges: 'periodic', particles: count } });
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
    const [stepMs] = await medians([{ step, rewind: () => {} }], pause);
    const alive = counts.reduce((sum, count) => sum + count, 0) / counts.length;
    if (Math.abs(alive - count) > TOLERANCE * count) {
      throw new Error(`${alive} particles burn instead of ${count}`);
    }
    return { alive, stepMs };
  } finally {
    sim.free();
  }
}

/**
 * The median times of a step of each [ms]. They run in turn, a batch of each, so that fast and slow phases of a
 * machine affect all of them.
 * @param {Stepper[]} fires
 * @param {() => Promise<void>} pause  Lets the page show something; throws once it is cancelled.
 */
async function medians(fires, pause) {
  await new Promise((resolve) => setTimeout(resolve, REST_MS));
  /** @type {{fire: Stepper, batch: number, times: number[]}[]} */
  const all = [];
  for (const fire of fires) all.push({ fire, batch: await warmed(fire, pause), times: [] });
  for (let round = 0; round < BATCHES; round += 1) {
    for (const { fire, batch, times } of all) {
      await pause();
      times.push(timed(fire, batch) / batch);
    }
  }
  return all.map(({ times }) => times.sort((a, b) => a - b)[times.length >> 1]);
}

/** The time of so many steps [ms]. @param {Stepper} fire @param {number} steps */
function timed({ step, rewind }, steps) {
  rewind();
  const start = performance.now();
  step(steps);
  return performance.now() - start;
}

/**
 * Runs a fire warm, and returns how many steps of it make a batch.
 * @param {Stepper} fire
 * @param {() => Promise<void>} pause
 */
async function warmed(fire, pause) {
  let batch = 1;
  for (let all = 0; all < WARM_MS; ) {
    await pause();
    const time = timed(fire, batch);
    all += time;
    if (time < BATCH_MS) batch = Math.min(2 * batch, MOST_STEPS);
  }
  return batch;
}
