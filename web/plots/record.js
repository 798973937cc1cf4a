/**
 * What was measured of a fire: the last minute, the mean over the height, and all of it as CSV.
 *
 * @typedef {import('../hearth-fire.js').HearthMeasures} HearthMeasures
 *
 * @typedef {object} Row
 * @property {number} time  Age of the fire [s].
 * @property {number} [frameTime]  Time between two pictures [ms].
 * @property {number} flame  Height of the flame [m].
 * @property {number} [power]  Power of the combustion [kW/m].
 * @property {number} luminosity  [m²]
 *
 * @typedef {object} Level  The gas at a height.
 * @property {number} y  [m]
 * @property {number} [temperature]  [K]
 * @property {number} [v]  [m/s]
 * @property {number} [meanTemperature]  [K]
 * @property {number} [meanV]  [m/s]
 */

import { spectrumOf } from './spectrum.js';

/** The time that is kept, and over which the profiles are averaged [s of fire]. */
const KEPT = 60;
const AVERAGED = 4;

/** Changes that follow each other faster are one [s of fire]. */
const ONE_MOVE = 1;

/** The record of a fire. */
export class Record {
  /** @type {Row[]} */
  rows = [];
  /** @type {Level[]} */
  levels = [];
  /** When values were changed, with their last values. @type {{time: number, text: string}[]} */
  marks = [];
  /** Where the vertical of the profiles is [m]. */
  x = NaN;

  /**
   * Adds what was measured.
   * @param {HearthMeasures} measures
   * @param {{fps: number} | null} stats
   * @param {number} x  Where the vertical is [m].
   */
  add({ time, power, flameHeight, luminosity, profile }, stats, x) {
    const last = this.rows.at(-1);
    // Another fire, or the same one from its start.
    if (last && (time < last.time || (power === undefined) !== (last.power === undefined))) this.#clear();
    if (x !== this.x || profile.at(-1)?.y !== this.levels.at(-1)?.y) this.levels = [];
    this.x = x;
    const passed = time - (this.rows.at(-1)?.time ?? -Infinity);
    if (passed === 0) this.rows.pop();
    this.rows.push({
      time,
      ...(stats?.fps ? { frameTime: 1000 / stats.fps } : {}),
      flame: flameHeight,
      ...(power === undefined ? {} : { power }),
      luminosity,
    });
    const first = this.rows.findIndex((row) => row.time >= time - KEPT);
    this.rows.splice(0, first);
    this.marks = this.marks.filter((mark) => mark.time >= time - KEPT);
    const share = 1 - Math.exp(-passed / AVERAGED);
    this.levels = profile.map(({ y, temperature, v }, at) => {
      const { meanTemperature, meanV } = this.levels[at] ?? {};
      return {
        y,
        temperature,
        v,
        meanTemperature: towards(meanTemperature, temperature, share),
        meanV: towards(meanV, v, share),
      };
    });
  }

  /** A value is changed now. A slider that is dragged makes one mark. @type {(id: string, value: unknown) => void} */
  mark(id, value) {
    const time = this.rows.at(-1)?.time;
    if (time === undefined) return;
    const last = this.marks.at(-1);
    if (last && time - last.time < ONE_MOVE) this.marks.pop();
    this.marks.push({ time, text: `${id.replaceAll('_', ' ')} ${value}` });
  }

  #clear() {
    this.rows = [];
    this.marks = [];
    this.levels = [];
  }

  /** The spectrum of the luminosity. */
  spectrum() {
    return spectrumOf(this.rows.map(({ time, luminosity }) => ({ time, value: luminosity })));
  }

  /** The series, the spectrum and the profiles side by side as CSV, with units in the first line. */
  csv() {
    const columns = [
      ...columnsOf(this.rows, {
        'time [s]': 'time',
        'frame time [ms]': 'frameTime',
        'flame height [m]': 'flame',
        'power [kW/m]': 'power',
        'luminosity [m²]': 'luminosity',
      }),
      ...columnsOf(this.spectrum(), { 'frequency [Hz]': 'frequency', 'luminosity spectrum [1]': 'power' }),
      ...columnsOf(this.levels, {
        [`height${this.levels.length > 0 ? ` at x = ${text(this.x)} m` : ''} [m]`]: 'y',
        'temperature [K]': 'temperature',
        'mean temperature [K]': 'meanTemperature',
        'upward velocity [m/s]': 'v',
        'mean upward velocity [m/s]': 'meanV',
      }),
    ];
    const length = Math.max(...columns.map(({ values }) => values.length), 0);
    const lines = Array.from({ length }, (_, at) => columns.map(({ values }) => text(values[at])).join(','));
    return [columns.map(({ name }) => name).join(','), ...lines, ''].join('\r\n');
  }
}

/**
 * Columns of what the model has, by their names.
 * @type {(rows: any[], fields: {[name: string]: string}) => {name: string, values: (number | undefined)[]}[]}
 */
function columnsOf(rows, fields) {
  return Object.entries(fields)
    .map(([name, field]) => ({ name, values: rows.map((row) => row[field]) }))
    .filter(({ values }) => values.length === 0 || values.some((value) => value !== undefined));
}

/**
 * The mean moved towards a value; where there is no gas, it stays.
 * @type {(mean: number | undefined, value: number | undefined, share: number) => number | undefined}
 */
function towards(mean, value, share) {
  if (mean === undefined || value === undefined) return mean ?? value;
  return mean + share * (value - mean);
}

/** @param {number | undefined} value */
function text(value) {
  return value === undefined ? '' : String(Number(value.toPrecision(7)));
}
