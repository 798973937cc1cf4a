/**
 * The field of a fire over its picture: arrows of the velocity, and isotherms. Both are drawn of the measures of some
 * verticals, a few times a second, over every display mode.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../hearth-fire.js').HearthMeasures['profile'][number]} Sample
 * @typedef {{x: number, profile: Sample[]}} Column  A vertical that is measured [m].
 * @typedef {[x: number, y: number]} Point
 * @typedef {[from: Point, to: Point]} Line
 */

import { addStyle } from '../editing/style.js';
import { celsius } from './units.js';

const SVG = 'http://www.w3.org/2000/svg';

/** What can be shown, with its name. @type {{name: 'arrows' | 'isotherms', label: string}[]} */
export const FIELDS = [
  { name: 'arrows', label: 'Arrows' },
  { name: 'isotherms', label: 'Isotherms' },
];

/** The temperatures of the isotherms [°C]. */
export const LEVELS = [100, 500, 900, 1300];

/** Verticals that are measured over the width of a picture, and how often [ms]. */
const COLUMNS = 24;
const PAUSE_MS = 200;

/** An arrow in so many columns and rows; its length of 1 m/s, as a share of the height; slower gas has none [m/s]. */
const EVERY = 2;
const EVERY_ROW = 4;
const LENGTH = 0.02;
const STILL = 0.1;

/**
 * The lines where the gas has a temperature, by linear interpolation between places (marching squares). There is none
 * beside a place without gas.
 * @param {Column[]} columns @param {number} level  [°C]
 * @returns {Line[]}
 */
export function isotherm(columns, level) {
  /** @type {Line[]} */
  const lines = [];
  for (let at = 1; at < columns.length; at += 1) {
    const [left, right] = [columns[at - 1], columns[at]];
    for (let row = 1; row < Math.min(left.profile.length, right.profile.length); row += 1) {
      // Around the cell.
      const corners = [cornerOf(left, row - 1), cornerOf(right, row - 1), cornerOf(right, row), cornerOf(left, row)];
      if (corners.some(({ value }) => Number.isNaN(value))) continue;
      const crossings = corners.flatMap((one, side) => crossing(one, corners[(side + 1) % 4], level));
      for (let pair = 1; pair < crossings.length; pair += 2) lines.push([crossings[pair - 1], crossings[pair]]);
    }
  }
  return lines;
}

/** @type {(column: Column, row: number) => {x: number, y: number, value: number}} */
function cornerOf({ x, profile }, row) {
  const { y, temperature = NaN } = profile[row];
  return { x, y, value: celsius(temperature) };
}

/** @typedef {ReturnType<typeof cornerOf>} Corner */

/** Where a side of a cell has the level: once or nowhere. @type {(one: Corner, other: Corner, level: number) => Point[]} */
function crossing(one, other, level) {
  if (one.value < level === other.value < level) return [];
  const share = (level - one.value) / (other.value - one.value);
  return [[one.x + share * (other.x - one.x), one.y + share * (other.y - one.y)]];
}

/** The arrows: from a place, along the velocity. @type {(columns: Column[], perSpeed: number) => Line[]} */
export function arrowsOf(columns, perSpeed) {
  return columns
    .filter((_, at) => at % EVERY === 0)
    .flatMap(({ x, profile }) =>
      profile
        .filter(({ u = 0, v = 0 }, row) => row % EVERY_ROW === EVERY && Math.hypot(u, v) > STILL)
        .map(
          ({ y, u = 0, v = 0 }) =>
            /** @type {Line} */ ([
              [x, y],
              [x + perSpeed * u, y + perSpeed * v],
            ]),
        ),
    );
}

/** The field over one fire. */
export class Field {
  #element = document.createElementNS(SVG, 'svg');
  #fire;
  #style;
  /** @type {Set<string>} */
  #shown = new Set();
  #runs = false;

