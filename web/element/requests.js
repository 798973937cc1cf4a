/**
 * Promises for what an element asked of the engine.
 *
 * Each request has a number; the engine's `done` or `refused` names it. What is
 * asked before there is a fire waits here and is sent in order when there is one.
 * A promise that nobody looks at never becomes an "unhandled rejection": a fire
 * is decoration, and the refusal is also an event and a warning.
 *
 * @typedef {import('../engine/engine.js').Message} Message
 * @typedef {{id: string, value: unknown, message: string, min?: number, max?: number}} Refusal
 * @typedef {{promise: Promise<any>, resolve: (value?: unknown) => void, reject: (error: Error) => void, failed: boolean}} Deferred
 */

/** Most requests that wait before some are dropped for newer ones of the same kind. */
const MOST_WAITING = 500;

/** Requests, waiting or on their way. */
export class Requests {
  #last = 0;
  /** @type {Map<number, Deferred & {fire: number}>} */
  #open = new Map();
  /** What is asked before there is a fire, models first. @type {Message[]} */
  #waiting = [];
  #models = 0;
  /** @type {((message: Message) => void) | undefined} */
  #send;
  #fire = 0;

  /**
   * Asks for something.
   * @param {Message} message
   * @returns {Promise<any>}
   */
  ask(message) {
    this.#last += 1;
    const request = this.#last;
    const entry = Object.assign(deferred(), { fire: this.#fire });
    this.#open.set(request, entry);
    if (this.#send) {
      this.#send({ ...message, request });
      return entry.promise;
    }
    this.#makeRoom(message, entry);
    if (isModel(message)) this.#waiting.splice(this.#models++, 0, { ...message, request });
    else this.#waiting.push({ ...message, request });
    return entry.promise;
  }

  /**
   * Who sets the same values again and again of a fire that nobody sees yet must not
   * fill the memory: where many wait, the oldest of the same kind goes the way of `entry`.
   * @type {(message: Message, entry: Deferred) => void}
   */
  #makeRoom(message, entry) {
    if (message.type !== 'set' || this.#waiting.length < MOST_WAITING) return;
    const kind = ids(message);
    const at = this.#waiting.findIndex((one) => one.type === 'set' && ids(one) === kind);
    if (at < 0) return;
    const [old] = this.#waiting.splice(at, 1);
    if (at < this.#models) this.#models -= 1;
    this.#open.get(old.request)?.resolve(entry.promise);
    this.#open.delete(old.request);
  }

  /**
   * There is a fire: sends what waits.
   * @param {number} fire
   * @param {(message: Message) => void} send
   * @returns {Promise<unknown>} when all of it was answered
   */
  connect(fire, send) {
    this.#fire = fire;
    this.#send = send;
    this.#models = 0;
    const answers = this.#waiting.splice(0).map((message) => {
      const entry = this.#open.get(message.request);
      if (entry) entry.fire = fire;
      send(message);
      // Steps can take their time; nothing needs to wait for them.
      return message.type === 'step' ? undefined : entry?.promise;
    });
    return Promise.allSettled(answers);
  }

  /** There is no fire any more; what is asked from now on waits for the next. */
  disconnect() {
    this.#fire = 0;
    this.#send = undefined;
  }

  /**
   * A request was carried out, with what it asked for, or refused with `error`.
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
   * Gives up what was asked of one fire; 0: what still waits for one.
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

/**
 * Whether a message sets the model alone, which decides what all other values may be.
 * @param {Message} message
 */
function isModel(message) {
  return message.type === 'set' && ids(message) === 'model';
}

/** The ids that a message sets. @param {Message} message */
function ids({ values = {} }) {
  return Object.keys(values).join();
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
 * The same value as plain data, which can be posted; where it is none, something of
 * its kind, which the engine refuses by that name. No code of the page runs later
 * than here, and none of it breaks more than its own value.
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
