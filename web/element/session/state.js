/**
 * The state of a fire as the engine reported it last, and what a new fire starts from.
 *
 * @typedef {import('../../engine/engine.js').Message} Message
 * @typedef {import('../../parameters.js').HearthParameters} HearthParameters
 * @typedef {import('../../parameters.js').PresetName} PresetName
 * @typedef {import('../types.js').HearthQuality} HearthQuality
 * @typedef {import('../../parameters.js').HearthStats} HearthStats
 *
 * @typedef {{[id: string]: any}} Fields
 * @typedef {Fields & {id: number, kind: string}} Item
 *
 * @typedef {object} Delta  What leads from settings to other ones.
 * @property {string} [preset]
 * @property {Fields} [values]  `null` restores a value. With a model, they are all that it has.
 * @property {{[id: string]: Fields | null}} [objects]  Changed fields, `null` for an object that is no more. An object
 *   with a kind is whole.
 * @property {number[]} [order]  The ids of all objects.
 * @property {boolean} [replaces]  Whether all objects are of another list than before.
 * @property {number} [list]  The number of the list.
 * @property {Fields} [children]  By their numbers.
 *
 * @typedef {object} Whole  All settings, as a settings file.
 * @property {string} [preset]
 * @property {Fields} [values]
 * @property {Item[]} [objects]
 * @property {Fields[]} [children]
 * @property {number} [list]  The number of the list of objects.
 */

import { DEFAULTS, LACKING } from '../attributes/attributes.js';
import { guess } from '../view/visibility.js';

/** @type {(fields: Fields) => Fields} */
const withoutNulls = (fields) => Object.fromEntries(Object.entries(fields).filter(([, value]) => value !== null));

/** A list of objects after a delta: the same list, if it changes none. @type {(list: Item[], delta: Delta) => Item[]} */
function after(list, { objects, order, replaces }) {
  if (!objects) return list;
  const all = new Map(replaces ? [] : list.map((object) => [object.id, object]));
  for (const [key, fields] of Object.entries(objects)) {
    const id = Number(key);
    if (!fields) all.delete(id);
    else all.set(id, /** @type {Item} */ ('kind' in fields ? fields : { ...all.get(id), ...fields }));
  }
  return order ? order.flatMap((id) => all.get(id) ?? []) : [...all.values()];
}

/** The state of one element's fire; it outlives the fire. */
export class FireState {
  /** The values of both models. */
  params = /** @type {HearthParameters} */ ({ ...DEFAULTS });
  /** @type {Required<import('../../parameters.js').HearthObject>[]} */
  objects = [];
  /** @type {Whole} */
  settings = {};
  /** Whether the engine has reported the values of a fire. */
  started = false;
  /** @type {'auto' | HearthQuality} */
  quality = 'auto';
  /** @type {HearthStats | null} */
  stats = null;

  /** The quality that a fire starts with, before its speed is measured. */
  get guess() {
    return guess();
  }

  /** Takes over the values of a message. @param {Message} message */
  take({ type, values, objects, settings, redo, children }) {
    this.params = { ...this.params, ...values };
    if (type === 'ready') {
      this.started = true;
      [this.objects, this.settings] = [objects, settings];
      return;
    }
    const { preset, values: before = {}, objects: list = [], children: known } = this.settings;
    this.settings = {
      ...this.settings,
      preset: redo.preset ?? preset,
      // Another model has other values.
      values: withoutNulls(redo.values?.model === undefined ? { ...before, ...redo.values } : redo.values),
      objects: after(list, redo),
      children: children ?? known,
      list: redo.list ?? this.settings.list,
    };
    this.objects = /** @type {any} */ (objects ? after(this.objects, objects) : this.settings.objects);
  }

  /** A copy of the values of its model. */
  get paramsOfModel() {
    const params = { ...this.params };
    for (const id of LACKING[params.model]) delete (/** @type {Fields} */ (params)[id]);
    return params;
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
    const { quality, guess } = this;
    if (this.started) return { config: this.settings, quality, guess, paused };
    const model = fire.getAttribute('model');
    return {
      preset: fire.getAttribute('preset') ?? undefined,
      config,
      values: model === null ? {} : { model },
      quality,
      guess,
      paused,
    };
  }
}
