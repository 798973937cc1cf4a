/**
 * The objects of a fire as the panel treats them: the tables of their properties, their names, and
 * the position of a new one.
 */

import { BODIES, KINDS as OWN, MAX_OBJECTS, SOURCE } from '../generated/scene-objects.js';
import { PARAMETERS } from '../generated/table.js';

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../parameters.js').ModelName} ModelName
 * @typedef {import('../parameters.js').ParameterDomain} Domain
 * @typedef {'source' | 'solid'} Kind
 * @typedef {Pick<HearthFire, 'objects' | 'params'> & Partial<Pick<HearthFire, 'toMetres' | 'clientWidth' |
 *   'clientHeight' | 'shadowRoot' | 'getBoundingClientRect'>>} Fire
 *   an element or anything with its API
 * @typedef {{id: number, kind: Kind, [name: string]: any}} Fields  An object, by the names of its fields.
 *
 * @typedef {object} Entry  The data of a property, like those of a parameter.
 * @property {string} id
 * @property {string} name
 * @property {string} label
 * @property {string} unit
 * @property {string} doc
 * @property {string} kind
 * @property {string} [scale]
 * @property {string[]} [choices]
 * @property {{[id: string]: string[]}} [when]
 * @property {{[id: string]: string[]}} [unless]
 * @property {(model: ModelName) => Domain | undefined} domain  Default and range, if the model uses it.
 */

/** The kinds, in the order of the panel. */
export const KINDS = /** @type {Kind[]} */ (Object.keys(OWN));

/** Free space around a new object, in sizes of it. */
const GAP = 0.25;

/** How many positions a new object tries in each direction. */
const TRIES = 100;

/** The properties of each kind: its own, then those that are parameters. @type {{[kind: string]: Entry[]}} */
const ENTRIES = Object.fromEntries(
  KINDS.map((kind) => [
    kind,
    OWN[kind].map((entry) => ({ ...entry, name: entry.id, domain: () => /** @type {any} */ (entry) })),
  ]),
);

ENTRIES.source.push(
  ...Object.entries(SOURCE).flatMap(([name, id]) => {
    const parameter = PARAMETERS.find((entry) => entry.id === id);
    if (!parameter) return [];
    const { when, unless } = /** @type {Pick<Entry, 'when' | 'unless'>} */ (parameter);
    return [{ ...parameter, name, when, unless, domain: (/** @type {ModelName} */ model) => parameter.domains[model] }];
  }),
);

/**
 * Default and range of an id of a solid on a slider, which spans the ids of the solids and the value.
 * @type {(fire: Pick<HearthFire, 'objects'>, id: string, value: any, domain: Domain | undefined) => Domain | undefined}
 */
export function idDomain(fire, id, value, domain) {
  if (!['source_solid', 'hangs_from'].includes(id) || !domain) return domain;
  const ids = objectsOf(fire)
    .filter(isBody)
    .map((solid) => solid.id);
  return { ...domain, max: Math.max(1, Number(value) || 0, ...ids) };
}

/**
 * Default and range of a property on a slider; undefined if the model does not use it. A coordinate may be
 * far outside of the domain, but a slider of all coordinates would be too coarse: it spans the domain and the value.
 * @type {(fire: Pick<HearthFire, 'params' | 'objects'>, entry: Entry, value: any) => Domain | undefined}
 */
export function sliderDomain(fire, entry, value) {
  const { params } = fire;
  const domain = idDomain(fire, entry.id, value, params && entry.domain(params.model));
  if (!domain || entry.scale !== 'linear' || entry.unit !== 'm') return domain;
  const { min = 0, max = 0 } = domain;
  const size = Math.max(params.domain_width, params.domain_height);
  return { ...domain, min: Math.max(min, Math.min(-size, value)), max: Math.min(max, Math.max(size, value)) };
}

/** The properties of a kind. @param {Kind} kind */
export function entriesOf(kind) {
  return ENTRIES[kind] ?? [];
}

/**
 * Whether two values are the same to the fire, whose numbers have single precision.
 * @type {(a: unknown, b: unknown) => boolean}
 */
export function isSame(a, b) {
  return typeof a === 'number' && typeof b === 'number' ? Math.fround(a) === Math.fround(b) : a === b;
}

