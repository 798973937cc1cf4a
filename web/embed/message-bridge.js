/**
 * The message bridge of a fire in an iframe: the page around it sends requests, if the fire's address
 * allows that page's origin.
 *
 *     → { hearth: 1, id: 7, method: 'set', args: ['viscosity', 0.02] }
 *     ← { hearth: 1, id: 7, ok: true, value: undefined }
 *     ← { hearth: 1, id: 7, ok: false, error: { name, message, id, value, min, max } }
 *     ← { hearth: 1, event: 'params-change', detail: {…} }
 *
 * The methods are a list: no name in a message is ever looked up in an object. Messages of other
 * forms and of other windows than the parent are ignored.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {{hearth: unknown, id?: unknown, method?: unknown, args?: unknown}} Request a message that nothing has checked
 */

import { OPTIONS } from '../pages/url-parameters.js';

/** The version of these messages. */
const VERSION = 1;

/** Most of a message: characters of its texts, and as much for each other value as it takes. */
const LARGEST = 64 * 1024;
/** Deepest nesting; a set of values needs four. */
const DEEPEST = 8;
/** Most requests that are answered at one time. */
const MOST_OPEN = 256;
/** Most origins that an address may name. */
const MOST_ORIGINS = 16;

/** The events that are forwarded; `ready` needs no subscription. */
const EVENTS = [
  'ready', 'play', 'pause', 'params-change', 'objects-change', 'quality-change', 'stats', 'error', 'restored',
];

/** The methods that a page may call. @type {Map<unknown, (fire: HearthFire, ...args: any[]) => unknown>} */
const METHODS = new Map(Object.entries({
  ready: (fire) => fire.ready,
  play: (fire) => fire.play(),
  pause: (fire) => fire.pause(),
  reset: (fire) => fire.reset(),
  step: (fire, steps) => fire.step(steps),
  set: (fire, ids, value) => fire.set(ids, value),
  get: (fire, id) => parameter(fire, id),
  params: (fire) => fire.params,
  objects: (fire) => fire.objects,
  addObject: (fire, object) => fire.addObject(object),
  changeObject: (fire, id, properties) => fire.changeObject(id, properties),
  removeObject: (fire, id) => fire.removeObject(id),
  stats: (fire) => fire.stats,
  restore: (fire, ...ids) => fire.restore(...ids),
  exportConfig: (fire) => fire.exportConfig(),
  importConfig: (fire, config) => fire.importConfig(config),
  toBlob: (fire, type, quality) => fire.toBlob(type, quality),
  stir: (fire, x, y, u, v) => fire.stir(x, y, u, v),
  sparks: (fire, x, y, count) => fire.sparks(x, y, count),
  option: (fire, name, value) => option(fire, name, value),
}));

/** The methods of the bridge itself. */
const OF_THE_BRIDGE = ['hello', 'subscribe', 'unsubscribe'];

/**
 * The origins that an address allows, and what is wrong with the others.
 * @param {string[]} lists  Origins with commas between.
 * @returns {{origins: string[], refused: string[]}}
 */
export function allowedOrigins(lists) {
  const named = lists.flatMap((list) => list.split(',')).map((one) => one.trim()).filter(Boolean);
  const refused = [];
  const origins = new Set();
  for (const one of named.slice(0, MOST_ORIGINS)) {
    const origin = originOf(one);
    if (origin === one) origins.add(one);
    else refused.push(`“allow” wants exact origins, as https://example.org; ${whyNot(one, origin)}`);
  }
  if (named.length > MOST_ORIGINS) {
    refused.push(`“allow” takes ${MOST_ORIGINS} origins; the others are not allowed.`);
  }
  return { origins: [...origins], refused };
}

/** The origin of a web address; undefined for any other text. @param {string} text */
function originOf(text) {
  try {
    const { protocol, host, origin } = new URL(text);
    // Some take a star for the name of a host, which it would be here as well.
    return ['http:', 'https:'].includes(protocol) && !host.includes('*') ? origin : undefined;
  } catch {
    return undefined;
  }
}

/** @type {(one: string, origin: string | undefined) => string} */
function whyNot(one, origin) {
  const shown = `“${one.slice(0, 80)}”`;
  return origin ? `${shown} is not allowed, ${origin} would be.` : `${shown} is none.`;
}

/**
 * Answers the page around this one from now on, if it is of one of these origins.
 * @param {HearthFire} fire
 * @param {string[]} origins
 * @param {Window} [host]
 */
export function answer(fire, origins, host = window.parent) {
  if (host === window) return;
  const bridge = new MessageBridge(fire, origins, host);
  window.addEventListener('message', (event) => bridge.receive(event));
  for (const type of EVENTS) {
    fire.addEventListener(type, (event) => bridge.forward(type, /** @type {CustomEvent} */ (event).detail));
  }
  bridge.announce();
}

/** Too many requests are open. */
class BusyError extends Error {
  name = 'BusyError';
}

