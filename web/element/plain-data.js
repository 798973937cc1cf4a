/**
 * Values of a page as plain data: in messages, in refusals and in attributes.
 */

/** The maximum number of fields of an object, items of a list and characters of a text; far more than any value has. */
const MAX_FIELDS = 1000;

/** The maximum length of a text that draws an outline, and its names. */
const MAX_OUTLINE = 66_000;
const OUTLINES = ['points', 'mask'];

/** The maximum length of the name of a field. */
const MAX_NAME = 100;

/**
 * A copy of a value as plain data, which can be posted, without fields that are undefined. A value that is no plain data becomes a
 * description or an empty value, which the engine refuses with its id. No getter of the page runs after this.
 * @param {unknown} value
 * @param {number} [depth] the levels of nesting that are copied
 * @param {number} [longest] the maximum length of a text
 * @returns {any}
 */
export function postable(value, depth = 0, longest = MAX_FIELDS) {
  if (longest === MAX_OUTLINE && Array.isArray(value)) return pairs(value);
  if (Array.isArray(value)) return depth > 0 ? value.slice(0, MAX_FIELDS).map((item) => postable(item, depth - 1)) : [];
  if (typeof value === 'object' && value !== null) {
    const given = depth > 0 ? Object.entries(value) : [];
    if (given.length > MAX_FIELDS) return 'an object of more than a thousand fields';
    const fields = given.map(([name, field]) => {
      const most = OUTLINES.includes(name) ? MAX_OUTLINE : MAX_FIELDS;
      return [name.slice(0, MAX_NAME), postable(field, depth - 1, most)];
    });
    // A field without a value states nothing.
    return Object.fromEntries(fields.filter(([, field]) => field !== undefined));
  }
  // Wasm would keep the memory of a copy.
  if (typeof value === 'string' && value.length > longest) return `a text of more than ${longest} letters`;
  return ['function', 'symbol', 'bigint'].includes(typeof value) ? `a ${typeof value}` : value;
}

/** A list of pairs of numbers as text: `0,0.1 0.2,-0.1`. @param {unknown[]} list */
const pairs = (list) =>
  list
    .slice(0, MAX_FIELDS)
    .map((pair) => (Array.isArray(pair) && pair.length === 2 ? pair.join() : 'no pair'))
    .join(' ');

/** The names of the properties of each element that have a value. @type {WeakMap<HTMLElement, Set<string>>} */
const STATED = new WeakMap();

/**
 * The value that a property gets. `undefined` states nothing; after a value of the same property it is null, because
 * React writes it to a property that is taken away.
 * @template T
 * @param {HTMLElement} element
 * @param {string} name
 * @param {T} value
 * @returns {T | null}
 */
export function stated(element, name, value) {
  const names = STATED.get(element) ?? new Set();
  STATED.set(element, names);
  const wasStated = names.delete(name);
  if (value === undefined) return wasStated ? null : value;
  names.add(name);
  return value;
}

/**
 * Sets an attribute to the value of a property, or removes it for null.
 * @param {HTMLElement} element
 * @param {string} name
 * @param {unknown} value
 */
export function setOrRemove(element, name, value) {
  const text = stated(element, name, value);
  if (text === null) element.removeAttribute(name);
  else if (text !== undefined) element.setAttribute(name, String(text));
}
