/**
 * Loads the engine and connects elements to it.
 *
 * Calls and events are plain data, delivered later and in order, as by `postMessage`, so no
 * getter of a page runs inside wasm. All fires of a page share one engine, which runs in a worker
 * if a worker can draw, and otherwise on the main thread. This module fetches and compiles its
 * wasm once.
 *
 * @typedef {[method: string, ...arguments: any[]]} Call a command of the engine: see its table
 * @typedef {{type: string, fire?: number, [field: string]: any}} Message an event of the engine
 * @typedef {ImageBitmap | HTMLCanvasElement} Drawn a picture: a bitmap to keep, or a canvas to
 *   copy at once
 * @typedef {{onMessage: (message: Message) => void, onPicture: (picture: Drawn) => void}} Listener
 * @typedef {'auto' | 'worker' | 'main'} Thread
 * @typedef {string | URL | BufferSource | Promise<BufferSource>} Source URL or bytes of wasm
 * @typedef {{part: string, module?: WebAssembly.Module, why?: string}} Part a part of the wasm, or why it is missing
 */

import { VERSION } from '../generated/version.js';
import { checkPart } from '../parts.js';
import { PARTS, glue, wasm, worker } from './files.js';
import { countdown, timely } from './time-limit.js';

/** Maximum time until the wasm arrives [ms]. */
const WASM_MS = 60_000;

