/**
 * The panel controller: the commands of the panel, for egui and for the accessible controls.
 *
 * Both send their commands as steps of the fire's history. The controller uses the fire's public API. It
 * changes the page on request only: clipboard, download, full screen.
 */

import { act } from '../editing/acts.js';
import { CardCommands } from './card-commands.js';
import { editingOf } from '../editing/editing.js';
import { remember, remembered } from '../editing/memory.js';
import { copyOf, newObject } from '../editing/objects.js';
import { PARAMETERS } from '../parameters.js';
import {
  DOMAINS,
  MODEL,
  hasSceneObjects,
  modelDefault,
  presetOf,
  sceneObjects,
  sceneOf,
  sceneProperty,
  sceneValue,
  valuesOf,
} from '../editing/scene.js';

/** The parameters that state the resolution. @type {string[]} */
const RESOLUTION = ['particles', 'spacing'];

/** The events after which the scene may have changed. */
const CHANGES = ['ready', 'params-change', 'objects-change'];

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../hearth-fire.js').HearthConfig} HearthConfig
 * @typedef {import('../parameters.js').ParameterId} Id
 * @typedef {import('../editing/objects.js').Fields} Fields
 * @typedef {import('../editing/objects.js').Kind} Kind
 * @typedef {import('../parameters.js').HearthParameters[Id]} Value
 * @typedef {Partial<import('../parameters.js').HearthParameters>} Values
 *
 * @typedef {object} State  What the panel shows of the controller.
 * @property {string} scene  The label of the scene, with a note if the fire has changed since.
 * @property {string} preset  The label of the scene.
 * @property {Values} values  The values of the scene.
 * @property {Fields[]} objects  The objects of the scene.
 * @property {number} [selected]  The id of the selected object.
 * @property {import('../editing/editing.js').Letter} compared  The state that the fire shows, of the two that are compared.
 * @property {boolean} undo
 * @property {boolean} redo
 * @property {import('../editing/exchange.js').CopyForm[]} copies  The forms that the page can copy: a link needs its URL, an
 *   iframe that of `embed.html`.
 * @property {boolean} fullscreen  Whether the browser allows full screen.
 * @property {string} done  The button whose action has just succeeded.
 * @property {string} message  About the last action, a success or a failure.
 */

/** The controller of one panel. It dispatches `change` when its state changes. */
export class PanelController extends CardCommands {
  #fire;
  #page;
  #editing;
  /** Ends what listens to the selection. */
  #ended = new AbortController();
  #scene = '';
  #preset = '';

  /** The value under the pointer and its label; undefined without one. @type {() => string[] | undefined} */
  hovered = () => undefined;

