/**
 * The URL parameters of a page with a fire: `?scene=seed&viscosity=0.01&paused`.
 *
 * Anyone can write an address. A bad value affects no other value, each refusal says why, and no value
 * makes the page fetch anything.
 *
 * @typedef {object} Address
 * @property {string | undefined} scene  The preset that it names.
 * @property {[string, string][]} values  Parameters, the model first.
 * @property {[string, string][]} options  The element's own attributes.
 * @property {URLSearchParams} others  What the page itself asked for.
 * @property {[string, string][]} unknown  What is not for the fire, as `fbclid` or `utm_source`.
 * @property {string[]} refused  What was not taken, in words.
 */

import { DEFAULTS, OWN_ATTRIBUTES } from '../generated/defaults.js';
import { alike } from '../element/spelling.js';
import { fromQuery } from '../share.js';

/** Longest query that is read, in characters; some servers take no longer one either. */
const LONGEST = 8192;

/** Most names in it: more than twice as many as there are. */
const MOST = 200;

/**
 * What of the element's own an address may say. `src` and `poster` are left out:
 * a link must not choose what a visitor's browser fetches.
 */
export const OPTIONS = [
  'align', 'alt', 'autoplay', 'controls', 'fit', 'fps-limit', 'interactive', 'loading', 'max-pixels', 'objects', 'paused',
  'quality', 'reduced-motion', 'touch-action', 'warm',
];

/** All names that are about the fire. */
const KNOWN = ['scene', ...OWN_ATTRIBUTES, ...Object.keys(DEFAULTS).map((id) => id.replaceAll('_', '-'))];

/**
 * Reads an address.
 * @param {string} search  As in `location.search`.
 * @param {string[]} [names]  What the page asks for besides.
 * @returns {Address}
 */
export function readAddress(search, names = []) {
  const query = new URLSearchParams(search.length > LONGEST ? '' : search);
  const refused = [];
  if (search.length > LONGEST) {
    refused.push(`The address is longer than ${LONGEST} characters; nothing of it was taken.`);
  }
  const count = [...query].length;
  const once = new URLSearchParams();
  /** @type {[string, string][]} */
  const unknown = [];
  if (count > MOST) {
    refused.push(`The address names ${count} values, and at most ${MOST} are read; none of them was taken.`);
  } else {
    const known = new Set();
    for (const [name, value] of query) {
      const same = name === 'preset' ? 'scene' : name.replaceAll('_', '-');
      if (!names.includes(name) && !KNOWN.includes(same)) {
        // Other people’s names are short and many, or words, as `source`; a misspelt one of ours is nearly right.
        const isWord = KNOWN.some((one) => one.split('-').includes(name));
        const [meant] = isWord ? [] : alike(name, KNOWN, Math.floor(name.length / 5));
        if (meant === undefined) unknown.push([name, value]);
        else refused.push(`The address names ${shortened(name)}; did you mean ${meant}?`);
        continue;
      }
      if (known.has(same) && !names.includes(name)) {
        refused.push(`The address names ${shortened(name)} more than once; the first one counts.`);
      } else {
        once.append(name, value);
      }
      known.add(same);
    }
  }
  const { config, others } = fromQuery(`${once}`, names);
  /** @type {[string, string][]} */
  const options = [];
  for (const [name, value] of [...others]) {
    if (names.includes(name)) continue;
    others.delete(name);
    if (OPTIONS.includes(name)) options.push([name, value]);
    else refused.push(`The address cannot set ${shortened(name)}.`);
  }
  const values = Object.entries(config.values).map(
    ([id, value]) => /** @type {[string, string]} */ ([id, String(value)]),
  );
  // The model decides what the others may be.
  values.sort(([a], [b]) => Number(b === 'model') - Number(a === 'model'));
  return { scene: config.preset, values, options, others, unknown, refused };
}

/**
 * Gives a fire that has just been made what its address says, each value by
 * itself. The fire says what it refuses, as always.
 * @param {import('../hearth-fire.js').HearthFire} fire
 * @param {Address} address
 */
export function applyAddress(fire, { scene, values, options, unknown }) {
  if (unknown.length > 0) {
    const names = unknown.map(([name]) => shortened(name)).join(', ');
    console.info(`Hearth: the address also names ${names}, of which a fire knows nothing.`);
  }
  for (const [name, value] of options) fire.setAttribute(name, value);
  // Before the values, which it would replace.
  if (scene !== undefined) fire.setAttribute('preset', scene);
  for (const [id, value] of values) fire.set(/** @type {any} */ (id), value);
}

/** @param {string} name */
function shortened(name) {
  return `“${name.length > 40 ? `${name.slice(0, 40)}…` : name}”`;
}