  /** @param {HearthFire} fire @param {HTMLElement} host  It covers the fire. */
  constructor(fire, host) {
    this.#fire = fire;
    this.#style = addStyle(host, new URL('./field.css', import.meta.url).href);
    this.#element.setAttribute('class', 'hearth-field');
    this.#element.setAttribute('aria-hidden', 'true');
    host.prepend(this.#element);
  }

  /** @param {string} name */
  shows(name) {
    return this.#shown.has(name);
  }

  /** Shows or hides arrows or isotherms. @param {string} name */
  toggle(name) {
    if (!this.#shown.delete(name)) this.#shown.add(name);
    this.#run();
  }

  remove() {
    this.#shown.clear();
    this.#element.remove();
    this.#style.removeStyle();
  }

  async #run() {
    if (this.#runs) return;
    this.#runs = true;
    while (this.#shown.size > 0) {
      // A fire that is gone or stopped has no field; the next one has.
      const columns = await this.#measure().catch(() => []);
      this.#draw(columns);
      await new Promise((resolve) => setTimeout(resolve, PAUSE_MS));
      await new Promise((resolve) => requestAnimationFrame(resolve));
    }
    this.#element.replaceChildren();
    this.#runs = false;
  }

  /** @returns {Promise<Column[]>} */
  async #measure() {
    const { clientWidth: width } = this.#fire;
    const [left, right] = [this.#fire.toMetres(0, 0), this.#fire.toMetres(width, 0)];
    if (!left || !right) return [];
    // A wide picture has more air, not more fire.
    const edge = this.#fire.params.domain_width / 2;
    const [from, to] = [Math.max(left.x, -edge), Math.min(right.x, edge)];
    const places = Array.from({ length: COLUMNS }, (_, at) => from + ((at + 0.5) / COLUMNS) * (to - from));
    return Promise.all(places.map(async (x) => ({ x, profile: (await this.#fire.measure(x, 0)).profile })));
  }

  /** @param {Column[]} columns */
  #draw(columns) {
    const [origin, unit] = [this.#fire.toPixels(0, 0), this.#fire.toPixels(1, 1)];
    if (!origin || !unit) return;
    const pixel = (/** @type {Point} */ [x, y]) =>
      /** @type {Point} */ ([origin.x + x * (unit.x - origin.x), origin.y + y * (unit.y - origin.y)]);
    const drawn = [];
    if (this.#shown.has('isotherms'))
      for (const level of LEVELS) drawn.push(...this.#isotherm(isotherm(columns, level), level, pixel));
    if (this.#shown.has('arrows')) {
      const perSpeed = LENGTH * this.#fire.params.domain_height;
      const lines = arrowsOf(columns, perSpeed).map((line) => /** @type {Line} */ (line.map(pixel)));
      const [start, length] = [12, perSpeed * (unit.x - origin.x)];
      const scale = /** @type {Line} */ ([
        [start, 16],
        [start + length, 16],
      ]);
      drawn.push(...pathsOf('arrow', [...lines, scale].map(arrow).join('')), text(start + length + 8, 20, '1 m/s'));
    }
    this.#element.replaceChildren(...drawn);
  }

  /** @type {(lines: Line[], level: number, pixel: (point: Point) => Point) => SVGElement[]} */
  #isotherm(lines, level, pixel) {
    if (lines.length === 0) return [];
    const shown = lines.map(([from, to]) => [pixel(from), pixel(to)]);
    const top = shown.map(([from]) => from).reduce((best, point) => (point[1] < best[1] ? point : best));
    const d = shown.map(([from, to]) => `M${from.map(Math.round)}L${to.map(Math.round)}`).join('');
    return [...pathsOf('isotherm', d), text(top[0] + 4, Math.max(top[1] - 4, 14), `${level} °C`)];
  }
}

/** A line with a head. @type {(line: Line) => string} */
function arrow([[x, y], [toX, toY]]) {
  const [along, across] = [(toX - x) / 4, (toY - y) / 4];
  const at = (/** @type {number} */ right, /** @type {number} */ down) => `${right.toFixed(1)},${down.toFixed(1)}`;
  const tip = at(toX, toY);
  const head = [1, -1].map((side) => `M${tip}l${at(side * across - along, -across - side * along)}`);
  return `M${at(x, y)}L${tip}${head.join('')}`;
}

/** A line on a dark one: legible on every flame. @type {(name: string, d: string) => SVGElement[]} */
function pathsOf(name, d) {
  return ['ground', name].map((kind) => {
    const made = document.createElementNS(SVG, 'path');
    made.setAttribute('class', kind);
    made.setAttribute('d', d);
    return made;
  });
}

/** @type {(x: number, y: number, words: string) => SVGElement} */
function text(x, y, words) {
  const made = document.createElementNS(SVG, 'text');
  made.setAttribute('x', String(Math.round(x)));
  made.setAttribute('y', String(Math.round(y)));
  made.textContent = words;
  return made;
}
