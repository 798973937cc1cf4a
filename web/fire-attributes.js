/**
 * What of a `<hearth-fire>` is an attribute: every parameter by its id with
 * hyphens, and a few of the element's own. The own ones that are only kept in
 * their attribute have their properties here.
 */

import { DEFAULTS } from './defaults.js';

/** The attributes that are no parameters, and the one that says what the others mean. */
export const OWN_ATTRIBUTES = ['preset', 'model', 'quality', 'paused', 'autoplay', 'alt', 'reduced-motion'];

const IDS = Object.keys(DEFAULTS);

/** The id of the parameter that an attribute sets. */
export const ID_OF_ATTRIBUTE = new Map(IDS.map((id) => [id.replaceAll('_', '-'), id]));

/** The id of the parameter that a property sets. */
export const ID_OF_PROPERTY = new Map(
  IDS.map((id) => [id.replace(/_(.)/g, (_, letter) => letter.toUpperCase()), id]),
);

const OWN_PROPERTIES = ['preset', 'quality', 'paused', 'autoplay', 'alt', 'reducedMotion'];

/** @type {typeof HTMLElement} */
const Base = globalThis.HTMLElement ?? class {};

/** An element with a fire's attributes. */
export class FireAttributes extends Base {
  static observedAttributes = [...OWN_ATTRIBUTES, ...ID_OF_ATTRIBUTE.keys()];

  /** The name of the preset that was last asked for. */
  get preset() {
    return this.getAttribute('preset') ?? 'default';
  }

  set preset(name) {
    this.setAttribute('preset', String(name));
  }

  /** Whether it plays from the start. */
  get autoplay() {
    return this.getAttribute('autoplay') !== 'false';
  }

  set autoplay(autoplay) {
    this.setAttribute('autoplay', String(Boolean(autoplay)));
  }

  /** What a screen reader says of it; without it the fire is decoration. */
  get alt() {
    return this.getAttribute('alt') ?? '';
  }

  set alt(alt) {
    this.setAttribute('alt', String(alt));
  }

  /** `auto`: a still fire where the visitor wants less motion; `ignore`: never. */
  get reducedMotion() {
    return this.getAttribute('reduced-motion') === 'ignore' ? 'ignore' : 'auto';
  }

  set reducedMotion(value) {
    this.setAttribute('reduced-motion', String(value));
  }

  /** Properties set before the element was defined hide its own; they are handed over. */
  keepEarlyProperties() {
    for (const name of [...OWN_PROPERTIES, ...ID_OF_PROPERTY.keys()]) {
      if (Object.hasOwn(this, name)) {
        const value = this[name];
        delete this[name];
        this[name] = value;
      }
    }
  }
}