/** The end of the name of the wasm, in an URL. */
const WASM_NAME = /_bg\.wasm(?=[?#]|$)/;

/** Lifetime of an engine without fires [ms]. */
const IDLE_MS = 5000;

/** Maximum time of starting a worker; then the main thread is used [s]. */
const WORKER_S = 15;

/** Time from an answer of a worker to the next ping [ms]. */
const PING_MS = 2000;

/** Maximum time without an answer of a worker [s]. */
const ANSWER_S = 10;

/** Maximum time without a graphics context [s]. */
const CONTEXT_S = 5;

/** Why there is no fire, with a message for visitors. */
export class EngineError extends Error {
  name = 'EngineError';

  /**
   * @param {'unsupported' | 'load' | 'stopped'} kind
   * @param {string} message
   */
  constructor(kind, message) {
    super(message);
    this.kind = kind;
  }
}

/**
 * The connection of elements to an engine, which they post calls to.
 * @typedef {EnginePort} Port
 */
class EnginePort {
  /** A problem of the server's configuration that does not prevent the fire; else empty. */
  warning = '';
  /** @type {(sent: [fire: number, request: number, ...call: Call] | number | Part) => void} */
  send = () => {};
  end = () => {};
  /** @type {Map<number, Listener>} */
  #listeners = new Map();
  #lastFire = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #idle;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #nextPing;
  #unanswered = () => {};
  /** Ends the wait for a lost context. @type {(() => void) | undefined} */
  #contextless;

  /** @param {'worker' | 'main'} thread on which the engine runs */
  constructor(thread) {
    this.thread = thread;
    this.#startIdleTimer();
  }

  /**
   * Connects a fire. `listener` gets its messages and pictures.
   * @param {Listener} listener
   * @returns {number} the fire's number
   */
  open(listener) {
    clearTimeout(this.#idle);
    this.#lastFire += 1;
    this.#listeners.set(this.#lastFire, listener);
    return this.#lastFire;
  }

  /** Disconnects a fire. Without fires, the engine is freed after a while. @param {number} fire */
  close(fire) {
    this.#listeners.delete(fire);
    if (this.#listeners.size === 0) this.#startIdleTimer();
  }

  /** Frees the engine unless a fire connects. */
  #startIdleTimer() {
    clearTimeout(this.#idle);
    this.#idle = setTimeout(() => this.#retire(), IDLE_MS);
  }

  /** Counts a picture of a fire as shown. @param {number} fire */
  shown(fire) {
    if (this.thread === 'worker') this.send(fire);
  }

  /** Requests an answer of a worker, which shows that it runs; 0 is the number of no fire. */
  ping() {
    this.send(0);
    this.#unanswered = countdown(ANSWER_S, () => this.fail(`it has not answered for ${ANSWER_S} seconds`));
  }

  /** The worker answers. */
  answered() {
    this.#unanswered();
    clearTimeout(this.#nextPing);
    this.#nextPing = setTimeout(() => this.ping(), PING_MS);
  }

  /** @param {Message} message */
  deliver(message) {
    if (message.type === 'part') {
      this.provide(message.part);
    } else if (message.kind === 'context-lost') {
      this.#contextless ??= countdown(CONTEXT_S, () => this.fail('the browser has not restored its graphics context'));
    } else if (message.type === 'restored') {
      this.#contextless?.();
      this.#contextless = undefined;
    }
    this.#listeners.get(message.fire ?? 0)?.onMessage(message);
  }

  /** Gives the engine a part, or the reason why it is missing. @param {string} part */
  async provide(part) {
    try {
      const { module } = await loadPart(part);
      this.send({ part, module });
    } catch (error) {
      this.send({ part, why: /** @type {Error} */ (error).message });
    }
  }

  /** @type {(fire: number, picture: Drawn) => void} */
  draw(fire, picture) {
    const listener = this.#listeners.get(fire);
    if (listener) listener.onPicture(picture);
    else if ('close' in picture) picture.close();
  }

  /**
   * Ends an engine that has a defect, lacks memory, or does not answer, and reports it to all
   * fires. The next fire gets a new engine.
   * @param {unknown} why
   */
  fail(why) {
    this.#retire();
    const message = `The fire's engine has stopped: ${why}`;
    for (const fire of [...this.#listeners.keys()]) {
      this.deliver({ type: 'error', fire, kind: 'stopped', message });
    }
  }

  #retire() {
    clearTimeout(this.#idle);
    clearTimeout(this.#nextPing);
    this.#unanswered();
    this.#contextless?.();
    if (current === this) opened = current = undefined;
    this.end();
    this.send = this.end = () => {};
  }
}

/** @type {Promise<EnginePort> | undefined} */
let opened;
/** @type {EnginePort | undefined} */
let current;
/** The wasm, kept so that a new engine needs no network. @type {ReturnType<typeof compile> | undefined} */
let kept;
/** The parts of it, by name; null after a failure. @type {{[part: string]: ReturnType<typeof compile> | null}} */
const keptParts = {};
/** The URL of the wasm, if the page names one whose parts are beside it. */
let named = '';

/**
 * Connects to the page's engine. The first call loads it; after a failure the next call tries
 * again.
 * @param {Source} [source] the wasm, if it is not next to its script
 * @param {Thread} [thread]
 * @returns {Promise<EnginePort>}
 */
export function connect(source, thread = 'auto') {
  opened ??= load(source, thread).then((port) => {
    current = port;
    return port;
  });
  const opening = opened;
  opening.catch(() => {
    if (opened === opening) opened = undefined;
  });
  return opening;
}

/**
 * Loads a part of the wasm. After a failure the next call tries again.
 * @param {string} part
 */
function loadPart(part) {
  const source = named ? named.replace(WASM_NAME, `_${part}.wasm`) : PARTS[part]();
  // What failed may stand in the browser's cache.
  keptParts[part] ??= compile(source, part in keptParts ? 'reload' : 'default')
    .then(async (loaded) => {
      const base = await kept;
      if (base) checkPart(loaded.module, part, base.module);
      return loaded;
    })
    .catch((error) => {
      keptParts[part] = null;
      throw error;
    });
  return keptParts[part];
}

/** @type {(source: Source | undefined, thread: Thread) => Promise<EnginePort>} */
async function load(source, thread) {
  // The worker's script and the wasm load in parallel.
  if (!kept) {
    const url = typeof source === 'string' || source instanceof URL ? new URL(source, document.baseURI).href : '';
    named = WASM_NAME.test(url) ? url : '';
    kept = compile(source ?? wasm()).catch((error) => {
      throw new EngineError('load', `The fire's engine could not be loaded: ${error.message}`);
    });
  }
  const compiled = kept;
  compiled.catch(() => (kept = undefined));
  const port = (thread !== 'main' && (await inWorker(compiled))) || undefined;
  const { module, warning } = await compiled;
  if (!port && thread === 'worker') {
    throw new EngineError('unsupported', 'The fire cannot be drawn in a worker of this browser.');
  }
  const connected = port ?? (await onMainThread(module));
  connected.warning = warning;
  return connected;
}

/**
 * Fetches and compiles the wasm, in parallel if the server sends the right type.
 * @param {Source} source
 * @param {RequestCache} [cache]
 * @returns {Promise<{module: WebAssembly.Module, warning: string}>}
 */
async function compile(source, cache) {
  const limit = AbortSignal.timeout(WASM_MS);
  try {
    const given = await source;
    if (typeof given !== 'string' && !(given instanceof URL)) {
      return checked(await WebAssembly.compile(given), '');
    }
    const url = new URL(given, document.baseURI).href;
    const response = await fetch(url, { credentials: 'same-origin', signal: limit, cache });
    if (!response.ok) throw new Error(`${url} gave ${response.status}`);
    const type = response.headers.get('content-type') ?? 'no type';
    const isWasm = /^application\/wasm\s*(;|$)/i.test(type);
    if (isWasm && WebAssembly.compileStreaming) return checked(await WebAssembly.compileStreaming(response), '');
    const bytes = await response.arrayBuffer();
    if (String.fromCharCode(...new Uint8Array(bytes.slice(0, 4))) !== '\0asm') {
      throw new Error(`${url} is no wasm file; it was served as ${type}`);
    }
    const warning = isWasm
      ? ''
      : `${url} is served as ${type} instead of application/wasm, so that the fire starts later.`;
    return checked(await WebAssembly.compile(bytes), warning);
  } catch (error) {
    throw limit.aborted ? new Error(`no answer within ${WASM_MS / 1000} s`) : error;
  }
}

/**
 * A module of the element's version. A cache may hold an old wasm beside a new element.
 * @param {WebAssembly.Module} module
 * @param {string} warning
 */
function checked(module, warning) {
  const version = WebAssembly.Module.imports(module)[0]?.module ?? 'none';
  // A module that only cargo and Trunk linked imports from a file in place of a version.
  if (version !== VERSION && version[0] !== '.') {
    throw new Error(`its wasm has version ${version}, the element has version ${VERSION}`);
  }
  return { module, warning };
}

/**
 * The engine in a worker; `undefined` if that is not possible.
 * @param {Promise<{module: WebAssembly.Module}>} compiled
 * @returns {Promise<EnginePort | undefined>}
 */
function inWorker(compiled) {
  /** @type {Worker} */
  let thread;
  try {
    thread = worker();
  } catch {
    return Promise.resolve(undefined);
  }
  const port = new EnginePort('worker');
  return new Promise((resolve) => {
    let started = () => {};
    const giveUp = () => {
      started();
      thread.terminate();
      resolve(undefined);
    };
    thread.onerror = (event) => {
      event.preventDefault();
      giveUp();
    };
    thread.onmessage = ({ data }) => {
      if (data.type !== 'started' || data.version !== VERSION) {
        // A cache may hold an old worker beside a new element.
        if (data.version) {
          console.warn(`Hearth: engine/worker.js has version ${data.version}, the element has version ${VERSION}.`);
        }
        giveUp();
        return;
      }
      started();
      port.send = (sent) => {
        try {
          thread.postMessage(sent);
        } catch (error) {
          // Calls are plain data: what cannot be posted lacks memory. The caller may be within a list of calls, and the
          // first ping goes out before anyone has this port.
          setTimeout(() => port.fail(error));
        }
      };
      port.end = () => thread.terminate();
      thread.onerror = (event) => {
        event.preventDefault();
        port.fail(event.message);
      };
      thread.onmessage = ({ data: event }) => {
        if (event.type === 'picture') port.draw(event.fire, event.bitmap);
        else if (event.type === 'answer') port.answered();
        else if (event.type === 'stopped') port.fail(event.at ? `${event.why} (${event.at})` : event.why);
        else port.deliver(event);
      };
      port.ping();
      resolve(port);
    };
    compiled
      .then(({ module }) => {
        thread.postMessage({ type: 'start', module });
        started = countdown(WORKER_S, giveUp);
      })
      .catch(giveUp);
  });
}

/**
 * The engine on this thread, whose code loads only here.
 * @param {WebAssembly.Module} module
 * @returns {Promise<EnginePort>}
 */
async function onMainThread(module) {
  const failed = (/** @type {unknown} */ error) => {
    throw new EngineError('load', `The fire's engine could not be loaded: ${error}`);
  };
  const code = Promise.all([glue(), import('./main-thread.js')]);
  const [{ default: init, Engine }, { start }] = await timely(code).catch(failed);
  await init({ module_or_path: module, fresh: true }).catch(failed);
  const port = new EnginePort('main');
  try {
    start(Engine, port, module, (part) => init({ part }));
  } catch (error) {
    throw new EngineError('unsupported', `The fire cannot be drawn: ${/** @type {Error} */ (error).message}.`);
  }
  return port;
}
