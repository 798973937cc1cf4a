/**
 * A fire in a flat world: where its picture lies there, so that the source is at a target and what has left it stays.
 *
 *     const fire = new FlatFire({ preset: 'torch' }, { picture: (picture) => upload(picture) });
 *     const { x, y } = fire.follow(hand, 300);
 */

import { Motion } from './worlds/motion.js';
import { FireSource } from './worlds/source.js';

/** A fire for an engine that shows pictures. */
export class FlatFire {
  /** Its light: where it is in the world, how bright, and its colour. */
  light = { x: 0, y: 0, intensity: 0, color: 0xff9040 };
  /** Edges of its picture: left, lower, right, upper [m]. @type {import('./worlds/motion.js').Area} */
  area = [-1, 0, 1, 2];
  fire;
  #motion;
  /** @type {{x: number, y: number} | undefined} */
  #before;
  #light = [0, 0, 0];

  /**
   * @param {import('./worlds/source.js').FireOptions} options
   * @param {import('./flat.js').FlatListener} on
   */
  constructor(options, on) {
    this.fire = new FireSource(options, {
      picture: (picture) => {
        on.picture(picture);
        // The engine draws no more pictures than the page shows.
        requestAnimationFrame(() => this.fire.shown());
      },
      lights: ([left, lower, right, upper, ...light]) => {
        this.area = [left, lower, right, upper];
        this.#light = light;
      },
      error: (error) => on.error?.(error),
    });
    this.#motion = new Motion(this.fire);
  }

  /**
   * Moves the source to a target; returns where the upper left corner of the picture is then.
   * @param {{x: number, y: number}} target @param {number} height of the picture
   * @param {1 | -1} [up] direction of y
   */
  follow({ x, y }, height, up = -1) {
    const [left, lower, , upper] = this.area;
    const scale = height / (upper - lower);
    const before = this.#before ?? { x, y };
    this.#motion.move((x - before.x) / scale, (up * (y - before.y)) / scale, this.area);
    this.#before = { x, y };
    const corner = { x: x - (this.#motion.x - left) * scale, y: y + up * (upper - this.#motion.y) * scale };
    const [intensity, right, above] = this.#light;
    const color = Number.parseInt(this.fire.stats.glow?.slice(1) ?? 'ff9040', 16);
    const at = { x: corner.x + (right - left) * scale, y: corner.y - up * (upper - above) * scale };
    Object.assign(this.light, at, { intensity, color });
    return corner;
  }

  /** Frees the fire. */
  dispose() {
    this.fire.dispose();
  }
}
