/**
 * Transitions of values: loaded by the first `to` of an element.
 *
 * An animation of the browser gives the progress, with its clock and its easings. It has no element,
 * so a page neither lists nor ends it. The fire gets values as from any script, each after it has
 * taken those before.
 *
 * @typedef {import('../engine/engine.js').Call} Call
 * @typedef {import('../parameters.js').ParameterId} Id
 * @typedef {{[id: string]: any}} Values
 * @typedef {[call: Call, answer: Promise<unknown>]} Order
 * @typedef {Order[] & {moves?: Moves, end?: () => void}} Orders
 *
 * @typedef {import('./session.js').FireSession} FireSession
 *
 * @typedef {object} Move one call of `to`
 * @property {Values} to where its values arrive
 * @property {Set<string>} ids those that it still moves
 * @property {string[]} held of them, values that another message sets; these wait for its answer
 * @property {boolean} whole whether it lost none of them
 * @property {() => void} end has all of them arrive at once
 */

import { LOGARITHMIC, WHOLE } from '../generated/between.js';

const ALLOWED = {
  duration: 'a number of milliseconds, 0 or more',
  easing: 'an easing of CSS, as linear, ease-in-out or cubic-bezier(0.2, 0, 0, 1)',
};

/**
 * Moves values.
 * @param {Orders} orders what is asked of the element since
 *   its first `to`: from now on what is put there is heard at once, and `end` has all values arrive
 * @param {FireSession} session
 * @param {Promise<unknown>} checked the answer whether the fire takes the values
 * @param {{duration?: unknown, easing?: unknown}} how
 * @returns {Promise<boolean>} whether all arrived; false if another message set one of them
 */
export function run(orders, session, checked, how) {
  orders.moves ??= new Moves(session);
  const { moves } = orders;
  for (const order of orders.splice(0)) moves.hear(order);
  orders.push = (order) => moves.hear(order);
  orders.end = () => moves.end();
  return moves.run(checked, how);
}

/** All values of an element that are on their way. */
class Moves {
  #session;
  /** By the answer to their first question, the oldest first. @type {Map<Promise<unknown>, Move>} */
  #all = new Map();

  /** @param {FireSession} session */
  constructor(session) {
    this.#session = session;
  }

  /**
   * Something was asked of the element: a move, or something whose values go no farther,
   * unless it is refused.
   * @param {Order} order
   * @returns {number} how many orders wait to be heard, as a list's `push` has it
   */
  hear([[method, given, source], answer]) {
    if (method === 'check') {
      // Its colours are as the engine has them when it is answered.
      this.#all.set(answer, { to: given, ids: new Set(Object.keys(given ?? {})), held: [], whole: true, end() {} });
      return 0;
    }
    if (source === 'to' || !['set', 'restore', 'preset', 'import'].includes(method)) return 0;
    const named = method === 'restore' ? given : method === 'set' && Object.keys(given);
    // Another model has values of its own.
    const all = !named || named.includes('model');
    for (const move of this.#all.values()) {
      for (const id of all ? [...move.ids] : named) {
        const free = () => move.held.splice(move.held.indexOf(id), 1);
        move.held.push(id);
        answer.then(() => lose(move, id), () => {}).then(free);
      }
    }
    return 0;
  }

