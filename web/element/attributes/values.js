/**
 * Values that only the browser can resolve: CSS colours, and the seed of `seed="auto"`.
 *
 * They are resolved when a call is sent. The element is on a page then, which `var()` and the order of
 * the fires depend on.
 *
 * @typedef {import('../../engine/engine.js').Call} Call
 */

import { DEFAULTS } from './attributes.js';

/** The automatic seed of each element. @type {WeakMap<Element, number>} */
const SEEDS = new WeakMap();

/** The number of automatic seeds in each document. @type {WeakMap<Document, number>} */
const COUNTS = new WeakMap();

/**
 * The automatic seed of a fire. It keeps its seed, and each fire of a document has another one. The
 * same page has the same seeds each time.
 * @param {Element} fire
 */
export function seedOf(fire) {
  let seed = SEEDS.get(fire);
  if (seed === undefined) {
    seed = (COUNTS.get(fire.ownerDocument) ?? 0) + 1;
    COUNTS.set(fire.ownerDocument, seed);
    // MurmurHash3's finalizer: neighbouring counts get unrelated bits.
    seed = Math.imul(seed ^ (seed >>> 16), 0x85ebca6b);
    seed = Math.imul(seed ^ (seed >>> 13), 0xc2b2ae35);
    seed = (seed ^ (seed >>> 16)) >>> 0;
    SEEDS.set(fire, seed);
  }
  return seed;
}

/** Whether a text is a colour in the engine's form. @param {unknown} value */
const isHex = (value) => /^(#(?!.{4}$)|transparent$)/.test(String(value));

/** Whether a parameter is a colour. @param {string} id */
export const isColour = (id) => isHex(DEFAULTS[/** @type {keyof typeof DEFAULTS} */ (id)]);

/**
 * A colour in the engine's form; the same text if it is no colour of this browser.
 * @param {string} colour in CSS
 * @param {Element} fire an element on a page, whose custom properties and own colour count
 */
export function hexOf(colour, fire) {
  // Every form of a colour becomes three sRGB numbers in a mixture.
  const mixture = `color-mix(in srgb, ${colour}, ${colour})`;
  if (isHex(colour) || !CSS.supports('color', mixture)) return colour;
  const probe = document.createElement('i');
  probe.style.cssText = 'forced-color-adjust: none';
  probe.style.backgroundColor = mixture;
  fire.shadowRoot?.append(probe);
  // The form is another one if a custom property is missing.
  const srgb = getComputedStyle(probe).backgroundColor.match(/^color\(srgb (\S+) (\S+) ([^\s)]+)(?: \/ ([^)]+))?/);
  probe.remove();
  if (!srgb) return colour;
  const bytes = srgb.slice(1).map((channel = '1') => Math.round(Math.min(Math.max(Number(channel) || 0, 0), 1) * 255));
  return `#${bytes.map((byte) => byte.toString(16).padStart(2, '0')).join('')}`;
}

/**
 * A call with its values resolved. Objects of values are changed in place: no other fire has them.
 * @param {Call} call
 * @param {Element} fire
 * @returns {Call}
 */
export function resolved([method, given, ...others], fire) {
  if (fire.getAttribute('seed') === 'auto') {
    // A call that replaces every value keeps the seed, unless it names one.
    if (method === 'preset') [method, given] = ['import', { preset: given }];
    if (method === 'import') others[1] = true;
    if (method === 'add' && given.config?.values?.seed === undefined) given.values = { seed: 'auto', ...given.values };
  }
  /** @type {{[method: string]: any[]}} */
  const all = { set: [given], check: [given], import: [given?.values], add: [given?.values, given?.config?.values] };
  for (const values of all[method] ?? []) {
    for (const id in values) {
      const value = values[id];
      if (id === 'seed' && value === 'auto') values[id] = seedOf(fire);
      else if (isColour(id) && typeof value === 'string') values[id] = hexOf(value, fire);
    }
  }
  return [method, given, ...others];
}
