/**
 * The geometry of objects in metres: what a gesture draws, where an object's outline and handles are, and
 * what an object becomes when a handle is dragged. No function touches the page.
 *
 * @typedef {{x: number, y: number}} Point  [m], y upwards
 * @typedef {{[name: string]: any}} Fields  Properties of an object.
 * @typedef {Fields & Point} Placed  Those of an object with a position.
 */

import { boxOf, isBody, pointsOf } from '../editing/objects.js';

/** The smallest side of a drawn solid [m], and the thickness of a line. */
const SMALLEST = 0.02;

/** Most points of a polygon or a stroke. */
const MAX_POINTS = 256;

/** The largest distance of a stroke from the drawn path, as a share of its thickness. */
const DEVIATION = 0.2;

/** The angle that turning with a modifier key is a multiple of [°]. */
const SNAP = 15;

/** The distance of the handle that turns an object from its box [px]. */
const ARM = 28;

/** Corners of the outline of a circle. */
const CORNERS = 48;

/** The direction of an angle. @param {number} degrees @returns {Point} */
function direction(degrees) {
  const angle = (degrees * Math.PI) / 180;
  return { x: Math.cos(angle), y: Math.sin(angle) };
}

/** To whole millimetres: shorter links, and equal values for equal gestures. @param {number} metres */
export const rounded = (metres) => Math.round(metres * 1000) / 1000;

/** @type {(a: Point, b: Point) => number} */
const apart = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

/** @type {(a: Point, b: Point) => Point} */
const between = (a, b) => ({ x: rounded((a.x + b.x) / 2), y: rounded((a.y + b.y) / 2) });

/** A box between two corners. @type {(a: Point, b: Point) => Fields} */
export function boxBetween(a, b) {
  const [width, height] = [Math.abs(a.x - b.x), Math.abs(a.y - b.y)].map((side) => rounded(Math.max(SMALLEST, side)));
  return { kind: 'solid', shape: 'box', ...between(a, b), width, height };
}

/** A circle around a point through another one. @type {(centre: Point, rim: Point) => Fields} */
export function circleAround(centre, rim) {
  const width = rounded(Math.max(SMALLEST, 2 * apart(centre, rim)));
  return { kind: 'solid', shape: 'circle', x: rounded(centre.x), y: rounded(centre.y), width };
}

/**
 * The angle of a line [°], on request a multiple of {@link SNAP}.
 * @type {(a: Point, b: Point, snaps: boolean) => number}
 */
function angleOf(a, b, snaps) {
  const angle = (Math.atan2(b.y - a.y, b.x - a.x) * 180) / Math.PI;
  return snaps ? SNAP * Math.round(angle / SNAP) : Math.round(angle * 10) / 10;
}

/** The end of a line from `a` whose angle is a multiple of {@link SNAP}. @type {(a: Point, b: Point) => Point} */
export function snapped(a, b) {
  const { x, y } = direction(angleOf(a, b, true));
  const length = apart(a, b);
  return { x: a.x + x * length, y: a.y + y * length };
}

/** A line between two points. @type {(a: Point, b: Point, thickness: number) => Fields} */
export function lineBetween(a, b, thickness) {
  const width = rounded(Math.max(SMALLEST, apart(a, b)));
  return { kind: 'solid', shape: 'line', ...between(a, b), angle: angleOf(a, b, false), width, height: thickness };
}

/** A source as wide as the distance of two points. @type {(a: Point, b: Point) => Fields} */
export function sourceBetween(a, b) {
  // Drawn from right to left, it is the same: fuel rises from its upper side.
  const [left, right] = a.x <= b.x ? [a, b] : [b, a];
  return {
    kind: 'source',
    ...between(a, b),
    angle: angleOf(left, right, false),
    width: rounded(Math.max(SMALLEST, apart(a, b))),
  };
}

/**
 * A path as a stroke, with few points; one that goes nowhere is a disc.
 * @type {(path: Point[], thickness: number) => Fields}
 */
export function strokeAlong(path, thickness) {
  let few = simplified(path, DEVIATION * thickness);
  for (let error = thickness; few.length > MAX_POINTS; error *= 2) few = simplified(path, error);
  if (few.length < 2)
    return { kind: 'solid', shape: 'circle', x: rounded(path[0].x), y: rounded(path[0].y), width: thickness };
  return { kind: 'solid', shape: 'stroke', height: thickness, ...outlined(few) };
}

/** A polygon with these corners, if it has an area. @type {(corners: Point[]) => Fields | undefined} */
export function polygonOf(corners) {
  const few = corners.filter((point, at) => at === 0 || apart(point, corners[at - 1]) >= 0.001).slice(0, MAX_POINTS);
  if (few.length < 3) return undefined;
  return { kind: 'solid', shape: 'polygon', ...outlined(few) };
}

