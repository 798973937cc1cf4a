/**
 * What each tool does with a press, a move and a release at points of the world, for a mouse, a finger, a
 * pen and the keys that move the cross.
 *
 * @typedef {import('./geometry.js').Point} Point
 * @typedef {import('./geometry.js').Fields} Fields
 * @typedef {import('./geometry.js').Placed} Placed
 * @typedef {import('../editing/objects.js').Fields} Owned  An object of the fire.
 *
 * @typedef {object} How
 * @property {boolean} snaps  Whether angles snap.
 * @property {boolean} adds  Whether a press adds to the selection.
 * @property {boolean} free  Whether what moves does not snap to other objects.
 * @property {number} perPixel  Metres of a pixel.
 *
 * @typedef {object} ToolContext  What gestures need of the toolbar.
 * @property {import('../hearth-fire.js').HearthFire} fire
 * @property {import('../editing/editing.js').Editing} editing
 * @property {() => Owned[]} objects
 * @property {(fields: Fields) => void} add
 * @property {(id: number) => Promise<void>} remove
 * @property {(objects: Owned[], fields: Fields[], held?: boolean) => Map<number, Fields>} changes  Of objects, in
 *   range. Held objects do not fall.
 * @property {(act: () => unknown) => Promise<void>} attempt  Does something; a refusal becomes a message.
 * @property {(object: Fields | undefined, at: Point) => ({does: 'size' | 'turn', at: Point} | undefined)} handleAt
 * @property {(shown: {points: Point[], closed: boolean}[]) => void} preview
 * @property {(lines: Point[][]) => void} guide  Shows the lines to which an object snaps.
 * @property {(id: number) => void} toggle  Adds an object to the selection, or takes it out.
 * @property {() => number} thickness  Of a new line [m].
 * @property {(at: Point) => void} askForText
 * @property {(at: Point, options?: {announce?: boolean}) => void} probe  Measures there if the probe is the tool.
 *
 * @typedef {object} Gesture
 * @property {(to: Point, how: How) => void} move
 * @property {(to: Point, how: How) => void} end
 * @property {() => void} cancel
 */

import { distance, isBody } from '../editing/objects.js';
import { blow, spray, throwSparks } from './air.js';
import { extinguish, ignite } from './fire.js';
import {
  boundsOf,
  boxBetween,
  circleAround,
  lineBetween,
  moved,
  outlineOf,
  polygonOf,
  sized,
  snapped,
  snapTo,
  sourceBetween,
  strokeAlong,
  turned,
} from './geometry.js';

/** How near to an object or to the first corner of a polygon a press is on it [px]. */
const NEAR_PX = 10;

/** The shortest move that draws [px]: a click draws nothing by accident. */
const SHORT_PX = 4;

/** The longest move of a click on an object, and how near to another one its edges and its middle snap [px]. */
const CLICK_PX = 2;
const SNAP_PX = 6;

/**
 * The objects that are on and have a position of their own, which a source on a solid lacks.
 * @param {Owned[]} objects
 */
export function placed(objects) {
  return objects.filter(
    ({ kind, shape, solid, enabled }) =>
      enabled !== false &&
      (kind !== 'source' || shape !== 'solid' || !objects.some((other) => isBody(other) && other.id === solid)),
  );
}

/**
 * The last object at a point, which is drawn before the others; undefined without one.
 * @type {(context: ToolContext, at: Point, near: number) => Owned | undefined}
 */
function objectAt(context, at, near) {
  return placed(context.objects()).findLast((object) => distance(object, at.x, at.y) <= near);
}

/**
 * Draws something between the press and the release.
 * @type {(context: ToolContext, from: Point, draw: (from: Point, to: Point) => Fields, turns?: boolean) => Gesture}
 */
function drawBetween(context, from, draw, turns = false) {
  const end = (/** @type {Point} */ to, /** @type {How} */ { snaps }) => (snaps && turns ? snapped(from, to) : to);
  return {
    move: (to, how) => context.preview([outlineOf(draw(from, end(to, how)))]),
    end: (to, how) => {
      if (Math.hypot(to.x - from.x, to.y - from.y) > SHORT_PX * how.perPixel) context.add(draw(from, end(to, how)));
    },
    cancel() {},
  };
}

/**
 * Changes objects while a pointer drags: one step of the history.
 * @type {(context: ToolContext, objects: Owned[], change: (to: Point, how: How) => Fields[]) => Gesture}
 */
function dragObjects(context, objects, change) {
  /** @type {Fields[] | undefined} */
  let wanted;
  /** @type {Fields[] | undefined} */
  let last;
  let busy = false;
  let held = true;
  // A pointer moves more often than the fire answers; the last position counts.
  const send = async () => {
    if (busy) return;
    busy = true;
    while (wanted) {
      const next = wanted;
      wanted = undefined;
      await context.editing.change(context.changes(objects, next, held)).catch(() => {});
    }
    busy = false;
  };
  const to = (/** @type {Fields[]} */ fields) => {
    wanted = fields;
    last = fields;
    send();
  };
  return {
    move: (at, how) => to(change(at, how)),
    end(at, how) {
      held = false;
      if (last) to(change(at, how));
      context.guide([]);
    },
    cancel() {
      held = false;
      const names = Object.keys(last?.[0] ?? {});
      if (last) to(objects.map((object) => Object.fromEntries(names.map((name) => [name, object[name]]))));
      context.guide([]);
    },
  };
}

/**
 * Moves objects; a press that moves nothing ends in `click`.
 * @type {(context: ToolContext, objects: Owned[], from: Point, click: () => void) => Gesture}
 */
