/**
 * Transitions of values. This code is loaded by the first `to` of an element.
 *
 * An animation of the browser provides the progress, with its clock and its easings. It has no target
 * element, so `getAnimations()` of the page does not list it. The engine receives values as from any
 * script, each after it has accepted those before.
 *
 * @typedef {import('../../engine/engine.js').Call} Call
 * @typedef {import('../../parameters.js').ParameterId} Id
 * @typedef {{[id: string]: any}} Values
 * @typedef {[call: Call, answer: Promise<unknown>]} Asked a call with its answer
 * @typedef {Asked[] & {transitions?: Transitions, end?: () => void}} Calls
 *
 * @typedef {import('./session.js').FireSession} FireSession
 * @typedef {import('./state.js').Whole} Whole
 *
 * @typedef {object} Transition one call of `to`
 * @property {Values} to the final values
 * @property {Set<string>} ids the values that it still changes
 * @property {string[]} held those of them that another call sets; they wait for its answer
 * @property {boolean} whole whether no other call has set one of them
 * @property {() => void} end sets all final values at once
 */

import { LOGARITHMIC, WHOLE } from '../../generated/interpolation.js';

const ALLOWED = {
  duration: 'a number of milliseconds, 0 or more',
  easing: 'an easing of CSS, such as linear, ease-in-out or cubic-bezier(0.2, 0, 0, 1)',
};

/**
 * Starts a transition.
 * @param {Calls} calls the calls of the element since its first `to`. From now on, `push` passes a call
 *   on at once, and `end` sets all final values
 * @param {FireSession} session
 * @param {Promise<unknown>} checked the answer whether the values are valid
 * @param {unknown} how its options, which nobody has checked
 * @param {string} source the source of the calls that set values
 * @returns {Promise<boolean>} false if another call has set one of the values
 */
export function run(calls, session, checked, how, source) {
  calls.transitions ??= new Transitions(session);
  const { transitions } = calls;
  for (const call of calls.splice(0)) transitions.record(call);
  calls.push = (/** @type {Asked} */ call) => transitions.record(call);
  calls.end = () => transitions.end();
  return transitions.run(checked, how, source);
}

/** The transitions of an element. */
class Transitions {
  #session;
  /** By the answer to their first call, the oldest first. @type {Map<Promise<unknown>, Transition>} */
  #all = new Map();

  /** @param {FireSession} session */
  constructor(session) {
    this.#session = session;
  }

  /**
   * Records a call of the element: a new transition, or a call that ends the transition of the values
   * that it sets, unless it is refused.
   * @param {Asked} asked
   * @returns {number} the number of calls that wait, as the `push` of a list returns it
   */
  record([[method, given, ...rest], answer]) {
    if (method === 'check') {
      // The answer replaces colours by those of the engine.
      this.#all.set(answer, { to: given, ids: new Set(Object.keys(given ?? {})), held: [], whole: true, end() {} });
      return 0;
    }
    // Of these alone, the next argument is a text, the source.
    if (!['set', 'preset', 'import', 'restore'].includes(method) || /^to\b/.test(rest[0])) return 0;
    const named = method === 'set' ? Object.keys(given) : method === 'restore' && Object.keys(given[0].values ?? {});
    // Another model has other values.
    const all = !named || named.includes('model');
    for (const transition of this.#all.values()) {
      for (const id of all ? [...transition.ids] : named) {
        const free = () => transition.held.splice(transition.held.indexOf(id), 1);
        transition.held.push(id);
        answer
          .then(
            () => release(transition, id),
            () => {},
          )
          .then(free);
      }
    }
    return 0;
  }

