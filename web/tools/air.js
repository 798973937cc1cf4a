/**
 * The tools that act on the fire and not on objects: a drag blows, throws sparks, or sprays water. None is a step
 * of the history.
 *
 * @typedef {import('./geometry.js').Point} Point
 * @typedef {import('./gestures.js').Gesture} Gesture
 * @typedef {import('./gestures.js').ToolContext} ToolContext
 */

import { EVERY_MS, SPEED, pour } from '../editing/effects.js';

/** The movement that sets a direction, and the distance of sparks from each other [px]. */
const AIM_PX = 5;
const APART_PX = 12;

/** Sparks of a press, sparks at each point of a drag, and the most points between two events. */
const FIRST = 24;
const SPARKS_AT_ONCE = 6;
const MOST = 20;

/** An arrow to a point [px]: its length, and that of its head. */
const ARROW_PX = 44;
const HEAD_PX = 12;

/**
 * Blows while the pointer is pressed, in the direction in which it has moved.
 * @type {(context: ToolContext, from: Point, towards?: Point) => Gesture}
 */
export function blow({ fire, preview }, from, towards) {
  let [anchor, at] = [from, from];
  const puff = () => {
    if (towards) fire.stir(at.x, at.y, SPEED * towards.x, SPEED * towards.y).catch(() => {});
  };
  const timer = setInterval(puff, EVERY_MS);
  puff();
  const stop = () => clearInterval(timer);
  return {
    move(to, { perPixel }) {
      at = to;
      const [x, y] = [to.x - anchor.x, to.y - anchor.y];
      const length = Math.hypot(x, y);
      if (length >= AIM_PX * perPixel) {
        towards = { x: x / length, y: y / length };
        anchor = to;
        puff();
      }
      if (towards) preview([arrow(at, towards, perPixel)]);
    },
    end: stop,
    cancel: stop,
  };
}

/**
 * An arrow that ends at a point.
 * @type {(tip: Point, towards: Point, perPixel: number) => {points: Point[], closed: boolean}}
 */
function arrow(tip, { x, y }, perPixel) {
  const back = (/** @type {number} */ along, /** @type {number} */ aside) => ({
    x: tip.x - (along * x + aside * y) * perPixel,
    y: tip.y - (along * y - aside * x) * perPixel,
  });
  const [left, right] = [HEAD_PX, -HEAD_PX].map((aside) => back(HEAD_PX, aside));
  return { points: [back(ARROW_PX, 0), tip, left, tip, right], closed: false };
}

/** Throws sparks at the press and along the way. @type {(context: ToolContext, from: Point) => Gesture} */
export function throwSparks({ fire }, from) {
  const sparks = (/** @type {Point} */ { x, y }, /** @type {number} */ count) =>
    fire.sparks(x, y, count).catch(() => {});
  sparks(from, FIRST);
  let last = from;
  return {
    move(to, { perPixel }) {
      const [x, y] = [to.x - last.x, to.y - last.y];
      const count = Math.min(MOST, Math.floor(Math.hypot(x, y) / (APART_PX * perPixel)));
      for (let step = 1; step <= count; step += 1) {
        sparks({ x: last.x + (x * step) / count, y: last.y + (y * step) / count }, SPARKS_AT_ONCE);
      }
      if (count > 0) last = to;
    },
    end() {},
    cancel() {},
  };
}

/**
 * Sprays water downwards from the pointer while it is pressed.
 * @type {(context: ToolContext, from: Point) => Gesture}
 */
export function spray({ fire, attempt }, from) {
  let at = from;
  attempt(() => pour(fire, at.x, at.y));
  const timer = setInterval(() => pour(fire, at.x, at.y).catch(() => {}), EVERY_MS);
  const end = () => clearInterval(timer);
  return { move: (to) => (at = to), end, cancel: end };
}
