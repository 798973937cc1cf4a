/**
 * What each tool does with a press, a move and a release at points of the world. A mouse, a finger, a pen
 * and the keys that move the cross all come here.
 *
 * @typedef {import('./geometry.js').Point} Point
 * @typedef {import('./geometry.js').Fields} Fields
 * @typedef {import('./geometry.js').Placed} Placed
 * @typedef {{snaps: boolean, perPixel: number}} How  Whether angles snap, and metres of a pixel.
 *
 * @typedef {object} Hands  What gestures need of the toolbar.
 * @property {import('../hearth-fire.js').HearthFire} fire
 * @property {import('../panel/editing.js').Editing} editing
 * @property {() => Fields[]} objects
 * @property {(fields: Fields) => void} add
 * @property {(id: number) => Promise<void>} remove
 * @property {(object: Fields | undefined, at: Point) => ({does: 'size' | 'turn', at: Point} | undefined)} handleAt
 * @property {(shown: {points: Point[], closed: boolean}[]) => void} preview
 * @property {() => number} thickness  Of a new line [m].
 * @property {(at: Point) => void} write  Asks for a word.
 *
 * @typedef {object} Gesture
 * @property {(to: Point, how: How) => void} move
 * @property {(to: Point, how: How) => void} end
 * @property {() => void} cancel
 */

import { distance } from '../panel/objects.js';
import { blow, throwSparks } from './air.js';
import {
  boxBetween, circleAround, lineBetween, moved, outlineOf, polygonOf, sized, snapped, sourceBetween, strokeAlong, turned,
} from './geometry.js';

/** How near to an object or to the first corner of a polygon a press is on it [px]. */
const NEAR_PX = 10;

/** The shortest move that draws [px]: a click draws nothing by accident. */
const SHORT_PX = 4;

/** The last object at a point, which is drawn before the others; undefined without one. @type {(hands: Hands, at: Point, near: number) => Fields | undefined} */
function objectAt(hands, at, near) {
  const objects = hands.objects();
  // A source on a solid has no place of its own.
  const hasPlace = (/** @type {Fields} */ { kind, shape, solid }) => (
    kind !== 'source' || shape !== 'solid' || !objects.some((one) => one.kind === 'solid' && one.id === solid)
  );
  return objects.findLast((object) => hasPlace(object) && distance(/** @type {any} */ (object), at.x, at.y) <= near);
}

/** Draws something between the press and the release. @type {(hands: Hands, from: Point, draw: (from: Point, to: Point) => Fields, turns?: boolean) => Gesture} */
function between(hands, from, draw, turns = false) {
  const end = (/** @type {Point} */ to, /** @type {How} */ { snaps }) => (snaps && turns ? snapped(from, to) : to);
  return {
    move: (to, how) => hands.preview([outlineOf(draw(from, end(to, how)))]),
    end: (to, how) => {
      if (Math.hypot(to.x - from.x, to.y - from.y) > SHORT_PX * how.perPixel) hands.add(draw(from, end(to, how)));
    },
    cancel() {},
  };
}

/** Changes an object while it is dragged: one step of the history. @type {(hands: Hands, object: Fields, change: (to: Point, how: How) => Fields) => Gesture} */
function changing(hands, object, change) {
  const { history } = hands.editing;
  /** @type {Fields | undefined} */
  let wanted;
  let busy = false;
  let began = false;
  // A pointer moves more often than the fire answers; the last place counts.
  const send = async () => {
    if (busy) return;
    busy = true;
    while (wanted) {
      const next = wanted;
      wanted = undefined;
      await history.change(object.id, next).catch(() => {});
    }
    busy = false;
  };
  const to = (/** @type {Fields} */ fields) => {
    wanted = fields;
    send();
  };
  return {
    move(at, how) {
      began = true;
      to(change(at, how));
    },
    end(at, how) {
      if (began) to(change(at, how));
    },
    cancel() {
      if (began) to(Object.fromEntries(Object.keys(change(/** @type {any} */ (object), { snaps: false, perPixel: 0 })).map((name) => [name, object[name]])));
    },
  };
}

