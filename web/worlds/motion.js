/**
 * Moves the source of a fire through its gas, as what carries it moves: what has left the source stays where it is.
 *
 * @typedef {import('./source.js').FireSource} FireSource
 * @typedef {[left: number, lower: number, right: number, upper: number]} Area of the picture [m]
 */

/** A source that moves farther from one picture to the next was put there [m]. */
const JUMP = 1;
/** Smallest motion that the fire feels [m]; smaller ones add up. */
const FELT = 0.002;
/** Speeds at which gas is dragged along [m/s]. */
const DRAGS = 0.3;
const MAX_DRAG = 20;

/** The motion of a source. */
export class Motion {
  /** Where the source is in the fire [m]. */
  x = 0;
  y = 0;
  /** Where it was at first [m]. */
  restX = 0;
  restY = 0;
  #fire;
  #known = false;
  #pending = [0, 0];
  #then = 0;

  /** @param {FireSource} fire */
  constructor(fire) {
    this.#fire = fire;
  }

  /**
   * What carries the source has moved. At the edges of the picture and of the domain, the fire moves with it.
   * @param {number} right [m]
   * @param {number} up
   * @param {Area} area
   */
  move(right, up, [left, lower, far, upper]) {
    const { values } = this.#fire;
    if (!this.#known) {
      // A fire that does not burn yet begins where its source is then.
      if (values.source_x === undefined) return;
      this.x = this.restX = values.source_x;
      this.y = this.restY = values.source_height;
      this.#known = true;
    }
    const now = performance.now();
    const seconds = Math.max(now - this.#then, 1) / 1000;
    this.#then = now;
    if (!(Math.hypot(right, up) < JUMP)) return;
    const [u, v] = [this.#pending[0] + right, this.#pending[1] + up];
    this.#pending = [u, v];
    if (Math.hypot(u, v) < FELT) return;
    this.#pending = [0, 0];
    const margin = values.source_width;
    // There is no gas outside of the domain, which a picture may show.
    const half = values.domain_width / 2;
    const x = Math.min(Math.max(this.x + u, Math.max(left, -half) + margin), Math.min(far, half) - margin);
    const y = Math.min(Math.max(this.y + v, Math.max(lower, 0)), Math.min(upper, values.domain_height) - margin);
    if (x === this.x && y === this.y) return;
    this.x = x;
    this.y = y;
    this.#fire.set({ source_x: x, source_height: y });
    const speed = Math.hypot(right, up) / seconds;
    if (speed > DRAGS && speed < MAX_DRAG) this.#fire.call('stir', x, y, right / seconds, up / seconds).catch(() => {});
  }
}
