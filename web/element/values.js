/**
 * Values that only the browser can resolve: any CSS colour, and the seed of `seed="auto"`.
 *
 * They are resolved when a call is sent: the element is on a page then, which `var()` and the order
 * of the fires depend on.
 *
 * @typedef {import('../engine/engine.js').Call} Call
 */

import { DEFAULTS } from '../generated/defaults.js';

/** The seeds of those that got one by themselves. @type {WeakMap<Element, number>} */
const SEEDS = new WeakMap();

/** How many that were in each document. @type {WeakMap<Document, number>} */
const COUNTS = new WeakMap();

/**
 * The seed that a fire gets by itself: it keeps it, and the next one of its document has
 * another. The same page has the same seeds each time.
 * @param {Element} fire
 */
export function seedOf(fire) {
  let seed = SEEDS.get(fire);
  if (seed === undefined) {
    const count = (COUNTS.get(fire.ownerDocument) ?? 0) + 1;
    COUNTS.set(fire.ownerDocument, count);
    seed = mixed(count);
    SEEDS.set(fire, seed);
  }
  return seed;
}

/** Bits that have nothing to do with those of the next number: MurmurHash3's last step. @param {number} bits */
function mixed(bits) {
  bits = Math.imul(bits ^ (bits >>> 16), 0x85ebca6b);
  bits = Math.imul(bits ^ (bits >>> 13), 0xc2b2ae35);
  return (bits ^ (bits >>> 16)) >>> 0;
}

/** @param {unknown} one */
const isObject = (one) => typeof one === 'object' && one && !Array.isArray(one);

/** Whether a parameter is a colour. @param {string} id */
export const isColour = (id) => /^(#|transparent$)/.test(String(DEFAULTS[/** @type {keyof typeof DEFAULTS} */ (id)]));

/**
 * A colour as the engine reads it; what is no colour of this browser, as it is.
 * @param {string} colour as CSS has it
 * @param {Element} fire one on a page, whose custom properties and own colour count
 */
export function hexOf(colour, fire) {
  // Of four digits the engine reads none.
  if (/^#(?!.{4}$)|^transparent$/.test(colour)) return colour;
  // Whatever form a colour has, a mixture of it has three numbers of sRGB.
  const mixture = `color-mix(in srgb, ${colour}, ${colour})`;
  if (!CSS.supports('color', mixture)) return colour;
  const probe = document.createElement('i');
  probe.style.cssText = 'forced-color-adjust: none';
  probe.style.backgroundColor = mixture;
  fire.shadowRoot?.append(probe);
  // Another form where it has a custom property that is not there.
  const srgb = getComputedStyle(probe).backgroundColor.match(/^color\(srgb (\S+) (\S+) ([^\s)]+)(?: \/ ([^)]+))?/);
  probe.remove();
  if (!srgb) return colour;
  const digits = [1, 2, 3, 4].map((at) => {
    const part = srgb[at] ?? 1;
    const byte = Math.round(Math.min(Math.max(Number(part) || 0, 0), 1) * 255);
    return byte.toString(16).padStart(2, '0');
  });
  return `#${digits.join('')}`;
}

/**
 * A call as the engine reads it. Its values are changed in place: they are data that
 * no other fire has.
 * @param {Call} call
 * @param {Element} fire
 * @returns {Call}
 */
export function meant([method, given, ...rest], fire) {
  if (fire.getAttribute('seed') === 'auto') {
    // What replaces every value leaves it its own seed, unless it names one.
    if (method === 'preset') [method, given] = ['import', { preset: given }];
    if ((method === 'import' || method === 'add') && isObject(given)) {
      given = { ...given, values: { seed: 'auto', ...given.values } };
    }
  }
  /** @type {{[method: string]: any[]}} */
  const all = { set: [given], check: [given], import: [given?.values], add: [given?.values, given?.config?.values] };
  for (const sent of all[method] ?? []) {
    for (const id in sent) {
      const value = sent[id];
      if (id === 'seed' && value === 'auto') sent[id] = seedOf(fire);
      else if (isColour(id) && typeof value === 'string') sent[id] = hexOf(value, fire);
    }
  }
  return [method, given, ...rest];
}
