/**
 * One fire of the engine, from its first size to the last event about it.
 *
 * An element has a link while it is on a page. When it is taken off, the link
 * is closed and everything of it is let go: watchers, listeners, the engine's fire.
 *
 * @typedef {import('../engine/engine.js').Call} Call
 * @typedef {import('../engine/engine.js').Message} Message
 * @typedef {import('../engine/engine.js').Drawn} Drawn
 * @typedef {{[field: string]: any}} Start what the fire starts with: see the engine's `add`
 */

import { connect } from '../engine/engine.js';
import { meant } from './values.js';
import { guess, sight, watch } from './visibility.js';

/** The request number of a removal: the largest; the others start at 1. */
const REMOVAL = 2 ** 32 - 1;

/** A link between an element and the engine. */
export class FireLink {
  #host;
  #requests;
  #tell;
  #watcher;
  #size = { width: 0, height: 0, side: 0 };
  #visible = false;
  #closed = false;
  /** @type {any} */
  #port;
  #fire = 0;
  /** Settles when the engine has freed the fire. */
  gone = Promise.resolve();
  #removed = () => {};
  #looked = () => {};
  /** Settles when it is known whether anybody sees it. */
  looked = /** @type {Promise<void>} */ (new Promise((resolve) => (this.#looked = resolve)));
  /** When it is made may be decided anew. */
  lookAgain = () => {};
  #shown = () => this.#port.shown(this.#fire);

  /**
   * @param {HTMLElement} host
   * @param {HTMLCanvasElement} canvas
   * @param {import('./requests.js').Requests} requests
   * @param {object} tell
   * @param {(message: Message) => void} tell.heard what the engine says
   * @param {(picture: Drawn) => void} tell.drawn a picture of the fire
   * @param {() => void} tell.begun the fire is there and everything asked of it before is answered
   * @param {(reduced: boolean) => void} tell.motion whether less motion is wanted, when that changes
   */
  constructor(host, canvas, requests, tell) {
    this.#host = host;
    this.#requests = requests;
    this.#tell = tell;
    this.#watcher = watch(host, canvas, {
      resized: (width, height, side) => {
        this.#size = { width, height, side };
        this.send('resize', width, height, side);
      },
      visible: (visible) => {
        this.#visible = visible;
        this.#looked();
        this.send('visible', visible);
      },
      motion: tell.motion,
    });
  }

  /** Whether the engine has the fire. */
  get live() {
    return this.#fire !== 0;
  }

  /** Whether it was closed. */
  get closed() {
    return this.#closed;
  }

  /** Where the engine runs; empty before it does. */
  get place() {
    return this.#port?.place ?? '';
  }

  /**
   * Gets the engine and has it make the fire.
   * @param {() => import('./visibility.js').Loading} loading when
   * @param {() => Parameters<typeof connect>} engine which
   * @param {() => Promise<unknown>} prepare what has to be there before it starts
   * @param {(prepared: any) => Start} start
   * @throws {import('../engine/engine.js').EngineError}
   */
  async open(loading, engine, prepare, start) {
    // A page's own script, which may say where the wasm is, has run by then.
    await new Promise((resolve) => setTimeout(resolve));
    await this.#sight(loading);
    if (this.closed) return;
    const wanted = engine();
    const [, prepared] = await Promise.all([connect(...wanted), prepare()]);
    if (this.closed) return;
    // It may have ended meanwhile, for want of a fire.
    const port = await connect(...wanted);
    if (this.closed) return;
    /** @type {Promise<unknown>} */
    let answered = Promise.resolve();
    const fire = port.open({
      onMessage: (message) => {
        // A fire that could not be made is refused its removal; it is gone as well, and
        // so is one whose engine has stopped.
        if (message.request === REMOVAL || (this.closed && message.kind === 'load')) {
          port.close(fire);
          this.#requests.abandon(fire, new Error('the fire was removed'));
          this.#removed();
          return;
        }
        this.#tell.heard(message);
        if (message.type === 'ready') {
          answered.then(() => this.live && this.#tell.begun());
        }
      },
      onPicture: (picture) => {
        if (this.closed) {
          if ('close' in picture) picture.close();
          return;
        }
        this.#tell.drawn(picture);
        // What is drawn faster than the page shows it is drawn for nobody.
        if (port.place === 'worker') requestAnimationFrame(this.#shown);
      },
    });
    this.#port = port;
    this.#fire = fire;
    if (port.warning) this.#tell.heard({ type: 'error', kind: 'load', message: port.warning, burns: true });
    const { width, height, side } = this.#size;
    const { view, ...started } = start(prepared);
    this.send('add', { side, guess: guess(), ...started });
    this.send('view', view.fit, view.x, view.y);
    this.send('resize', width, height, side);
    this.send('visible', this.#visible);
    answered = this.#requests.connect(fire, (request, call) => this.#call(request, call));
  }

  /**
   * Waits until the fire is to be made.
   * @param {() => import('./visibility.js').Loading} loading
   */
  async #sight(loading) {
    for (let again = true; again && !this.closed; ) {
      const wait = new AbortController();
      this.lookAgain = () => wait.abort();
      await sight(this.#host, loading(), wait.signal);
      again = wait.signal.aborted;
    }
  }

  /** Frees everything. */
  close() {
    this.#closed = true;
    this.lookAgain();
    this.#watcher.stop();
    if (this.live) {
      this.gone = new Promise((resolve) => (this.#removed = resolve));
      this.#call(REMOVAL, ['remove']);
    }
    this.#requests.disconnect();
    this.#fire = 0;
  }

  /**
   * There is no fire: gives up what was asked of it.
   * @param {Error} error
   */
  abandon(error) {
    this.#requests.abandon(this.#fire, error);
    this.#requests.abandon(0, error);
    if (this.live) {
      this.#call(REMOVAL, ['remove']);
      this.#port.close(this.#fire);
    }
    this.#removed();
    this.#fire = 0;
  }

  /** Calls the engine, whose answer nobody waits for. @param {Call} call */
  send(...call) {
    this.#call(0, call);
  }

  /** @type {(request: number, call: Call) => void} */
  #call(request, call) {
    if (this.#fire) this.#port.send([this.#fire, request, ...meant(call, this.#host)]);
  }
}
