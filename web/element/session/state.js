/**
 * The state of a fire as the engine reported it last, and what a new fire starts from.
 *
 * @typedef {import('../../engine/engine.js').Message} Message
 * @typedef {import('../../parameters.js').HearthParameters} HearthParameters
 * @typedef {import('../../parameters.js').PresetName} PresetName
 * @typedef {import('../types.js').HearthQuality} HearthQuality
 * @typedef {import('../../parameters.js').HearthStats} HearthStats
 */

import { DEFAULTS } from '../attributes/attributes.js';

/** The state of one element's fire; it outlives the fire. */
export class FireState {
  params = /** @type {HearthParameters} */ ({ ...DEFAULTS });
  /** @type {Required<import('../../parameters.js').HearthObject>[]} */
  objects = [];
  /** The values before the model changed, which a change back restores. @type {Partial<HearthParameters>} */
  #kept = {};
  /** Whether the page set the number of particles, as the engine reports it. */
  #countIsSet = false;
  /** The same of the spacing of particles. */
  #spacingIsSet = false;
  /** Whether the engine has reported the values of a fire. */
  started = false;
  /** @type {PresetName} */
  preset = 'default';
  /** @type {'auto' | HearthQuality} */
  quality = 'auto';
  /** @type {HearthStats | null} */
  stats = null;

  /** Takes over the values of a message. @param {Message} message */
  take({ type, values, objects, replaced, countOverridden, spacingOverridden, preset }) {
    if (type === 'ready') this.started = true;
    else if (replaced) this.#kept = {};
    else if ('model' in values) this.#kept = this.params;
    this.params = { ...this.params, ...values };
    this.objects = objects ?? this.objects;
    this.#countIsSet = countOverridden;
    this.#spacingIsSet = spacingOverridden;
    this.preset = preset;
  }

  /**
   * What a fire starts from: the attributes and the file of a new element, or its last state.
   * @param {HTMLElement} fire
   * @param {boolean} paused
   * @param {unknown} config the settings in the file
   */
  start(fire, paused, config) {
    const { preset, params, objects, quality } = this;
    if (this.started) {
      const own = { countOverridden: this.#countIsSet, spacingOverridden: this.#spacingIsSet };
      return { preset, kept: this.#kept, values: { ...params, objects }, ...own, quality, paused };
    }
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