/** @type {(hands: Hands, from: Point, how: How) => Gesture | undefined} */
function select(hands, from, { perPixel }) {
  const { editing } = hands;
  const handle = hands.handleAt(editing.selected, from);
  const chosen = editing.selected;
  if (handle && chosen) {
    const before = /** @type {Placed & {id: number}} */ (/** @type {any} */ ({ ...chosen }));
    return changing(hands, before, (to, { snaps }) => (handle.does === 'turn' ? turned(before, to, snaps) : sized(before, handle.at, to)));
  }
  const object = objectAt(hands, from, NEAR_PX * perPixel);
  editing.select(object?.id);
  if (!object) return undefined;
  return changing(hands, { ...object }, (to) => moved(object, from, to));
}

/** @type {(hands: Hands, from: Point, how: How) => Gesture} */
function erase(hands, from, { perPixel }) {
  let done = () => {};
  const ended = /** @type {Promise<void>} */ (new Promise((resolve) => (done = resolve)));
  const gone = new Set();
  /** @type {Promise<unknown>[]} */
  const removals = [];
  // All of it is one step.
  hands.editing.history.objects(async () => {
    await ended;
    await Promise.allSettled(removals);
  });
  const rub = (/** @type {Point} */ at) => {
    const object = objectAt({ ...hands, objects: () => hands.objects().filter(({ id }) => !gone.has(id)) }, at, NEAR_PX * perPixel);
    if (!object) return;
    gone.add(object.id);
    removals.push(hands.remove(object.id));
  };
  rub(from);
  return { move: rub, end: done, cancel: done };
}

/** @type {(hands: Hands, from: Point) => Gesture} */
function brush(hands, from) {
  const path = [from];
  return {
    move(to) {
      path.push(to);
      hands.preview([{ points: path, closed: false }]);
    },
    end: () => hands.add(strokeAlong(path, hands.thickness())),
    cancel() {},
  };
}

/** The corners of a polygon, which a visitor clicks one after the other. */
export class PolygonDrawing {
  #hands;
  /** @type {Point[]} */
  #corners = [];

  /** @param {Hands} hands */
  constructor(hands) {
    this.#hands = hands;
  }

  get active() {
    return this.#corners.length > 0;
  }

  /** A click adds a corner; one at the first corner or the last one closes it. @type {(at: Point, how: How) => void} */
  press(at, { perPixel }) {
    const near = (/** @type {Point | undefined} */ one) => one && Math.hypot(one.x - at.x, one.y - at.y) <= NEAR_PX * perPixel;
    if (this.#corners.length > 2 && (near(this.#corners[0]) || near(this.#corners.at(-1)))) this.close();
    else if (!near(this.#corners.at(-1))) this.#corners.push(at);
  }

  /** Shows the sides so far. @param {Point} at */
  show(at) {
    if (this.active) this.#hands.preview([{ points: [...this.#corners, at], closed: false }]);
  }

  /** Adds the polygon. */
  close() {
    const polygon = polygonOf(this.#corners);
    this.cancel();
    if (polygon) this.#hands.add(polygon);
  }

  cancel() {
    this.#corners = [];
    this.#hands.preview([]);
  }
}

/**
 * Begins the gesture of a tool; undefined if a press is all.
 * @type {(tool: string, hands: Hands, from: Point, how: How) => Gesture | undefined}
 */
export function begin(tool, hands, from, how) {
  switch (tool) {
    case 'blow': return blow(hands, from);
    case 'sparks': return throwSparks(hands, from);
    case 'select': return select(hands, from, how);
    case 'erase': return erase(hands, from, how);
    case 'brush': return brush(hands, from);
    case 'line': return between(hands, from, (a, b) => lineBetween(a, b, hands.thickness()), true);
    case 'box': return between(hands, from, boxBetween);
    case 'circle': return between(hands, from, circleAround);
    case 'source': return between(hands, from, sourceBetween, true);
    case 'text': hands.write(from); return undefined;
    default: return undefined;
  }
}
