/**
 * The state of a fire as the engine reported it last, and what a new fire starts from.
 *
 * @typedef {import('../../engine/engine.js').Message} Message
 * @typedef {import('../../parameters.js').HearthParameters} HearthParameters
 * @typedef {import('../../parameters.js').PresetName} PresetName
 * @typedef {import('../types.js').HearthQuality} HearthQuality
 * @typedef {import('../../parameters.js').HearthStats} HearthStats
 * @typedef {{[part: string]: unknown}} Whole  All settings, as a settings file whose parts do not depend on each other.
 */

import { DEFAULTS } from '../attributes/attributes.js';

/** The state of one element's fire; it outlives the fire. */
export class FireState {
  params = /** @type {HearthParameters} */ ({ ...DEFAULTS });
  /** @type {Required<import('../../parameters.js').HearthObject>[]} */
  objects = [];
  /** @type {Whole} */
  settings = {};
  /** The largest id of an object so far, children aside: no fire of the element gives it again. */
  #lastId = 0;
  /** Whether the engine has reported the values of a fire. */
  started = false;
  /** @type {'auto' | HearthQuality} */
  quality = 'auto';
  /** @type {HearthStats | null} */
  stats = null;

  /** Takes over the values of a message. @param {Message} message */
  take({ type, values, objects, settings }) {
    if (type === 'ready') this.started = true;
    this.params = { ...this.params, ...values };
    this.objects = objects ?? this.objects;
    this.settings = { ...this.settings, ...settings };
    const own = /** @type {{id: number}[]} */ (settings?.objects ?? []);
    this.#lastId = Math.max(this.#lastId, ...own.map(({ id }) => id));
  }

  /** @returns {PresetName} */
  get preset() {
    return /** @type {PresetName} */ (this.settings.preset ?? 'default');
  }

  /**
   * What a fire starts from: the attributes and the file of a new element, or its last state.
   * @param {HTMLElement} fire
   * @param {boolean} paused
   * @param {unknown} config the settings in the file
   */
  start(fire, paused, config) {
    const { quality } = this;
    if (this.started) return { config: this.settings, quality, paused, last_id: this.#lastId };
    const model = fire.getAttribute('model');
    return {
      preset: fire.getAttribute('preset') ?? undefined,
      config,
      values: model === null ? {} : { model },
      quality,
      paused,
    };
  }
}
