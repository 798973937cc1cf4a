/**
 * The cross that stands for the pointer while keys draw.
 *
 * @typedef {import('./geometry.js').Point} Point
 * @typedef {import('./gestures.js').How} How
 */

import { blow } from './air.js';

/** The pointer that the keys are. */
const KEYS = -1;

/** The tools whose press is all. */
const AT_ONCE = ['sparks', 'ignite', 'extinguish'];

/** How long a key blows [ms]. */
const PUFF_MS = 250;

/** The cross of one toolbar. */
export class Cross {
  #context;
  #pointers;
  #overlay;
  /** @type {Point | undefined} */
  #at;
  /** Where it blows. @type {Point} */
  #aim = { x: 0, y: 1 };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #puffEnds;

  /**
   * @param {import('./gestures.js').ToolContext} context
   * @param {import('./pointers.js').Pointers} pointers
   * @param {import('./overlay.js').Overlay} overlay
   */
  constructor(context, pointers, overlay) {
    this.#context = context;
    this.#pointers = pointers;
    this.#overlay = overlay;
  }

  /** Whether it is shown. */
  get shown() {
    return this.#at !== undefined;
  }

  /** Where it is, or appears: in the middle of what is seen. */
  get at() {
    return this.#at ?? this.#overlay.seen;
  }

  /** Moves it to a point, or hides it. @param {Point | undefined} at */
  point(at) {
    this.#at = at;
    this.#overlay.cross(at);
    if (!at) this.#pointers.cancel(KEYS);
  }

  /** Shows it where it is. */
  #show() {
    const { x, y } = this.at;
    this.point({ x, y });
    return { x, y };
  }

  /** Moves it, and returns where it is. @type {(right: number, up: number, how: How) => Point} */
  move(right, up, how) {
    const { x, y } = this.at;
    const at = { x: x + right, y: y + up };
    this.point(at);
    this.#pointers.move(KEYS, at, how);
    return at;
  }

  /**
   * Blows from it for a moment, in the direction of the last time if there is none.
   * @type {(how: How, towards?: Point) => void}
   */
  puff(how, towards = this.#aim) {
    const at = this.#show();
    this.#aim = towards;
    const gesture = blow(this.#context, at, towards);
    this.#pointers.follow(KEYS, gesture);
    gesture.move(at, how);
    clearTimeout(this.#puffEnds);
    this.#puffEnds = setTimeout(() => this.#pointers.cancel(KEYS), PUFF_MS);
  }

  /** Presses at it or, after that, releases. @type {(tool: string, how: How) => void} */
  press(tool, how) {
    if (tool === 'blow') {
      this.puff(how);
      return;
    }
    const at = this.#show();
    const began = this.#pointers.has(KEYS);
    if (!began) this.#pointers.begin(tool, KEYS, at, how);
    // What acts on the fire acts at once, and a press that adds to the selection is a click.
    if (began || AT_ONCE.includes(tool) || (how.adds && tool === 'select')) this.#pointers.end(KEYS, at, how);
  }

  /** Ends what its keys have begun. */
  remove() {
    clearTimeout(this.#puffEnds);
  }
}
