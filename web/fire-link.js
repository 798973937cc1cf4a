/**
 * One fire of the engine, from its canvas to the last message about it.
 *
 * An element has a link while it is on a page. When it is taken off, the link
 * is closed and everything of it is let go: watchers, listeners, the engine's
 * fire and its graphics context.
 *
 * @typedef {import('./engine.js').Message} Message
 * @typedef {{preset?: string, kept?: object, values: object, ownNumber?: boolean, quality: string, paused: boolean}} Start
 */

import { connect } from './engine.js';
import { guess, watch } from './watch.js';

/** The request number of a removal; the others start at 1. */
const REMOVAL = 0;

/** A link between an element and the engine. */
export class FireLink {
  #canvas;
  #requests;
  #tell;
  #watcher;
  #size = { width: 0, height: 0 };
  #visible = false;
  #closed = false;
  /** @type {any} */
  #port;
  #fire = 0;

  /**
   * @param {HTMLElement} host
   * @param {HTMLCanvasElement} canvas
   * @param {import('./requests.js').Requests} requests
   * @param {object} tell
   * @param {(message: Message) => void} tell.heard what the engine says
   * @param {() => void} tell.begun the fire is there and everything asked of it before is answered
   * @param {(reduced: boolean) => void} tell.motion whether less motion is wanted, when that changes
   */
  constructor(host, canvas, requests, tell) {
    this.#canvas = canvas;
    this.#requests = requests;
    this.#tell = tell;
    this.#watcher = watch(host, canvas, {
      resized: (width, height) => {
        this.#size = { width, height };
        this.#send({ type: 'resize', width, height });
      },
      visible: (visible) => {
        this.#visible = visible;
        this.#send({ type: 'visible', visible });
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

  /**
   * Gets the engine and has it make the fire.
   * @param {() => string | URL | undefined} wasmUrl
   * @param {() => Start} start
   * @throws {import('./engine.js').EngineError}
   */
  async open(wasmUrl, start) {
    // A page's own script, which may say where the wasm is, has run by then.
    await new Promise((resolve) => setTimeout(resolve));
    if (this.#closed) return;
    const port = await connect(wasmUrl());
    if (this.#closed) return;
    /** @type {Promise<unknown>} */
    let answered = Promise.resolve();
    const fire = port.open((message) => {
      // A fire that could not be made is refused its removal; it is gone as well.
      if (message.request === REMOVAL) {
        port.close(fire);
        this.#requests.abandon(fire, new Error('the fire was removed'));
        return;
      }
      this.#tell.heard(message);
      if (message.type === 'ready') {
        answered.then(() => this.#closed || this.#tell.begun());
      }
    });
    this.#port = port;
    this.#fire = fire;
    const state = { ...this.#size, visible: this.#visible, guess: guess() };
    this.#send({ type: 'add', canvas: this.#canvas, ...state, ...start() });
    answered = this.#requests.connect(fire, (message) => this.#send(message));
  }

  /** Frees everything. */
  close() {
    this.#closed = true;
    this.#watcher.stop();
    this.#send({ type: 'remove', request: REMOVAL });
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
  }

  /** @param {Message} message */
  #send(message) {
    if (this.#fire) this.#port.post({ ...message, fire: this.#fire });
  }
}
