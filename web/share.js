/**
 * A fire's settings as URL parameters, as a link and as HTML. Settings that are too long for URL parameters are a
 * compressed fragment.
 *
 * Pure functions for pages and servers. They take the settings of `exportConfig()`. They validate no
 * values: the fire that receives a URL's values does. The values of the model that does not burn are left out.
 *
 * @typedef {object} Config
 * @property {number} [hearth]  The version of the format, 2.
 * @property {string} [preset]  The preset, unless it is the default one.
 * @property {{[id: string]: unknown}} [values]  The values that differ from the preset.
 * @property {{[id: string]: unknown}} [classic]  Those that the classic model has for itself while it does not burn.
 * @property {{[id: string]: unknown}} [combustion]  The same of the combustion model.
 * @property {object[]} [objects]  The objects, unless they are the preset's.
 * @property {string} [label]  A title for people.
 * @property {string} [description]  A description for people.
 *
 * @typedef {object} Shown  How generated HTML shows a fire.
 * @property {number} [width]  Its width [CSS px], 320 by default.
 * @property {number} [height]  Its height [CSS px], 400 by default.
 * @property {{[name: string]: string}} [attributes]  The element's own attributes, such as `warm`.
 */

import { DEFAULTS, OWN_ATTRIBUTES } from './generated/defaults.js';

/** The URL of this file, or of the bundle that contains it. */
export const FILE = import.meta.url;

/** The URL parameters of the preset: the first is written, both are read. */
const PRESET = ['scene', 'preset'];

/** The element's attributes that are neither parameters nor the preset. */
const OWN = OWN_ATTRIBUTES.filter((name) => !PRESET.includes(name));

/** The most characters of URL parameters that are written; longer settings become a fragment. */
export const MAX_QUERY = 2000;

/**
 * The URL parameters of a fire, without the question mark; empty for the defaults.
 * @param {Config} config
 * @returns {string} `scene=seed&viscosity=0.02`
 */
export function toQuery(config) {
  checkConfig(config);
  const query = new URLSearchParams();
  if (config.preset !== undefined) query.set(PRESET[0], config.preset);
  for (const [name, value] of attributes(config)) query.set(name, value);
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
  const reserved = new Set([...OWN, ...names]);
  const others = new URLSearchParams();
  /** @type {[string, string][]} */
  const values = [];
  let preset;
  for (const [name, value] of new URLSearchParams(search)) {
    if (reserved.has(name)) others.append(name, value);
    else if (PRESET.includes(name)) preset = value;
    else values.push([name.replaceAll('-', '_'), value]);
  }
  // A name such as `__proto__` becomes an own key, which the fire refuses.
  const config = { hearth: 2, ...(preset !== undefined && { preset }), values: Object.fromEntries(values) };
  return { config, others };
}

/**
 * The settings in the fragment of a URL; undefined if it has none. Nobody has validated them.
 * @param {string} hash  With its number sign.
 * @returns {Promise<Config | undefined>}
 * @throws {RangeError} the fragment is damaged
 */
export async function fromFragment(hash) {
  if (!hash.startsWith('#fire=')) return undefined;
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
  return urlOf(base, config, `${PRESET[0]}=default`);
}

/** @type {(base: string | URL, config: Config, otherwise?: string) => Promise<string>} */
async function urlOf(base, config, otherwise = '') {
  const query = toQuery(config);
  const isShort = query.length <= MAX_QUERY;
  const url = new URL(base);
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
  checkConfig(config);
  const { width, height, own } = checked(shown);
  const named = attributes(config).map(([name, value]) => {
    const id = name.replaceAll('-', '_');
    if (!Object.hasOwn(DEFAULTS, id) && id !== 'objects') {
      throw new RangeError(`${JSON.stringify(shortened(name))} is not a parameter of a fire`);
    }
    return value === 'true' ? name : attribute(name, value);
  });
  named.push(...own.map(([name, value]) => (value === '' ? name : attribute(name, value))));
  if (config.preset !== undefined) named.unshift(attribute('preset', config.preset));
  named.push(attribute('style', `width: ${width}px; max-width: 100%; height: ${height}px`));
  const element = `<hearth-fire ${named.join(' ')}></hearth-fire>`;
  if (scriptUrl === undefined) return element;
  return `<script type="module" ${attribute('src', String(scriptUrl))}></script>\n${element}`;
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
  const url = new URL(await urlOf(embedUrl, config));
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

/**
 * The values as attributes, the model first.
 * @param {Config} config
 * @returns {[string, string][]}
 */
function attributes({ values, objects }) {
  const named = Object.entries({ ...values, ...(objects && { objects: JSON.stringify(objects) }) }).map(
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

/**
 * How a fire is shown, with defaults.
 * @param {Shown} [shown]
 * @throws {RangeError} a size is no size, or an attribute is not the element's own
 */
function checked({ width = 320, height = 400, attributes: own = {} } = {}) {
  for (const [name, size] of Object.entries({ width, height }))
    if (!(typeof size === 'number' && size > 0 && size < Infinity))
      throw new RangeError(`shown.${name} must be a positive number, not ${kindOf(size)}`);
  for (const name of Object.keys(own))
    if (!OWN.includes(name))
      throw new RangeError(`shown.attributes: ${JSON.stringify(shortened(name))} is no attribute`);
  return { width, height, own: Object.entries(own).map(([name, value]) => [name, String(value)]) };
}

/**
 * Throws where settings have another form.
 * @param {unknown} config
 * @throws {TypeError}
 */
function checkConfig(config) {
  const isObject = (/** @type {unknown} */ value) =>
    typeof value === 'object' && value !== null && !Array.isArray(value);
  if (!isObject(config)) throw new TypeError(`config must be an object of settings, not ${kindOf(config)}`);
  const { preset, values, objects } = /** @type {{[name: string]: unknown}} */ (config);
  if (preset !== undefined && typeof preset !== 'string')
    throw new TypeError(`config.preset must be a text, not ${kindOf(preset)}`);
  if (values !== undefined && !isObject(values))
    throw new TypeError(`config.values must be an object, not ${kindOf(values)}`);
  for (const [id, value] of Object.entries(/** @type {object} */ (values ?? {})))
    if (!['string', 'number', 'boolean'].includes(typeof value))
      throw new TypeError(`config.values.${shortened(id)} must be a number, a text or a flag, not ${kindOf(value)}`);
  if (objects !== undefined && !Array.isArray(objects))
    throw new TypeError(`config.objects must be a list, not ${kindOf(objects)}`);
}

/** A value in words, without its own code. @param {unknown} value */
function kindOf(value) {
  if (['number', 'boolean', 'undefined'].includes(typeof value) || value === null) return String(value);
  return Array.isArray(value) ? 'a list' : typeof value === 'string' ? 'a text' : `something of type ${typeof value}`;
}

/** @param {string} name */
function shortened(name) {
  return name.length > 40 ? `${name.slice(0, 40)}…` : name;
}
