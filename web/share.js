/**
 * A fire's settings as an address, as a link and as HTML to paste.
 *
 * Pure functions from text to text, for pages and servers alike. What they take
 * are the settings of `exportConfig()`; what an address holds is checked by the
 * fire that it is given to, not here.
 *
 * @typedef {object} Config
 * @property {number} [hearth]  The version of the form: 1 or 2.
 * @property {string} [preset]  The preset that it starts from, if not the default one.
 * @property {{[id: string]: unknown}} [values]  What differs from that.
 * @property {object[]} [objects]  Its objects, where they are not the preset's.
 * @property {string} [label]  What it is called, for people.
 * @property {string} [description]  And what it shows.
 */

import { DEFAULTS, OWN_ATTRIBUTES } from './generated/defaults.js';
import { SOURCE } from './generated/objects.js';

/** Where this file is; what a bundler made of it is somewhere else. */
export const FILE = import.meta.url;

/** The preset's names in an address: the first is written, both are read. */
const PRESET = ['scene', 'preset'];

/** The element's attributes that are neither parameters nor the preset. */
const OWN = OWN_ATTRIBUTES.filter((name) => !PRESET.includes(name));

/** Room for a fire on a page that gives it none. */
const SIZE = { width: 320, height: 400 };

/**
 * The query of an address that gives this fire, without its question mark;
 * empty for a fire of the defaults.
 * @param {Config} config
 * @returns {string} `scene=seed&viscosity=0.02`
 */
export function toQuery(config) {
  const query = new URLSearchParams();
  if (config.preset !== undefined) query.set(PRESET[0], config.preset);
  for (const [name, value] of attributes(config)) query.set(name, value);
  return query.toString();
}

/**
 * What a query asks for. Values stay texts, and names that are no parameters
 * stay among them: the fire that gets them says what is wrong with which.
 * @param {string | URLSearchParams} search  With its question mark or without.
 * @param {Iterable<string>} [names]  What the page itself reads from its address.
 * @returns {{config: Config & {values: {[id: string]: string}}, others: URLSearchParams}}
 *   the fire's settings; and those names, with the element's own attributes
 */
export function fromQuery(search, names = []) {
  const apart = new Set([...OWN, ...names]);
  const others = new URLSearchParams();
  /** @type {[string, string][]} */
  const values = [];
  let preset;
  for (const [name, value] of new URLSearchParams(search)) {
    if (apart.has(name)) others.append(name, value);
    else if (PRESET.includes(name)) preset = value;
    else values.push([name.replaceAll('-', '_'), value]);
  }
  // A name such as `__proto__` becomes a plain key here, which the fire refuses.
  const config = { hearth: 1, ...(preset !== undefined && { preset }), values: Object.fromEntries(values) };
  return { config, others };
}

/**
 * The address of a page that shows this fire, and nothing else of its old query. It names
 * the scene `default` rather than nothing: an empty query shows what the page opens with.
 * @param {Config} config
 * @param {string | URL} base  The whole address of a page that reads its query.
 */
export function pageLink(config, base) {
  return addressOf(base, toQuery(config) || `${PRESET[0]}=default`);
}

/** @type {(base: string | URL, query: string) => string} */
function addressOf(base, query) {
  const url = new URL(base);
  url.search = query;
  url.hash = '';
  return url.href;
}

/**
 * HTML that shows this fire on any page.
 * @param {Config} config
 * @param {string | URL} [scriptUrl]  Where `hearth-fire.js` is; without it, the element
 *   alone, for a page that has it.
 * @throws {RangeError} a value whose name is no parameter's
 */
export function elementCode(config, scriptUrl) {
  const named = attributes(config).map(([name, value]) => {
    const id = name.replaceAll('-', '_');
    if (!Object.hasOwn(DEFAULTS, id) && id !== 'objects') {
      throw new RangeError(`${JSON.stringify(shortened(name))} is not a parameter of a fire`);
    }
    return value === 'true' ? name : attribute(name, value);
  });
  if (config.preset !== undefined) named.unshift(attribute('preset', config.preset));
  named.push(attribute('style', `width: ${SIZE.width}px; height: ${SIZE.height}px`));
  const element = `<hearth-fire ${named.join(' ')}></hearth-fire>`;
  if (scriptUrl === undefined) return element;
  return `<script type="module" ${attribute('src', String(scriptUrl))}></script>\n${element}`;
}

/**
 * HTML that shows this fire on any page in a frame of its own.
 * @param {Config} config
 * @param {string | URL} embedUrl  The whole address of `embed.html`.
 */
export function iframeCode(config, embedUrl) {
  const parts = [
    attribute('src', addressOf(embedUrl, toQuery(config))),
    attribute('width', String(SIZE.width)),
    attribute('height', String(SIZE.height)),
    // Of another colour scheme than its page the frame would get an opaque ground.
    'style="border: 0; color-scheme: light" loading="lazy" title="A fire"',
  ];
  return `<iframe ${parts.join(' ')}></iframe>`;
}

/**
 * The objects by the ids of parameters, where one source is all that there is, and else as JSON.
 * @param {Config} config
 * @returns {{[id: string]: unknown}}
 */
function ofObjects({ objects }) {
  if (!objects) return {};
  const [first = {}, ...others] = objects;
  const { kind, ...properties } = /** @type {{[name: string]: unknown}} */ (first);
  const isPlain = kind === 'source' && others.length === 0 && Object.keys(properties).every((name) => name in SOURCE);
  if (!isPlain) return { objects: JSON.stringify(objects) };
  return Object.fromEntries(Object.entries(properties).map(([name, value]) => [SOURCE[/** @type {keyof typeof SOURCE} */ (name)], value]));
}

/**
 * The values by the names of their attributes, the model first.
 * @param {Config} config
 * @returns {[string, string][]}
 */
function attributes(config) {
  const named = Object.entries({ ...config.values, ...ofObjects(config) }).map(
    ([id, value]) => /** @type {[string, string]} */ ([id.replaceAll('_', '-'), String(value)]),
  );
  return named.sort(([a], [b]) => Number(b === 'model') - Number(a === 'model'));
}

/** @type {(name: string, value: string) => string} */
function attribute(name, value) {
  return `${name}="${escaped(value)}"`;
}

/** @type {{[character: string]: string}} */
const ESCAPES = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;' };

/** @param {string} text */
function escaped(text) {
  return text.replace(/[&<>"']/g, (character) => ESCAPES[character]);
}

/** @param {string} name */
function shortened(name) {
  return name.length > 40 ? `${name.slice(0, 40)}…` : name;
}
