/**
 * Promises for what an element asked of the engine.
 *
 * Each request has a number; the engine's `done` or `refused` names it. What is
 * asked before there is a fire waits here and is sent in order when there is one.
 * A promise that nobody looks at never becomes an "unhandled rejection": a fire
 * is decoration, and the refusal is also an event and a warning.
 *
 * @typedef {import('./engine.js').Message} Message
 * @typedef {{id: string, value: unknown, message: string, min?: number, max?: number}} Refusal
 * @typedef {{promise: Promise<void>, resolve: () => void, reject: (error: Error) => void, failed: boolean}} Deferred
 */

/** Requests, waiting or on their way. */
export class Requests {
  #last = 0;
  /** @type {Map<number, Deferred & {fire: number}>} */
  #open = new Map();
  /** @type {Message[]} */
  #waiting = [];
  /** @type {((message: Message) => void) | undefined} */
  #send;
  #fire = 0;

  /**
   * Asks for something.
   * @param {Message} message
   * @returns {Promise<void>}
   */
  ask(message) {
    this.#last += 1;
    const request = this.#last;
    const entry = Object.assign(deferred(), { fire: this.#fire });
    this.#open.set(request, entry);
    if (this.#send) this.#send({ ...message, request });
    else this.#waiting.push({ ...message, request });
    return entry.promise;
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
   * A request was carried out, or refused with `error`.
   * @param {number} request
   * @param {Error} [error]
   */
  settle(request, error) {
    const entry = this.#open.get(request);
    this.#open.delete(request);
    if (error) entry?.reject(error);
    else entry?.resolve();
  }

  /**
   * A request was refused.
   * @param {number} request
   * @param {Refusal[]} errors
   */
  refuse(request, errors) {
    const { id, value, min, max, message } = errors[0];
    this.settle(request, Object.assign(new RangeError(message), { id, value, min, max, errors }));
  }

  /**
   * Gives up what was asked of one fire; 0: what still waits for one.
   * @param {number} fire
   * @param {Error} error
   */
  abandon(fire, error) {
    if (fire === 0) this.#waiting.length = 0;
    for (const [request, entry] of this.#open) {
      if (entry.fire === fire) this.settle(request, error);
    }
  }
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
    made.reject = (error) => {
      made.failed = true;
      reject(error);
    };
  });
  made.promise.catch(() => {});
  return made;
}

/**
 * The same value if it can be posted, else something of its kind that can be,
 * and that the engine refuses by that name.
 * @param {unknown} value
 */
export function postable(value) {
  if (Array.isArray(value)) return [];
  if (typeof value === 'object' && value !== null) return {};
  if (['function', 'symbol', 'bigint'].includes(typeof value)) return `a ${typeof value}`;
  return value;
}

/**
 * The same values as plain data.
 * @param {{[id: string]: unknown}} values
 */
export function postableValues(values) {
  return Object.fromEntries(Object.entries(values).map(([id, value]) => [id, postable(value)]));
}
