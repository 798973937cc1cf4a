/** Values of a caller, checked before wasm copies them. */

import { cut, listed } from '../quoted.js';

/** Most fields of an object and elements of a list, far more than there are parameters. */
const MAX_FIELDS = 1000;

/**
 * The fields of a plain object.
 * @param {string} name the name in errors
 * @param {any} object
 * @returns {[string, any][]}
 */
export function fields(name, object) {
  if (!isPlain(object)) throw new TypeError(`${name} must be a plain object, not ${words(object)}`);
  const all = Object.entries(object);
  if (all.length > MAX_FIELDS) throw new RangeError(`${name} has more than ${MAX_FIELDS} fields`);
  return all;
}

/** Whether it is an object of no class, of this realm or another. */
function isPlain(/** @type {any} */ object) {
  if (typeof object !== 'object' || object === null || Array.isArray(object)) return false;
  const prototype = Object.getPrototypeOf(object);
  return prototype === null || Object.getPrototypeOf(prototype) === null;
}

/**
 * Ids and values as the two arrays that wasm takes; each object of `objects` becomes two such
 * arrays.
 * @param {[string, any][]} values
 */
export function columns(values) {
  return columnsOf(values, (id, value) =>
    id === 'objects' && Array.isArray(value) ? objects(value) : scalar(id, value),
  );
}

/** @param {[string, any][]} values @param {(id: string, value: any) => any} each */
function columnsOf(values, each) {
  return [values.map(([id]) => id), values.map(([id, value]) => each(id, value))];
}

/** A number, a text or a flag, and points as text; words for everything else, which wasm refuses. */
function scalar(/** @type {string} */ id, /** @type {any} */ value) {
  if (id === 'points' && Array.isArray(value)) {
    const pairs = value.slice(0, MAX_FIELDS);
    return pairs
      .map((pair) =>
        Array.isArray(pair) && pair.length === 2 ? pair.map((x) => (typeof x === 'number' ? x : words(x))) : 'no pair',
      )
      .join(' ');
  }
  return value === null || ['string', 'number', 'boolean', 'undefined'].includes(typeof value) ? value : words(value);
}

/** @param {any[]} list */
function objects(list) {
  if (list.length > MAX_FIELDS) throw new RangeError(`objects has more than ${MAX_FIELDS} elements`);
  // A list may have holes.
  return Array.from(list, (object, at) => columnsOf(fields(`objects[${at}]`, object), scalar));
}

/**
 * The error for the errors of wasm.
 * @param {any[]} errors
 * @param {any[][]} [values] the values of the call
 */
export function refusal(errors, values) {
  // Wasm has only words for some values.
  for (const error of errors) {
    for (const [id, value] of values ?? []) if (id === error.id) error.value = value;
  }
  const [first] = errors;
  return Object.assign(new RangeError(first.message), first, first.id && { errors });
}

/**
 * Throws for a name that is not among these.
 * @param {string} what @param {string} name @param {readonly string[]} names
 */
export function known(what, name, names) {
  if (names.includes(name)) return;
  throw new TypeError(`there is no ${what} ${words(name)}; there are ${listed(names)}`);
}

/**
 * Throws for a value that is not a whole number in this range.
 * @param {string} id @param {unknown} value @param {number} min @param {number} max
 */
export function whole(id, value, min, max) {
  if (typeof value === 'number' && Number.isInteger(value) && value >= min && value <= max) return;
  const message = `${id} = ${words(value)} is refused: it must be a whole number from ${min} to ${max}`;
  throw refusal([{ id, value, min, max, message }]);
}

/**
 * Throws for a value that is not a number in this range.
 * @param {string} id @param {unknown} value @param {number} min @param {number} max
 */
export function between(id, value, min, max) {
  if (typeof value === 'number' && value >= min && value <= max) return;
  const message = `${id} = ${words(value)} is refused: it must be a number from ${min} to ${max}`;
  throw refusal([{ id, value, min, max, message }]);
}

/** @param {string} id @param {unknown} value */
export function finite(id, value) {
  if (Number.isFinite(value)) return;
  throw refusal([{ id, value, message: `${id} = ${words(value)} is refused: it must be a finite number` }]);
}

/** @param {string} name @param {unknown} value */
export function text(name, value) {
  if (typeof value !== 'string') throw new TypeError(`${name} must be a text, not ${words(value)}`);
}

/** Any value in a few words. No code of the value runs. */
export function words(/** @type {unknown} */ value) {
  switch (typeof value) {
    case 'string':
      return `"${cut(value)}"`;
    case 'number':
    case 'boolean':
    case 'undefined':
      return String(value);
    case 'object':
      if (value === null) return 'null';
      return Array.isArray(value) ? 'an array' : 'an object';
    case 'bigint':
      return 'a big integer';
    default:
      return `a ${typeof value}`;
  }
}
