/**
 * Sets up and times the cases, in a page and in Node.
 *
 * The speed of a machine varies over time, so the caller measures a round of all cases,
 * and repeats the rounds.
 */
import { ScanFire } from './scan.mjs';
import { TypedFire } from './typed.mjs';
import { PaperLoop } from '../../web/paper/bench/paper-loop.js';

/**
 * @typedef {object} Case
 * @property {string} scene  block, plume or combustion; typed, scan or paper: a block in JavaScript.
 * @property {number} count
 * @property {number} [neighbours]  Of a block.
 * @property {number} [stiffness]  Of combustion.
 */

/** Time that a round of one case takes, at least [ms]. */
const ROUND_MS = 150;
/** Ticks of the clock between two looks at it, at least; browsers' clocks tick coarsely. */
const TICKS = 100;
/** Batches in a round, at least. */
const BATCHES = 3;
/** Steps after which a fire goes back to its start: a block drifts apart. */
const STEPS = 100;

const BASELINES = { typed: TypedFire, scan: ScanFire, paper: PaperLoop };

/** All cases of one place. */
export class Bench {
  /** @param {typeof import('hearth_benches')} module  The wasm module. */
  constructor(module) {
    this.module = module;
    this.fires = new Map();
    this.batchMs = TICKS * tick();
  }

  /**
   * Sets a case up and lets it run warm; returns the error where it is refused.
   * @param {string} id
   * @param {Case} what
   * @returns {string | undefined}
   */
  prepare(id, what) {
    try {
      this.fires.set(id, what.scene in BASELINES ? this.baseline(what) : this.scene(what));
    } catch (error) {
      return String(error);
    }
    this.round(id);
    return undefined;
  }

  /** @param {Case} what */
  scene({ scene, count, neighbours = 20, stiffness = 6 }) {
    const { Scene } = this.module;
    const fire = {
      block: () => Scene.block(count, neighbours),
      plume: () => Scene.plume(count),
      combustion: () => Scene.combustion(count, stiffness),
    }[scene]();
    return {
      step: (steps) => fire.step(steps),
      rewind: () => fire.rewind(),
      about: () => ({
        particles: fire.particles(),
        neighbours: fire.neighbours(),
        substeps: fire.substeps(),
        stepsPerFrame: fire.stepsPerFrame(),
      }),
    };
  }

  /** The same block as Hearth's, in JavaScript. @param {Case} what */
  baseline({ scene, count }) {
    const block = this.module.Scene.block(count, 20);
    const start = { positions: block.positions(), velocities: block.velocities() };
    block.free();
    const fire = new BASELINES[scene](start);
    return {
      step: (steps) => {
        for (let step = 0; step < steps; step += 1) fire.step();
      },
      rewind: () => fire.rewind(),
      about: () => ({ particles: count, neighbours: fire.neighbours(), substeps: 1 }),
    };
  }

  /**
   * Time of a step [ms]: the median of as many batches as a round needs.
   * @param {string} id
   */
  round(id) {
    const fire = this.fires.get(id);
    const times = [];
    let batch = 1;
    let steps = STEPS;
    const start = performance.now();
    while (times.length < BATCHES || performance.now() - start < ROUND_MS) {
      if (steps + batch > STEPS) {
        fire.rewind();
        fire.step(1);
        steps = 1;
      }
      const before = performance.now();
      fire.step(batch);
      const time = performance.now() - before;
      steps += batch;
      if (time < this.batchMs && batch < STEPS / 2) {
        batch *= 2;
      } else {
        times.push(time / batch);
      }
    }
    times.sort((a, b) => a - b);
    return times[times.length >> 1];
  }

  /** What the case is now. @param {string} id */
  about(id) {
    return this.fires.get(id).about();
  }

  /** The peak rate on four numbers at once [GFLOP/s]. */
  gigaflops() {
    const rounds = 1_000_000;
    const before = performance.now();
    this.module.compute(rounds);
    const time = performance.now() - before;
    return (rounds * this.module.operationsARound()) / time / 1e6;
  }
}

/** The resolution of the clock [ms]. */
function tick() {
  let least = Infinity;
  for (let change = 0; change < 20; change += 1) {
    const before = performance.now();
    let after = before;
    while (after === before) after = performance.now();
    least = Math.min(least, after - before);
  }
  return least;
}
