/**
 * The gestures that pointers make with a tool. The keys that move the cross count as a pointer.
 *
 * @typedef {import('./geometry.js').Point} Point
 * @typedef {import('./gestures.js').Gesture} Gesture
 * @typedef {import('./gestures.js').ToolContext} ToolContext
 * @typedef {import('./gestures.js').How} How
 */

import { begin, PolygonDrawing } from './gestures.js';

/** The pointers of one toolbar. */
export class Pointers {
  #context;
  /** @type {Map<number, Gesture>} */
  #gestures = new Map();

  /** @param {ToolContext} context */
  constructor(context) {
    this.#context = context;
    this.polygon = new PolygonDrawing(context);
  }

  /** Whether any of them draws. */
  get active() {
    return this.#gestures.size > 0 || this.polygon.active;
  }

  /** Whether this one draws. @param {number} pointer */
  has(pointer) {
    return this.#gestures.has(pointer);
  }

  /** @type {(tool: string, pointer: number, at: Point, how: How) => void} */
  begin(tool, pointer, at, how) {
    // Keyboard users see no hover readout.
    this.#context.probe(at, { announce: pointer < 0 });
    this.#context.editing.press();
    if (tool === 'polygon') {
      this.polygon.press(at, how);
      return;
    }
    // A second finger ends what the first one draws.
    this.#cancelGestures();
    const gesture = begin(tool, this.#context, at, how);
    if (gesture) this.#gestures.set(pointer, gesture);
  }

  /** Goes on with a gesture that has begun already. @type {(pointer: number, gesture: Gesture) => void} */
  follow(pointer, gesture) {
    this.cancel(pointer);
    this.#gestures.set(pointer, gesture);
  }

  /** @type {(pointer: number, at: Point, how: How) => void} */
  move(pointer, at, how) {
    this.polygon.show(at);
    this.#context.probe(at);
    this.#gestures.get(pointer)?.move(at, how);
  }

  /** @type {(pointer: number, at: Point, how: How) => void} */
  end(pointer, at, how) {
    const gesture = this.#gestures.get(pointer);
    this.#gestures.delete(pointer);
    if (!gesture) return;
    gesture.end(at, how);
    this.#context.preview([]);
  }

  /** @param {number} pointer */
  cancel(pointer) {
    this.#gestures.get(pointer)?.cancel();
    this.#gestures.delete(pointer);
    this.#context.preview([]);
  }

  /** Cancels all gestures, and the polygon; returns whether there were any. */
  cancelAll() {
    const { active } = this;
    this.#cancelGestures();
    this.polygon.cancel();
    return active;
  }

  #cancelGestures() {
    for (const pointer of [...this.#gestures.keys()]) this.cancel(pointer);
  }
}
