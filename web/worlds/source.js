/**
 * A fire without an element, whose pictures other programs show in their own worlds. All fires of a page share one
 * engine.
 *
 * @typedef {import('../engine/engine.js').Message} Message
 * @typedef {import('./source.js').FireOptions} FireOptions
 * @typedef {object} Listener
 * @property {(picture: ImageBitmap) => void} picture  A new picture, which is the listener's to close.
 * @property {(numbers: Float32Array) => void} [lights]  What the picture before shows: see the engine's `lights`.
 * @property {(error: Error) => void} error  A value is refused, or there is no fire; the console has it, too.
 */

import { connect } from '../engine/engine.js';
import { cut, listed } from '../quoted.js';

/** Options with their types, and the largest and smallest size of a picture [pixels]. */
const OPTIONS = {
  ...{ preset: 'string', values: 'object', quality: 'string', warm: 'number', paused: 'boolean' },
  ...{ width: 'number', height: 'number', fit: 'string', wasmUrl: 'any', thread: 'string' },
};
const MAX_SIDE = 2048;
const MIN_SIDE = 16;

/** A world has its own ground and background. */
const BARE = { backdrop: 'none', ground: 'none', background: 'transparent' };

/** A fire of the engine. */
export class FireSource {
  /** The values of all parameters, once the fire burns. @type {{[id: string]: any}} */
  values = {};
  /** The statistics, about four times a second. @type {{[name: string]: any}} */
  stats = {};
  /** Settles with the fire's first values, or fails. @type {Promise<void>} */
  ready;
  /** @type {import('../engine/engine.js').Port | undefined} */
  #port;
  #fire = 0;
  #requests = 0;
  /** @type {Map<number, {resolve: (value: any) => void, reject: (error: Error) => void}>} */
  #open = new Map();
  #on;
  #begun = { resolve: () => {}, reject: (/** @type {Error} */ _) => {} };
  #disposed = false;

  /**
   * @param {FireOptions} options
   * @param {Listener} on
   * @param {boolean} [sheets] whether a picture is an atlas of the slices
   */
  constructor(options, on, sheets = false) {
    const { width = 512, height = 512, fit = 'height', wasmUrl, thread, values, ...start } = checked(options);
    const shown = {
      side: height,
      guess: navigator.hardwareConcurrency > 2 ? 'medium' : 'low',
      warm: 0,
      lights: true,
      sheets,
    };
    this.#on = on;
    this.ready = new Promise((resolve, reject) => (this.#begun = { resolve, reject }));
    this.ready.catch(() => {});
    this.#connect(wasmUrl, thread).then(
      (port) => {
        if (this.#disposed) return;
        this.#port = port;
        this.#fire = port.open({ onMessage: (message) => this.#receive(message), onPicture: (it) => this.#take(it) });
        this.#send(0, 'add', { ...shown, ...start, values: { ...BARE, ...values } });
        this.#send(0, 'max_pixels', Math.max(width * height, 1024));
        this.#send(0, 'view', fit, 0.5, 0);
        this.#send(0, 'resize', width, height, height);
        this.#send(0, 'visible', true);
        if (start.warm) this.#send(0, 'warm');
      },
      (error) => this.#fail(error),
    );
  }

  /** @param {any} wasmUrl @param {any} thread */
  async #connect(wasmUrl, thread) {
    await connect(wasmUrl, thread);
    // An engine without fires may have ended meanwhile.
    return connect(wasmUrl, thread);
  }

  /**
   * Calls a command of the engine, once the fire burns.
   * @param {string} name
   * @param {...any} rest
   * @returns {Promise<any>}
   */
  async call(name, ...rest) {
    await this.ready;
    if (this.#disposed) throw new Error('the fire was removed');
    const request = ++this.#requests;
    return new Promise((resolve, reject) => {
      this.#open.set(request, { resolve, reject });
      this.#send(request, name, ...rest);
    });
  }

  /** Sets parameters, all or none. @param {{[id: string]: unknown}} values */
  set(values) {
    const answer = this.call('set', values, 'world');
    // A refusal is also reported.
    answer.catch(() => {});
    return answer;
  }

  /** @param {number} request  0: it needs no answer. @param {string} name @param {...any} rest */
  #send(request, name, ...rest) {
    this.#port?.send([this.#fire, request, name, ...rest]);
  }

  /** The page has shown a picture: the engine may draw another one. */
  shown() {
    if (this.#fire) this.#port?.shown(this.#fire);
  }

  /** @param {import('../engine/engine.js').Drawn} picture */
  async #take(picture) {
    // A canvas of the engine shows another picture later.
    const bitmap = 'close' in picture ? picture : await createImageBitmap(picture, { premultiplyAlpha: 'premultiply' });
    if (this.#disposed) bitmap.close();
    else this.#on.picture(bitmap);
  }

  /** @param {Message} message */
  #receive(message) {
    const { type, request, value, values, stats, numbers, errors, message: why, kind, burns } = message;
    const open = this.#open.get(request ?? 0);
    this.#open.delete(request ?? 0);
    if (type === 'lights') this.#on.lights?.(numbers);
    else if (type === 'stats') this.stats = stats;
    else if (type === 'ready' || type === 'changed') Object.assign(this.values, values);
    else if (type === 'done') open?.resolve(value);
    else if (type === 'refused') {
      const error = new RangeError(errors[0]?.message);
      open?.reject(error);
      this.#report(error);
    } else if (type === 'error' && !burns && kind !== 'context-lost') this.#fail(new Error(why));
    if (type === 'ready') this.#begun.resolve();
  }

  /** @param {Error} error */
  #fail(error) {
    this.#begun.reject(error);
    for (const { reject } of this.#open.values()) reject(error);
    this.#open.clear();
    if (!this.#disposed) this.#report(error);
  }

  /** @param {Error} error */
  #report(error) {
    console.warn(`Hearth: ${error.message}`);
    this.#on.error(error);
  }

  /** Frees the fire. */
  dispose() {
    if (this.#disposed) return;
    this.#disposed = true;
    this.#send(0, 'remove');
    this.#port?.close(this.#fire);
    this.#fail(new Error('the fire was removed'));
    this.#fire = 0;
  }
}

/**
 * Options whose names, types and sizes are right.
 * @param {FireOptions} options
 * @returns {FireOptions}
 */
function checked(options) {
  const given = /** @type {{[name: string]: unknown}} */ ({ ...options });
  for (const [name, value] of Object.entries(given)) {
    const type = OPTIONS[/** @type {keyof typeof OPTIONS} */ (name)];
    if (!type) throw new TypeError(`there is no option ${cut(name)}: there are ${listed(Object.keys(OPTIONS))}`);
    if (value === undefined) delete given[name];
    else if (type !== 'any' && typeof value !== type) throw new TypeError(`${name} must be of type ${type}`);
    else if (type === 'number' && name !== 'warm') {
      const fits = Number.isInteger(value) && Number(value) >= MIN_SIDE && Number(value) <= MAX_SIDE;
      if (!fits) throw new RangeError(`${name} = ${value} must be a whole number from ${MIN_SIDE} to ${MAX_SIDE}`);
    }
  }
  return given;
}
