/**
 * A fire's settings as URL parameters, as a link and as HTML. Settings that are too long for URL parameters are a
 * compressed fragment.
 *
 * Pure functions for pages and servers. They take the settings of `exportConfig()`. They validate no
 * values: the fire that receives a URL's values does.
 *
 * @typedef {object} Config
 * @property {number} [hearth]  The version of the format, 3.
 * @property {string} [preset]  The preset, unless it is the default one.
 * @property {{[id: string]: unknown}} [values]  The values that differ from the preset.
 * @property {object[]} [objects]  The objects, unless they are the preset's.
 * @property {string} [label]  A title for people.
 * @property {string} [description]  A description for people.
 * @property {string} [author]  Who made the scene.
 * @property {string} [licence]  Its licence.
 *
 * @typedef {object} Shown  How generated HTML shows a fire.
 * @property {number} [width]  Its width [CSS px], 320 by default.
 * @property {number} [height]  Its height [CSS px], 400 by default.
 * @property {{[name: string]: string}} [attributes]  The element's own attributes, such as `warm`.
 */

import { DEFAULTS, OWN_ATTRIBUTES } from './generated/defaults.js';
import { cut } from './quoted.js';

/** The URL of this file, or of the bundle that contains it. */
export const FILE = import.meta.url;

/** The URL parameters of the preset: the first is written, both are read. */
const PRESET = ['scene', 'preset'];

/** The element's attributes that are neither parameters nor the preset. */
const OWN = OWN_ATTRIBUTES.filter((name) => !PRESET.includes(name));

/** What the fragment of settings begins with, also encoded. */
const SETTINGS = /^#fire(=|%(25)*3d)/i;

/** The most characters of URL parameters that are written; longer settings become a fragment. */
export const MAX_QUERY = 2000;

/**
 * The URL parameters of a fire, without the question mark; empty for the defaults.
 * @param {Config} config
 * @returns {string} `scene=seed&viscosity=0.02`
 */
export function toQuery(config) {
  const { preset, attributes } = settingsOf(config);
  const query = new URLSearchParams();
  if (preset !== undefined) query.set(PRESET[0], preset);
  for (const [name, value] of attributes) query.set(name, value);
  return query.toString();
}

/**
 * The settings in URL parameters. Values stay strings, and unknown names stay among them: the fire that
 * receives them reports what is invalid.
 * @param {string | URLSearchParams} search  With or without its question mark.
 * @param {Iterable<string>} [names]  The page's own URL parameters.
 * @returns {{config: Config & {values: {[id: string]: string}}, others: URLSearchParams}}
 *   the fire's settings; and the page's own parameters with the element's own attributes
 */
export function fromQuery(search, names = []) {
  if (typeof search !== 'string' && !(search instanceof URLSearchParams))
    throw new TypeError(`search must be a text or URLSearchParams, not ${kindOf(search)}`);
  if (typeof names?.[Symbol.iterator] !== 'function') throw new TypeError(`names must be a list, not ${kindOf(names)}`);
  const reserved = new Set([...OWN, ...names]);
  const others = new URLSearchParams();
  /** @type {[string, string][]} */
  const values = [];
  let preset;
  for (const [written, value] of new URLSearchParams(search)) {
    // An ampersand that a program has written as HTML.
    const name = written.replace(/^(amp;)+/, '');
    if (reserved.has(name)) others.append(name, value);
    else if (PRESET.includes(name)) preset = value;
    else values.push([name.replaceAll('-', '_'), value]);
  }
  // A name such as `__proto__` becomes an own key, which the fire refuses.
  const config = { hearth: 3, ...(preset !== undefined && { preset }), values: Object.fromEntries(values) };
  return { config, others };
}

/**
 * The settings in the fragment of a URL; undefined if it has none. Nobody has validated them.
 * @param {string} hash  With its number sign.
 * @returns {Promise<Config | undefined>}
 * @throws {RangeError} the fragment is damaged
 */
