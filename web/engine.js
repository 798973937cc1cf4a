/**
 * Loads the engine and connects elements to it, in messages only.
 *
 * Whatever an element and the engine say to each other could go through
 * `postMessage`: plain data, delivered later, in order, no getter into wasm.
 * Today the engine runs on the main thread; moved into a worker it would change
 * nothing here but `post`. All fires of a page share one engine.
 *
 * @typedef {{type: string, fire?: number, [field: string]: any}} Message
 */

/** The smallest module that uses a SIMD instruction. */
const SIMD_MODULE = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15,
  253, 98, 11,
]);

/** Why there is no fire, in words that a visitor can be shown. */
export class EngineError extends Error {
  /**
   * @param {'unsupported' | 'load'} kind
   * @param {string} message
   */
  constructor(kind, message) {
    super(message);
    this.name = 'EngineError';
    this.kind = kind;
  }
}

/** What this browser lacks, in words; empty if it has everything. */
export function missing() {
  if (typeof WebAssembly !== 'object') {
    return 'This browser has no WebAssembly, or it is switched off.';
  }
  if (!WebAssembly.validate(SIMD_MODULE)) {
    return 'This browser has no WebAssembly SIMD; every browser since 2023 has it.';
  }
  // A page may have only a few contexts, so the one that was tried is freed at once.
  const context = document.createElement('canvas').getContext('webgl2');
  if (!context) {
    return 'This browser gives no WebGL2: it may be switched off, or the graphics driver may be blocked.';
  }
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return '';
}

/** The engine as an element sees it: a port that can only be posted to. */
class EnginePort {
  #engine;
  /** @type {Map<number, (message: Message) => void>} */
  #listeners = new Map();
  #lastFire = 0;

  /** @param {new (post: (message: Message) => void) => any} Engine */
  constructor(Engine) {
    this.#engine = new Engine((message) => queueMicrotask(() => this.#deliver(message)));
  }

  /**
   * Opens a line for one fire; `listener` hears what is said about it.
   * @param {(message: Message) => void} listener
   * @returns {number} the fire's number
   */
  open(listener) {
    this.#lastFire += 1;
    this.#listeners.set(this.#lastFire, listener);
    return this.#lastFire;
  }

  /**
   * Closes the line of a fire.
   * @param {number} fire
   */
  close(fire) {
    this.#listeners.delete(fire);
  }

  /**
   * Sends a message to the engine.
   * @param {Message} message
   */
  post(message) {
    queueMicrotask(() => {
      try {
        this.#engine.receive(message);
      } catch (error) {
        // Only a defect of the engine itself comes here; its fires must hear it.
        const words = `The fire's engine has stopped: ${error}`;
        for (const fire of [...this.#listeners.keys()]) {
          this.#deliver({ type: 'error', fire, kind: 'load', message: words });
        }
      }
    });
  }

  /** @param {Message} message */
  #deliver(message) {
    this.#listeners.get(message.fire ?? 0)?.(message);
  }
}

/** @type {Promise<EnginePort> | undefined} */
let opened;

/**
 * Connects to the page's engine, which is loaded at the first call. A failure
 * is not remembered: the next call tries again.
 * @param {string | URL} [wasmUrl] where the wasm file is, if not beside its script
 * @returns {Promise<EnginePort>}
 */
export function connect(wasmUrl) {
  opened ??= load(wasmUrl).catch((error) => {
    opened = undefined;
    throw error;
  });
  return opened;
}

/** @param {string | URL} [wasmUrl] */
async function load(wasmUrl) {
  const lacking = missing();
  if (lacking) throw new EngineError('unsupported', lacking);
  try {
    const { default: init, Engine } = await import('./wasm/hearth-widget.js');
    const url = wasmUrl ?? new URL('./wasm/hearth-widget_bg.wasm', import.meta.url);
    await init({ module_or_path: url });
    return new EnginePort(Engine);
  } catch (error) {
    throw new EngineError('load', `The fire's engine could not be loaded: ${error}`);
  }
}
