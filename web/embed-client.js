/**
 * A fire in an iframe, as an object of the embedding page:
 *
 *     const fire = connectFire(document.querySelector('iframe'));
 *     await fire.set('viscosity', 0.02);
 *     fire.addEventListener('stats', ({ detail }) => console.log(detail.fps));
 *
 * The URL of the iframe must allow the origin of this page. This file imports no other, so that a page can
 * host a copy of it alone.
 */

/** The methods of the fire; each returns a promise. */
const METHODS = [
  'ready', 'play', 'pause', 'reset', 'step', 'set', 'get', 'params', 'objects', 'stats', 'restore',
  'addObject', 'changeObject', 'removeObject', 'exportConfig', 'importConfig', 'toBlob', 'stir', 'sparks', 'freeSolids', 'measure', 'ignite',
  'extinguish', 'option',
];

/** The maximum time from the load of the iframe to its first message [ms]. */
const GREETING_MS = 10_000;
/** The interval of the check whether the iframe is still on the page, while a request is open [ms]. */
const CHECK_MS = 1000;

const LOST = 'the iframe is not on a page';

/**
 * Connects to the fire in an iframe, which may still be loading.
 * @param {HTMLIFrameElement} iframe
 * @returns {import('./embed-client.js').FrameFire}
 */
export function connectFire(iframe) {
  return /** @type {any} */ (new FrameFire(iframe));
}

/** @typedef {{listener: unknown, capture: boolean, wrapped: EventListenerOrEventListenerObject | null}} Listener */

class FrameFire extends EventTarget {
  #iframe;
  #origin;
  #ended = new AbortController();
  #last = 0;
  /** The window that answers. An iframe that moves gets another one. @type {unknown} */
  #window;
  /** Why all requests are refused. @type {string | undefined} */
  #refusal;
  /** @type {Map<number, {resolve: (value: any) => void, reject: (error: unknown) => void}>} */
  #open = new Map();
  /** @type {{id: number}[]} */
  #waiting = [];
  /** The listeners of each event. @type {Map<string, Listener[]>} */
  #listeners = new Map();
  /** The events that are subscribed to. @type {Set<string>} */
  #subscribed = new Set();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #greeting;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #check;