  /** @type {(checked: Promise<unknown>, how: {duration?: unknown, easing?: unknown}) => Promise<boolean>} */
  async run(checked, how) {
    const move = /** @type {Move} */ (this.#all.get(checked));
    try {
      const effect = this.#effect(how);
      await checked;
      for (const older of this.#all.values()) {
        if (older === move) break;
        for (const id of move.ids) lose(older, id);
      }
      await this.#move(move, effect);
      return move.whole;
    } finally {
      this.#all.delete(checked);
    }
  }

  /** All arrive at once. */
  end() {
    for (const move of this.#all.values()) move.end();
  }

  /** @type {(how: {duration?: unknown, easing?: unknown}) => KeyframeEffect} */
  #effect({ duration = 600, easing = 'ease-in-out' }) {
    const refuse = (/** @type {'duration' | 'easing'} */ id, /** @type {unknown} */ value) => (
      this.#session.reports.refuse(id, String(value), ALLOWED[id])
    );
    if (typeof duration !== 'number' || !(duration >= 0 && duration < Infinity)) throw refuse('duration', duration);
    try {
      return new KeyframeEffect(null, null, { duration, easing: String(easing), fill: 'both' });
    } catch {
      throw refuse('easing', easing);
    }
  }

  /** @type {(move: Move, effect: KeyframeEffect) => Promise<void>} */
  async #move(move, effect) {
    const { fire } = this.#session;
    const set = (/** @type {Values} */ values) => this.#session.ask('set', values, 'to');
    // What has nothing between two values, the model among it, is the new one at once; the
    // others move in that model, and from where they are in it.
    const sudden = [...move.ids].filter((id) => !isBetween(id, fire.get(/** @type {Id} */ (id))));
    if (sudden.length > 0) {
      for (const id of sudden) move.ids.delete(id);
      await set(picked(move.to, sudden));
    }
    /** @type {Values} */
    const from = fire.params;

    const watched = new AbortController();
    const animation = new Animation(effect);
    animation.play();
    /** @type {Promise<unknown>} */
    let last = Promise.resolve();
    let wake = () => {};
    const step = (/** @type {number} */ part) => {
      const free = [...move.ids].filter((id) => !move.held.includes(id));
      // A value that is sent for the last time is free for others.
      if (part === 1) for (const id of free) move.ids.delete(id);
      const values = free.map((id) => [id, part === 1 ? move.to[id] : this.#between(id, from[id], move.to[id], part)]);
      if (free.length > 0) last = set(Object.fromEntries(values));
    };
    move.end = () => {
      step(1);
      for (const id of [...move.ids]) lose(move, id);
      wake();
    };
    // Nobody is to see the way, or can.
    const jump = () => document.hidden && move.end();
    document.addEventListener('visibilitychange', jump, watched);
    if (document.hidden || !fire.isConnected || this.#session.playback.isCalm()) move.end();
    try {
      while (move.ids.size > 0) {
        step(clamped(effect.getComputedTiming().progress ?? 1));
        await last;
        if (move.ids.size > 0) {
          await new Promise((resolve) => {
            wake = () => resolve(undefined);
            requestAnimationFrame(wake);
          });
        }
      }
      await last;
    } finally {
      animation.cancel();
      watched.abort();
    }
  }

  /** @type {(id: string, from: any, to: any, part: number) => unknown} */
  #between(id, from, to, part) {
    if (typeof from === 'number') {
      return LOGARITHMIC.includes(id) ? from * (to / from) ** part : from + (to - from) * part;
    }
    const { hexOf, fire } = this.#session;
    const hex = hexOf(`color-mix(in oklab, ${to} ${part * 100}%, ${from})`, fire);
    // Browsers before 2023 mix no colours.
    return isColour(hex) ? hex : from;
  }
}

/** Whether there is anything between a value and another one. @type {(id: string, value: unknown) => boolean} */
function isBetween(id, value) {
  return typeof value === 'number' ? !WHOLE.includes(id) : isColour(value);
}

/** @param {unknown} value */
function isColour(value) {
  return /^(#|transparent$)/.test(String(value));
}

/** An easing may go beyond both ends, where the fire would refuse a value. @param {number} part */
function clamped(part) {
  return Math.min(Math.max(part, 0), 1);
}

/** @type {(values: Values, ids: string[]) => Values} */
function picked(values, ids) {
  return Object.fromEntries(ids.map((id) => [id, values[id]]));
}

/** @type {(move: Move, id: string) => void} */
function lose(move, id) {
  if (move.ids.delete(id)) move.whole = false;
}