export async function fromFragment(hash) {
  if (typeof hash !== 'string') throw new TypeError(`hash must be a text, not ${kindOf(hash)}`);
  if (!SETTINGS.test(hash)) return undefined;
  const { settingsOf } = await import('./share/fragment.js');
  return settingsOf(hash);
}

/**
 * The URL of a page that shows this fire. It replaces the URL parameters and the fragment of `base`. The default scene
 * is named, because a page without URL parameters shows its own scene.
 * @param {Config} config
 * @param {string | URL} base  The absolute URL of a page that applies its URL parameters.
 * @returns {Promise<string>}
 * @throws {RangeError} the settings are too long for an address
 */
export function pageLink(config, base) {
  return urlOf('base', base, config, `${PRESET[0]}=default`);
}

/**
 * Whether settings become URL parameters. Servers and their logs see those, but no fragment: a mask, which may be a
 * visitor's word or logo, travels in the fragment alone.
 * @param {Config} config
 * @param {string} [query]  Their URL parameters.
 */
export function fitsQuery({ objects, ...config }, query = toQuery({ ...config, ...(objects && { objects }) })) {
  const hasMask = objects?.some((object) => /** @type {{shape?: string}} */ (object)?.shape === 'mask');
  return query.length <= MAX_QUERY && !hasMask;
}

/** @type {(name: string, base: string | URL, config: Config, otherwise?: string) => Promise<string>} */
async function urlOf(name, base, config, otherwise = '') {
  const query = toQuery(config);
  const isShort = fitsQuery(config, query);
  const text = textOf(name, base);
  let url;
  try {
    url = new URL(text);
  } catch {
    throw new TypeError(`${name} must be an absolute URL, not "${cut(text)}"`);
  }
  url.search = isShort ? query || otherwise : '';
  url.hash = isShort ? '' : await (await import('./share/fragment.js')).fragmentOf(config);
  return url.href;
}

/**
 * HTML that shows this fire on any page.
 * @param {Config} config
 * @param {string | URL} [scriptUrl]  The URL of `hearth-fire.js`; without it, the HTML is the element alone.
 * @param {Shown} [shown]
 * @throws {RangeError} a name is not a parameter
 */
export function elementCode(config, scriptUrl, shown) {
  const named = elementAttributes(config, shown).map(([name, value]) => (value === '' ? name : attribute(name, value)));
  const element = `<hearth-fire ${named.join(' ')}></hearth-fire>`;
  if (scriptUrl === undefined) return element;
  return `<script type="module" ${attribute('src', textOf('scriptUrl', scriptUrl))}></script>\n${element}`;
}

/**
 * The attributes of that element, in order; the value of a flag is empty.
 * @param {Config} config
 * @param {Shown} [shown]
 * @returns {[name: string, value: string][]}
 * @throws {RangeError} a name is not a parameter
 */
export function elementAttributes(config, shown) {
  const { preset, attributes } = settingsOf(config);
  const { width, height, own } = checked(shown);
  /** @type {[string, string][]} */
  const named = attributes.map(([name, value]) => {
    const id = name.replaceAll('-', '_');
    if (!Object.keys(DEFAULTS).includes(id) && id !== 'objects') {
      throw new RangeError(`"${cut(name)}" is not a parameter of a fire`);
    }
    return [name, value === 'true' ? '' : value];
  });
  named.push(.../** @type {[string, string][]} */ (own));
  if (preset !== undefined) named.unshift(['preset', preset]);
  named.push(['style', `width: ${width}px; max-width: 100%; height: ${height}px`]);
  return named;
}

/**
 * HTML that shows this fire in an iframe.
 * @param {Config} config
 * @param {string | URL} embedUrl  The absolute URL of `embed.html`.
 * @param {Shown} [shown]
 * @returns {Promise<string>}
 * @throws {RangeError} the settings are too long for an address
 */
export async function iframeCode(config, embedUrl, shown) {
  const { width, height, own } = checked(shown);
  const url = new URL(await urlOf('embedUrl', embedUrl, config));
  const options = new URLSearchParams(own).toString().replace(/=(?=&|$)/g, '');
  url.search = [url.search.slice(1), options].filter(Boolean).join('&');
  const attributes = [
    attribute('src', url.href),
    attribute('width', String(width)),
    attribute('height', String(height)),
    // An iframe with another colour scheme than its page gets an opaque background.
    'style="border: 0; max-width: 100%; color-scheme: light" loading="lazy" allow="autoplay" title="A fire"',
  ];
  return `<iframe ${attributes.join(' ')}></iframe>`;
}