  /** @param {HTMLIFrameElement} iframe */
  constructor(iframe) {
    super();
    this.#iframe = iframe;
    this.#origin = new URL(iframe.src, document.baseURI).origin;
    const { signal } = this.#ended;
    window.addEventListener('message', (event) => this.#receive(event), { signal });
    iframe.addEventListener('load', () => this.#greet(), { signal });
    // A page that loaded before this script has sent its greeting already.
    if (hasLoaded(iframe)) this.#greet();
  }

  /** @type {EventTarget['addEventListener']} */
  addEventListener(type, listener, options) {
    const { capture = false, once = false, signal } = optionsOf(options);
    if (!listener || signal?.aborted || this.#listenerOf(type, listener, capture)) return;
    const entry = { listener, capture, wrapped: listener };
    const forget = () => this.#forget(type, entry);
    // The event target removes a `once` listener by itself, unnoticed.
    if (once) entry.wrapped = after(forget, listener);
    super.addEventListener(type, entry.wrapped, options);
    signal?.addEventListener('abort', forget);
    this.#listeners.set(type, [...(this.#listeners.get(type) ?? []), entry]);
    this.#subscribe(type);
  }

  /** @type {EventTarget['removeEventListener']} */
  removeEventListener(type, listener, options) {
    const { capture = false } = optionsOf(options);
    const entry = this.#listenerOf(type, listener, capture);
    if (entry) this.#forget(type, entry);
  }

  /** @param {string} type @param {Listener} entry */
  #forget(type, entry) {
    super.removeEventListener(type, entry.wrapped, entry.capture);
    const others = (this.#listeners.get(type) ?? []).filter((one) => one !== entry);
    if (others.length > 0) this.#listeners.set(type, others);
    else this.#listeners.delete(type);
    this.#subscribe(type);
  }

  /** @param {string} type @param {unknown} listener @param {boolean} capture */
  #listenerOf(type, listener, capture) {
    return this.#listeners.get(type)?.find((one) => one.listener === listener && one.capture === capture);
  }

  /**
   * Sends a request.
   * @param {string} method
   * @param {...unknown} args
   * @returns {Promise<any>}
   */
  call(method, ...args) {
    if (this.#refusal !== undefined) return Promise.reject(new Error(this.#refusal));
    if (!this.#iframe.contentWindow) {
      this.#stop(LOST);
      return Promise.reject(new Error(LOST));
    }
    this.#last += 1;
    const message = { hearth: 1, id: this.#last, method, args };
    try {
      if (this.#listens) this.#post(message);
      // A copy: the page may change the arguments before they are sent.
      else this.#waiting.push(structuredClone(message));
    } catch (error) {
      return Promise.reject(error);
    }
    const answer = new Promise((resolve, reject) => this.#open.set(message.id, { resolve, reject }));
    this.#check ??= setTimeout(() => this.#checkFrame(), CHECK_MS);
    return answer;
  }

  /** Closes the connection; the fire keeps burning. */
  close() {
    this.#ended.abort();
    this.#refuse('the connection is closed');
  }

  get #listens() {
    return this.#window !== undefined && this.#window === this.#iframe.contentWindow;
  }

  /** @param {object} message */
  #post(message) {
    this.#iframe.contentWindow?.postMessage(message, this.#origin);
  }

  /** Sends a greeting to a page that has loaded. */
  #greet() {
    this.#window = undefined;
    this.#refusal = undefined;
    this.#post({ hearth: 1, id: 0, method: 'hello' });
    clearTimeout(this.#greeting);
    this.#greeting = setTimeout(() => {
      this.#refuse(`the page in the iframe does not answer; its URL must allow ${location.origin}`);
    }, GREETING_MS);
  }

  /** @param {MessageEvent} event */
  #receive({ source, origin, data }) {
    if (!source || source !== this.#iframe.contentWindow) return;
    if (origin !== this.#origin || data?.hearth !== 1) return;
    if (data.event === 'hello') this.#begin(true);
    else if (data.id === 0) this.#begin(false);
    else if (data.event !== undefined) this.dispatchEvent(new CustomEvent(data.event, { detail: data.detail }));
    else this.#settle(data);
  }

  /**
   * The page answers: sends the requests that wait for it.
   * @param {boolean} fresh  Whether the page has just loaded.
   */
  #begin(fresh) {
    clearTimeout(this.#greeting);
    this.#refusal = undefined;
    this.#window = this.#iframe.contentWindow;
    const waiting = this.#waiting.splice(0);
    // The page before it does not answer any more.
    if (fresh) this.#abandon('the page in the iframe was reloaded', new Set(waiting.map(({ id }) => id)));
    for (const type of new Set([...this.#subscribed, ...this.#listeners.keys()])) this.#subscribe(type);
    for (const message of waiting) this.#post(message);
  }

  /**
   * Subscribes to an event that has a listener, or unsubscribes from it. Each has a request of its
   * own, because an unknown event refuses all events of its request.
   * @param {string} type
   */
  #subscribe(type) {
    const subscribed = this.#subscribed;
    const wanted = this.#listeners.has(type);
    if (!this.#listens || subscribed.has(type) === wanted) return;
    if (wanted) subscribed.add(type);
    else subscribed.delete(type);
    this.call(wanted ? 'subscribe' : 'unsubscribe', [type]).catch((error) => {
      // A page that has loaded since gets its own subscriptions.
      if (subscribed !== this.#subscribed) return;
      subscribed.delete(type);
      console.warn(`Hearth: ${error.message}`);
    });
  }

  /** Checks whether the iframe is still on the page; there is no event for that. */
  #checkFrame() {
    this.#check = undefined;
    // If it returns, its page is a new one.
    if (!this.#iframe.contentWindow) this.#stop(LOST);
    else if (this.#open.size > 0) this.#check = setTimeout(() => this.#checkFrame(), CHECK_MS);
  }

  /** @param {string} why */
  #stop(why) {
    clearTimeout(this.#greeting);
    this.#window = undefined;
    this.#abandon(why);
  }

  /**
   * Refuses all requests until another page loads.
   * @param {string} why
   */
  #refuse(why) {
    this.#stop(why);
    this.#refusal = why;
  }

  /** @param {any} answer */
  #settle({ id, ok, value, error }) {
    const request = this.#open.get(id);
    this.#open.delete(id);
    if (ok) request?.resolve(value);
    else request?.reject(Object.assign(new Error(), error));
  }

  /**
   * Rejects the open requests.
   * @param {string} why
   * @param {Set<number>} [except]  The numbers of requests that are kept.
   */
  #abandon(why, except = new Set()) {
    this.#waiting.length = 0;
    this.#subscribed = new Set();
    for (const [id, { reject }] of this.#open) {
      if (except.has(id)) continue;
      this.#open.delete(id);
      reject(new Error(why));
    }
  }
}

for (const method of METHODS) {
  Object.defineProperty(FrameFire.prototype, method, {
    value(/** @type {unknown[]} */ ...args) {
      return this.call(method, ...args);
    },
  });
}

/**
 * The options of a listener as an object.
 * @param {boolean | AddEventListenerOptions | undefined} options
 * @returns {AddEventListenerOptions}
 */
function optionsOf(options) {
  return typeof options === 'object' ? (options ?? {}) : { capture: Boolean(options) };
}

/**
 * A listener that does something else first.
 * @param {() => void} act
 * @param {EventListenerOrEventListenerObject} listener
 * @returns {EventListener}
 */
function after(act, listener) {
  return /** @this {EventTarget} */ function (event) {
    act();
    if (typeof listener === 'function') listener.call(this, event);
    else listener.handleEvent(event);
  };
}

/**
 * Whether the iframe shows its page, and not the empty one that it starts with.
 * @param {HTMLIFrameElement} iframe
 */
function hasLoaded(iframe) {
  const inside = iframe.contentDocument;
  // A page of another origin is unreadable, so there is one.
  return inside ? inside.URL !== 'about:blank' && inside.readyState === 'complete' : iframe.isConnected;
}
