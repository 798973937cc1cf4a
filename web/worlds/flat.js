/**
 * A fire in a flat world: where its picture lies there, so that the source is at a target and what has left it stays.
 */

import { Motion } from './motion.js';
import { FireSource } from './source.js';

/**
 * A fire in a world whose places are pixels, with y downwards.
 * @typedef {{x: number, y: number}} Place
 */
export class FlatFire {
  /** Its light: where it is in the world [pixels], how bright, and its colour. */
  light = { x: 0, y: 0, intensity: 0, color: 0xff9040 };
  /** Edges of its picture: left, lower, right, upper [m]. @type {import('./motion.js').Area} */
  area = [-1, 0, 1, 2];
  source;
  #motion;
  /** @type {Place | undefined} */
  #before;
  #light = [0, 0, 0];

  /**
   * @param {any} object of an engine, which gets `fire` and `light`, and events `error`
   * @param {import('./source.js').FireOptions} options
   * @param {(picture: ImageBitmap) => void} show
   */
  constructor(object, options, show) {
    this.source = new FireSource(options, {
      picture: (picture) => {
        show(picture);
        // The engine draws no more pictures than the page shows.
        requestAnimationFrame(() => this.source.shown());
      },
      lights: ([left, lower, right, upper, ...light]) => {
        this.area = [left, lower, right, upper];
        this.#light = light;
      },
      error: (error) => object.emit('error', error),
    });
    Object.assign(object, { fire: this.source, light: this.light });
    this.#motion = new Motion(this.source);
  }

  /**
   * Moves the source to a target; returns where the upper left corner of the picture is then.
   * @param {Place} target @param {number} height of the picture [pixels]
   * @returns {Place}
   */
  follow({ x, y }, height) {
    const [left, lower, , upper] = this.area;
    const scale = height / (upper - lower);
    const before = this.#before ?? { x, y };
    this.#motion.move((x - before.x) / scale, (before.y - y) / scale, this.area);
    this.#before = { x, y };
    const corner = { x: x - (this.#motion.x - left) * scale, y: y - (upper - this.#motion.y) * scale };
    const [intensity, right, up] = this.#light;
    const color = Number.parseInt(this.source.stats.glow?.slice(1) ?? 'ff9040', 16);
    const at = { x: corner.x + (right - left) * scale, y: corner.y + (upper - up) * scale };
    Object.assign(this.light, at, { intensity, color });
    return corner;
  }
}