  /** @param {import('./card-commands.js').PanelOptions} options */
  constructor(options) {
    super(options);
    const { fire, page, only } = options;
    this.#fire = fire;
    this.#page = page;
    const known = only?.map((id) => id.replaceAll('-', '_')).filter(isParameter);
    /** The parameters that the panel shows, in this order; undefined means all. */
    this.only = known?.length ? known : undefined;
    this.#restoreQuality();
    this.#editing = editingOf(fire);
    this.#editing.watch(this.changed, this.#ended.signal);
    for (const name of CHANGES) fire.addEventListener(name, this.#update);
    this.#update();
  }

  /** @returns {State} */
  get state() {
    return {
      scene: this.#scene,
      preset: presetOf(this.#fire)?.label ?? '',
      values: valuesOf(this.#fire),
      objects: sceneObjects(this.#fire),
      selected: this.#editing.id,
      compared: this.#editing.letter,
      undo: this.#fire.history.canUndo,
      redo: this.#fire.history.canRedo,
      copies: this.copies,
      fullscreen: document.fullscreenEnabled === true,
      done: this.done,
      message: this.message,
    };
  }

  /** A new gesture begins: the next change is a new step. */
  press() {
    this.#editing.press();
  }

  /** Undoes the last step, or cancels what a tool draws. */
  undo() {
    return this.#editing.undo();
  }

  /** Redoes the step that was undone last. */
  redo() {
    return this.#editing.redo();
  }

  /** Sets a parameter, or restores its default for null. @type {(id: Id, value: Value | null) => Promise<void>} */
  set(id, value) {
    return this.#fire.history.step(() => this.#fire.set(id, value), this.#editing.key(id));
  }

  /**
   * The value of a parameter in the scene; undefined if the current model does not use it.
   * @param {Id} id
   */
  defaultOf(id) {
    return sceneValue(this.#fire, id);
  }

  /**
   * Resets a parameter to its value in the scene.
   * @param {Id} id
   */
  restore(id) {
    return this.set(id, this.#restored(id));
  }

  /** The value in the scene; null for the default. @param {Id} id */
  #restored(id) {
    const target = this.defaultOf(id);
    // A restored resolution follows the scene and the quality again.
    const isDefault = RESOLUTION.includes(id) || target === modelDefault(id, this.#fire.params.model);
    return isDefault || target === undefined ? null : target;
  }

  /** The selected object. @returns {Fields | undefined} */
  get selected() {
    return this.#editing.selected;
  }

  /** Selects an object, or none. @param {number} [id] */
  select(id) {
    this.#editing.select(id);
  }

  /** Sets a property of an object. @type {(id: number, name: string, value: Value) => Promise<void>} */
  change(id, name, value) {
    return this.#editing.change(new Map([[id, { [name]: value }]]));
  }

  /**
   * The value of a property in the scene; its default in an object that the scene lacks.
   * @type {(object: Fields, name: string) => Value | undefined}
   */
  propertyOf(object, name) {
    return sceneProperty(this.#fire, object, name);
  }

  /** Resets a property of an object to its value in the scene. @type {(id: number, name: string) => Promise<void>} */
  async restoreProperty(id, name) {
    const object = this.#editing.find(id);
    const value = object && this.propertyOf(object, name);
    if (value !== undefined) await this.change(id, name, value);
  }

  /** Adds an object of a kind beside the fire, and selects it. @param {Kind} kind */
  add(kind) {
    return this.#editing.add(newObject(this.#fire, kind));
  }

  /** Adds an object like another one beside it, and selects it. @param {number} id */
  duplicate(id) {
    const object = this.#editing.find(id);
    return this.#editing.add(object && copyOf(this.#fire, object));
  }

  /** Removes an object. @param {number} id */
  remove(id) {
    return this.#editing.remove(id);
  }

  /** Moves a solid before all others, or behind them. @type {(id: number, front: boolean) => Promise<void>} */
  order(id, front) {
    return this.#editing.order([id], front);
  }

  /** Does one of `ACTS` at an object. @type {(name: string, id: number) => Promise<void>} */
  act(name, id) {
    return this.attempt(() => act(this.#fire, this.#editing, name, id));
  }

  /**
   * Resets the parameters that the panel shows to their values in the scene, and the objects, if it shows
   * them. The model stays.
   */
  restoreAll() {
    const fire = this.#fire;
    const ids = (this.only ?? PARAMETERS.map(({ id }) => id)).filter(
      (id) => id !== MODEL.id && DOMAINS.get(id)?.[fire.params.model],
    );
    const values = ids.map((id) => [id, this.#restored(id)]);
    const objects = this.only || hasSceneObjects(fire) ? undefined : /** @type {any[]} */ (sceneObjects(fire));
    return this.#editing.group()(() => fire.set({ objects, ...Object.fromEntries(values) }));
  }

  /** Shows the fire of settings: one step. @param {HearthConfig | string} config */
  async replace(config) {
    await super.replace(config);
    this.#update();
  }

  /** Shows one of two states. @param {import('../editing/editing.js').Letter} letter */
  compare(letter) {
    return this.#editing.compare(letter);
  }

  /** Sets random values. @param {import('../editing/random-values.js').Strength} strength */
  randomise(strength) {
    return this.#editing.randomise(strength);
  }

  /** @param {string} name */
  quality(name) {
    this.#fire.quality = /** @type {HearthFire['quality']} */ (name);
    remember({ quality: name });
  }

  /** The folded groups of the last visit. */
  get folds() {
    return remembered();
  }

  /** @type {(folded: string[], times: boolean) => void} */
  rememberFolds(folded, times) {
    remember({ folded, times });
  }

  /** Focuses the search field. */
  search() {
    this.dispatchEvent(new Event('search'));
  }

  /** Copies the value under the pointer; undefined without one, or if text is selected. */
  get copyHovered() {
    const hovered = this.hovered();
    if (!hovered || !(getSelection()?.isCollapsed ?? true)) return undefined;
    const [value, label] = hovered;
    return () =>
      this.attempt(async () => {
        await navigator.clipboard.writeText(value);
        this.notify('value', `Copied: ${label} ${value}`);
      });
  }

  /** Enters or leaves full screen: for the fire, or for a page about it. */
  async fullscreen() {
    const target = this.#page === undefined ? this.#fire : document.documentElement;
    await this.attempt(() => (document.fullscreenElement ? document.exitFullscreen() : target.requestFullscreen()));
  }

  /** Closes the card and stops listening. */
  close() {
    for (const name of CHANGES) this.#fire.removeEventListener(name, this.#update);
    this.#ended.abort();
    super.close();
  }

  /** Compares the fire with its scene. */
  #update = () => {
    this.mark();
    const [scene, preset] = [sceneOf(this.#fire), this.#fire.preset];
    const isGone = this.#editing.id !== undefined && !this.selected;
    if (scene === this.#scene && preset === this.#preset && !isGone) return;
    [this.#scene, this.#preset] = [scene, preset];
    if (isGone) this.select();
    this.changed();
  };

  /** Applies the quality of the last visit, unless the page or its URL sets one. */
  #restoreQuality() {
    const fire = this.#fire;
    const { quality } = remembered();
    const isSet = fire.hasAttribute?.('quality') || fire.quality !== 'auto';
    if (isSet || (quality !== 'low' && quality !== 'medium' && quality !== 'high')) return;
    fire.quality = quality;
  }
}

/** @type {(id: string) => id is Id} */
function isParameter(id) {
  return DOMAINS.has(id);
}
