/** Particles and embers as rows of numbers, which wasm takes and gives. */

import { fields, known, words } from './values.js';

/** Most particles that wasm takes. More are refused before they are copied. */
const MAX_PARTICLES = 400_000;

/** The properties of a particle in the order of wasm, each with its count of numbers. */
export const PARTICLE = {
  positions: 2,
  velocities: 2,
  temperatures: 1,
  ages: 1,
  lifetimes: 1,
  fuel: 1,
  oxygen: 1,
  soot: 1,
};
const PARTICLE_NUMBERS = 10;

/** The properties of an ember in the order of wasm. */
const EMBER = { positions: 2, velocities: 2, temperatures: 1, sizes: 1, ages: 1, lifetimes: 1 };
const EMBER_NUMBERS = 8;

/**
 * An array a property, from all numbers of one ember, then of the next.
 * @param {Float32Array} numbers
 */
export function embersOf(numbers) {
  const count = numbers.length / EMBER_NUMBERS;
  /** @type {any} */
  const embers = { count };
  let from = 0;
  for (const [name, width] of Object.entries(EMBER)) {
    embers[name] = Float32Array.from(
      { length: count * width },
      (_, at) => numbers[index(at, width, EMBER_NUMBERS) + from],
    );
    from += width;
  }
  return embers;
}

/** The states of a solid with fuel in the order of wasm. */
const STATES = ['burnt', 'unlit', 'out', 'no-oxygen', 'burning'];

/**
 * The solids with fuel, from all numbers of one, then of the next.
 * @param {Float32Array} numbers
 */
export function fuelsOf(numbers) {
  return Array.from({ length: numbers.length / 8 }, (_, at) => {
    const [id, state, first, fuel, water, char, power, temperature] = numbers.subarray(8 * at);
    return { id, state: STATES[state], first, fuel, water, char, power, temperature };
  });
}

/**
 * All numbers of one particle, then of the next, from an array or a number a property.
 * @param {unknown} particles
 * @param {() => number} airTemperature
 */
export function numbersOf(particles, airTemperature) {
  const given = fields('particles', particles);
  for (const [name] of given) known('property of particles', name, Object.keys(PARTICLE));
  const { positions: places, ...others } = Object.fromEntries(given.filter(([, value]) => value !== undefined));
  const positions = list('positions', places);
  const count = positions.length / 2;
  if (!Number.isInteger(count)) {
    throw new RangeError(`positions has ${2 * count} numbers: it must have two for each particle`);
  }
  if (count > MAX_PARTICLES) {
    throw new RangeError(`the particles are refused: there may be ${MAX_PARTICLES} of them at most`);
  }
  /** @type {{[name: string]: unknown}} */
  const values = {
    positions,
    velocities: 0,
    temperatures: airTemperature(),
    ages: 0,
    lifetimes: Infinity,
    fuel: 0,
    oxygen: 1,
    soot: 0,
    ...others,
  };
  const numbers = new Float32Array(count * PARTICLE_NUMBERS);
  let from = 0;
  for (const [name, width] of Object.entries(PARTICLE)) {
    fill(numbers, from, name, width, values[name]);
    from += width;
  }
  return numbers;
}

/**
 * The numbers of an array or a typed array. Throws for everything else.
 * @param {string} name @param {any} given
 * @returns {any}
 */
function list(name, given) {
  if (ArrayBuffer.isView(given) && !(given instanceof DataView)) return given;
  if (Array.isArray(given)) return given.slice(0, 2 * MAX_PARTICLES + 2);
  throw new TypeError(`${name} must be an array of numbers, not ${words(given)}`);
}

/**
 * Copies one property of all particles.
 * @param {Float32Array} numbers all numbers of one particle, then of the next
 * @param {number} from the first number of the property in a particle
 * @param {string} name @param {number} width
 * @param {any} given an array, or one number for all
 */
function fill(numbers, from, name, width, given) {
  const count = numbers.length / PARTICLE_NUMBERS;
  const values = typeof given === 'number' ? undefined : list(name, given);
  if (values && values.length !== count * width) {
    const required = width === 1 ? 'one' : 'two';
    throw new RangeError(
      `${name} has ${values.length} numbers: it must have ${required} for each of ${count} particles`,
    );
  }
  for (let at = 0; at < count * width; at += 1) {
    const number = values ? values[at] : given;
    if (typeof number !== 'number') {
      throw new TypeError(`${name}[${at}] must be a number, not ${words(number)}`);
    }
    numbers[index(at, width, PARTICLE_NUMBERS) + from] = number;
  }
}

/** The index of number `at` of a property whose first number is at 0. */
function index(/** @type {number} */ at, /** @type {number} */ width, /** @type {number} */ all) {
  return Math.floor(at / width) * all + (at % width);
}