/** The objects of a fire; another object with its API may have none. @param {Pick<HearthFire, 'objects'>} fire */
export function objectsOf(fire) {
  return /** @type {Fields[]} */ (fire.objects ?? []);
}

/** Whether an object is a body that gas flows around. @param {{[name: string]: any}} object */
export function isBody({ kind }) {
  return BODIES.includes(kind);
}

/**
 * Whether the properties of an object are parameters.
 * @type {(fire: Pick<HearthFire, 'objects'>, object: Fields) => boolean}
 */
export function isFirstSource(fire, { id }) {
  return objectsOf(fire).find(({ kind }) => kind === 'source')?.id === id;
}

/**
 * Whether there are as many objects of a kind as a scene can have.
 * @type {(fire: Pick<HearthFire, 'objects'>, kind: Kind) => boolean}
 */
export function isFull(fire, kind) {
  return objectsOf(fire).filter((object) => object.kind === kind).length >= MAX_OBJECTS;
}

/** An object in a list: "Source 1", "Solid 2 · wood line", "Back log · Solid 3 · off". @param {Fields} object */
export function nameOf({ id, kind, shape, material, name, enabled }) {
  const numbered = `${kind[0].toUpperCase()}${kind.slice(1)} ${id}`;
  const looks = isBody({ kind }) ? `${numbered} · ${material === 'none' ? 'invisible' : material} ${shape}` : numbered;
  // Isolated, a name in a script from right to left keeps the words behind it in their order.
  const isolated = /^[ -~]*$/.test(name ?? '') ? name : `\u2068${name}\u2069`;
  return `${name ? `${isolated} · ${numbered}` : looks}${enabled === false ? ' · off' : ''}`;
}

/**
 * The fields of a new object beside the fire. A source is a line, half as wide and as strong as the first one.
 * A solid fits the domain.
 * @type {(fire: Fire, kind: Kind) => Omit<Fields, 'id'>}
 */
export function newObject(fire, kind) {
  const { domain_width: width, domain_height: height } = fire.params;
  const first = objectsOf(fire).find((object) => object.kind === 'source');
  if (kind === 'source') {
    if (!first) return { kind, enabled: true };
    const { id, shape, solid, name: own, enabled, ...fields } = first;
    for (const name of ['width', 'power', 'rate']) {
      if (name in fields) fields[name] = rounded(inRange(fire, kind, name, fields[name] / 2));
    }
    return { ...fields, ...freePosition(fire, fields, first) };
  }
  const size = rounded(Math.min(0.2, 0.15 * Math.min(width, height)));
  const fields = { kind, width: size, height: rounded(size / 2) };
  return { ...fields, ...freePosition(fire, { ...fields, shape: 'circle' }, first ?? { x: 0, y: 0, width: 0 }) };
}

/** The fields of an object like this one, beside it. @type {(fire: Fire, object: Fields) => Omit<Fields, 'id'>} */
export function copyOf(fire, object) {
  const { id, ...fields } = object;
  return { ...fields, ...freePosition(fire, fields, object) };
}

/**
 * A value of a property within its range.
 * @type {(fire: Pick<HearthFire, 'params'>, kind: Kind, name: string, value: number) => number}
 */
export function inRange(fire, kind, name, value) {
  const { min = value, max = value } =
    entriesOf(kind)
      .find((entry) => entry.name === name)
      ?.domain(fire.params.model) ?? {};
  return Math.min(max, Math.max(min, value));
}

/**
 * A visible position beside `anchor`, clear of all objects: the nearest one in its row, else in the rows above.
 * Solids get the height of the lowest solid or, without solids, that of the anchor.
 * @param {Fire} fire
 * @param {{[name: string]: any}} fields
 * @param {{[name: string]: any}} anchor
 */
function freePosition(fire, fields, anchor) {
  const seen = seenOf(fire);
  const radius = sizeOf(fields).radius;
  const step = radius / 2;
  const start = sizeOf(anchor).width / 2 + radius * (1 + GAP);
  const solids = isBody(fields) ? objectsOf(fire).filter(isBody) : [];
  const ground = Math.max(0, Math.min(...solids.map((object) => object.y - sizeOf(object).height / 2)));
  const lowest = solids.length > 0 ? ground + radius : anchor.y;
  const all = objectsOf(fire);
  const isClear = (/** @type {number} */ x, /** @type {number} */ y) =>
    x - radius >= seen.left &&
    x + radius <= seen.right &&
    y >= seen.bottom &&
    y + radius <= seen.top &&
    all.every((object) => distance(object, x, y) >= radius);
  for (let row = 0; row < TRIES; row += 1) {
    for (let at = 0; at < TRIES; at += 1) {
      for (const side of [1, -1]) {
        const x = rounded(anchor.x + side * (start + at * step));
        const y = rounded(lowest + 2 * row * step);
        if (isClear(x, y)) return { x, y };
      }
    }
  }
  return { x: anchor.x, y: rounded(Math.min(seen.top, lowest + 2 * radius)) };
}