/** The bridge to the page around. */
class MessageBridge {
  #fire;
  #origins;
  #host;
  #open = 0;
  #wanted = new Set(['ready']);
  #warned = false;
  /** The origins that get events: all that are allowed, until one of them sends a message. */
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
    if (this.#wanted.has(type)) this.#post(type, detail);
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
        console.warn(`Hearth: ${origin} asked for something; the address of this fire does not allow it to.`);
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
    const counts = this.#open < MOST_OPEN;
    this.#open += Number(counts);
    try {
      if (!counts) throw new BusyError(`too many requests: ${MOST_OPEN} are waiting for their answers`);
      post({ id, ok: true, value: await this.#carryOut(message) });
    } catch (error) {
      post({ id, ok: false, error: posted(error) });
    } finally {
      this.#open -= Number(counts);
    }
  }

  /** @param {Request} message */
  #carryOut(message) {
    check(message);
    const { method, args = [] } = message;
    switch (method) {
      case 'hello':
        return this.#greeting();
      case 'subscribe':
        for (const type of eventsOf(args[0])) this.#wanted.add(type);
        return [...this.#wanted];
      case 'unsubscribe':
        for (const type of eventsOf(args[0])) this.#wanted.delete(type);
        return [...this.#wanted];
      default: {
        const act = METHODS.get(method);
        if (!act) throw new TypeError(`there is no method ${quoted(method)}; there are: ${allMethods().join(', ')}`);
        return act(this.#fire, ...args);
      }
    }
  }

  #greeting() {
    return { version: VERSION, methods: allMethods(), events: EVENTS };
  }
}

function allMethods() {
  return [...METHODS.keys(), ...OF_THE_BRIDGE];
}

/**
 * Whether data is a request. An answer is not a request: two pages that answered each other's answers
 * would never end.
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
  const left = remaining(message, LARGEST, DEEPEST);
  if (left < 0) {
    throw new RangeError(`a message is plain data, at most ${LARGEST} characters of it and at most ${DEEPEST} deep; this one is not`);
  }
  if (message.hearth !== VERSION) {
    throw new TypeError(`this fire speaks version ${VERSION}, not ${quoted(message.hearth)}`);
  }
  if (!isId(message.id)) {
    throw new TypeError('“id” is to be a number, or a text of at most 100 characters');
  }
  if (message.args !== undefined && !Array.isArray(message.args)) {
    throw new TypeError('“args” is to be an array');
  }
}

/**
 * What a value leaves of so much room; less than nothing if it is too much, too
 * deep, or no plain data. It stops as soon as that is known.
 * @param {unknown} value
 * @param {number} room
 * @param {number} depth
 * @returns {number}
 */
function remaining(value, room, depth) {
  if (typeof value === 'string') return room - value.length;
  if (typeof value !== 'object' || value === null) return typeof value === 'bigint' ? -1 : room - 8;
  const isArray = Array.isArray(value);
  if (depth === 0 || !(isArray || Object.getPrototypeOf(value) === Object.prototype)) return -1;
  // Before anything looks at each of them.
  if (isArray && value.length > room) return -1;
  let left = room - 8;
  for (const [key, field] of Object.entries(value)) {
    left = remaining(field, left - key.length, depth - 1);
    if (left < 0) break;
  }
  return left;
}

/** @param {unknown} names */
function eventsOf(names) {
  const list = Array.isArray(names) ? names : [names];
  const unknown = list.find((name) => !EVENTS.includes(name));
  if (list.length === 0 || unknown !== undefined || list.includes(undefined)) {
    throw new TypeError(`there is no event ${quoted(unknown)}; there are: ${EVENTS.join(', ')}`);
  }
  return list;
}

/**
 * Reads, and never does anything else.
 * @type {(fire: HearthFire, id: unknown) => unknown}
 */
function parameter(fire, id) {
  /** @type {{[id: string]: unknown}} */
  const params = { ...fire.params };
  if (typeof id !== 'string') throw new TypeError(`“id” is to be the id of a parameter, a text, not ${quoted(id)}`);
  if (Object.hasOwn(params, id)) return params[id];
  const all = Object.keys(params).join(', ');
  throw Object.assign(new RangeError(`there is no parameter ${quoted(id)}; there are: ${all}`), { id });
}

/**
 * Reads one of the element's own attributes, having set it if there is a value;
 * null takes it away. For all but `autoplay`, which is there where nothing is said,
 * false does too.
 * @param {HearthFire} fire
 * @param {string} name
 * @param {unknown} value
 */
function option(fire, name, value) {
  if (!OPTIONS.includes(name)) {
    throw new TypeError(`there is no option ${quoted(name)}; there are: ${OPTIONS.join(', ')}`);
  }
  const written = value === false && name === 'autoplay' ? 'false' : value;
  if (written === null || written === false) fire.removeAttribute(name);
  else if (written !== undefined) fire.setAttribute(name, written === true ? '' : String(written));
  return fire.getAttribute(name);
}

/** @param {unknown} value */
function quoted(value) {
  const text = typeof value === 'string' ? value : String(JSON.stringify(value));
  return `“${text.length > 40 ? `${text.slice(0, 40)}…` : text}”`;
}

/** An error as it can be posted. @param {unknown} error */
function posted(error) {
  const { name, message, id, value, min, max, kind } = Object(error);
  /** @type {{[field: string]: unknown}} */
  const described = { name: String(name ?? 'Error'), message: String(message ?? error) };
  for (const [key, detail] of Object.entries({ id, value, min, max, kind })) {
    if (['string', 'number', 'boolean'].includes(typeof detail)) described[key] = detail;
  }
  return described;
}
