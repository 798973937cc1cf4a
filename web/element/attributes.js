/**
 * The attributes of `<hearth-fire>`: one for each parameter, its id with hyphens, and the element's
 * own. Properties that only reflect an attribute are defined here.
 */

import { DEFAULTS, OWN_ATTRIBUTES } from '../generated/defaults.js';

const IDS = Object.keys(DEFAULTS);

/** The id of the parameter that an attribute sets. */
export const ID_OF_ATTRIBUTE = new Map(IDS.map((id) => [id.replaceAll('_', '-'), id]));

/** The id of the parameter that a property sets. */
export const ID_OF_PROPERTY = new Map(
  IDS.map((id) => [camelCase(id), id]),
);

/** @param {string} name */
function camelCase(name) {
  return name.replace(/[-_](.)/g, (_, letter) => letter.toUpperCase());
}

/** The element's own properties that have setters. */
const OWN_PROPERTIES = OWN_ATTRIBUTES.map(camelCase);

/** The choices of an attribute; the first one is the default. */
export const CHOICES = {
  /** @type {readonly ['height', 'contain', 'cover', 'width']} */
  fit: ['height', 'contain', 'cover', 'width'],
  /** @type {readonly ['auto', 'lazy', 'eager']} */
  loading: ['auto', 'lazy', 'eager'],
  /** @type {readonly ['auto', 'ignore']} */
  'reduced-motion': ['auto', 'ignore'],
};

/**
 * An `HTMLElement` with the properties that this module and `hearth-fire.js` define on the
 * prototype. Where there is no DOM, as on servers, it is an empty class.
 * @type {new () => HTMLElement & import('./types.js').HearthReflected & import('../parameters.js').HearthProperties}
 */
const Base = /** @type {any} */ (globalThis.HTMLElement ?? class {});

/** All attributes that do anything. */
export const OBSERVED = [...OWN_ATTRIBUTES, ...ID_OF_ATTRIBUTE.keys()];

/** An element with a fire's attributes. */
export class FireAttributes extends Base {
  static observedAttributes = OBSERVED;

  /**
   * The name of the preset that was last asked for.
   * @returns {import('../parameters.js').PresetName}
   */
  get preset() {
    return /** @type {import('../parameters.js').PresetName} */ (this.getAttribute('preset') ?? 'default');
  }

  set preset(name) {
    setOrRemove(this, 'preset', name);
  }

  /**
   * `false`: the fire stands still until `play()`.
   * @attribute
   * @default true
   * @returns {boolean}
   */
  get autoplay() {
    return this.getAttribute('autoplay') !== 'false';
  }

  set autoplay(autoplay) {
    setOrRemove(this, 'autoplay', autoplay === undefined ? undefined : Boolean(autoplay));
  }
}

/**
 * Hands over properties that were set before the element was defined, and so hide its own.
 * @param {HTMLElement} element
 */
export function keepEarlyProperties(element) {
  for (const name of [...OWN_PROPERTIES, ...ID_OF_PROPERTY.keys()]) {
    if (Object.hasOwn(element, name)) {
      const early = /** @type {{[name: string]: unknown}} */ (/** @type {unknown} */ (element));
      const value = early[name];
      delete early[name];
      early[name] = value;
    }
  }
}

/**
 * What an attribute chooses, if it can be chosen, else the usual.
 * @param {HTMLElement} element
 * @param {keyof typeof CHOICES} name
 * @returns {string}
 */
export function chosen(element, name) {
  const value = element.getAttribute(name) ?? '';
  /** @type {readonly string[]} */
  const choices = CHOICES[name];
  return choices.includes(value) ? value : choices[0];
}

/** Seconds of fire before the first picture where `warm` has no value; and the most. */
const [WARM, WARMEST] = [3, 30];

/**
 * How long a new fire burns before it is shown [s]; NaN where that is no such number.
 * @param {HTMLElement} element
 */
export function warmth(element) {
  const text = element.getAttribute('warm');
  if (text === null || text === 'false') return 0;
  const seconds = text.trim() ? Number(text) : WARM;
  return seconds >= 0 && seconds <= WARMEST ? seconds : NaN;
}

reflect('warm', (element) => warmth(element) || 0, (element, value) => {
  setOrRemove(element, 'warm', value === true ? '' : value === false ? undefined : value);
});

// The others are kept in their attributes as HTML's own elements keep theirs: texts,
// and flags, which are there or not.
for (const name of ['src', 'poster', 'alt', 'max-pixels', 'fps-limit', 'touch-action', 'align']) {
  reflect(name, (element) => element.getAttribute(name) ?? '', (element, value) => setOrRemove(element, name, value));
}
for (const name of /** @type {(keyof typeof CHOICES)[]} */ (Object.keys(CHOICES))) {
  reflect(name, (element) => chosen(element, name), (element, value) => setOrRemove(element, name, value));
}
reflect('interactive', (element) => element.hasAttribute('interactive'), (element, value) => element.toggleAttribute('interactive', Boolean(value)));
// A flag that may name what it is about.
reflect('controls', (element) => element.getAttribute('controls') || element.hasAttribute('controls'), (element, value) => (
  setOrRemove(element, 'controls', value ? (value === true ? '' : value) : undefined)
));

/**
 * Sets an attribute; without a value, takes it away.
 * @param {HTMLElement} element
 * @param {string} name
 * @param {unknown} value
 */
export function setOrRemove(element, name, value) {
  if (value === undefined || value === null) element.removeAttribute(name);
  else element.setAttribute(name, String(value));
}

/** @type {(attribute: string, get: (element: FireAttributes) => unknown, set: (element: FireAttributes, value: unknown) => void) => void} */
function reflect(attribute, get, set) {
  Object.defineProperty(FireAttributes.prototype, camelCase(attribute), {
    configurable: true,
    enumerable: true,
    get() {
      return get(this);
    },
    set(value) {
      set(this, value);
    },
  });
}