function moveObjects(context, objects, from, click) {
  const box = boundsOf(objects);
  const ids = objects.map(({ id }) => id);
  const others = placed(context.objects())
    .filter(({ id }) => !ids.includes(id))
    .map((object) => boundsOf([object]));
  const drag = dragObjects(context, objects, (to, { free, perPixel }) => {
    const [x, y] = [to.x - from.x, to.y - from.y];
    const target = { left: box.left + x, right: box.right + x, bottom: box.bottom + y, top: box.top + y };
    const { by, guides } = snapTo(target, free ? [] : others, SNAP_PX * perPixel);
    context.guide(guides);
    return objects.map((object) => moved(object, from, { x: to.x + by.x, y: to.y + by.y }));
  });
  let began = false;
  return {
    move(to, how) {
      began ||= Math.hypot(to.x - from.x, to.y - from.y) > CLICK_PX * how.perPixel;
      if (began) drag.move(to, how);
    },
    end(to, how) {
      drag.end(to, how);
      if (!began) click();
    },
    cancel: drag.cancel,
  };
}

/** @type {(context: ToolContext, from: Point, how: How) => Gesture | undefined} */
function select(context, from, { perPixel, adds }) {
  const { editing } = context;
  const [chosen, ...more] = context.objects().filter(({ id }) => editing.all.some((selected) => selected.id === id));
  const handle = more.length === 0 && context.handleAt(chosen, from);
  if (handle && chosen) {
    const before = /** @type {Owned & Placed} */ ({ ...chosen });
    return dragObjects(context, [before], (to, { snaps }) => [
      handle.does === 'turn' ? turned(before, to, snaps) : sized(before, handle.at, to),
    ]);
  }
  const object = objectAt(context, from, NEAR_PX * perPixel);
  const isChosen = editing.all.some(({ id }) => id === object?.id);
  if (adds) {
    if (object) context.toggle(object.id);
  } else if (!isChosen) {
    editing.select(object?.id);
  }
  if (!object || (adds && isChosen)) return undefined;
  const objects = placed(context.objects()).filter(({ id }) => editing.all.some((selected) => selected.id === id));
  // A click on one of several selects it alone.
  return moveObjects(context, objects, from, () => adds || editing.select(object.id));
}

/** @type {(context: ToolContext, from: Point, how: How) => Gesture} */
function erase(context, from, { perPixel }) {
  const gone = new Set();
  const step = context.editing.group();
  /** @type {Promise<unknown>[]} */
  const removed = [];
  const rub = (/** @type {Point} */ at) => {
    const object = objectAt(
      { ...context, objects: () => context.objects().filter(({ id }) => !gone.has(id)) },
      at,
      NEAR_PX * perPixel,
    );
    if (!object) return;
    gone.add(object.id);
    removed.push(step(() => context.remove(object.id)));
  };
  rub(from);
  return {
    move: rub,
    end() {},
    async cancel() {
      const all = await Promise.allSettled(removed);
      if (all.some(({ status }) => status === 'fulfilled')) await context.fire.history.undo();
    },
  };
}

/** @type {(context: ToolContext, from: Point) => Gesture} */
function brush(context, from) {
  const path = [from];
  return {
    move(to) {
      path.push(to);
      context.preview([{ points: path, closed: false }]);
    },
    end: () => context.add(strokeAlong(path, context.thickness())),
    cancel() {},
  };
}

/** The corners of a polygon, which a visitor clicks one after the other. */
export class PolygonDrawing {
  #context;
  /** @type {Point[]} */
  #corners = [];

  /** @param {ToolContext} context */
  constructor(context) {
    this.#context = context;
  }

  get active() {
    return this.#corners.length > 0;
  }

  /** A click adds a corner; one at the first corner or the last one closes it. @type {(at: Point, how: How) => void} */
  press(at, { perPixel }) {
    const near = (/** @type {Point | undefined} */ corner) =>
      corner && Math.hypot(corner.x - at.x, corner.y - at.y) <= NEAR_PX * perPixel;
    if (this.#corners.length > 2 && (near(this.#corners[0]) || near(this.#corners.at(-1)))) this.close();
    else if (!near(this.#corners.at(-1))) this.#corners.push(at);
  }

  /** Shows the sides so far. @param {Point} at */
  show(at) {
    if (this.active) this.#context.preview([{ points: [...this.#corners, at], closed: false }]);
  }

  /** Adds the polygon. */
  close() {
    const polygon = polygonOf(this.#corners);
    this.cancel();
    if (polygon) this.#context.add(polygon);
  }

  cancel() {
    this.#corners = [];
    this.#context.preview([]);
  }
}

/**
 * Begins the gesture of a tool; undefined if a press is all.
 * @type {(tool: string, context: ToolContext, from: Point, how: How) => Gesture | undefined}
 */
export function begin(tool, context, from, how) {
  switch (tool) {
    case 'blow':
      return blow(context, from);
    case 'sparks':
      return throwSparks(context, from);
    case 'ignite':
      return ignite(context, from, objectAt(context, from, NEAR_PX * how.perPixel), how.perPixel);
    case 'extinguish':
      return extinguish(context, from);
    case 'water':
      return spray(context, from);
    case 'select':
      return select(context, from, how);
    case 'erase':
      return erase(context, from, how);
    case 'brush':
      return brush(context, from);
    case 'line':
      return drawBetween(context, from, (a, b) => lineBetween(a, b, context.thickness()), true);
    case 'box':
      return drawBetween(context, from, boxBetween);
    case 'circle':
      return drawBetween(context, from, circleAround);
    case 'source':
      return drawBetween(context, from, sourceBetween, true);
    case 'text':
      context.askForText(from);
      return undefined;
    default:
      return undefined;
  }
}
