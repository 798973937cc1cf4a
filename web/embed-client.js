/**
 * A fire in an iframe, as an object of the page around it:
 *
 *     const fire = connectFire(document.querySelector('iframe'));
 *     await fire.set('viscosity', 0.02);
 *     fire.addEventListener('stats', ({ detail }) => console.log(detail.fps));
 *
 * The address in the iframe has to allow the origin of this page. This file uses
 * no other, so that a page that has only the iframe can have a copy of it.
 */

/** What can be asked of the fire; each becomes a method that gives a promise. */
const METHODS = [
  'ready', 'play', 'pause', 'reset', 'step', 'set', 'get', 'params', 'objects', 'stats', 'restore',
  'addObject', 'changeObject', 'removeObject', 'exportConfig', 'importConfig', 'toBlob', 'stir', 'sparks', 'option',
];

/** How long a page that has loaded may take to say that it listens [ms]. */
const PATIENCE = 10_000;
/** How often to look whether the iframe is still on the page while an answer is awaited [ms]. */
const LOOK = 1000;

const LOST = 'the iframe is on no page';

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
  /** The window that listens. An iframe that is put somewhere else has another one. @type {unknown} */
  #window;
  /** Why there is no use in asking. @type {string | undefined} */
  #refusal;
  /** @type {Map<number, {resolve: (value: any) => void, reject: (error: unknown) => void}>} */
  #open = new Map();
  /** @type {{id: number}[]} */
  #waiting = [];
  /** Who listens for what. @type {Map<string, Listener[]>} */
  #listeners = new Map();
  /** The events that the page was asked for. @type {Set<string>} */
  #subscribed = new Set();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #silence;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #look;

  /** @param {HTMLIFrameElement} iframe */
  constructor(iframe) {
    super();
    this.#iframe = iframe;
    this.#origin = new URL(iframe.src, document.baseURI).origin;
    const { signal } = this.#ended;
    window.addEventListener('message', (event) => this.#hear(event), { signal });
    iframe.addEventListener('load', () => this.#greet(), { signal });
    // A page that was there before this script has said hello already.
    if (hasLoaded(iframe)) this.#greet();
  }

  /** @type {EventTarget['addEventListener']} */
  addEventListener(type, listener, options) {
    const { capture = false, once = false, signal } = optionsOf(options);
    if (!listener || signal?.aborted || this.#listenerOf(type, listener, capture)) return;
    const entry = { listener, capture, wrapped: listener };
    const forget = () => this.#forget(type, entry);
    // Whoever listens once would go unseen.
    if (once) entry.wrapped = after(forget, listener);
    super.addEventListener(type, entry.wrapped, options);
    signal?.addEventListener('abort', forget);
    this.#listeners.set(type, [...(this.#listeners.get(type) ?? []), entry]);
    this.#agree(type);
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
    this.#agree(type);
  }

  /** @param {string} type @param {unknown} listener @param {boolean} capture */
  #listenerOf(type, listener, capture) {
    return this.#listeners.get(type)?.find((one) => one.listener === listener && one.capture === capture);
  }

  /**
   * Asks for something.
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
      // As it is now: it may be changed before it can be sent.
      else this.#waiting.push(structuredClone(message));
    } catch (error) {
      return Promise.reject(error);
    }
    const answer = new Promise((resolve, reject) => this.#open.set(message.id, { resolve, reject }));
    this.#look ??= setTimeout(() => this.#watch(), LOOK);
    return answer;
  }

  /** Lets the fire go; it burns on, unheard. */
  close() {
    this.#ended.abort();
    this.#refuse('the fire was let go');
  }

  get #listens() {
    return this.#window !== undefined && this.#window === this.#iframe.contentWindow;
  }

  /** @param {object} message */
  #post(message) {
    this.#iframe.contentWindow?.postMessage(message, this.#origin);
  }

  /** Asks a page that has loaded whether it listens; it may be another one than before. */
  #greet() {
    this.#window = undefined;
    this.#refusal = undefined;
    this.#post({ hearth: 1, id: 0, method: 'hello' });
    clearTimeout(this.#silence);
    this.#silence = setTimeout(() => {
      this.#refuse(`the page in the iframe does not answer; its address must allow ${location.origin}`);
    }, PATIENCE);
  }

  /** @param {MessageEvent} event */
  #hear({ source, origin, data }) {
    if (!source || source !== this.#iframe.contentWindow) return;
    if (origin !== this.#origin || data?.hearth !== 1) return;
    if (data.event === 'hello') this.#begin(true);
    else if (data.id === 0) this.#begin(false);
    else if (data.event !== undefined) this.dispatchEvent(new CustomEvent(data.event, { detail: data.detail }));
    else this.#settle(data);
  }

  /**
   * The page listens: sends what waits for it.
   * @param {boolean} anew  Whether it has just been loaded and knows nothing yet.
   */
  #begin(anew) {
    clearTimeout(this.#silence);
    this.#refusal = undefined;
    this.#window = this.#iframe.contentWindow;
    const waiting = this.#waiting.splice(0);
    // Requests to the page before it stay without an answer.
    if (anew) this.#giveUp('the page in the iframe was loaded anew', new Set(waiting.map(({ id }) => id)));
    for (const type of new Set([...this.#subscribed, ...this.#listeners.keys()])) this.#agree(type);
    for (const message of waiting) this.#post(message);
  }

  /**
   * Subscribes to an event that has a listener, or unsubscribes from it. Each has a request of its
   * own, because an unknown event refuses all events of its request.
   * @param {string} type
   */
  #agree(type) {
    const subscribed = this.#subscribed;
    const wanted = this.#listeners.has(type);
    if (!this.#listens || subscribed.has(type) === wanted) return;
    if (wanted) subscribed.add(type);
    else subscribed.delete(type);
    this.call(wanted ? 'subscribe' : 'unsubscribe', [type]).catch((error) => {
      // If it is not for the page that this is, that one is asked as it comes.
      if (subscribed !== this.#subscribed) return;
      subscribed.delete(type);
      console.warn(`Hearth: ${error.message}`);
    });
  }

  /** Looks whether the iframe is still on the page, which no event tells. */
  #watch() {
    this.#look = undefined;
    // It may come back; its page is a new one then.
    if (!this.#iframe.contentWindow) this.#stop(LOST);
    else if (this.#open.size > 0) this.#look = setTimeout(() => this.#watch(), LOOK);
  }

  /** @param {string} why */
  #stop(why) {
    clearTimeout(this.#silence);
    this.#window = undefined;
    this.#giveUp(why);
  }

  /**
   * Refuses everything, until another page is loaded.
   * @param {string} why
   */
  #refuse(why) {
    this.#stop(why);
    this.#refusal = why;
  }

  /** @param {any} answer */
  #settle({ id, ok, value, error }) {
    const asked = this.#open.get(id);
    this.#open.delete(id);
    if (ok) asked?.resolve(value);
    else asked?.reject(Object.assign(new Error(), error));
  }

  /**
   * Refuses what has not been answered.
   * @param {string} why
   * @param {Set<number>} [except]  The numbers of requests that are kept.
   */
  #giveUp(why, except = new Set()) {
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
 * What may be said of a listener.
 * @param {boolean | AddEventListenerOptions | undefined} options
 * @returns {AddEventListenerOptions}
 */
function optionsOf(options) {
  return typeof options === 'object' ? (options ?? {}) : { capture: Boolean(options) };
}

/**
 * A listener before which something else is done.
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
  // A page of another origin cannot be looked at: so there is one.
  return inside ? inside.URL !== 'about:blank' && inside.readyState === 'complete' : iframe.isConnected;
}
