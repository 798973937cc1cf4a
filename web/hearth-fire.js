/**
 * `<hearth-fire>`: a fire as an HTML element.
 *
 * The element is a thin shell. It turns attributes, properties and methods into calls of
 * the engine, and the engine's events into promises and events. It checks no value: the
 * table of parameters in wasm does. Reading a value gives the last one that the engine
 * accepted.
 *
 * The module can be imported where there is no `window`; it then defines nothing.
 *
 * @typedef {import('./engine.js').Call} Call
 * @typedef {import('./engine.js').Message} Message
 * @typedef {import('./requests.js').Refusal} Refusal
 */

import { DEFAULTS } from './defaults.js';
import { EngineError } from './engine.js';
import { burning } from './engine-files.js';
import {
  FireAttributes, ID_OF_ATTRIBUTE, ID_OF_PROPERTY, chosen, keepEarlyProperties, setOrRemove, warmth,
} from './fire-attributes.js';
import { FireLink } from './fire-link.js';
import { FireManners } from './fire-manners.js';
import { settings, settingsOfFile } from './fire-settings.js';
import { FireSigns } from './fire-signs.js';
import { hexOf, seedOf } from './fire-values.js';
import { FireView } from './fire-view.js';
import { Requests, deferred, postable, quiet, refusal } from './requests.js';
import { motionIsReduced } from './watch.js';

/** Seconds of fire that a still picture has burnt, so that it shows a fire. */
const STILL_AFTER = 2;

/** The element's class. */
export class HearthFire extends FireAttributes {
  /**
   * Where the wasm file is, if it is not at `wasm/hearth-engine_bg.wasm` beside
   * this module. It counts when it is set before the first fire is on the page.
   * @type {string | URL | undefined}
   */
  static wasmUrl;

  /**
   * Where the engine runs: `auto`, in a worker where that can draw, else on the main
   * thread; `worker`; `main`. It counts for the next engine: set it before the first
   * fire is on the page.
   * @type {import('./engine.js').Place}
   */
  static engine = 'auto';

  #requests = new Requests();
  /** @type {FireView} */
  #view;
  /** @type {{[id: string]: any}} */
  #params = { ...DEFAULTS };
  /** The values as they were before the model changed, for the way back. */
  #kept = {};
  /** @type {{[name: string]: any} | null} */
  #stats = null;
  #quality = 'auto';
  /** Whether somebody set the number of particles, as the engine says. */
  #ownNumber = false;
  #paused = false;
  /** Whether it stands still because the visitor wants less motion. */
  #still = false;
  /** Whether it burns although the visitor wants less motion, who said so here. */
  #stoppable = false;
  /** Whether the engine ever had a fire of this element, and has told its values. */
  #started = false;
  /** Settles when the engine has freed all fires before this one. */
  #gone = Promise.resolve();
  #announced = false;
  /** Whether the preset's attribute is taken away without a wish for other values. */
  #dropping = false;
  #preset = 'default';
  /** @type {FireLink | null} */
  #link = null;
  /** @type {import('./fire-manners.js').Ways} */
  #ways;
  /** @type {FireManners} */
  #manners;
  /** @type {FireSigns} */
  #signs;
  /** Whether its graphics context is there, of which it may be waiting for another one. */
  #drawable = true;
  /** What is asked of it, since somebody asked for a transition. @type {any} */
  #orders;
  #ready = deferred();