  /**
   * @type {(checked: Promise<unknown>, how: unknown, source: string) =>
   *   Promise<boolean>}
   */
  async run(checked, how, source) {
    const transition = /** @type {Transition} */ (this.#all.get(checked));
    try {
      const effect = this.#effect(how);
      await checked;
      for (const older of this.#all.values()) {
        if (older === transition) break;
        for (const id of transition.ids) release(older, id);
      }
      await this.#animate(transition, effect, source);
      return transition.whole;
    } finally {
      this.#all.delete(checked);
    }
  }

  /** Sets all final values at once. */
  end() {
    for (const transition of this.#all.values()) transition.end();
  }

  /** @type {(how: unknown) => KeyframeEffect} */
  #effect(how) {
    if (!/^(undefined|object)$/.test(typeof how)) throw new TypeError('options must be an object');
    const { duration = 600, easing = 'ease-in-out' } = /** @type {{[name: string]: unknown}} */ (how ?? {});
    const refuse = (/** @type {'duration' | 'easing'} */ id, /** @type {unknown} */ value) => {
      const words = /^(object|function)$/.test(typeof value) ? `something of type ${typeof value}` : String(value);
      return this.#session.reports.refuse(id, words, ALLOWED[id]);
    };
    if (typeof duration !== 'number' || !(duration >= 0 && duration < Infinity)) throw refuse('duration', duration);
    try {
      if (typeof easing !== 'string') throw new TypeError('it is no text');
      return new KeyframeEffect(null, null, { duration, easing, fill: 'both' });
    } catch {
      throw refuse('easing', easing);
    }
  }

  /** @type {(transition: Transition, effect: KeyframeEffect, source: string) => Promise<void>} */
  async #animate(transition, effect, source) {
    const { fire } = this.#session;
    const set = (/** @type {Values} */ values) => this.#session.call('set', values, source);
    // Values without intermediate values, such as the model, are set first. The others start from
    // what they are in that model.
    const sudden = [...transition.ids].filter((id) => !isBetween(id, fire.get(/** @type {Id} */ (id))));
    if (sudden.length > 0) {
      for (const id of sudden) transition.ids.delete(id);
      await set(picked(transition.to, sudden));
    }
    /** @type {Values} */
    const from = fire.params;

    const ended = new AbortController();
    const animation = new Animation(effect);
    animation.play();
    /** @type {Promise<unknown>} */
    let last = Promise.resolve();
    let wake = () => {};
    const step = (/** @type {number} */ progress) => {
      const free = [...transition.ids].filter((id) => !transition.held.includes(id));
      // A call that sets a value after its last step does not interrupt the transition.
      if (progress === 1) for (const id of free) transition.ids.delete(id);
      const values = free.map((id) => [
        id,
        progress === 1 ? transition.to[id] : this.#between(id, from[id], transition.to[id], progress),
      ]);
      if (free.length > 0) last = set(Object.fromEntries(values));
    };
    transition.end = () => {
      step(1);
      for (const id of [...transition.ids]) release(transition, id);
      wake();
    };
    // There are no intermediate values on a hidden page and with reduced motion.
    const jump = () => document.hidden && transition.end();
    document.addEventListener('visibilitychange', jump, ended);
    if (document.hidden || !fire.isConnected || this.#session.playback.prefersStill()) transition.end();
    try {
      while (transition.ids.size > 0) {
        step(clamped(effect.getComputedTiming().progress ?? 1));
        await last;
        if (transition.ids.size > 0) {
          await new Promise((resolve) => {
            wake = () => resolve(undefined);
            requestAnimationFrame(wake);
          });
        }
      }
      await last;
    } finally {
      animation.cancel();
      ended.abort();
    }
  }

  /** @type {(id: string, from: any, to: any, progress: number) => unknown} */
  #between(id, from, to, progress) {
    if (typeof from === 'number') {
      return LOGARITHMIC.includes(id) ? from * (to / from) ** progress : from + (to - from) * progress;
    }
    const { hexOf, fire } = this.#session;
    const hex = hexOf(`color-mix(in oklab, ${to} ${progress * 100}%, ${from})`, fire);
    // Browsers before 2023 have no `color-mix`.
    return isColour(hex) ? hex : from;
  }
}

/** Whether a value has intermediate values. @type {(id: string, value: unknown) => boolean} */
function isBetween(id, value) {
  return typeof value === 'number' ? !WHOLE.includes(id) : isColour(value);
}

/** @param {unknown} value */
function isColour(value) {
  return /^(#|transparent$)/.test(String(value));
}

/** An easing may overshoot; the engine would refuse values out of range. @param {number} progress */
function clamped(progress) {
  return Math.min(Math.max(progress, 0), 1);
}

/** @type {(values: Values, ids: string[]) => Values} */
function picked(values, ids) {
  return Object.fromEntries(ids.map((id) => [id, values[id]]));
}

/** Stops changing one value. @type {(transition: Transition, id: string) => void} */
function release(transition, id) {
  if (transition.ids.delete(id)) transition.whole = false;
}