/**
 * The box of the picture in its fire [px]: a panel inside the fire takes a part of that.
 * @param {Fire} fire
 */
export function pictureOf(fire) {
  const inner = fire.shadowRoot?.querySelector('[part=canvas]')?.getBoundingClientRect();
  const outer = fire.getBoundingClientRect?.();
  if (!inner || !outer) return { left: 0, right: fire.clientWidth ?? 0, top: 0, bottom: fire.clientHeight ?? 0 };
  return {
    left: inner.left - outer.left,
    right: inner.right - outer.left,
    top: inner.top - outer.top,
    bottom: inner.bottom - outer.top,
  };
}

/** The part of the domain that the element shows [m]. @param {Fire} fire */
function seenOf(fire) {
  const { domain_width: width, domain_height: height } = fire.params;
  const { left, right, top, bottom } = pictureOf(fire);
  const lower = fire.toMetres?.(left, bottom);
  const upper = fire.toMetres?.(right, top);
  return {
    left: Math.max(-width / 2, lower?.x ?? -Infinity),
    right: Math.min(width / 2, upper?.x ?? Infinity),
    bottom: Math.max(0, lower?.y ?? 0),
    top: Math.min(height, upper?.y ?? Infinity),
  };
}

/**
 * Extent of an object, and the radius of a disc that contains it. A source is a line.
 * @param {{[name: string]: any}} fields
 */
export function sizeOf(fields) {
  const { kind, shape = 'circle', angle = 0 } = fields;
  const { width, height } = boxOf(fields);
  if (kind === 'source') return { width, height: 0, radius: width / 2 };
  if (shape === 'circle') return { width, height: width, radius: width / 2 };
  const [sine, cosine] = [Math.sin, Math.cos].map((of) => Math.abs(of((angle * Math.PI) / 180)));
  return {
    width: cosine * width + sine * height,
    height: sine * width + cosine * height,
    radius: Math.hypot(width, height) / 2,
  };
}

/**
 * The points of a polygon or a stroke, relative to its position.
 * @param {{[name: string]: any}} fields
 * @returns {{x: number, y: number}[]}
 */
export function pointsOf({ points = '' }) {
  const all = (String(points).match(/[-+.\de]+/g) ?? []).map(Number);
  return Array.from({ length: all.length >> 1 }, (_, at) => ({ x: all[2 * at], y: all[2 * at + 1] }));
}

/** Width and height of the box of an object before it is turned. @param {{[name: string]: any}} fields */
export function boxOf({ shape, points, width, height }) {
  if (shape !== 'polygon' && shape !== 'stroke') return { width, height };
  const all = pointsOf({ points });
  const reach = (/** @type {'x' | 'y'} */ axis) => 2 * Math.max(0, ...all.map((point) => Math.abs(point[axis])));
  const line = shape === 'stroke' ? height : 0;
  return { width: reach('x') + line, height: reach('y') + line };
}

/** The distance of a point from an object. @type {(object: Fields, x: number, y: number) => number} */
export function distance(object, x, y) {
  const { kind, shape, angle = 0 } = object;
  const { width, height } = boxOf(object);
  const [right, up] = [x - object.x, y - object.y];
  if (kind !== 'source' && shape === 'circle') return Math.hypot(right, up) - width / 2;
  const [sine, cosine] = [Math.sin, Math.cos].map((of) => of((angle * Math.PI) / 180));
  const along = Math.abs(cosine * right + sine * up) - width / 2;
  const across = Math.abs(cosine * up - sine * right) - (kind === 'source' ? 0 : height / 2);
  return Math.hypot(Math.max(along, 0), Math.max(across, 0));
}

/** Three digits are enough for a first value. @param {number} x */
function rounded(x) {
  return Number(x.toPrecision(3));
}
