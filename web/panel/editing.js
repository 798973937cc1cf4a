/**
 * What a visitor edits of a fire: the history of steps, the selected object and the two states to compare. The
 * panel and the toolbar of the same fire share it, so an undo in one undoes a step of the other.
 */

import { isBody, objectsOf } from './objects.js';
import { randomValues } from './random-values.js';
import { modelDefault, sceneValue } from './scene.js';
import { UndoHistory } from './undo-history.js';

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('./objects.js').Fields} Fields
 */

/**
 * @typedef {'A' | 'B'} Letter
 * @typedef {{letter: Letter, other?: import('../hearth-fire.js').HearthConfig}} Compared  The state that the fire
 *   shows, and the settings of the other one, once it has been shown.
 */

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

/** The history and the selection of one fire. It dispatches `change`. */
export class Editing extends EventTarget {
  #fire;
  /** The ids of the selected objects; the last one's properties have rows. @type {number[]} */
  #ids = [];
  /** @type {{compared: Compared}} */
  #variants = { compared: { letter: 'A' } };
  /** How many panels and toolbars watch. */
  #watchers = 0;
  /** Ends the listeners of the fire. */
  #unfollowed = new AbortController();

  /** @param {HearthFire} fire */
  constructor(fire) {
    super();
    this.#fire = fire;
    this.history = new UndoHistory(
      fire,
      () => this.#changed(),
      modelDefault,
      (id) => sceneValue(fire, id),
      this.#variants,
    );
  }

  /**
   * Calls `changed` at each change, and records what a pointer on the fire moves, until the signal.
   * @param {() => void} changed
   * @param {AbortSignal} signal
   */
  watch(changed, signal) {
    this.addEventListener('change', changed, { signal });
    this.#watchers += 1;
    if (this.#watchers === 1) this.#followPointer();
    signal.addEventListener(
      'abort',
      () => {
        this.#watchers -= 1;
        if (this.#watchers === 0) this.#unfollowed.abort();
      },
      { once: true },
    );
  }

  #followPointer() {
    this.#unfollowed = new AbortController();
    const { signal } = this.#unfollowed;
    /** The objects at the last press on the fire. @type {Fields[]} */
    let before = [];
    const press = () => {
      before = objectsOf(this.#fire);
      this.history.press();
    };
    // The element moves objects before listeners of its event run.
    this.#fire.addEventListener('pointerdown', press, { capture: true, signal });
    this.#fire.addEventListener(
      'objects-change',
      ({ detail }) => {
        if (detail.source === 'pointer') this.history.moved(before);
      },
      { signal },
    );
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

  /**
   * Adds an object and selects it: one step.
   * @param {() => object | undefined} fields  Called when the fire is ready for it.
   */
  async add(fields) {
    /** @type {number | undefined} */
    let id;
    await this.history.objects(async () => {
      const object = /** @type {import('../parameters.js').HearthObject | undefined} */ (fields());
      if (object) id = await this.#fire.addObject(object);
    });
    if (id !== undefined) this.select(id);
  }

  /** Removes an object: one step. @param {number} id */
  remove(id) {
    // A step before this one may have removed it.
    return this.history.objects(() => this.find(id) && this.takeAway(id));
  }

  /** Removes objects, and the sources that are their surfaces: they would burn elsewhere. @param {number[]} ids */
  async takeAway(...ids) {
    const on = objectsOf(this.#fire).filter((object) => ids.some((id) => isOn(object, id)));
    await Promise.all([...new Set([...on.map(({ id }) => id), ...ids])].map((id) => this.#fire.removeObject(id)));
  }

  /**
   * Moves solids to the end of the list, where they are before the others, or to its beginning: one step.
   * @type {(ids: number[], front: boolean) => Promise<void>}
   */
  order(ids, front) {
    return this.history.objects(() => {
      const all = objectsOf(this.#fire);
      const moves = (/** @type {Fields} */ object) => isBody(object) && ids.includes(object.id);
      const [moved, others] = [all.filter(moves), all.filter((object) => !moves(object))];
      return this.#fire.set({ objects: /** @type {any[]} */ (front ? [...others, ...moved] : [...moved, ...others]) });
    });
  }

  /** The letter of the state that the fire shows. */
  get letter() {
    return this.#variants.compared.letter;
  }

  /** Shows the other of two states, which begins as a copy of the first one: one step. @param {Letter} letter */
  compare(letter) {
    return this.history.all(async () => {
      const { compared } = this.#variants;
      if (letter === compared.letter) return;
      const shown = await this.#fire.exportConfig();
      await this.#fire.importConfig(compared.other ?? shown);
      this.#variants.compared = { letter, other: shown };
    });
  }

  /** Sets random values near those of the scene: one step. */
  randomise() {
    return this.history.all(() => this.#fire.set(randomValues(this.#fire)));
  }

  #changed() {
    this.dispatchEvent(new Event('change'));
  }
}
