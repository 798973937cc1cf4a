/**
 * The message bridge of a fire in an iframe: it answers requests of the embedding page, if the URL parameter
 * `allow` names that page's origin.
 *
 *     → { hearth: 1, id: 7, method: 'set', args: ['viscosity', 0.02] }
 *     ← { hearth: 1, id: 7, ok: true, value: undefined }
 *     ← { hearth: 1, id: 7, ok: false, error: { name, message, id, value, min, max } }
 *     ← { hearth: 1, event: 'params-change', detail: {…} }
 *
 * The methods are a list, which codegen writes from the members of the class with `@posted`: no other name in a
 * message is looked up in the element. Messages of other formats and of other windows than the parent are ignored.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {{hearth: unknown, id?: unknown, method?: unknown, args?: unknown}} Request a message that is not validated
 */

import { POSTED_EVENTS, POSTED_MEMBERS } from '../generated/iframe-methods.js';
import { suggestion } from '../element/attributes/spelling.js';
import { cut, listed } from '../quoted.js';
import { OPTIONS as OF_ADDRESSES } from '../pages/url-parameters.js';

/** The version of these messages. */
const VERSION = 1;

/** The maximum number of allowed origins. */
const MAX_ORIGINS = 16;

/** The attributes that a page may set: more than an address, which never turns sound on. */
const OPTIONS = [...OF_ADDRESSES, 'sound', 'roar', 'crackle', 'hiss'];

/** The methods that a page may call. `option` reads and sets attributes of the element. */
const METHODS = [...POSTED_MEMBERS, 'option'];

/** The methods of the bridge itself. */
const BRIDGE_METHODS = ['hello', 'subscribe', 'unsubscribe'];

/**
 * The allowed origins, and the reasons why others are refused.
 * @param {string[]} lists  Comma-separated origins.
 * @returns {{origins: string[], refused: string[]}}
 */
export function allowedOrigins(lists) {
  const named = lists
    .flatMap((list) => list.split(','))
    .map((name) => name.trim())
    .filter(Boolean);
  const refused = [];
  const origins = new Set();
  for (const name of named.slice(0, MAX_ORIGINS)) {
    const origin = originOf(name);
    if (origin === name) origins.add(name);
    else refused.push(`“allow” must list exact origins, such as https://example.org; ${whyNot(name, origin)}`);
  }
  if (named.length > MAX_ORIGINS) {
    refused.push(`“allow” may list at most ${MAX_ORIGINS} origins; the others are ignored.`);
  }
  return { origins: [...origins], refused };
}

/** The origin of an HTTP URL; undefined for any other text. @param {string} text */
function originOf(text) {
  try {
    const { protocol, host, origin } = new URL(text);
    // Some browsers accept a star in a host name.
    return ['http:', 'https:'].includes(protocol) && !host.includes('*') ? origin : undefined;
  } catch {
    return undefined;
  }
}

/** @type {(name: string, origin: string | undefined) => string} */
function whyNot(name, origin) {
  const shown = `“${cut(name, 80)}”`;
  return origin ? `use ${origin} instead of ${shown}.` : `${shown} is not an origin.`;
}

/**
 * Starts to answer the embedding page, if it has one of these origins.
 * @param {HearthFire} fire
 * @param {string[]} origins
 * @param {Window} [host]
 */
export function answer(fire, origins, host = window.parent) {
  if (host === window) return;
  const bridge = new MessageBridge(fire, origins, host);
  window.addEventListener('message', (event) => bridge.receive(event));
  for (const type of POSTED_EVENTS) {
    fire.addEventListener(type, (event) => bridge.forward(type, /** @type {CustomEvent} */ (event).detail));
  }
  bridge.announce();
}

/** The bridge to the embedding page. */
class MessageBridge {
  #fire;
  #origins;
  #host;
  #subscribed = new Set(['ready']);
  #warned = false;
  /** The origins that receive events: all allowed ones, until one of them sends a message. */
  #listeners;

  /** @param {HearthFire} fire @param {string[]} origins @param {Window} host */
  constructor(fire, origins, host) {
    this.#fire = fire;
    this.#origins = origins;
    this.#host = host;
    const parent = location.ancestorOrigins?.[0];
    this.#listeners = origins.filter((origin) => parent === undefined || parent === origin);
  }

  /** Announces that the bridge is open. */
  announce() {
    this.#post('hello', this.#greeting());
  }

  /** @type {(type: string, detail: unknown) => void} */
  forward(type, detail) {
    if (this.#subscribed.has(type)) this.#post(type, detail);
  }

  /** @type {(event: string, detail: unknown) => void} */
  #post(event, detail) {
    for (const origin of this.#listeners) {
      this.#host.postMessage({ hearth: VERSION, event, detail }, origin);
    }
  }

