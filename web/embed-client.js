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
  'ready', 'play', 'pause', 'reset', 'step', 'set', 'get', 'params', 'stats', 'restore',
  'exportConfig', 'importConfig', 'toBlob', 'option',
];

/** How long a page that has loaded may take to say that it listens [ms]. */
const PATIENCE = 10_000;

/**
 * Connects to the fire in an iframe, which may still be loading.
 * @param {HTMLIFrameElement} iframe
 * @returns {import('./embed-client.js').FrameFire}
 */
export function connectFire(iframe) {
  return /** @type {any} */ (new FrameFire(iframe));
}

class FrameFire extends EventTarget {
  #iframe;
  #origin;
  #ended = new AbortController();
  #last = 0;
  #listens = false;
  /** @type {Map<number, {resolve: (value: any) => void, reject: (error: Error) => void}>} */
  #open = new Map();
  /** @type {{id: number}[]} */
  #waiting = [];
  #wanted = new Set(['ready']);
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #silence;

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
    super.addEventListener(type, listener, options);
    if (this.#wanted.has(type)) return;
    this.#wanted.add(type);
    this.call('subscribe', [type]).catch((error) => console.warn(`Hearth: ${error.message}`));
  }

  /**
   * Asks for something.
   * @param {string} method
   * @param {...unknown} args
   * @returns {Promise<any>}
   */
  call(method, ...args) {
    if (this.#ended.signal.aborted) return Promise.reject(new Error('the fire was let go'));
    this.#last += 1;
    const message = { hearth: 1, id: this.#last, method, args };
    const answer = new Promise((resolve, reject) => this.#open.set(message.id, { resolve, reject }));
    if (this.#listens) this.#post(message);
    else this.#waiting.push(message);
    return answer;
  }

  /** Lets the fire go; it burns on, unheard. */
  close() {
    this.#ended.abort();
    clearTimeout(this.#silence);
    this.#waiting.length = 0;
    this.#giveUp('the fire was let go');
  }

  /** @param {object} message */
  #post(message) {
    this.#iframe.contentWindow?.postMessage(message, this.#origin);
  }

  /** Asks a page that has loaded whether it listens; it may be another one than before. */
  #greet() {
    this.#listens = false;
    this.#post({ hearth: 1, id: 0, method: 'hello' });
    clearTimeout(this.#silence);
    this.#silence = setTimeout(() => {
      this.#waiting.length = 0;
      this.#giveUp(`the page in the iframe does not answer; its address must allow ${location.origin}`);
    }, PATIENCE);
  }

  /** @param {MessageEvent} event */
  #hear({ source, origin, data }) {
    if (source !== this.#iframe.contentWindow || origin !== this.#origin || data?.hearth !== 1) return;
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
    this.#listens = true;
    const waiting = this.#waiting.splice(0);
    if (anew) {
      // What was asked of the page before it nobody will answer.
      this.#giveUp('the page in the iframe was loaded anew', new Set(waiting.map(({ id }) => id)));
      this.#post({ hearth: 1, id: 0, method: 'subscribe', args: [[...this.#wanted]] });
    }
    for (const message of waiting) this.#post(message);
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
 * Whether the iframe shows its page, and not the empty one that it starts with.
 * @param {HTMLIFrameElement} iframe
 */
function hasLoaded(iframe) {
  const inside = iframe.contentDocument;
  // A page of another origin cannot be looked at: so there is one.
  return inside ? inside.URL !== 'about:blank' && inside.readyState === 'complete' : iframe.isConnected;
}
