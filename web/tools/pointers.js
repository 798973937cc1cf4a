/**
 * The gestures that pointers make with a tool, one each. The keys that move the cross are a pointer, too.
 *
 * @typedef {import('./geometry.js').Point} Point
 * @typedef {import('./gestures.js').Gesture} Gesture
 * @typedef {import('./gestures.js').Hands} Hands
 * @typedef {import('./gestures.js').How} How
 */

import { begin, PolygonDrawing } from './gestures.js';

/** The pointers of one toolbar. */
export class Pointers {
  #hands;
  /** @type {Map<number, Gesture>} */
  #gestures = new Map();

  /** @param {Hands} hands */
  constructor(hands) {
    this.#hands = hands;
    this.polygon = new PolygonDrawing(hands);
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
    // Keys have no value before their eyes.
    this.#hands.probe(at, pointer < 0);
    this.#hands.editing.history.press();
    if (tool === 'polygon') {
      this.polygon.press(at, how);
      return;
    }
    // A second finger ends what the first one draws.
    this.#cancelGestures();
    const gesture = begin(tool, this.#hands, at, how);
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
    this.#hands.probe(at);
    this.#gestures.get(pointer)?.move(at, how);
  }

  /** @type {(pointer: number, at: Point, how: How) => void} */
  end(pointer, at, how) {
    const gesture = this.#gestures.get(pointer);
    this.#gestures.delete(pointer);
    if (!gesture) return;
    gesture.end(at, how);
    this.#hands.preview([]);
  }

  /** @param {number} pointer */
  cancel(pointer) {
    this.#gestures.get(pointer)?.cancel();
    this.#gestures.delete(pointer);
    this.#hands.preview([]);
  }

  /** Cancels all gestures, and the polygon. */
  cancelAll() {
    this.#cancelGestures();
    this.polygon.cancel();
  }

  #cancelGestures() {
    for (const pointer of [...this.#gestures.keys()]) this.cancel(pointer);
  }
}
