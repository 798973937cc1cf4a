/**
 * What a visitor edits of a fire: the history of steps and the selected object. The panel and the
 * toolbar of the same fire share it, so an undo in one undoes a step of the other.
 */

import { objectsOf } from './objects.js';
import { modelDefault, sceneValue } from './scene.js';
import { UndoHistory } from './undo-history.js';

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('./objects.js').Fields} Fields
 */

/** @type {WeakMap<HearthFire, Editing>} */
const all = new WeakMap();

/** The editing of a fire. @param {HearthFire} fire */
export function editingOf(fire) {
  const editing = all.get(fire) ?? new Editing(fire);
  all.set(fire, editing);
  return editing;
}

/** The history and the selection of one fire. It dispatches `change`. */
export class Editing extends EventTarget {
  #fire;
  /** @type {number | undefined} */
  #selected;

  /** @param {HearthFire} fire */
  constructor(fire) {
    super();
    this.#fire = fire;
    this.history = new UndoHistory(fire, () => this.#changed(), modelDefault, (id) => sceneValue(fire, id));
  }

  /** The selected object. @returns {Fields | undefined} */
  get selected() {
    return objectsOf(this.#fire).find(({ id }) => id === this.#selected);
  }

  /** The id of the object that was selected last; it may be removed. */
  get id() {
    return this.#selected;
  }

  /** Selects an object, or none. @param {number} [id] */
  select(id) {
    if (id === this.#selected) return;
    this.#selected = id;
    this.#changed();
  }

  /**
   * Moves solids to the end of the list, where they are before the others, or to its beginning: one step.
   * @type {(ids: number[], front: boolean) => Promise<void>}
   */
  order(ids, front) {
    return this.history.objects(() => {
      const all = objectsOf(this.#fire);
      const moves = (/** @type {Fields} */ { id, kind }) => kind === 'solid' && ids.includes(id);
      const [moved, rest] = [all.filter(moves), all.filter((one) => !moves(one))];
      return this.#fire.set({ objects: /** @type {any[]} */ (front ? [...rest, ...moved] : [...moved, ...rest]) });
    });
  }

  #changed() {
    this.dispatchEvent(new Event('change'));
  }
}