/** Points around the middle of their box. @param {Point[]} points */
function outlined(points) {
  const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)];
  const middle = (/** @type {number[]} */ all) => rounded((Math.min(...all) + Math.max(...all)) / 2);
  const [x, y] = [middle(xs), middle(ys)];
  return { x, y, points: points.map((point) => `${rounded(point.x - x)},${rounded(point.y - y)}`).join(' ') };
}

/**
 * A path without the points that are near the line between their neighbours: the algorithm of Ramer,
 * Douglas and Peucker.
 * @type {(path: Point[], error: number) => Point[]}
 */
export function simplified(path, error) {
  const kept = new Set([0]);
  if (path.some((point) => apart(point, path[0]) > error)) kept.add(path.length - 1);
  const segments = [[0, path.length - 1]];
  for (let segment = segments.pop(); segment; segment = segments.pop()) {
    const [from, to] = segment;
    let [farthest, most] = [0, error];
    for (let at = from + 1; at < to; at += 1) {
      const away = fromSegment(path[at], path[from], path[to]);
      if (away > most) [farthest, most] = [at, away];
    }
    if (!farthest) continue;
    kept.add(farthest);
    segments.push([from, farthest], [farthest, to]);
  }
  return [...kept].sort((a, b) => a - b).map((at) => path[at]);
}

/** The distance of a point from a segment. @type {(point: Point, a: Point, b: Point) => number} */
function fromSegment(point, a, b) {
  const length = apart(a, b);
  const along = length ? ((point.x - a.x) * (b.x - a.x) + (point.y - a.y) * (b.y - a.y)) / length : 0;
  const share = length ? Math.min(1, Math.max(0, along / length)) : 0;
  return apart(point, { x: a.x + share * (b.x - a.x), y: a.y + share * (b.y - a.y) });
}

/** Whether an object is turned; a circle is not. @param {Fields} object */
export const isTurned = ({ kind, shape }) => kind === 'source' || shape !== 'circle';

/**
 * From coordinates along an object's width and height to those of the world.
 * @type {(object: Fields, local: Point) => Point}
 */
function outOf(object, { x, y }) {
  const axis = direction(isTurned(object) ? (object.angle ?? 0) : 0);
  return { x: object.x + axis.x * x - axis.y * y, y: object.y + axis.y * x + axis.x * y };
}

/** The reverse of {@link outOf}. @type {(object: Fields, point: Point) => Point} */
function into(object, point) {
  const axis = direction(isTurned(object) ? (object.angle ?? 0) : 0);
  const [x, y] = [point.x - object.x, point.y - object.y];
  return { x: axis.x * x + axis.y * y, y: axis.x * y - axis.y * x };
}

/** The box of an object along its width and height; a source has no height. @param {Fields} object */
function sizeOf(object) {
  const { width, height } = boxOf(/** @type {any} */ (object));
  if (object.kind === 'source') return { width, height: 0 };
  if (object.shape === 'circle') return { width, height: width };
  // The round ends of a line are beyond its length.
  return object.shape === 'line' ? { width: width + height, height } : { width, height };
}

/** The corners of the box of an object; the ends of a source. @param {Fields} object */
function cornersOf(object) {
  const { width, height } = sizeOf(object);
  const corners = isBody(object)
    ? [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ]
    : [
        [-1, 0],
        [1, 0],
      ];
  return corners.map(([x, y]) => outOf(object, { x: (x * width) / 2, y: (y * height) / 2 }));
}

/**
 * The outline of an object.
 * @param {Fields} object
 * @returns {{points: Point[], closed: boolean}}
 */
export function outlineOf(object) {
  const { width } = sizeOf(object);
  if (object.shape === 'polygon' || object.shape === 'stroke') {
    return { points: pointsOf(object).map((point) => outOf(object, point)), closed: object.shape === 'polygon' };
  }
  if (object.shape === 'circle') {
    const points = Array.from({ length: CORNERS }, (_, at) => direction((360 * at) / CORNERS));
    return {
      points: points.map(({ x, y }) => outOf(object, { x: (x * width) / 2, y: (y * width) / 2 })),
      closed: true,
    };
  }
  return { points: cornersOf(object), closed: isBody(object) };
}

/** @typedef {{left: number, right: number, bottom: number, top: number}} Bounds */

/** The upright box around objects. @param {Fields[]} objects @returns {Bounds} */
export function boundsOf(objects) {
  const points = objects.flatMap((object) => {
    // A stroke is as thick as its ends.
    const reach = object.shape === 'stroke' ? object.height / 2 : 0;
    return outlineOf(object).points.flatMap(({ x, y }) => [
      { x: x - reach, y: y - reach },
      { x: x + reach, y: y + reach },
    ]);
  });
  const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)];
  return { left: Math.min(...xs), right: Math.max(...xs), bottom: Math.min(...ys), top: Math.max(...ys) };
}

/** The edges and the middle of a box in one direction. @type {(box: Bounds) => {[axis in 'x' | 'y']: number[]}} */
const linesOf = ({ left, right, bottom, top }) => ({
  x: [left, (left + right) / 2, right],
  y: [bottom, (bottom + top) / 2, top],
});

