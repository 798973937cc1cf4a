/**
 * The card of plots: the frame time, height, power and light of a flame over time, the spectrum of its light, and
 * temperature and velocity over the height.
 *
 * @typedef {import('./record.js').Record} Record
 * @typedef {import('./record.js').Row} Row
 * @typedef {import('./record.js').Level} Level
 */

import { element } from '../element/controls/icon-button.js';
import { download } from '../editing/download.js';
import { Chart, roundUp } from './chart.js';
import { FIELDS } from './field.js';
import { Moves } from './moves.js';
import { peakOf, SHORTEST } from './spectrum.js';
import { CANDLE, celsius } from './units.js';

/** The time that the series show [s of fire]. */
const SHOWN = 20;

/**
 * The series of a record.
 * @typedef {{field: 'frameTime' | 'flame' | 'power' | 'luminosity', title: string, unit: string, digits: number,
 *   each?: number}} Series  `each`: what one of the unit is in the record.
 * @type {Series[]}
 */
const SERIES = [
  { field: 'frameTime', title: 'Frame time', unit: 'ms', digits: 0 },
  { field: 'flame', title: 'Flame height', unit: 'm', digits: 2 },
  { field: 'power', title: 'Power', unit: 'kW/m', digits: 0 },
  { field: 'luminosity', title: 'Luminosity', unit: 'candles', digits: 1, each: CANDLE },
];

/**
 * The profiles of a record, at a time and on average.
 * @typedef {{field: 'temperature' | 'v', mean: 'meanTemperature' | 'meanV', title: string, unit: string, digits:
 *   number, of?: (value: number) => number}} Profile  `of`: the value in the unit.
 * @type {Profile[]}
 */
const PROFILES = [
  { field: 'temperature', mean: 'meanTemperature', title: 'Temperature', unit: '°C', digits: 0, of: celsius },
  { field: 'v', mean: 'meanV', title: 'Velocity', unit: 'm/s ↑', digits: 1 },
];

/** All charts in their order. @type {{field: string, title: string, shape?: string}[]} */
const CHARTS = [
  ...SERIES,
  { field: 'spectrum', title: 'Luminosity spectrum', shape: 'wide' },
  ...PROFILES.map((profile) => ({ ...profile, shape: 'tall' })),
];

/** The card of one fire. */
export class Card {
  element = element('section', { class: 'hearth-plots', 'aria-label': 'Plots' });
  #record;
  #head = element('h2', {}, 'Plots');
  /** @type {{[field: string]: Chart}} */
  #charts = Object.fromEntries(CHARTS.map(({ field, title, shape }) => [field, new Chart(title, shape)]));

  /** @param {Record} record @param {import('./field.js').Field} field @param {() => void} close */
  constructor(record, field, close) {
    this.#record = record;
    const moves = new Moves(this.element);
    const bar = element(
      'header',
      {},
      moves.handle,
      this.#head,
      button('CSV', 'Download the series, the spectrum and the profiles as CSV', () =>
        download(new Blob([record.csv()], { type: 'text/csv' }), 'hearth.csv'),
      ),
      moves.sizes,
      button('Close', 'Close the plots', close),
    );
    const fields = element('div', { class: 'fields', role: 'group', 'aria-label': 'Over the fire' }, 'Over the fire');
    for (const { name, label } of FIELDS) {
      const toggle = button(label, `Show or hide ${label.toLowerCase()} over the fire`, () => {
        field.toggle(name);
        toggle.setAttribute('aria-pressed', String(field.shows(name)));
      });
      toggle.setAttribute('aria-pressed', String(field.shows(name)));
      fields.append(toggle);
    }
    // Readers and keys reach all of it.
    const charts = element('div', { class: 'charts', role: 'group', 'aria-label': 'Charts', tabindex: '0' });
    charts.append(...Object.values(this.#charts).map((chart) => chart.element));
    // Arrow keys scroll, and move no object.
    charts.addEventListener('keydown', (event) => event.key.startsWith('Arrow') && event.stopPropagation());
    this.element.append(bar, fields, charts);
    moves.follow(bar);
  }

  /** Shows the record. */
  show() {
    for (const series of SERIES) this.#series(series);
    // The last chart of an odd number fills its row.
    const shown = SERIES.filter(({ field }) => !this.#charts[field].element.hidden);
    this.#charts.luminosity.element.classList.toggle('wide', shown.length % 2 > 0);
    this.#spectrum();
    for (const profile of PROFILES) this.#profile(profile);
  }

  /** @param {Series} series */
  #series({ field, unit, digits, each = 1 }) {
    const end = this.#record.rows.at(-1)?.time ?? 0;
    const rows = this.#record.rows
      .filter(({ time }) => time >= end - SHOWN)
      .map((row) => ({ time: row.time, value: row[field] === undefined ? undefined : Number(row[field]) / each }));
    const values = rows.map(({ value }) => value).filter((value) => value !== undefined);
    // The classic model has no power, and a paused fire no frames.
    this.#charts[field].element.hidden = values.length === 0;
    const now = values.at(-1);
    const inUnit = (/** @type {number} */ value) => `${value.toFixed(digits)} ${unit}`;
    const top = roundUp(Math.max(...values));
    const mean = values.reduce((sum, value) => sum + value / values.length, 0);
    const moved = this.#record.marks.filter(({ time }) => time >= end - SHOWN);
    const [last] = moved.slice(-1);
    this.#charts[field].show({
      lines: [rows.map(({ time, value }) => pointOf(time - end, value))],
      across: [-SHOWN, 0],
      up: [0, top],
      alongX: [`−${SHOWN} s`, last ? `time | ${last.text}` : 'time', 'now'],
      alongY: ['0', `mean ${inUnit(mean)}`, `${top} ${unit}`],
      mean,
      marks: moved.map(({ time }) => time - end),
      now: now === undefined ? '' : inUnit(now),
      description:
        now === undefined
          ? ''
          : `now ${inUnit(now)}; in the last ${Math.min(SHOWN, end - rows[0].time).toFixed(0)} s from ${inUnit(Math.min(...values))} to ${inUnit(Math.max(...values))}, mean ${inUnit(mean)}${moved.map(({ time, text }) => `; ${(end - time).toFixed(0)} s ago ${text}`).join('')}`,
    });
  }

