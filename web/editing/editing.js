/**
 * What a visitor edits of a fire: the gesture that a step of its history is, the selected objects and the two states to
 * compare. The panel and the toolbar of the same fire share it.
 */

import { isBody, objectsOf } from './objects.js';
import { otherScene, randomValues } from './random-values.js';

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('./objects.js').Fields} Fields
 * @typedef {import('./random-values.js').Strength} Strength
 * @typedef {'A' | 'B'} Letter
 */

/** What the key of a step ends with that shows the other state. */
const COMPARE = 'compare';

/** @type {WeakMap<HearthFire, Editing>} */
const all = new WeakMap();

/**
 * Whether an object is a source that is the surface of a solid.
 * @type {(object: {[name: string]: any}, id: number) => boolean}
 */
export function isOn({ kind, shape, solid }, id) {
  return kind === 'source' && shape === 'solid' && solid === id;
}

/** The editing of a fire. @param {HearthFire} fire */
export function editingOf(fire) {
  const editing = all.get(fire) ?? new Editing(fire);
  all.set(fire, editing);
  return editing;
}

/** The gestures and the selection of one fire. It dispatches `change`. */
export class Editing extends EventTarget {
  #fire;
  /** The ids of the selected objects; the last one's properties have rows. @type {number[]} */
  #ids = [];
  #gesture = 0;
  /** @type {object | undefined} */
  #followed;
  /** Cancels what a tool draws; false if none does. */
  cancelDrawing = () => false;
  /** The state that the fire shows, and the settings of both when they were shown last. @type {Letter} */
  letter = 'A';
  /** @type {{[letter in Letter]?: import('../hearth-fire.js').HearthConfig}} */
  #compared = {};

  /** @param {HearthFire} fire */
  constructor(fire) {
    super();
    this.#fire = fire;
  }

  /**
   * Calls `changed` at each change, until the signal.
   * @param {() => void} changed
   * @param {AbortSignal} signal
   */
  watch(changed, signal) {
    this.addEventListener('change', changed, { signal });
    this.#fire.addEventListener('history-change', ({ detail }) => this.#follow(detail), { signal });
  }

  /** A step was made, undone or redone. @param {import('../element/types.js').HearthHistoryDetail} detail */
  #follow(detail) {
    // A panel and a toolbar may watch the same fire.
    if (detail === this.#followed) return;
    this.#followed = detail;
    if (detail.type !== 'step' && detail.key.endsWith(COMPARE)) this.letter = this.letter === 'A' ? 'B' : 'A';
    this.#changed();
  }

  /** A new gesture begins: the next change is a new step. */
  press() {
    this.#gesture += 1;
  }

  /** Undoes the last step or, while a tool draws, cancels what it draws. @returns {Promise<unknown>} */
  async undo() {
    return this.cancelDrawing() || this.#fire.history.undo();
  }

  /** Redoes the step that was undone last or, while a tool draws, cancels what it draws. @returns {Promise<unknown>} */
  async redo() {
    return this.cancelDrawing() || this.#fire.history.redo();
  }

  /** The key of a step of the history: what the same gesture does to the same is one step. @param {string} what */
  key(what) {
    return `${this.#gesture} ${what}`;
  }

  /**
   * A function that does something to the fire at once; all that it does is one step.
   * @returns {<T>(act: () => T) => T}
   */
  group() {
    this.press();
    const key = this.key('group');
    return (act) => this.#fire.history.step(act, key);
  }

  /**
   * Sets properties of objects: one step.
   * @param {Map<number, {[name: string]: any}>} changes  By the ids of the objects.
   */
  async change(changes) {
    // A step before this one may have removed some.
    const all = [...changes].filter(([id]) => this.find(id));
    const what = all.map(([id, properties]) => `${id}.${Object.keys(properties)}`).join();
    const changed = () => Promise.all(all.map(([id, properties]) => this.#fire.changeObject(id, properties)));
    await this.#fire.history.step(changed, this.key(what));
  }

  /** The selected object; of several, the one that was selected last. @returns {Fields | undefined} */
  get selected() {
    const all = this.all;
    return all.find(({ id }) => id === this.#ids.at(-1)) ?? all.at(-1);
  }

  /** All selected objects, in the order of the list. */
  get all() {
    return objectsOf(this.#fire).filter(({ id }) => this.#ids.includes(id));
  }

  /** The id of the object that was selected last; it may be removed. */
  get id() {
    return this.selected?.id ?? this.#ids.at(-1);
  }

  /** Selects these objects and no other. @param {(number | undefined)[]} ids */
  select(...ids) {
    const known = ids.filter((id) => id !== undefined);
    if (known.join() === this.#ids.join()) return;
    this.#ids = known;
    this.#changed();
  }

  /** Selects an object besides the others, or deselects it. @param {number} id */
  toggle(id) {
    const others = this.#ids.filter((other) => other !== id);
    this.select(...others, ...(others.length < this.#ids.length ? [] : [id]));
  }

  /** The object of this id; undefined without one. @param {number} id */
  find(id) {
    return objectsOf(this.#fire).find((object) => object.id === id);
  }

  /** Adds an object and selects it: one step. @param {{[name: string]: any} | undefined} fields */
  async add(fields) {
    const object = /** @type {import('../parameters.js').HearthObject | undefined} */ (fields);
    if (object) this.select(await this.group()(() => this.#fire.addObject(object)));
  }

  /** Removes objects: one step. @param {number[]} ids */
  remove(...ids) {
    return this.group()(() => this.takeAway(...ids));
  }

  /** Removes objects, and the sources that are their surfaces: they would burn elsewhere. @param {number[]} ids */
  async takeAway(...ids) {
    const all = objectsOf(this.#fire);
    const gone = all.filter((object) => ids.some((id) => object.id === id || isOn(object, id)));
    await Promise.all(gone.map(({ id }) => this.#fire.removeObject(id)));
  }

  /**
   * Moves solids to the end of the list, where they are before the others, or to its beginning: one step.
   * @type {(ids: number[], front: boolean) => Promise<void>}
   */
  order(ids, front) {
    const all = objectsOf(this.#fire);
    const moves = (/** @type {Fields} */ object) => isBody(object) && ids.includes(object.id);
    const [moved, others] = [all.filter(moves), all.filter((object) => !moves(object))];
    const objects = /** @type {any[]} */ (front ? [...others, ...moved] : [...moved, ...others]);
    return this.group()(() => this.#fire.set({ objects }));
  }

  /** Shows the other of two states, which begins as a copy of the first one: one step. @param {Letter} letter */
  async compare(letter) {
    if (letter === this.letter) return;
    // Steps that are not answered yet come first.
    await this.#fire.exportConfig();
    const shown = this.#fire.history.settings;
    const next = this.#compared[letter] ?? shown;
    this.press();
    await this.#fire.history.step(() => this.#fire.importConfig(next), this.key(COMPARE));
    this.#compared = { [this.letter]: shown, [letter]: next };
    this.letter = letter;
    this.#changed();
  }

  /** Sets random values, at the greatest strength of another scene: one step. @param {Strength} strength */
  async randomise(strength) {
    const step = this.group();
    if (strength === 'wild') {
      const { PRESETS } = await import('../parameters.js');
      const preset = otherScene(PRESETS, this.#fire.preset);
      await step(() => this.#fire.importConfig({ hearth: 3, preset, values: {} }));
    }
    await step(() => this.#fire.set(randomValues(this.#fire, strength)));
  }

  #changed() {
    this.dispatchEvent(new Event('change'));
  }
}
