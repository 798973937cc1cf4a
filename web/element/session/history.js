/**
 * The history of a fire: its settings before and after each step, as whole values.
 *
 * A step is what a visitor does at once: a drag of a slider, a typed value, a press of a button. Its changes carry the
 * key of the step in their source, so the engine's events assign them to it. A page's own script may change values
 * sixty times a second: its changes are not steps, and undoing a step keeps them.
 *
 * @typedef {import('../types.js').HearthHistoryDetail} HearthHistoryDetail
 * @typedef {import('./state.js').Whole} Whole
 *
 * @typedef {{key: string, spans: [before: Whole, after: Whole][]}} Step  Between two spans, the page has changed
 *   settings.
 */

import { quiet } from './requests.js';

/** The maximum number of steps. */
const MAX_STEPS = 200;

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
  /** The key of the step that is undone or redone now. @type {string | undefined} */
  moving;
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
   * Runs a function and records the changes that it calls for before it returns or waits.
   * @template T
   * @param {() => T} act
   * @param {string} [key]  Changes with the key of the last step belong to it.
   * @returns {T}
   * @throws {TypeError} an argument is neither
   */
  step(act, key) {
    if (typeof act !== 'function')
      throw new TypeError(`act must be a function, not ${act === null ? 'null' : typeof act}`);
    if (!['string', 'undefined'].includes(typeof key))
      throw new TypeError(`key must be a text, not ${key === null ? 'null' : typeof key}`);
    const outer = this.#key;
    this.#steps += 1;
    this.#key = key ?? `step ${this.#steps}`;
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
   * @type {(key: string, before: Whole, after: Whole) => void}
   */
  record(key, before, after) {
    // A change that was on its way when its step was undone.
    if (key === this.moving) return;
    const last = this.#done.at(-1);
    if (last?.key === key && !this.canRedo) {
      const span = last.spans[last.spans.length - 1];
      if (span[1] === before) span[1] = after;
      else last.spans.push([before, after]);
      // A drag there and back is no step.
      if (last.spans.length === 1 && JSON.stringify(span[0]) === JSON.stringify(after)) this.#done.pop();
    } else if (JSON.stringify(before) === JSON.stringify(after)) {
      return;
    } else {
      this.#done.push({ key, spans: [[before, after]] });
      if (this.#done.length > MAX_STEPS) this.#done.shift();
    }
    this.#undone.length = 0;
    this.#report({ type: 'step', key });
  }

  /** @type {(type: 'undo' | 'redo', from: Step[], to: Step[]) => Promise<boolean>} */
  #move(type, from, to) {
    const report = (/** @type {string} */ key) => this.#report({ type, key });
    const move = () => import('./undo.js').then((code) => code.move(this.#session, type, from, to, report));
    this.#moved = quiet(this.#moved.then(move, move));
    return this.#moved;
  }

  /** @param {HearthHistoryDetail} detail */
  #report(detail) {
    this.#session.reports.emit('history-change', detail);
  }
}