  #spectrum() {
    const spectrum = this.#record.spectrum();
    const peak = peakOf(spectrum);
    const highest = Math.ceil(spectrum.at(-1)?.frequency ?? 8);
    this.#charts.spectrum.show({
      lines: [spectrum.map(({ frequency, power }) => ({ x: frequency, y: power }))],
      across: [0, highest],
      up: [0, 1.05],
      alongX: ['0', 'frequency', `${highest} Hz`],
      alongY: ['', '', 'share of the strongest'],
      now: peak === undefined ? `after ${SHORTEST} s of fire` : `${peak.toFixed(1)} Hz`,
      description: peak === undefined ? 'the fire is not measured long enough' : `the peak is at ${peak.toFixed(1)} Hz`,
      marks: peak === undefined ? [] : [peak],
    });
  }

  /** @param {Profile} profile */
  #profile({ field, mean, title, unit, digits, of = (value) => value }) {
    const { levels: measured, x } = this.#record;
    const inUnit = (/** @type {number | undefined} */ value) => (value === undefined ? undefined : of(value));
    const levels = measured.map((level) => ({
      y: level.y,
      [field]: inUnit(level[field]),
      [mean]: inUnit(level[mean]),
    }));
    const height = levels.length > 1 ? (levels.at(-1)?.y ?? 1) : 1;
    const known = levels.filter((level) => level[mean] !== undefined);
    const values = levels.flatMap((level) => [level[field] ?? 0, level[mean] ?? 0]);
    const [low, high] = [Math.min(0, ...values), Math.max(...values)];
    const [left, right] = [low < -0.05 * high ? -roundUp(-low) : 0, roundUp(high)];
    const most =
      known.length > 0
        ? known.reduce((best, level) => (Number(level[mean]) > Number(best[mean]) ? level : best))
        : undefined;
    const at = most && `${Number(most[mean]).toFixed(digits)} ${unit}`;
    this.#charts[field].show({
      lines: [
        levels.map((level) => pointOf(level[field], level.y)),
        levels.map((level) => pointOf(level[mean], level.y)),
      ],
      across: [left, right],
      up: [0, height],
      alongX: [String(left), title.toLowerCase(), `${right} ${unit}`],
      alongY: ['', '', `height ${height.toFixed(1)} m`],
      now: at ? `≤ ${at}` : '',
      description: most
        ? `over the height at x = ${x.toFixed(2)} m, on average at most ${at}, at ${most.y.toFixed(2)} m`
        : 'there is no gas',
    });
  }
}

/**
 * A point; undefined without a coordinate.
 * @type {(x: number | undefined, y: number | undefined) => {x: number, y: number} | undefined}
 */
function pointOf(x, y) {
  return x === undefined || y === undefined ? undefined : { x, y };
}

/** @type {(text: string, title: string, act: () => void) => HTMLElement} */
function button(text, title, act) {
  const made = element('button', { type: 'button', title }, text);
  made.addEventListener('click', act);
  return made;
}
