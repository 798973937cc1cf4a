/**
 * The attributes of `<hearth-fire>`: one for each parameter, its id with hyphens, and the element's
 * own. Properties that only reflect an attribute are defined here.
 */

import { DEFAULTS, LACKING, OWN_ATTRIBUTES } from '../../generated/defaults.js';
import { setOrRemove } from '../plain-data.js';

export { DEFAULTS, LACKING };

const IDS = Object.keys(DEFAULTS);

/** The id of the parameter that an attribute sets. */
export const ID_OF_ATTRIBUTE = new Map(IDS.map((id) => [id.replaceAll('_', '-'), id]));

/** The id of the parameter that a property sets. */
export const ID_OF_PROPERTY = new Map(IDS.map((id) => [camelCase(id), id]));

/** @param {string} name */
function camelCase(name) {
  return name.replace(/[-_](.)/g, (_, letter) => letter.toUpperCase());
}

/** The values of each attribute that has a list of them; the first one is the default. */
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
 * prototype. Without a DOM, as on servers, it is an empty class.
 * @type {new () => import('../types.js').HearthListeners<import('../types.js').HearthFireEventMap> & HTMLElement &
 *   import('../types.js').HearthReflected & import('../../parameters.js').HearthProperties}
 */
const Base = /** @type {any} */ (globalThis.HTMLElement ?? class {});

/** All attributes that have an effect. */
export const OBSERVED = [...OWN_ATTRIBUTES, ...ID_OF_ATTRIBUTE.keys()];

/** An element with a fire's attributes. */
export class FireAttributes extends Base {
  /** @internal */
  static observedAttributes = OBSERVED;

  /**
   * The preset that the page requested last.
   * @returns {import('../../parameters.js').PresetName}
   */
  get preset() {
    return /** @type {import('../../parameters.js').PresetName} */ (this.getAttribute('preset') ?? 'default');
  }

  set preset(name) {
    setOrRemove(this, 'preset', name);
  }

  /**
   * `false`: the fire is paused until `play()`.
   * @attribute
   * @default true
   * @returns {boolean}
   */
  get autoplay() {
    return this.getAttribute('autoplay') !== 'false';
  }

  set autoplay(autoplay) {
    setOrRemove(this, 'autoplay', autoplay === undefined || autoplay === null ? autoplay : isOn(autoplay));
  }
}

/**
 * Sets properties again that were set before the element was defined: they shadow the accessors of
 * the prototype.
 * @param {HTMLElement} element
 */
export function upgradeProperties(element) {
  const early = Object.keys(element);
  for (const name of [...OWN_ATTRIBUTES.map(camelCase), ...ID_OF_PROPERTY.keys()]) {
    if (early.includes(name)) {
      const own = /** @type {{[name: string]: unknown}} */ (/** @type {unknown} */ (element));
      const value = own[name];
      delete own[name];
      own[name] = value;
    }
  }
}

/**
 * The value of an attribute that has a list of values; the default for any other value.
 * @param {HTMLElement} element
 * @param {keyof typeof CHOICES} name
 * @returns {string}
 */
function chosen(element, name) {
  const value = element.getAttribute(name) ?? '';
  /** @type {readonly string[]} */
  const choices = CHOICES[name];
  return choices.includes(value) ? value : choices[0];
}

/** Simulated seconds before the first frame: of `warm` without a value, and the maximum. */
const [WARM_DEFAULT, WARM_MAX] = [3, 30];

/**
 * How long a new fire burns before its first frame [s]; NaN if the attribute is invalid.
 * @param {HTMLElement} element
 */
export function warmth(element) {
  const text = element.getAttribute('warm');
  if (text === null || !isOn(text)) return 0;
  const seconds = isFlag(text) ? WARM_DEFAULT : Number(text);
  return seconds >= 0 && seconds <= WARM_MAX ? seconds : NaN;
}

/**
 * Whether an attribute or a property that is a flag is on. Frameworks and servers write `true` and `false` as text.
 * @param {unknown} value
 */
export function isOn(value) {
  return value === '' || (Boolean(value) && value !== 'false');
}

/** Whether the text of an attribute that is on has no value besides. @param {string} text */
export function isFlag(text) {
  return ['', 'true'].includes(text.trim());
}

// Off, it is a flag: Vue gives a number the value 0 for an attribute without a value.
reflect('warm', (element) => warmth(element) || false, setFlag('warm'));

// The others reflect as those of HTML's own elements do: as text, and as flags, which are present or
// absent.
for (const name of ['src', 'poster', 'alt', 'max-pixels', 'fps-limit', 'touch-action', 'align', 'pan']) {
  reflect(
    name,
    (element) => element.getAttribute(name) ?? '',
    (element, value) => setOrRemove(element, name, value),
  );
}
for (const name of /** @type {(keyof typeof CHOICES)[]} */ (Object.keys(CHOICES))) {
  reflect(
    name,
    (element) => chosen(element, name),
    (element, value) => setOrRemove(element, name, value),
  );
}
reflect(
  'zoom',
  (element) => Number(element.getAttribute('zoom')) || 1,
  (element, value) => setOrRemove(element, 'zoom', value),
);
/** The highest values of the sound, from 0 on. @type {{[name: string]: number}} */
export const LOUDEST = { sound: 1, roar: 2, crackle: 2, hiss: 2 };

/** The value of an attribute of the sound; NaN for any other text. @param {string} name @param {string} text */
export const loudness = (name, text) =>
  text.trim() && Number(text) >= 0 && Number(text) <= LOUDEST[name] ? Number(text) : NaN;

for (const [name, initial] of /** @type {const} */ ([
  ['sound', 0],
  ['roar', 1],
  ['crackle', 1],
  ['hiss', 1],
])) {
  reflect(
    name,
    (element) => {
      const value = loudness(name, element.getAttribute(name) ?? '');
      return Number.isNaN(value) ? initial : value;
    },
    (element, value) => setOrRemove(element, name, value),
  );
}
for (const name of ['interactive', 'decorative'])
  reflect(name, (element) => isOn(element.getAttribute(name)), setFlag(name));
// A flag, or a list of parameters.
reflect(
  'controls',
  (element) => {
    const list = element.getAttribute('controls');
    return list === null || !isOn(list) ? false : isFlag(list) || list;
  },
  setFlag('controls'),
);

/** Sets a flag, which may have a value. @param {string} name */
function setFlag(name) {
  return (/** @type {HTMLElement} */ element, /** @type {unknown} */ value) =>
    setOrRemove(element, name, value === undefined ? value : !isOn(value) ? null : value === true ? '' : value);
}

/**
 * @type {(attribute: string, get: (element: FireAttributes) => unknown, set: (element: FireAttributes, value: unknown)
 *   => void) => void}
 */
function reflect(attribute, get, set) {
  defineProperty(FireAttributes, camelCase(attribute), get, set);
}

/**
 * Defines a property on the prototype of a class.
 * @template {HTMLElement} Element
 * @param {new (...args: any) => Element} type
 * @param {string} name
 * @param {(element: Element) => unknown} get
 * @param {(element: Element, value: any) => unknown} set
 */
export function defineProperty(type, name, get, set) {
  Object.defineProperty(type.prototype, name, {
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
