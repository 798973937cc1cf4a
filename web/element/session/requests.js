/**
 * Promises for the calls of an element.
 *
 * Each request has a number, which the engine's `done` or `refused` event carries. Calls made without
 * a fire wait here and are sent in order when there is one, and so do most calls while the engine has
 * many unanswered sets. A rejected promise without a handler is no "unhandled rejection": a fire is
 * decoration, and the refusal is also an event and a warning.
 *
 * @typedef {import('../../engine/engine.js').Call} Call
 * @typedef {{id: string, value: unknown, message: string, min?: number, max?: number}} Refusal
 * @typedef {import('../promises.js').Deferred} Deferred
 */

import { AT_ONCE } from '../../parts.js';
import { deferred } from '../promises.js';

/**
 * The number of unanswered sets from which on calls wait, and the number of waiting calls from which on
 * new calls replace older ones that set the same ids.
 */
const MAX_WAITING = 500;

/** Requests, waiting for a fire or for an answer. */
export class Requests {
  #last = 0;
  /** @type {Map<number, Deferred & {fire: number, ids?: string}>} */
  #pending = new Map();
  /** Calls that wait, without a fire models first. @type {{request: number, call: Call, ids?: string}[]} */
  #waiting = [];
  #models = 0;
  /** The number of sets that the engine has not answered. */
  #unanswered = 0;
  /** @type {((request: number, call: Call) => void) | undefined} */
  #send;
  #fire = 0;

  /**
   * Calls a command of the engine.
   * @param {Call} call
   * @returns {Promise<any>}
   */
  call(...call) {
    const request = ++this.#last;
    const ids = idsOf(call);
    const entry = Object.assign(deferred(), { fire: 0, ids });
    this.#pending.set(request, entry);
    if (this.#send && AT_ONCE.includes(call[0])) {
      entry.fire = this.#fire;
      this.#send(request, call);
      return entry.promise;
    }
    this.#makeRoom(ids, entry);
    // The model decides which values are valid.
    const at = ids === 'model' && !this.#send ? this.#models++ : this.#waiting.length;
    this.#waiting.splice(at, 0, { request, call, ids });
    this.#flush(MAX_WAITING);
    return entry.promise;
  }

  /**
   * Bounds the memory and the work of a page that sets the same values again and again: the last
   * waiting call that sets the same ids is dropped and settles as `entry` does.
   * @type {(ids: string | undefined, entry: Deferred) => void}
   */
  #makeRoom(ids, entry) {
    if (ids === undefined || this.#waiting.length < MAX_WAITING) return;
    const at = this.#waiting.findLastIndex((waiting) => waiting.ids === ids);
    if (at < 0) return;
    const [{ request }] = this.#waiting.splice(at, 1);
    if (at < this.#models) this.#models -= 1;
    this.settle(request, undefined, entry.promise);
  }

  /** Sends the calls that wait until so many sets are unanswered. @param {number} max */
  #flush(max) {
    let sent = 0;
    for (const { request, call, ids } of this.#send ? this.#waiting : []) {
      if (this.#unanswered >= max) break;
      const entry = this.#pending.get(request);
      if (entry) entry.fire = this.#fire;
      if (ids !== undefined) this.#unanswered += 1;
      this.#send?.(request, call);
      sent += 1;
    }
    this.#waiting.splice(0, sent);
  }

  /**
   * There is a fire: sends the calls that wait.
   * @param {number} fire
   * @param {(request: number, call: Call) => void} send
   * @returns {Promise<unknown>} when all of them are answered
   */
  connect(fire, send) {
    this.#fire = fire;
    this.#send = send;
    this.#models = 0;
    // Steps can take long, and nothing depends on them.
    const answers = this.#waiting.map(
      ({ request, call }) => ['step', 'advance'].includes(call[0]) || this.#pending.get(request)?.promise,
    );
    this.#flush(Infinity);
    return Promise.allSettled(answers);
  }

  /** There is no fire any more: it gets the calls before this one, and new calls wait for the next one. */
  disconnect() {
    this.#flush(Infinity);
    this.#fire = 0;
    this.#send = undefined;
  }

  /**
   * Settles a request: with its value, or with the error that refuses it.
   * @param {number} request
   * @param {Error} [error]
   * @param {unknown} [value]
   */
  settle(request, error, value) {
    const entry = this.#pending.get(request);
    this.#pending.delete(request);
    if (error) entry?.reject(error);
    else entry?.resolve(value);
    // A fire's number is that of a call that was sent.
    if (entry?.fire && entry.ids !== undefined) this.#unanswered -= 1;
    this.#flush(MAX_WAITING);
  }

  /** The promise of a request. @param {number} request */
  promise(request) {
    return this.#pending.get(request)?.promise;
  }

  /**
   * Rejects the requests to one fire; 0: those that wait for one.
   * @param {number} fire
   * @param {Error} error
   */
  abandon(fire, error) {
    if (fire === 0) this.#waiting.length = this.#models = 0;
    for (const [request, entry] of this.#pending) {
      if (entry.fire === fire) this.settle(request, error);
    }
  }
}

/** The ids that a call sets. @param {Call} call */
function idsOf([method, values]) {
  return method === 'set' ? Object.keys(values).join() : undefined;
}

/**
 * The error for refused values: the first one, with a list of all.
 * @param {Refusal[]} errors
 */
export function refusal(errors) {
  const { message, ...first } = errors[0] ?? { message: '' };
  return Object.assign(new RangeError(message), first, { errors });
}
