/**
 * The history of a fire: what each step has changed, value by value, and what the values were before.
 *
 * A step is what a visitor does at once: a drag of a slider, a typed value, a press of a button. Its changes carry the
 * key of the step in their source, so the engine's events assign them to it. A page's own script may change values
 * sixty times a second: its changes are not steps, and undoing a step keeps them. A scene replaces every value, so it is
 * a step whoever chooses it.
 *
 * @typedef {import('../types.js').HearthHistoryDetail} HearthHistoryDetail
 * @typedef {import('./state.js').Delta} Delta
 * @typedef {import('./state.js').Fields} Fields
 * @typedef {{key: string, undo: Delta, redo: Delta}} Step
 */

import { quiet } from '../promises.js';

/** The key of the changes of undo and redo. */
const MOVE = ' move';

/** The maximum number of steps. */
const MAX_STEPS = 200;

/** The most characters of a key: the engine gets it with each change. */
const MAX_KEY = 1000;

/** @type {(value: unknown) => boolean} */
const hasFields = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/** Fields with those of a later delta; a list or a value replaces another one. @type {(first: Fields, then: Fields) => Fields} */
function joined(first, then) {
  const all = { ...first };
  for (const [name, value] of Object.entries(then)) {
    // A whole object leaves no field of an earlier one.
    const isPart = hasFields(value) && value.kind === undefined && hasFields(all[name]);
    all[name] = isPart ? joined(all[name], value) : value;
  }
  return all;
}

/** Whether two deltas state the same. @type {(one: any, other: any) => boolean} */
const isEqual = (one, other) =>
  Object.is(one, other) ||
  (Object(one) === one &&
    Object(other) === other &&
    Object.keys(one).length === Object.keys(other).length &&
    Object.keys(one).every((name) => isEqual(one[name], other[name])));

/** The steps of one element. */
export class FireHistory {
  #session;
  /** @type {Step[]} */
  #done = [];
  /** @type {Step[]} */
  #undone = [];
  /** The key of the running step. @type {string | undefined} */
  #key;
  #steps = 0;
  /** Whether the fire was ready once: a scene before that is what it starts from. */
  begun = false;
  /**
   * The step that is undone or redone now, whether it has changed since, and what leads back.
   * @type {{step: Step, isLate: boolean, back: Delta} | undefined}
   */
  #moving;
  /** The last undo or redo. @type {Promise<boolean>} */
  #moved = Promise.resolve(false);

  /** @param {import('./session.js').FireSession} session */
  constructor(session) {
    this.#session = session;
  }

  /** Whether there is a step to undo. */
  get canUndo() {
    return this.#done.length > 0;
  }

  /** Whether there is a step to redo. */
  get canRedo() {
    return this.#undone.length > 0;
  }

  /**
   * All present settings, without a question to the fire.
   * @returns {import('../types.js').HearthConfig}
   */
  get settings() {
    return /** @type {any} */ (this.#session.state.settings);
  }

  /**
   * Runs a function and records the changes that it calls for before it returns or waits. A step in a step belongs to
   * the outer one.
   * @template T
   * @param {() => T} act
   * @param {string} [key]  Changes with the key of the last step belong to it.
   * @returns {T}
   * @throws {TypeError} an argument is neither
   * @throws {RangeError} the key is too long
   */
  step(act, key) {
    if (typeof act !== 'function')
      throw new TypeError(`act must be a function, not ${act === null ? 'null' : typeof act}`);
    if (!['string', 'undefined'].includes(typeof key))
      throw new TypeError(`key must be a text, not ${key === null ? 'null' : typeof key}`);
    if (key !== undefined && key.length > MAX_KEY)
      throw new RangeError(`key must have at most ${MAX_KEY} characters, not ${key.length}`);
    const outer = this.#key;
    this.#steps += 1;
    this.#key = outer ?? key ?? `step ${this.#steps}`;
    try {
      return act();
    } finally {
      this.#key = outer;
    }
  }

  /** The source of a call, with the key of the running step. @param {string} name */
  source(name) {
    return this.#key === undefined ? name : `${name}:${this.#key}`;
  }

  /** The source of a call that replaces every value, as a step. @param {string} name */
  sourceOfScene(name) {
    return this.begun ? this.step(() => this.source(name)) : this.source(name);
  }

  /** Undoes the last step. Resolves to false without one. */
  undo() {
    return this.#move('undo', this.#done, this.#undone);
  }

  /** Redoes the step that was undone last. Resolves to false without one. */
  redo() {
    return this.#move('redo', this.#undone, this.#done);
  }

  /**
   * Settings have changed.
   * @type {(key: string, undo: Delta, redo: Delta) => void}
   */
  record(key, undo, redo) {
    if (key === MOVE) {
      // What the page has changed of the same values comes back with the next move.
      if (this.#moving) this.#moving.back = joined(undo, this.#moving.back);
      return;
    }
    const moving = this.#moving?.step.key === key ? this.#moving : undefined;
    const last = moving?.step ?? this.#done.at(-1);
    const step = last && last.key === key && (moving || !this.canRedo) ? last : undefined;
    if (step) {
      step.undo = joined(undo, step.undo);
      step.redo = joined(step.redo, redo);
    }
    if (moving) {
      // A change of the step was on its way when the step was undone.
      moving.isLate = true;
      return;
    }
    // A drag there and back is no step.
    if (step && isEqual(step.undo, step.redo)) this.#done.pop();
    if (!step) this.#done.push({ key, undo, redo });
    if (this.#done.length > MAX_STEPS) this.#done.shift();
    this.#undone.length = 0;
    this.#report({ type: 'step', key });
  }

  /** @type {(type: 'undo' | 'redo', from: Step[], to: Step[]) => Promise<boolean>} */
  #move(type, from, to) {
    // Steps that are not answered yet come first, and later ones do not.
    const asked = this.#session.call('export');
    const move = () => asked.then(() => this.#restore(type, from, to));
    this.#moved = quiet(this.#moved.then(move, move));
    return this.#moved;
  }

  /** @type {(type: 'undo' | 'redo', from: Step[], to: Step[]) => Promise<boolean>} */
  async #restore(type, from, to) {
    const step = from.pop();
    if (!step) return false;
    const { key } = step;
    const moving = { step, isLate: false, /** @type {Delta} */ back: {} };
    this.#moving = moving;
    try {
      do {
        moving.isLate = false;
        await this.#session.call('restore', [step[type]], `property:${MOVE}`);
      } while (type === 'undo' && moving.isLate);
      const other = type === 'undo' ? 'redo' : 'undo';
      step[other] = joined(step[other], moving.back);
      to.push(step);
    } catch (error) {
      // The fire would refuse a refused step again, so that step is dropped. Another fire follows a stopped one.
      if (!(error instanceof RangeError)) from.push(step);
      throw error;
    } finally {
      this.#moving = undefined;
      this.#report({ type, key });
    }
    return true;
  }

  /** @param {HearthHistoryDetail} detail */
  #report(detail) {
    this.#session.reports.emit('history-change', detail);
  }
}