/** @type {(name: string, value: string) => string} */
function attribute(name, value) {
  return `${name}="${escaped(value)}"`;
}

/** @type {{[character: string]: string}} */
const ESCAPES = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;' };

/** @param {string} text */
export function escaped(text) {
  return text.replace(/[&<>"']/g, (character) => ESCAPES[character]);
}

/**
 * How a fire is shown, with defaults.
 * @param {Shown} [shown]
 * @throws {RangeError} a size is no size, or an attribute is not the element's own
 */
function checked(shown = {}) {
  if (!isObject(shown)) throw new TypeError(`shown must be an object, not ${kindOf(shown)}`);
  const { width = 320, height = 400, attributes: own = {} } = shown;
  for (const [name, size] of Object.entries({ width, height }))
    if (!(typeof size === 'number' && size > 0 && size < Infinity))
      throw new RangeError(`shown.${name} must be a positive number, not ${kindOf(size)}`);
  if (!isObject(own)) throw new TypeError(`shown.attributes must be an object, not ${kindOf(own)}`);
  const named = Object.entries(own);
  for (const [name, value] of named) {
    if (!OWN.includes(name)) throw new RangeError(`shown.attributes: "${cut(name)}" is no attribute`);
    if (!isPrimitive(value))
      throw new TypeError(`shown.attributes.${name} must be a number, a text or a flag, not ${kindOf(value)}`);
  }
  return { width, height, own: named.map(([name, value]) => [name, String(value)]) };
}

/**
 * What settings have: the preset, and the values as attributes, the model first.
 * @param {unknown} config
 * @returns {{preset?: string, attributes: [string, string][]}}
 * @throws {TypeError} they have another form
 */
function settingsOf(config) {
  if (!isObject(config)) throw new TypeError(`config must be an object of settings, not ${kindOf(config)}`);
  const { preset, values, objects } = /** @type {Config} */ (config);
  if (preset !== undefined && typeof preset !== 'string')
    throw new TypeError(`config.preset must be a text, not ${kindOf(preset)}`);
  if (values !== undefined && !isObject(values))
    throw new TypeError(`config.values must be an object, not ${kindOf(values)}`);
  /** @type {[string, unknown][]} */
  const named = Object.entries(values ?? {});
  for (const [id, value] of named)
    if (!isPrimitive(value))
      throw new TypeError(`config.values.${cut(id)} must be a number, a text or a flag, not ${kindOf(value)}`);
  if (objects !== undefined) {
    if (!Array.isArray(objects)) throw new TypeError(`config.objects must be a list, not ${kindOf(objects)}`);
    named.push(['objects', JSON.stringify(objects)]);
  }
  const attributes = named.map(
    ([id, value]) => /** @type {[string, string]} */ ([id.replaceAll('_', '-'), String(value)]),
  );
  return { preset, attributes: attributes.sort(([a], [b]) => Number(b === 'model') - Number(a === 'model')) };
}

/** Whether it is an object of fields. @param {unknown} value */
function isObject(value) {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** Whether an attribute can have it. @param {unknown} value */
function isPrimitive(value) {
  return ['string', 'number', 'boolean'].includes(typeof value);
}

/** The text of an address. @param {string} name @param {unknown} address */
function textOf(name, address) {
  if (typeof address === 'string') return address;
  if (address instanceof URL) return address.href;
  throw new TypeError(`${name} must be a text or a URL, not ${kindOf(address)}`);
}

/** A value in words, without its own code. @param {unknown} value */
function kindOf(value) {
  if (['number', 'boolean', 'undefined'].includes(typeof value) || value === null) return String(value);
  return Array.isArray(value) ? 'a list' : typeof value === 'string' ? 'a text' : `something of type ${typeof value}`;
}
