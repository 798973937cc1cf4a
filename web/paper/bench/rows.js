/**
 * The rows that can be measured, the paper's figures for them, and the link that names a choice of rows.
 *
 * @typedef {'classic' | 'combustion'} Model
 * @typedef {object} Choice
 * @property {number[]} counts
 * @property {Model[]} models
 * @property {number[]} sizes  In the paper's pixels.
 */

/**
 * The paper's Table 1: pictures a second, memory [MB] and time of a loop [ms] by the number of particles.
 * @type {{[count: number]: {fps: number, memory: [number, number], ms: number}}}
 */
export const TABLE_1 = {
  300: { fps: 110, memory: [9.8, 12.3], ms: 5.46 },
  500: { fps: 105, memory: [10, 12.3], ms: 6.73 },
  800: { fps: 90, memory: [10.1, 12.4], ms: 15.97 },
  900: { fps: 75, memory: [10.1, 12.4], ms: 18.74 },
  1000: { fps: 60, memory: [10.1, 12.3], ms: 21.89 },
  1300: { fps: 30, memory: [10.1, 12.4], ms: 42.67 },
  1500: { fps: 25, memory: [10, 12.3], ms: 86.09 },
  2000: { fps: 15, memory: [10.1, 12.3], ms: 110.67 },
  3000: { fps: 7, memory: [10, 11.9], ms: 347.42 },
  5000: { fps: 5, memory: [10, 11.7], ms: 615.52 },
};

/** The paper's Table 2: memory [MB] by the size of a particle [px]. @type {{[size: number]: [number, number]}} */
export const TABLE_2 = {
  1: [6.8, 9.2],
  3: [6.8, 9.3],
  5: [7, 10],
  8: [7.3, 9.9],
  10: [8.9, 11.2],
  12: [9.5, 11.5],
  15: [10, 12.3],
  20: [10, 13.3],
  25: [11, 14.5],
  30: [11.2, 15.7],
};

/** Length of a pixel of the paper [m]: its canvas is taken as 1.5 m high, and has 600. */
export const PIXEL = 1.5 / 600;

/** Number of particles of Table 2. */
export const TABLE_2_COUNT = 1000;

/** @type {Choice} */
export const ALL = {
  counts: [...Object.keys(TABLE_1).map(Number), 10_000, 30_000, 100_000],
  models: ['classic', 'combustion'],
  sizes: Object.keys(TABLE_2).map(Number),
};

/** The URL parameter of each choice. */
const NAMES = /** @type {const} */ ({ counts: 'n', models: 'models', sizes: 'sizes' });

/**
 * The choice that a link names: every known value of a list that it has, and all values of one that it lacks.
 * Unknown values are ignored.
 * @param {string} search  As in `location.search`.
 * @returns {Choice}
 */
export function choiceOf(search) {
  const query = new URLSearchParams(search);
  return {
    counts: named(query.get(NAMES.counts), ALL.counts),
    models: named(query.get(NAMES.models), ALL.models),
    sizes: named(query.get(NAMES.sizes), ALL.sizes),
  };
}

/**
 * The values that a list names; all without a list.
 * @template {string | number} T
 * @param {string | null} list  With commas.
 * @param {T[]} all
 */
function named(list, all) {
  const names = list?.split(',');
  return all.filter((value) => names === undefined || names.includes(String(value)));
}

/** The query that names a choice; empty for all rows. @param {Choice} choice */
export function queryOf(choice) {
  const terms = /** @type {(keyof Choice)[]} */ (Object.keys(NAMES))
    .filter((key) => choice[key].length < ALL[key].length)
    .map((key) => `${NAMES[key]}=${choice[key].join(',')}`);
  return terms.length > 0 ? `?${terms.join('&')}` : '';
}
