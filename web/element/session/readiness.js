/**
 * Whether a fire is ready: its picture is shown or, out of sight, can be drawn; and whether a stopped
 * fire is followed by another.
 */

import { countdown } from '../../engine/time-limit.js';
import { deferred } from '../promises.js';

/** Maximum time from the first values of a visible fire to its picture [s]. */
const PICTURE_S = 10;

/** The number of stops in a minute after which no fire follows. */
const MAX_STOPS = 3;
const MINUTE_MS = 60_000;

/** Time before another fire follows the second stop of a minute [ms]. */
const PAUSE_MS = 1000;

/** The readiness of one element. */
export class Readiness {
  #ready = deferred();
  /** Whether the fire was reported as ready. */
  announced = false;
  /** Whether the fire has its values, but no picture yet. */
  awaited = false;
  #late = () => {};
  /** When the fire stopped during the last minute [ms]. @type {number[]} */
  #stops = [];

  /** @returns {Promise<void>} */
  get promise() {
    return this.#ready.promise;
  }

  /** Whether there is no fire and none follows. */
  get failed() {
    return this.#ready.failed;
  }

  /** The fire has its values: `late` is called if no picture follows. @param {(message: string) => void} late */
  await(late) {
    this.awaited = true;
    this.#late = countdown(PICTURE_S, () => late(`The fire has had no picture for ${PICTURE_S} seconds`));
  }

  /** The fire has no picture to wait for. */
  cancel() {
    this.awaited = false;
    this.#late();
  }

  /** The fire is ready. */
  resolve() {
    this.cancel();
    this.announced = true;
    this.#ready.resolve();
  }

  /** A promise that is settled now stands for the next fire. */
  renew() {
    if (this.announced || this.failed) this.#ready = deferred();
    this.announced = false;
  }

  /** There is no fire. A resolved promise stays resolved; a new one rejects. @param {Error} error */
  reject(error) {
    this.renew();
    this.#ready.reject(error);
  }

  /**
   * The fire has stopped.
   * @returns {{stops: number, pause: number}} how often in a minute, and the time before another follows
   *   [ms]: infinite if none follows
   */
  stop() {
    const now = performance.now();
    this.#stops = [...this.#stops.filter((time) => now - time < MINUTE_MS), now];
    const stops = this.#stops.length;
    return { stops, pause: stops >= MAX_STOPS ? Infinity : stops > 1 ? PAUSE_MS : 0 };
  }

  /** Forgets the stops before a restart on request. */
  forget() {
    this.#stops = [];
  }
}
