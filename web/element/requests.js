/**
 * Promises for the calls of an element.
 *
 * Each request has a number, which the engine's `done` or `refused` event carries. Calls
 * made before there is a fire wait here and are sent in order when there is one. A
 * rejected promise that nobody handles is no "unhandled rejection": a fire is decoration,
 * and the refusal is also an event and a warning.
 *
 * @typedef {import('../engine/engine.js').Call} Call
 * @typedef {{id: string, value: unknown, message: string, min?: number, max?: number}} Refusal
 * @typedef {{promise: Promise<any>, resolve: (value?: unknown) => void, reject: (error: Error) => void, failed: boolean}} Deferred
 */

/** Most calls that wait before some are dropped for newer ones of the same kind. */
const MAX_WAITING = 500;

/** Requests, waiting or on their way. */
export class Requests {
  #last = 0;
  /** @type {Map<number, Deferred & {fire: number}>} */
  #open = new Map();
  /** Calls made before there is a fire, models first. @type {{request: number, call: Call}[]} */
  #waiting = [];
  #models = 0;
  /** @type {((request: number, call: Call) => void) | undefined} */
  #send;
  #fire = 0;

  /**
   * Calls a command of the engine.
   * @param {Call} call
   * @returns {Promise<any>}
   */
  ask(...call) {
    this.#last += 1;
    const request = this.#last;
    const entry = Object.assign(deferred(), { fire: this.#fire });
    this.#open.set(request, entry);
    if (this.#send) {
      this.#send(request, call);
      return entry.promise;
    }
    this.#makeRoom(call, entry);
    if (ids(call) === 'model') this.#waiting.splice(this.#models++, 0, { request, call });
    else this.#waiting.push({ request, call });
    return entry.promise;
  }

  /**
   * Bounds the memory of a page that sets the same values of an unseen fire again and again:
   * where many calls wait, the oldest of the same kind is dropped and settles as `entry` does.
   * @type {(call: Call, entry: Deferred) => void}
   */
  #makeRoom(call, entry) {
    const kind = ids(call);
    if (kind === undefined || this.#waiting.length < MAX_WAITING) return;
    const at = this.#waiting.findIndex((waiting) => ids(waiting.call) === kind);
    if (at < 0) return;
    const [old] = this.#waiting.splice(at, 1);
    if (at < this.#models) this.#models -= 1;
    this.#open.get(old.request)?.resolve(entry.promise);
    this.#open.delete(old.request);
  }

  /**
   * There is a fire: sends the calls that wait.
   * @param {number} fire
   * @param {(request: number, call: Call) => void} send
   * @returns {Promise<unknown>} when all of them were answered
   */
  connect(fire, send) {
    this.#fire = fire;
    this.#send = send;
    this.#models = 0;
    const answers = this.#waiting.splice(0).map(({ request, call }) => {
      const entry = this.#open.get(request);
      if (entry) entry.fire = fire;
      send(request, call);
      // Steps can take long; nothing needs to wait for them.
      return call[0] === 'step' ? undefined : entry?.promise;
    });
    return Promise.allSettled(answers);
  }

  /** There is no fire any more; calls from now on wait for the next. */
  disconnect() {
    this.#fire = 0;
    this.#send = undefined;
  }

  /**
   * A request was carried out, with the value that it asked for, or refused with `error`.
   * @param {number} request
   * @param {Error} [error]
   * @param {unknown} [value]
   */
  settle(request, error, value) {
    const entry = this.#open.get(request);
    this.#open.delete(request);
    if (error) entry?.reject(error);
    else entry?.resolve(value);
  }

  /**
   * Gives up the requests to one fire; 0: those that still wait for one.
   * @param {number} fire
   * @param {Error} error
   */
  abandon(fire, error) {
    if (fire === 0) this.#waiting.length = this.#models = 0;
    for (const [request, entry] of this.#open) {
      if (entry.fire === fire) this.settle(request, error);
    }
  }
}

/** The ids that a call sets; the model decides what all other values may be. @param {Call} call */
function ids([method, values]) {
  return method === 'set' ? Object.keys(values).join() : undefined;
}

/**
 * What is thrown where something was refused.
 * @param {Refusal[]} errors
 */
export function refusal(errors) {
  const { id, value, min, max, message } = errors[0];
  return Object.assign(new RangeError(message), { id, value, min, max, errors });
}

/**
 * A promise with its handles, whose rejection may go unseen.
 * @returns {Deferred}
 */
export function deferred() {
  /** @type {any} */
  const made = { failed: false };
  made.promise = new Promise((resolve, reject) => {
    made.resolve = resolve;
    made.reject = (/** @type {Error} */ error) => {
      made.failed = true;
      reject(error);
    };
  });
  quiet(made.promise);
  return made;
}

/**
 * The same promise, whose rejection may go unseen.
 * @template T
 * @param {Promise<T>} promise
 */
export function quiet(promise) {
  promise.catch(() => {});
  return promise;
}

/** Most fields of an object; far more than there are parameters. */
const MOST_FIELDS = 1000;

/**
 * The same value as plain data, which can be posted. A value that is no plain data becomes
 * something of its kind, which the engine refuses by that name. No code of the page runs
 * after this, and none of it breaks more than its own value.
 * @param {unknown} value
 * @param {number} [depth] how deep it may yet be nested
 * @returns {any}
 */
export function postable(value, depth = 0) {
  try {
    if (Array.isArray(value)) return depth > 0 ? value.slice(0, MOST_FIELDS).map((one) => postable(one, depth - 1)) : [];
    if (typeof value === 'object' && value !== null) {
      // What is no plain data has no fields of its own that anybody means.
      if (depth === 0) return {};
      const names = Object.keys(value);
      if (names.length > MOST_FIELDS) return 'an object of more than a thousand fields';
      return Object.fromEntries(names.map((name) => [name, field(/** @type {{[name: string]: unknown}} */ (value), name, depth - 1)]));
    }
  } catch {
    return 'something unreadable';
  }
  if (['function', 'symbol', 'bigint'].includes(typeof value)) return `a ${typeof value}`;
  return value;
}

/** @type {(object: {[name: string]: unknown}, name: string, depth: number) => unknown} */
function field(object, name, depth) {
  try {
    return postable(object[name], depth);
  } catch {
    return 'something unreadable';
  }
}
