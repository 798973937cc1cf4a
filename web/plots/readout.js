/**
 * What the probe shows beside the point that it measures: a ring, and values with their units. Quantities that the
 * model lacks have no row.
 *
 * @typedef {import('../hearth-fire.js').HearthMeasures['place']} Place
 * @typedef {{x: number, y: number}} Point
 */

import { element } from '../element/controls/icon-button.js';
import { oxygen as ofAir, temperature as onScales } from './units.js';

/** Distance of the values from the ring, and of both from the edges [px]. */
const BESIDE = 18;
const EDGE = 8;

/** Speed below which the velocity reads “at rest” [m/s]. */
const STILL = 0.05;

/** Directions by eighths of a turn, counterclockwise from the right. */
const DIRECTIONS = ['right', 'up and right', 'up', 'up and left', 'left', 'down and left', 'down', 'down and right'];
const ARROWS = ['→', '↗', '↑', '↖', '←', '↙', '↓', '↘'];

/** The eighth of a turn in which a velocity points. @type {(u: number, v: number) => number} */
function eighth(u, v) {
  return (Math.round((4 * Math.atan2(v, u)) / Math.PI) + 8) % 8;
}

/**
 * The values at a point as text, by their names.
 * @param {Place} place
 * @returns {{[name: string]: string}}
 */
export function valuesOf({ gas, solid, temperature, u = 0, v = 0, density, fuel, oxygen, soot }) {
  if (solid) return { place: 'in a solid' };
  if (!gas) return { place: 'no gas' };
  const speed = Math.hypot(u, v);
  const along = eighth(u, v);
  const inUnit = (/** @type {number | undefined} */ value, /** @type {number} */ digits, unit = '') =>
    value?.toFixed(digits).concat(unit);
  const share = (/** @type {number | undefined} */ fraction) =>
    fraction === undefined ? fraction : inUnit(100 * fraction, fraction > 0 && fraction < 0.095 ? 1 : 0, ' %');
  const all = {
    temperature: temperature === undefined ? undefined : onScales(temperature),
    velocity: speed < STILL ? 'at rest' : `${inUnit(speed, 2, ' m/s')} ${ARROWS[along]} ${DIRECTIONS[along]}`,
    density: inUnit(density, 2, ' kg/m³'),
    oxygen: oxygen === undefined ? undefined : ofAir(oxygen),
    fuel: share(fuel),
    soot: inUnit(soot, 2),
  };
  return Object.fromEntries(
    Object.entries(all).flatMap(([name, value]) => (value === undefined ? [] : [[name, value]])),
  );
}

/** Gas that is warmer than air [K], that glows [K], that moves [m/s]; fuel, and oxygen that is scarce, as shares. */
const WARM = 330;
const GLOWING = 900;
const MOVING = 0.3;
const FUEL = 0.03;
const SCARCE = 0.2;

/**
 * Why it is so at a place, in a sentence; undefined where nothing is to be said.
 * @param {Place} place
 * @returns {string | undefined}
 */
export function whyOf({ gas, solid, temperature = 0, u = 0, v = 0, fuel = 0, oxygen = 1 }) {
  if (solid || !gas) return undefined;
  if (fuel > FUEL && oxygen < SCARCE) return 'Fuel without enough air cannot burn yet.';
  if (temperature > GLOWING && oxygen < 1) return 'Burning has used up oxygen, and hot soot glows.';
  if (temperature > WARM) return v > MOVING ? 'Hot gas is thinner than air, so it rises.' : 'Warm gas mixes with air.';
  return Math.hypot(u, v) > MOVING ? 'Fresh air follows the gas that rises.' : 'Fresh air has 21 % of oxygen.';
}

/** The values of one probe. */
export class Readout {
  element = element('div', { class: 'hearth-probe', role: 'group', 'aria-label': 'Probe' });
  #ring = element('i', {});
  #list = element('dl', {});

  constructor() {
    this.element.append(this.#ring, this.#list);
  }

  /** @type {(place: Place | undefined, at: Point) => void} */
  show(place, { x, y }) {
    const why = place && whyOf(place);
    const at = `${x.toFixed(2)}, ${y.toFixed(2)} m`;
    const values = { ...(place && valuesOf(place)), at, ...(why && { why }) };
    const rows = Object.entries(values).map(([name, value]) =>
      element('div', {}, element('dt', {}, name), element('dd', {}, value)),
    );
    this.#list.replaceChildren(...rows);
  }

  /**
   * Moves it to a point of its parent [px]; its values are at the left if they can, or at the right.
   * @type {(at: Point, left: boolean) => void}
   */
  move({ x, y }, left) {
    const { clientWidth: width = 0, clientHeight: height = 0 } = this.element.parentElement ?? {};
    const { offsetWidth: across, offsetHeight: up } = this.#list;
    this.#ring.style.translate = `${x.toFixed(1)}px ${y.toFixed(1)}px`;
    const [before, behind] = [x - BESIDE - across, x + BESIDE];
    const isLeft = left ? before >= EDGE : behind + across + EDGE > width;
    const along = Math.max(EDGE, Math.min(isLeft ? before : behind, width - across - EDGE));
    // Above the ring, or a finger would cover them.
    const top = Math.max(EDGE, Math.min(y - BESIDE - up, height - up - EDGE));
    this.#list.style.translate = `${along.toFixed(1)}px ${top.toFixed(1)}px`;
  }
}