  /** @param {MessageEvent} event */
  receive({ source, origin, data }) {
    if (source !== this.#host || !isOurs(data)) return;
    if (!this.#origins.includes(origin)) {
      if (!this.#warned) {
        console.warn(`Hearth: a request of ${origin} is ignored; the URL parameter “allow” must name that origin.`);
      }
      this.#warned = true;
      return;
    }
    this.#listeners = [origin];
    this.#answer(data, (answer) => this.#host.postMessage({ hearth: VERSION, ...answer }, origin));
  }

  /** @type {(message: Request, post: (answer: object) => void) => Promise<void>} */
  async #answer(message, post) {
    const id = isId(message.id) ? message.id : null;
    try {
      post({ id, ok: true, value: await this.#execute(message) });
    } catch (error) {
      post({ id, ok: false, error: posted(error) });
    }
  }

  /** @param {Request} message */
  #execute(message) {
    check(message);
    const { method, args = [] } = message;
    switch (method) {
      case 'hello':
        return this.#greeting();
      case 'subscribe':
        for (const type of eventsOf(args[0])) this.#subscribed.add(type);
        return [...this.#subscribed];
      case 'unsubscribe':
        for (const type of eventsOf(args[0])) this.#subscribed.delete(type);
        return [...this.#subscribed];
      // The element returns undefined for an id of no parameter; a message gets the reason.
      case 'get':
        return parameter(this.#fire, args[0]);
      case 'option':
        return option(this.#fire, args[0], args[1]);
      default:
        return execute(this.#fire, method, args);
    }
  }

  #greeting() {
    return { version: VERSION, methods: allMethods(), events: POSTED_EVENTS };
  }
}

function allMethods() {
  return [...METHODS, ...BRIDGE_METHODS];
}

/**
 * Whether data is a request. Answers are not: two bridges would answer each other endlessly.
 * @param {unknown} data
 * @returns {data is Request}
 */
function isOurs(data) {
  if (typeof data !== 'object' || data === null || !Object.hasOwn(data, 'hearth')) return false;
  return Object.hasOwn(data, 'method') || !(Object.hasOwn(data, 'ok') || Object.hasOwn(data, 'event'));
}

/** @param {unknown} id */
function isId(id) {
  return typeof id === 'number' ? Number.isFinite(id) : typeof id === 'string' && id.length <= 100;
}

/**
 * @param {Request} message
 * @returns {asserts message is Request & {args?: any[]}}
 */
function check(message) {
  if (message.hearth !== VERSION) {
    throw new TypeError(`“hearth” must be version ${VERSION}, not ${quoted(message.hearth)}`);
  }
  if (!isId(message.id)) {
    throw new TypeError('“id” must be a number, or a string of at most 100 characters');
  }
  if (message.args !== undefined && !Array.isArray(message.args)) {
    throw new TypeError('“args” must be an array');
  }
}

/** @param {unknown} names */
function eventsOf(names) {
  const list = Array.isArray(names) ? names : [names];
  const unknown = list.find((name) => !POSTED_EVENTS.includes(name));
  if (list.length === 0 || unknown !== undefined || list.includes(undefined)) {
    throw new TypeError(`there is no event ${quoted(unknown)}; the events are: ${listed(POSTED_EVENTS)}`);
  }
  return list;
}

/**
 * Calls a method of the element that is in the list, or reads a property.
 * @type {(fire: HearthFire, method: unknown, args: unknown[]) => unknown}
 */
function execute(fire, method, args) {
  const name = POSTED_MEMBERS.find((member) => member === method);
  if (!name) throw new TypeError(`there is no method ${quoted(method)}; the methods are: ${listed(allMethods())}`);
  const member = /** @type {any} */ (fire)[name];
  return typeof member === 'function' ? member.apply(fire, args) : member;
}

/**
 * The value of a parameter.
 * @type {(fire: HearthFire, id: unknown) => unknown}
 */
function parameter(fire, id) {
  if (typeof id !== 'string') throw new TypeError(`“id” must be the id of a parameter, a string, not ${quoted(id)}`);
  const value = fire.get(/** @type {any} */ (id));
  if (value !== undefined) return value;
  const known = Object.keys(fire.params);
  throw Object.assign(new RangeError(`there is no parameter ${quoted(id)}${suggestion(id, known)}`), { id });
}

/**
 * Sets one of the element's own attributes if there is a value, and returns it. Null removes it, and so
 * does false, except for `autoplay`, which is on by default.
 * @param {HearthFire} fire
 * @param {string} name
 * @param {unknown} value
 */
function option(fire, name, value) {
  if (!OPTIONS.includes(name)) {
    throw new TypeError(`there is no option ${quoted(name)}; the options are: ${listed(OPTIONS)}`);
  }
  const text = value === false && name === 'autoplay' ? 'false' : value;
  if (text === null || text === false) fire.removeAttribute(name);
  else if (text !== undefined) fire.setAttribute(name, text === true ? '' : String(text));
  return fire.getAttribute(name);
}

/** @param {unknown} value */
function quoted(value) {
  let text = `a value of the type ${typeof value}`;
  try {
    text = typeof value === 'string' ? value : String(JSON.stringify(value));
  } catch {
    // It refers to itself, or has a number that JSON does not know.
  }
  return `“${cut(text)}”`;
}

/** An error as plain data. @param {unknown} error */
function posted(error) {
  const { name, message, id, value, min, max, kind } = Object(error);
  /** @type {{[field: string]: unknown}} */
  const described = { name: String(name ?? 'Error'), message: String(message ?? error) };
  for (const [key, detail] of Object.entries({ id, value, min, max, kind })) {
    if (['string', 'number', 'boolean'].includes(typeof detail)) described[key] = detail;
  }
  return described;
}