  constructor() {
    super();
    this.#view = new FireView(this, () => this.#press());
    this.#signs = new FireSigns(this, this.#view);
    this.#ways = {
      fire: this,
      ask: (...call) => this.#ask(...call),
      send: (...call) => this.#link?.send(...call),
      refuse: (id, value, allowed) => this.#refuse(id, value, allowed),
      complain: (kind, message) => this.#complain(kind, message),
      hexOf,
      isCalm: () => this.#isCalm(motionIsReduced()),
    };
    this.#manners = new FireManners(this.#ways, this.#view);
  }

  /** The name of the preset that its values started from. */
  get preset() {
    return this.#started ? this.#preset : super.preset;
  }

  set preset(name) {
    super.preset = name;
  }

  /** All values, by id: those that the fire burns with. */
  get params() {
    return { ...this.#params };
  }

  /** What the fire last said about itself: fps, particles, stepMs …; null before it did. */
  get stats() {
    return this.#stats && { ...this.#stats };
  }

  /** How much work it may make itself: `low`, `medium`, `high`, or `auto`: as much as fits. */
  get quality() {
    return this.#quality;
  }

  set quality(quality) {
    setOrRemove(this, 'quality', quality);
  }

  /**
   * Resolves when the fire burns; rejects where it cannot. An element that was taken off the page
   * has a new one.
   */
  get ready() {
    return this.#ready.promise;
  }

  /** Whether it stands still. */
  get paused() {
    return this.#paused;
  }

  set paused(paused) {
    this.#setPaused(Boolean(paused));
  }

  /**
   * The value of one parameter.
   * @param {string} id
   */
  get(id) {
    return Object.hasOwn(this.#params, id) ? this.#params[id] : undefined;
  }

  /**
   * Sets one parameter, or several: all of them or none.
   * @param {string | {[id: string]: unknown}} ids
   * @param {unknown} [value]
   * @returns {Promise<void>} rejects with a RangeError that has id, value, min and max
   */
  set(ids, value) {
    return this.#set(typeof ids === 'object' && ids ? ids : { [String(ids)]: value }, 'property');
  }

  /**
   * Moves parameters to values: all of them or none.
   * @param {{[id: string]: unknown}} values
   * @param {{duration?: number, easing?: string}} [how] in milliseconds; as CSS has it
   * @returns {Promise<boolean>} whether they arrived; false where one was set meanwhile
   */
  to(values, how) {
    this.#orders ??= [];
    const checked = this.#ask('check', postable(values, 1));
    const code = import('./fire-transition.js').catch((why) => {
      this.#orders = undefined;
      this.#complain('load', `Transitions could not be loaded: ${why}`);
      throw why;
    });
    return quiet(code.then(({ run }) => run(this.#orders, this.#ways, checked, { ...how })));
  }

  /**
   * Puts parameters back to their defaults; without ids: all of them, the model
   * too, and no preset is left.
   * @param {...string} ids
   * @returns {Promise<void>}
   */
  restore(...ids) {
    if (ids.length > 0) return this.#ask('restore', postable(ids, 1), 'property');
    this.#dropPreset();
    return this.#ask('preset', 'default', 'property');
  }

  /** Lets it burn. */
  play() {
    return this.#setPaused(false);
  }

  /** Lets it stand still. */
  pause() {
    return this.#setPaused(true);
  }

  /** Starts again from nothing, with the same values. */
  reset() {
    return this.#ask('reset');
  }

  /**
   * Makes some steps of the simulation, playing or not, then draws.
   * @param {number} [steps]
   * @returns {Promise<void>}
   */
  step(steps = 1) {
    return this.#ask('step', postable(steps));
  }

  /**
   * Its settings: the preset, where that is not the default one, and what differs
   * from it. JSON of them can be kept, sent, and given to `importConfig` or `src`.
   * @returns {Promise<{hearth: 1, preset?: string, values: {[id: string]: any}}>}
   */
  exportConfig() {
    return this.#ask('export');
  }

  /**
   * Burns with these settings from now on: all of them or, if anything is wrong in
   * them, none.
   * @param {unknown} config settings, or their JSON text
   * @returns {Promise<void>}
   */
  importConfig(config) {
    try {
      return this.#ask('import', settings(config), 'property');
    } catch (error) {
      const { message } = /** @type {Error} */ (error);
      return quiet(Promise.reject(this.#refused([{ id: 'config', value: config, message }])));
    }
  }

  /**
   * What is seen of it now, as a file.
   * @param {string} [type] PNG, if it is not `image/jpeg` or `image/webp`
   * @param {number} [quality] of those, from 0 to 1
   * @returns {Promise<Blob>}
   */
  toBlob(type = 'image/png', quality) {
    return this.#ofPicture((canvas) => new Promise((resolve, reject) => {
      const refused = new Error(`the browser makes no file of the picture as ${type}`);
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(refused)), type, quality);
    }));
  }

  /**
   * The fire as a stream of video, for a recorder, a call or a `<video>`.
   * @param {number} [fps] most pictures a second; without it, all
   * @returns {Promise<MediaStream>}
   */
  captureStream(fps) {
    return this.#ofPicture((canvas) => {
      if (!canvas.captureStream) throw new Error('this browser cannot capture a canvas');
      return fps === undefined ? canvas.captureStream() : canvas.captureStream(fps);
    });
  }

  /**
   * Puts the fire out and frees all that it holds. It burns again when the element
   * is put on a page anew.
   * @returns {Promise<void>} when it is freed
   */
  async destroy() {
    if (this.#link) this.#close();
    await this.#gone;
  }

  /**
   * Carries the gas around a place along, for a twentieth of a second.
   * @param {number} x metres from the middle
   * @param {number} y metres above the floor
   * @param {number} u metres a second to the right, at most 20
   * @param {number} v metres a second up, at most 20
   * @returns {Promise<void>}
   */
  stir(x, y, u, v) {
    return this.#ask('stir', ...postable([x, y, u, v], 1));
  }

  /**
   * Throws sparks from a place; the classic model has none.
   * @param {number} x metres from the middle
   * @param {number} y metres above the floor
   * @param {number} [count] from 1 to 200
   * @returns {Promise<void>}
   */
  sparks(x, y, count = 24) {
    return this.#ask('sparks', ...postable([x, y, count], 1));
  }

  /**
   * Which place of the fire's world a point of the page shows.
   * @param {number} x CSS pixels from the element's left edge
   * @param {number} y CSS pixels from its upper edge
   * @returns {{x: number, y: number} | null} in metres, from the middle of the
   *   floor, y up; null while there is no picture
   */
  toMetres(x, y) {
    return this.#view.place(this.#params)?.toMetres(x, y) ?? null;
  }

  /**
   * Where a place of the fire's world is shown: the inverse of `toMetres`.
   * @param {number} x metres from the middle
   * @param {number} y metres above the floor
   * @returns {{x: number, y: number} | null} CSS pixels from the element's upper left corner
   */
  toPixels(x, y) {
    return this.#view.place(this.#params)?.toPixels(x, y) ?? null;
  }

  connectedCallback() {
    keepEarlyProperties(this);
    if (this.getAttribute('seed') === 'auto') seedOf(this);
    this.#manners.watch();
    // One that failed tries again, also where it was taken off and put back at once.
    if (this.#link && this.#ready.failed) this.#close();
    if (!this.#link) this.#open();
  }

  /** It was taken to another document, as a window beside the page. */
  adoptedCallback() {
    this.#view.dress();
  }

  disconnectedCallback() {
    // An element that is only moved is back before the microtask.
    queueMicrotask(() => {
      if (!this.isConnected && this.#link) this.#close();
    });
  }

  /** A move by `moveBefore` needs nothing. */
  connectedMoveCallback() {}

  /** @type {(name: string, old: string | null, value: string | null) => void} */
  attributeChangedCallback(name, old, value) {
    const id = ID_OF_ATTRIBUTE.get(name);
    this.#manners.change(name, value);
    if (name === 'loading') this.#link?.lookAgain();
    // Before, the fire starts with what its attributes say, wherever they stand.
    const begun = this.#started || this.#link?.live;
    if (name === 'model' && !begun) {
      // The first fire starts with its model.
    } else if (id !== undefined) {
      if (value !== null) this.#set({ [id]: value }, 'attribute');
      else this.#ask('restore', [id], 'attribute');
    } else if (name === 'preset') {
      if (begun && !this.#dropping) this.#ask('preset', value ?? 'default', 'preset');
    } else if (name === 'quality') {
      this.#ask('quality', value ?? 'auto');
    } else if (name === 'paused') {
      if ((value !== null) !== this.#paused) this.#setPaused(value !== null);
    } else if (name === 'src') {
      if (begun) this.#changeFile();
    } else if (name === 'warm') {
      const seconds = warmth(this);
      if (Number.isNaN(seconds)) this.#refuse(name, value ?? '', 'a number of seconds from 0 to 30');
      else if (begun) this.#ask('warm', seconds);
    } else if (name === 'autoplay') {
      if (this.#link && !this.#started && !this.autoplay) this.#setPaused(true);
    } else if (name === 'reduced-motion' && this.#link) {
      this.#motion(motionIsReduced());
    }
  }

  /** The attribute goes; its values are somebody else's to change. */
  #dropPreset() {
    this.#dropping = true;
    this.removeAttribute('preset');
    this.#dropping = false;
  }

  /** Calls the engine. @param {Call} call */
  #ask(...call) {
    // Where there can be no fire, nothing waits for one.
    const answer = this.#ready.failed ? this.#ready.promise : this.#requests.ask(...call);
    this.#orders?.push([call, answer]);
    return answer;
  }

  /** @type {(values: {[id: string]: unknown}, source: string) => Promise<void>} */
  #set(values, source) {
    return this.#ask('set', postable(values, 1), source);
  }

  /**
   * The settings in the file that `src` names; undefined where there are none, which
   * is said.
   */
  async #settingsOfFile() {
    const { src } = this;
    if (!src) return undefined;
    try {
      return await settingsOfFile(src);
    } catch (error) {
      const { message } = /** @type {Error} */ (error);
      if (error instanceof RangeError) this.#refused([{ id: 'src', value: src, message }]);
      else this.#complain('load', message);
      return undefined;
    }
  }

  /** Another file: the fire takes over what is in it. */
  async #changeFile() {
    const { src } = this;
    const config = await this.#settingsOfFile();
    if (src !== this.src) return;
    if (config !== undefined) this.#ask('import', config, 'src');
    // Without a file it burns as it would have without one.
    else if (!src) this.#ask('preset', this.preset, 'src');
  }

  /**
   * What `make` makes of the canvas, when there is a picture on it.
   * @template T
   * @param {(canvas: HTMLCanvasElement) => T | Promise<T>} make
   * @returns {Promise<T>}
   */
  #ofPicture(make) {
    return quiet(this.#ready.promise.then(() => this.#view.drawn()).then(make));
  }

  /** @type {(paused: boolean, still?: boolean) => Promise<void>} */
  #setPaused(paused, still = false) {
    // A visitor who wants less motion and lets it burn can stop it again.
    this.#stoppable = !paused && motionIsReduced() && (this.#still || this.#stoppable);
    this.#paused = paused;
    this.#still = still;
    this.#offer();
    this.#signal();
    // That it stands still for a visitor is nothing that its page said.
    if (!still && this.hasAttribute('paused') !== paused) this.toggleAttribute('paused', paused);
    // A fire that is still to come is told how it starts.
    if (!this.#link?.live) return this.#ready.promise;
    return this.#ask(paused ? 'pause' : 'play');
  }

  /** What the button in the picture does. */
  #press() {
    if (this.#still) this.play();
    else this.#setPaused(true, true);
  }

  #offer() {
    this.#view.offer(this.#still ? 'play' : this.#stoppable ? 'pause' : '');
  }

  /** Says whether it is seen to burn. */
  #signal() {
    this.#signs.burning(this.#view.shows && this.#drawable && !this.#paused);
  }

  /** Whether it moves less. @param {boolean} reduced */
  #isCalm(reduced) {
    return reduced && this.reducedMotion !== 'ignore';
  }

  /** @param {boolean} reduced */
  #motion(reduced) {
    const still = this.#isCalm(reduced);
    if (still && !this.#paused) {
      this.#setPaused(true, true);
    } else if (!still && this.#still) {
      this.#setPaused(false);
    }
  }

  /** Makes a fire. */
  #open() {
    if (this.#ready.failed) this.#ready = deferred();
    const canvas = this.#view.newCanvas();
    this.#view.describe(this.alt);
    this.#view.show('loading');
    if (this.warm) this.#view.fade();
    const reduced = this.#isCalm(motionIsReduced());
    // One that stood still for that when it was taken off does so again.
    const still = reduced && (this.#still || !this.#paused);
    if (this.#still && !reduced) this.#setPaused(false);
    const link = new FireLink(this, canvas, this.#requests, {
      heard: (message) => this.#receive(message, link),
      drawn: (picture) => this.#view.draw(picture),
      begun: () => this.#begin(link, still),
      motion: (reduced) => this.#motion(reduced),
    });
    this.#link = link;
    this.#manners.begin();
    if (still) this.#setPaused(true, true);
    else if (!this.#started && !this.autoplay) this.#setPaused(true);
    const opened = link.open(
      () => chosen(this, 'loading'),
      () => [HearthFire.wasmUrl, HearthFire.engine],
      () => this.#prepare(),
      (prepared) => ({
        ...this.#start(prepared.config), warm: this.warm, state: prepared.state, view: this.#view.camera,
      }),
    );
    opened.catch((error) => link.closed || this.#fail(error.kind ?? 'load', error.message));
  }

  /** What a fire waits for: all that the one before it has to tell, or its file; and a kept fire. */
  async #prepare() {
    const state = this.warm && !this.src ? burning(this.preset) : undefined;
    await this.#gone;
    let config;
    let src;
    do {
      src = this.src;
      config = this.#started ? undefined : await this.#settingsOfFile();
      // Another file may have been named meanwhile.
    } while (src !== this.src);
    return { config, state: await state };
  }

  /**
   * What the fire starts from: preset, file and model at first, what it was when it comes
   * back.
   * @param {unknown} config what was in the file
   */
  #start(config) {
    const [paused, quality] = [this.#paused, this.#quality];
    if (this.#started) {
      const [preset, kept, values, ownNumber] = [this.#preset, this.#kept, this.#params, this.#ownNumber];
      return { preset, kept, values, ownNumber, quality, paused };
    }
    const preset = this.getAttribute('preset') ?? undefined;
    const model = this.getAttribute('model');
    return { preset, config, values: model === null ? {} : { model }, quality, paused };
  }

  /**
   * The fire is there and has its values.
   * @param {FireLink} link
   * @param {boolean} still
   */
  async #begin(link, still) {
    if (this.warm) {
      // Before, it may be taken for one that nobody sees.
      if (!document.hidden) await link.looked;
      await this.#ask('warm').catch(() => {});
    } else if (still) {
      await this.#ask('burn', STILL_AFTER).catch(() => {});
    }
    if (!link.live) return;
    this.#view.show('shown');
    this.#offer();
    this.#announced = true;
    this.#view.drawn().then(() => this.#signal(), () => {});
    this.#manners.burns();
    this.#ready.resolve();
    this.#emit('ready');
  }

  /** Frees the fire and all that belongs to it. */
  #close() {
    this.#orders?.end?.();
    // Who waits from now on waits for the next one.
    if (this.#announced) this.#ready = deferred();
    this.#link?.close();
    // One that never got its fire leaves none behind; the fire before it may still be there.
    const gone = this.#link?.gone;
    this.#gone = this.#gone.then(() => gone);
    this.#link = null;
    this.#announced = false;
    this.#stats = null;
    this.#manners.end();
    this.#view.dropCanvas();
    this.#view.offer('');
    this.#view.show('loading');
    this.#drawable = true;
    this.#signal();
    this.#signs.light();
  }

  /** @type {(message: Message, link: FireLink) => void} */
  #receive(message, link) {
    // Of a fire that was taken off only what it was given before still counts.
    if (link.closed && !['ready', 'changed', 'done', 'refused'].includes(message.type)) return;
    switch (message.type) {
      case 'ready':
        this.#started = true;
        this.#params = { ...this.#params, ...message.values };
        this.#ownNumber = message.ownNumber;
        this.#preset = message.preset;
        break;
      case 'changed':
        if (message.anew) this.#kept = {};
        else if ('model' in message.values) this.#kept = this.#params;
        this.#params = { ...this.#params, ...message.values };
        this.#ownNumber = message.ownNumber;
        this.#preset = message.preset;
        if (message.anew) this.#reflectPreset();
        if (!this.#announced) break;
        for (const [id, value] of Object.entries(message.values)) {
          this.#emit('params-change', { id, value, source: message.source });
        }
        break;
      case 'done':
        this.#requests.settle(message.request, undefined, message.value);
        break;
      case 'refused':
        this.#refused(message.errors, message.request);
        break;
      case 'stats':
        this.#stats = { ...message.stats, engine: link.place };
        this.#manners.measure(this.#params.display_mode, message.stats.scale);
        this.#signs.light(message.stats.scale ? 0 : message.stats.power, this.#params);
        this.#emit('stats', this.stats);
        break;
      case 'quality': {
        const { wish, quality, reason } = message;
        this.#quality = wish;
        if (this.#announced) this.#emit('quality-change', { quality, reason });
        break;
      }
      case 'state':
        this.#emit(message.playing ? 'play' : 'pause');
        break;
      case 'warming':
        this.#view.fade();
        break;
      case 'restored':
        this.#drawable = true;
        this.#signal();
        this.#emit('restored');
        break;
      case 'error':
        // Its last picture stays where it goes on.
        if (message.kind === 'context-lost') {
          this.#drawable = false;
          this.#signal();
          this.#emit('error', { kind: message.kind, message: message.message });
        } else if (message.burns) this.#complain(message.kind, message.message);
        else this.#fail(message.kind, message.message);
        break;
    }
  }

  /** The attribute names the preset that a fire with other settings has. */
  #reflectPreset() {
    if (super.preset === this.#preset) return;
    this.#dropping = true;
    if (this.#preset === 'default') this.removeAttribute('preset');
    else this.setAttribute('preset', this.#preset);
    this.#dropping = false;
  }

  /** @type {(id: string, value: string, allowed: string) => Error} */
  #refuse(id, value, allowed) {
    return this.#refused([{ id, value, message: `${id} = ${value} is refused: it must be ${allowed}` }]);
  }

  /** Something is wrong, and the fire burns on. @type {(kind: string, message: string) => void} */
  #complain(kind, message) {
    console.warn(`<hearth-fire>: ${message}`);
    this.#emit('error', { kind, message });
  }

  /** @type {(errors: Refusal[], request?: number) => Error} */
  #refused(errors, request) {
    for (const { message, ...rest } of errors) {
      console.warn(`<hearth-fire>: ${message}`);
      this.#emit('error', { kind: 'bad-parameter', message, ...rest });
    }
    const error = refusal(errors);
    if (request !== undefined) this.#requests.settle(request, error);
    return error;
  }

  /**
   * There is no fire and why not: the poster stays, with words.
   * @param {'unsupported' | 'load'} kind
   * @param {string} message
   */
  #fail(kind, message) {
    this.#view.show('failed', message);
    this.#view.offer('');
    this.#signal();
    this.#manners.end();
    const error = new EngineError(kind, message);
    this.#link?.abandon(error);
    // A promise that was kept cannot be broken; what comes now is refused.
    if (this.#announced) this.#ready = deferred();
    this.#ready.reject(error);
    this.#complain(kind, message);
  }

  /** @type {(type: string, detail?: object | null) => void} */
  #emit(type, detail = null) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}

for (const [property, id] of ID_OF_PROPERTY) {
  Object.defineProperty(HearthFire.prototype, property, {
    configurable: true,
    enumerable: true,
    get() {
      return this.get(id);
    },
    set(value) {
      // Frameworks put undefined or null where there is no value any more.
      if (value === undefined || value === null) this.restore(id);
      else this.set(id, value);
    },
  });
}

if (globalThis.customElements && !customElements.get('hearth-fire')) {
  customElements.define('hearth-fire', HearthFire);
}
