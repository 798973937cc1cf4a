/**
 * What the engine has told an element about its fire, and what a new fire starts from.
 *
 * @typedef {import('../engine/engine.js').Message} Message
 * @typedef {import('../parameters.js').HearthParameters} HearthParameters
 * @typedef {import('../parameters.js').PresetName} PresetName
 * @typedef {import('./types.js').HearthQuality} HearthQuality
 * @typedef {import('../parameters.js').HearthStats} HearthStats
 */

import { DEFAULTS } from '../generated/defaults.js';

/** The state of one element's fire; it outlives the fire. */
export class FireState {
  params = /** @type {HearthParameters} */ ({ ...DEFAULTS });
  /** @type {Required<import('../parameters.js').HearthObject>[]} */
  objects = [];
  /** The values before the model changed, for the way back. @type {Partial<HearthParameters>} */
  #kept = {};
  /** Whether the page set the number of particles, as the engine says. */
  #countIsSet = false;
  /** Whether the engine has had a fire of this element, and has told its values. */
  started = false;
  /** @type {PresetName} */
  preset = 'default';
  /** @type {'auto' | HearthQuality} */
  quality = 'auto';
  /** @type {HearthStats | null} */
  stats = null;

  /** Takes over the values of a message. @param {Message} message */
  take({ type, values, objects, replaced, ownNumber, preset }) {
    if (type === 'ready') this.started = true;
    else if (replaced) this.#kept = {};
    else if ('model' in values) this.#kept = this.params;
    this.params = { ...this.params, ...values };
    this.objects = objects ?? this.objects;
    this.#countIsSet = ownNumber;
    this.preset = preset;
  }

  /**
   * What the fire starts from: preset, file and model at first, what it was when it comes
   * back.
   * @param {HTMLElement} fire
   * @param {boolean} paused
   * @param {unknown} config what was in the file
   */
  start(fire, paused, config) {
    const { preset, params, quality } = this;
    if (this.started) {
      const values = { ...params, objects: this.objects };
      return { preset, kept: this.#kept, values, ownNumber: this.#countIsSet, quality, paused };
    }
    const model = fire.getAttribute('model');
    const values = model === null ? {} : { model };
    return { preset: fire.getAttribute('preset') ?? undefined, config, values, quality, paused };
  }
}
