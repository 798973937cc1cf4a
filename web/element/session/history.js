/**
 * The history of a fire: its settings before and after each step, as whole values.
 *
 * A step is what a visitor does at once: a drag of a slider, a typed value, a press of a button. Its changes carry the
 * key of the step in their source, so the engine's events assign them to it. A page's own script may change values
 * sixty times a second: its changes are not steps, and undoing a step keeps them. A scene replaces every value, so it is
 * a step whoever chooses it.
 *
 * @typedef {import('../types.js').HearthHistoryDetail} HearthHistoryDetail
 * @typedef {import('./state.js').Whole} Whole
 *
 * @typedef {[before: Whole, after: Whole]} Span
 * @typedef {{key: string, spans: Span[]}} Step  Between two spans, the page has changed settings.
 */

import { quiet } from './requests.js';

/** The key of the changes of undo and redo. */
const MOVE = ' move';

/** The maximum number of steps, and that of spans in a call. */
const MAX_STEPS = 200;
const MAX_SPANS = 100;

/** @type {(span: Span) => Span} */
const reversed = ([before, after]) => [after, before];

/** The parts of settings that a span changes; parts that it does not change are shared. @type {(span: Span) => Span} */
const changes = ([before, after]) => {
  const names = Object.keys(after).filter((name) => after[name] !== before[name]);
  const parts = [before, after].map((whole) => Object.fromEntries(names.map((name) => [name, whole[name]])));
  return /** @type {Span} */ (parts);
};

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
   * The step that is undone or redone now, what this has changed, and the step's own late changes.
   * @type {{key: string, spans: Span[], late: Span[]} | undefined}
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
   */
  step(act, key) {
    if (typeof act !== 'function')
      throw new TypeError(`act must be a function, not ${act === null ? 'null' : typeof act}`);
    if (!['string', 'undefined'].includes(typeof key))
      throw new TypeError(`key must be a text, not ${key === null ? 'null' : typeof key}`);
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
   * @type {(key: string, before: Whole, after: Whole) => void}
   */
  record(key, before, after) {
    if (key === MOVE || key === this.#moving?.key) {
      // A change of the step may be on its way when the step is undone.
      this.#moving?.[key === MOVE ? 'spans' : 'late'].push([before, after]);
      return;
    }
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
    const back = type === 'undo';
    const moving = { key, /** @type {Span[]} */ spans: [], /** @type {Span[]} */ late: [] };
    let { spans } = step;
    this.#moving = moving;
    try {
      do {
        spans = [...spans, ...moving.late.splice(0)];
        const ways = (back ? spans.map(reversed).reverse() : spans).map(changes);
        const calls = [];
        for (let at = 0; at < ways.length; at += MAX_SPANS) {
          const [here, there] = [0, 1].map((side) => ways.slice(at, at + MAX_SPANS).map((way) => way[side]));
          calls.push(this.#session.call('restore', there, here, `property:${MOVE}`));
        }
        await Promise.all(calls);
      } while (back && moving.late.length > 0);
      const done = back ? moving.spans.map(reversed).reverse() : [...moving.spans, ...moving.late];
      // The page may have changed the same values: what changes nothing now may do so later.
      to.push({ key, spans: done.length > 0 ? done : spans });
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
