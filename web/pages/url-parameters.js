/**
 * The URL parameters of a page with a fire: `?scene=seed&viscosity=0.01&paused`.
 *
 * They are untrusted. An invalid value affects no other value, each refusal has a reason, and no value
 * makes the page fetch anything.
 *
 * @typedef {object} UrlParameters
 * @property {string | undefined} scene  The preset.
 * @property {[string, string][]} values  Parameters, the model first.
 * @property {[string, string][]} options  The element's own attributes.
 * @property {URLSearchParams} others  The page's own parameters.
 * @property {[string, string][]} unknown  Parameters of others, such as `fbclid` or `utm_source`.
 * @property {string[]} refused  The reasons why parameters are refused.
 */

import { DEFAULTS, OWN_ATTRIBUTES } from '../generated/defaults.js';
import { alike } from '../element/attributes/spelling.js';
import { cut } from '../quoted.js';
import { fromQuery } from '../share.js';
import { parametersOf } from '../share/strangers.js';

/** The maximum length of the query in characters; some servers have the same limit. */
const MAX_LENGTH = 8192;

/** The maximum number of parameters: more than twice as many as there are. */
const MAX_COUNT = 200;

/**
 * The element's own attributes that a URL may set. `src` and `poster` are absent: a link must not choose
 * what a visitor's browser fetches.
 */
export const OPTIONS = /** @type {const} */ ([
  'align',
  'alt',
  'autoplay',
  'controls',
  'decorative',
  'fit',
  'fps-limit',
  'interactive',
  'loading',
  'max-pixels',
  'objects',
  'pan',
  'paused',
  'quality',
  'reduced-motion',
  'touch-action',
  'warm',
  'zoom',
]);

/** All names of the fire. */
const KNOWN = ['scene', ...OWN_ATTRIBUTES, ...Object.keys(DEFAULTS).map((id) => id.replaceAll('_', '-'))];

/**
 * Reads URL parameters.
 * @param {string} search  As in `location.search`.
 * @param {string[]} [names]  The page's own parameters.
 * @returns {UrlParameters}
 */
export function readUrlParameters(search, names = []) {
  const query = parametersOf(search.length > MAX_LENGTH ? '' : search);
  const refused = [];
  if (search.length > MAX_LENGTH) {
    refused.push(`The URL parameters are ignored: they are longer than ${MAX_LENGTH} characters.`);
  }
  const count = [...query].length;
  const once = new URLSearchParams();
  /** @type {[string, string][]} */
  const unknown = [];
  if (count > MAX_COUNT) {
    refused.push(`The URL parameters are ignored: they set ${count} values, and at most ${MAX_COUNT} are allowed.`);
  } else {
    const known = new Set();
    for (const [name, value] of query) {
      const same = name === 'preset' ? 'scene' : name.replaceAll('_', '-');
      if (!names.includes(name) && !KNOWN.includes(same)) {
        // Names of others are short, or words such as `source`. A misspelt name of the fire is nearly right.
        const isWord = KNOWN.some((known) => known.split('-').includes(name));
        const [meant] = isWord ? [] : alike(name, KNOWN, Math.floor(name.length / 5));
        if (meant === undefined) unknown.push([name, value]);
        else refused.push(`The URL parameter “${cut(name)}” is unknown; did you mean “${meant}”?`);
        continue;
      }
      if (known.has(same) && !names.includes(name)) {
        refused.push(`The URL names “${cut(name)}” more than once; the first one applies.`);
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
    if (OPTIONS.some((option) => option === name)) options.push([name, value]);
    else refused.push(`The URL parameters cannot set “${cut(name)}”.`);
  }
  const values = Object.entries(config.values).map(
    ([id, value]) => /** @type {[string, string]} */ ([id, String(value)]),
  );
  // The model decides which values are valid.
  values.sort(([a], [b]) => Number(b === 'model') - Number(a === 'model'));
  return { scene: config.preset, values, options, others, unknown, refused };
}

/**
 * Applies URL parameters to a new fire, each value by itself. The fire reports what it refuses.
 * @param {import('../hearth-fire.js').HearthFire} fire
 * @param {UrlParameters} parameters
 */
export function applyUrlParameters(fire, { scene, values, options, unknown }) {
  if (unknown.length > 0) {
    const names = unknown.map(([name]) => `“${cut(name)}”`).join(', ');
    console.info(`Hearth: the URL parameters ${names} are not for the fire.`);
  }
  for (const [name, value] of options) fire.setAttribute(name, value);
  // A preset replaces the values, so it is set first.
  if (scene !== undefined) fire.setAttribute('preset', scene);
  for (const [id, value] of values) fire.set(/** @type {any} */ (id), value);
}
