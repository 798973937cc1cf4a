/**
 * The connection of an element to its fire in the engine: from the first observed size to the last
 * event.
 *
 * An element has a connection while it is on a page. When the element is removed, the connection closes
 * and frees its observers, its listeners and the engine's fire.
 *
 * @typedef {import('../../engine/engine.js').Call} Call
 * @typedef {import('../../engine/engine.js').Message} Message
 * @typedef {import('../../engine/engine.js').Drawn} Drawn
 * @typedef {{[field: string]: any}} Start what the fire starts with: see the engine's `add`
 */

import { connect } from '../../engine/engine.js';
import { resolved } from '../attributes/values.js';
import { due, observe } from '../view/visibility.js';

/** The request number of a removal: the largest; the others start at 1. */
const REMOVAL = 2 ** 32 - 1;

/** A connection between an element and the engine. */
export class EngineConnection {
  #host;
  #requests;
  #on;
  #stop = () => {};
  #size = [0, 0, 0];
  #visible = false;
  /** Whether it is known whether the element is visible. */
  #known = false;
  /** Whether the fire has sent a picture. */
  pictured = false;
  /** @type {any} */
  #port;
  #fire = 0;
  /** Settles when the engine has freed the fire. */
  gone = Promise.resolve();
  /** Whether the connection is closed. */
  closed = false;
  #removed = () => {};
  #observed = () => {};
  /** Settles when it is known whether the element is visible. */
  observed = /** @type {Promise<void>} */ (new Promise((resolve) => (this.#observed = resolve)));
  /** Applies a changed `loading` attribute to a fire that is not loaded yet. */
  reschedule = () => {};
  #shown = () => this.live && this.#port.shown(this.#fire);

  /**
   * @param {HTMLElement} host
   * @param {HTMLCanvasElement} canvas
   * @param {import('./requests.js').Requests} requests
   * @param {object} on
   * @param {(message: Message) => void} on.message an event of the engine
   * @param {(frame: Drawn) => void} on.frame a frame of the fire
   * @param {() => void} on.visible the fire has come into sight or gone out of it, or has another size
   * @param {() => void} on.start the fire exists and every earlier request is answered
   * @param {(reduced: boolean) => void} on.motion whether the visitor prefers reduced motion, when that changes
   */
  constructor(host, canvas, requests, on) {
    this.#host = host;
    this.#requests = requests;
    this.#on = on;
    this.watch(canvas);
  }

  /** Observes this canvas and its element. @param {HTMLCanvasElement} canvas */
  watch(canvas) {
    const on = this.#on;
    this.#stop();
    // A fire that is paused draws another picture when its size changes alone.
    this.send('resize', 0, 0, 0);
    this.#stop = observe(this.#host, canvas, {
      resized: (...size) => {
        this.#size = size;
        this.send('resize', ...size);
        on.visible();
      },
      visible: (visible) => {
        this.#visible = visible;
        this.#known = true;
        this.#observed();
        this.send('visible', visible);
        on.visible();
      },
      motion: on.motion,
    });
  }

  /** Whether the engine has the fire. */
  get live() {
    return this.#fire !== 0;
  }

  /** Whether the fire is out of sight or has no area, so that the engine draws no picture of it. */
  get unseen() {
    const [width, height] = this.#size;
    // A browser observes nothing in a hidden page.
    return document.hidden || (this.#known && !(this.#visible && width && height));
  }

  /** The number of the fire in the engine; 0: it has none. */
  get number() {
    return this.#fire;
  }

  /**
   * Makes a copy of the fire in the engine.
   * @template T
   * @param {(port: import('../../engine/engine.js').Port, fire: number, resolve: (call: Call) => Call) => T} make
   */
  copy(make) {
    return make(this.#port, this.#fire, (call) => resolved(call, this.#host));
  }

  /** The thread of the engine; empty before it runs. */
  get engineThread() {
    return this.#port?.thread ?? '';
  }

  /**
   * Loads the engine, which makes the fire.
   * @param {() => import('../view/visibility.js').Loading} loading
   * @param {() => Parameters<typeof connect>} engine
   * @param {() => Promise<unknown>} prepare loads what the fire starts with
   * @param {(prepared: any) => Start} start
   * @throws {import('../../engine/engine.js').EngineError}
   */
  async open(loading, engine, prepare, start) {
    // The page's own script may set `wasmUrl` until then.
    await new Promise((resolve) => setTimeout(resolve));
    await this.#due(loading);
    if (this.closed) return;
    const options = engine();
    const [, prepared] = await Promise.all([connect(...options), prepare()]);
    if (this.closed) return;
    // An engine without fires may have ended meanwhile.
    const port = await connect(...options);
    if (this.closed) return;
    /** @type {Promise<unknown>} */
    let answered = Promise.resolve();
    const fire = port.open({
      onMessage: (message) => {
        // The fire is gone if its removal is answered, also with a refusal, or if its engine has stopped.
        if (message.request === REMOVAL || (this.closed && message.kind === 'stopped')) {
          port.close(fire);
          this.#requests.abandon(fire, new Error('the fire was removed'));
          this.#removed();
          return;
        }
        this.#on.message(message);
        if (message.type === 'ready') answered.then(() => this.live && this.#on.start());
      },
      onPicture: (frame) => {
        if (this.closed) {
          if ('close' in frame) frame.close();
          return;
        }
        this.pictured = true;
        this.#on.frame(frame);
        // The engine draws no more frames than the page shows.
        if (port.thread === 'worker') requestAnimationFrame(this.#shown);
      },
    });
    this.#port = port;
    this.#fire = fire;
    if (port.warning) this.#on.message({ type: 'error', kind: 'load', message: port.warning, burns: true });
    const { view, ...started } = start(prepared);
    this.send('add', { side: this.#size[2], ...started });
    this.send('view', view.fit, view.x, view.y);
    this.send('zoom', view.zoom, view.panX, view.panY);
    this.send('resize', ...this.#size);
    this.send('visible', this.#visible);
    answered = this.#requests.connect(fire, (request, call) => this.#call(request, call));
  }

  /**
   * Waits until the fire may be loaded.
   * @param {() => import('../view/visibility.js').Loading} loading
   */
  async #due(loading) {
    for (let again = true; again && !this.closed; ) {
      const wait = new AbortController();
      this.reschedule = () => wait.abort();
      await due(this.#host, loading(), wait.signal);
      again = wait.signal.aborted;
    }
  }

  /** Frees everything. */
  close() {
    this.closed = true;
    this.reschedule();
    this.#stop();
    this.#requests.disconnect();
    if (this.live) {
      this.gone = new Promise((resolve) => (this.#removed = resolve));
      this.send('remove');
    }
    this.#fire = 0;
  }

  /**
   * There is no fire: rejects its requests.
   * @param {Error} error
   */
  abandon(error) {
    this.#requests.abandon(this.#fire, error);
    this.#requests.abandon(0, error);
    if (this.live) {
      this.send('remove');
      this.#port.close(this.#fire);
    }
    this.#removed();
    this.#fire = 0;
  }

  /** Calls the engine without waiting for an answer, except that of a removal. @param {Call} call */
  send(...call) {
    this.#call(call[0] === 'remove' ? REMOVAL : 0, call);
  }

  /** @type {(request: number, call: Call) => void} */
  #call(request, call) {
    if (this.#fire) this.#port.send([this.#fire, request, ...resolved(call, this.#host)]);
  }
}