/**
 * How far a moved box has to go so that an edge or its middle is at one of another box, at most `near` in each
 * direction, and the lines on which they are.
 * @type {(box: Bounds, others: Bounds[], near: number) => {by: Point, guides: Point[][]}}
 */
export function snapTo(box, others, near) {
  const by = { x: 0, y: 0 };
  /** @type {Point[][]} */
  const guides = [];
  for (const axis of /** @type {const} */ (['x', 'y'])) {
    /** @type {{away: number, at: number, other: Bounds} | undefined} */
    let best;
    for (const other of others) {
      for (const at of linesOf(other)[axis]) {
        for (const own of linesOf(box)[axis]) {
          if (Math.abs(at - own) <= (best ? Math.abs(best.away) - 1e-9 : near)) best = { away: at - own, at, other };
        }
      }
    }
    if (!best) continue;
    by[axis] = best.away;
    const { at, other } = best;
    const both = [linesOf(box), linesOf(other)].flatMap((lines) => lines[axis === 'x' ? 'y' : 'x']);
    guides.push(
      [Math.min(...both), Math.max(...both)].map((end) => (axis === 'x' ? { x: at, y: end } : { x: end, y: at })),
    );
  }
  return { by, guides };
}

/** The ways to align. @typedef {'left' | 'centre' | 'right' | 'top' | 'middle' | 'bottom'} Alignment */

/**
 * How far each object has to go so that all are at an edge or the middle of the box around them.
 * @type {(objects: Fields[], to: Alignment) => Point[]}
 */
export function aligned(objects, to) {
  const axis = ['left', 'centre', 'right'].includes(to) ? 'x' : 'y';
  const line = { left: 0, bottom: 0, centre: 1, middle: 1, right: 2, top: 2 }[to];
  const at = (/** @type {Fields[]} */ some) => linesOf(boundsOf(some))[axis][line];
  const goal = at(objects);
  return objects.map((object) => ({ x: 0, y: 0, [axis]: goal - at([object]) }));
}

/**
 * The handles of an object: those that size it at the corners of its box, and the one that turns it.
 * @param {Fields} object
 * @param {number} perPixel  Metres of a pixel.
 * @returns {{does: 'size' | 'turn', at: Point}[]}
 */
export function handlesOf(object, perPixel) {
  /** @type {{does: 'size' | 'turn', at: Point}[]} */
  const handles = cornersOf(object).map((at) => ({ does: 'size', at }));
  const up = sizeOf(object).height / 2 + ARM * perPixel;
  if (isTurned(object)) handles.push({ does: 'turn', at: outOf(object, { x: 0, y: up }) });
  return handles;
}

/** An object moved along a path from `from` to `to`. @type {(object: Fields, from: Point, to: Point) => Fields} */
export function moved(object, from, to) {
  return { x: rounded(object.x + to.x - from.x), y: rounded(object.y + to.y - from.y) };
}

/**
 * An object turned so that the handle that turns it points to `to`.
 * @type {(object: Placed, to: Point, snaps: boolean) => Fields}
 */
export function turned(object, to, snaps) {
  const angle = angleOf(object, to, false) - 90;
  const whole = snaps ? SNAP * Math.round(angle / SNAP) : Math.round(angle * 10) / 10;
  // Not minus zero.
  return { angle: (whole <= -180 ? whole + 360 : whole) + 0 };
}

/**
 * An object sized so that the corner of its box that was at `from` is at `to`; its middle stays.
 * @type {(object: Placed, from: Point, to: Point) => Fields}
 */
export function sized(object, from, to) {
  const [before, now] = [into(object, from), into(object, to)];
  const side = (/** @type {number} */ half) => rounded(Math.max(SMALLEST / 2, 2 * Math.abs(half)));
  if (object.kind === 'source') return { width: side(now.x) };
  switch (object.shape) {
    case 'circle':
      return { width: rounded(Math.max(SMALLEST / 2, (object.width * apart(object, to)) / apart(object, from))) };
    case 'polygon':
    case 'stroke':
      return scaled(object, Math.hypot(now.x, now.y) / Math.hypot(before.x, before.y));
    case 'line': {
      const height = side(now.y);
      return { width: rounded(Math.max(0.002, 2 * Math.abs(now.x) - height)), height };
    }
    default:
      return { width: side(now.x), height: side(now.y) };
  }
}

/** An object larger by a factor. @type {(object: Fields, factor: number) => Fields} */
export function scaled(object, factor) {
  const by = (/** @type {number} */ length) => rounded(Math.max(0.002, length * factor));
  if (object.kind === 'source' || object.shape === 'circle') return { width: by(object.width) };
  if (object.shape === 'polygon' || object.shape === 'stroke') {
    const points = pointsOf(object)
      .map(({ x, y }) => `${rounded(x * factor)},${rounded(y * factor)}`)
      .join(' ');
    return object.shape === 'stroke' ? { points, height: by(object.height) } : { points };
  }
  return { width: by(object.width), height: by(object.height) };
}
