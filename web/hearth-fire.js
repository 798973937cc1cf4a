/**
 * `<hearth-fire>`: a fire as an HTML element.
 *
 * The element is a thin shell. It turns attributes, properties and calls into
 * messages to the engine and the engine's messages into promises and events. It
 * checks no value: the engine's table of parameters does. Reading a value gives
 * the last one that the engine accepted.
 *
 * The module can be imported where there is no `window`; it then defines nothing.
 *
 * @typedef {import('./engine/engine.js').Message} Message
 * @typedef {import('./element/requests.js').Refusal} Refusal
 * @typedef {import('./parameters.js').HearthParameters} HearthParameters
 * @typedef {import('./parameters.js').ParameterId} ParameterId
 * @typedef {import('./parameters.js').HearthObject} HearthObject
 * @typedef {import('./element/types.js').HearthStats} HearthStats
 * @typedef {import('./element/types.js').HearthConfig} HearthConfig
 * @typedef {import('./element/types.js').HearthPoint} HearthPoint
 * @typedef {import('./element/types.js').HearthQuality} HearthQuality
 * @typedef {import('./element/types.js').HearthTransition} HearthTransition
 * @typedef {import('./parameters.js').PresetName} PresetName
 */

import { DEFAULTS } from './generated/defaults.js';
import { EngineError } from './engine/engine.js';
import { burning } from './engine/files.js';
import {
  FireAttributes, ID_OF_ATTRIBUTE, ID_OF_PROPERTY, keepEarlyProperties, setOrRemove, warmth,
} from './element/attributes.js';
import { FireLink } from './element/engine-connection.js';
import { FireManners } from './element/page-policies.js';
import { settings, settingsOfFile } from './element/settings.js';
import { FireSigns } from './element/states.js';
import { hexOf, seedOf } from './element/values.js';
import { FireView } from './element/view.js';
import { Requests, deferred, postable, quiet, refusal } from './element/requests.js';
import { motionIsReduced } from './element/visibility.js';

/** Deepest nesting of values: `{objects: [{property: value}]}`. */
const DEEPEST = 3;

/** Seconds of fire that a still picture has burnt, so that it shows a fire. */
const STILL_AFTER = 2;

/**
 * A fire, simulated by smoothed particle hydrodynamics.
 *
 * @fires {null} ready  The fire burns.
 * @fires {null} play  It burns again.
 * @fires {null} pause  It stands still.
 * @fires {HearthChangeDetail} params-change  A value changed, whoever changed it.
 * @fires {HearthObjectsDetail} objects-change  An object was added, changed or removed.
 * @fires {HearthQualityDetail} quality-change  The fire makes itself more or less work than before.
 * @fires {HearthStats} stats  What the fire says about itself, about four times a second.
 * @fires {HearthErrorDetail} error  Something is wrong: a value that was refused, a file that did not arrive, a browser that cannot.
 * @fires {null} restored  The graphics context was lost and is back.
 * @slot poster  What is shown until the fire burns, and where it cannot; the attribute's picture if this is empty.
 * @csspart canvas  The canvas.
 * @csspart message  The words for a browser that cannot show the fire.
 * @csspart play  The button that plays a fire that stands still for the visitor's sake, and pauses it again.
 * @csspart panel  The panel of sliders, where there is one.
 * @csspart scale  The bar that says which colour is how much, where the picture shows a quantity.
 * @cssproperty --hearth-light  Its power now against its mean, from 0 to 1; 0.5 is the mean.
 * @cssproperty --hearth-glow  The colour of its light.
 * @cssstate burning  Its picture is shown and it plays.
 */
export class HearthFire extends FireAttributes {
  /**
   * Where the wasm file is, if it is not at `wasm/hearth-engine_bg.wasm` beside
   * this module. Set it before the first fire.
   * @type {string | URL | undefined}
   */
  static wasmUrl;

  /**
   * Where the engine runs; `auto`: in a worker where that can draw, else on the main thread.
   * Set it before the first fire.
   * @type {'auto' | 'worker' | 'main'}
   */
  static engine = 'auto';

  #requests = new Requests();
  /** @type {FireView} */
  #view;
  /** @type {HearthParameters} */
  #params = /** @type {HearthParameters} */ ({ ...DEFAULTS });
  /** @type {Required<HearthObject>[]} */
  #objects = [];
  /** The values as they were before the model changed, for the way back. */
  #kept = {};
  /** @type {HearthStats | null} */
  #stats = null;
  /** @type {'auto' | HearthQuality} */
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
  /** @type {PresetName} */
  #preset = 'default';
  /** @type {FireLink | null} */
  #link = null;
  /** @type {import('./element/page-policies.js').Ways} */
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
      ask: (message) => this.#ask(message),
      send: (message) => this.#link?.send(message),
      refuse: (id, value, allowed) => this.#refuse(id, value, allowed),
      complain: (kind, message) => this.#complain(kind, message),
      hexOf,
      isCalm: () => this.#isCalm(motionIsReduced()),
    };
    this.#manners = new FireManners(this.#ways, this.#view);
  }

  /**
   * The named set of values that the fire starts from. Changed later, it replaces every value.
   * @attribute
   * @default default
   * @returns {PresetName}
   */
  get preset() {
    return this.#started ? this.#preset : super.preset;
  }

  set preset(name) {
    super.preset = name;
  }

  /**
   * Every value that the fire burns with, by id.
   * @returns {HearthParameters}
   */
  get params() {
    return { ...this.#params };
  }

  /**
   * The objects of the fire: copies, each with its kind, its id and its properties. Setting them
   * replaces all. The attribute has them as JSON; without it the fire has one source, which the
   * parameters describe.
   * @attribute
   * @returns {Required<HearthObject>[]}
   */
  get objects() {
    return this.#objects.map((object) => ({ ...object }));
  }

  /** @param {HearthObject[]} objects */
  set objects(objects) {
    // Frameworks put undefined or null where there is no value any more.
    if (objects === undefined || objects === null) this.restore('objects');
    else this.#set({ objects }, 'property');
  }

  /**
   * What the fire last said about itself; null before it did.
   * @returns {HearthStats | null}
   */
  get stats() {
    return this.#stats && { ...this.#stats };
  }

  /**
   * How much work the fire may make itself; `auto`: as much as fits.
   * @attribute
   * @default auto
   * @returns {'auto' | HearthQuality}
   */
  get quality() {
    return this.#quality;
  }

  set quality(quality) {
    setOrRemove(this, 'quality', quality);
  }

  /**
   * Resolves when the fire burns; rejects where it cannot. An element that was taken off the page
   * has a new one.
   * @returns {Promise<void>}
   */
  get ready() {
    return this.#ready.promise;
  }

  /**
   * Whether the fire stands still.
   * @attribute
   * @default false
   * @returns {boolean}
   */
  get paused() {
    return this.#paused;
  }

  set paused(paused) {
    this.#setPaused(Boolean(paused));
  }

  /**
   * The value of one parameter.
   * @template {ParameterId} Id
   * @param {Id} id
   * @returns {HearthParameters[Id]}
   */
  get(id) {
    return /** @type {any} */ (Object.hasOwn(this.#params, id) ? this.#params[id] : undefined);
  }

  /**
   * Sets one parameter; rejects with a {@link HearthRangeError}.
   * @template {ParameterId} Id
   * @overload
   * @param {Id} id
   * @param {HearthParameters[Id]} value
   * @returns {Promise<void>}
   */
  /**
   * Sets all of these or none; rejects with a {@link HearthRangeError}.
   * @overload
   * @param {Partial<HearthParameters> & {objects?: HearthObject[]}} values
   * @returns {Promise<void>}
   */
  /**
   * Sets one parameter, or several: all of them or none. Rejects with a RangeError that names what is allowed.
   * @param {ParameterId | Partial<HearthParameters> & {objects?: HearthObject[]}} ids
   * @param {number | string | boolean} [value]
   * @returns {Promise<void>}
   */
  set(ids, value) {
    return this.#set(typeof ids === 'object' && ids ? ids : { [String(ids)]: value }, 'property');
  }

  /**
   * Adds an object and resolves to its id. Rejects with a {@link HearthRangeError}.
   * @param {HearthObject} object
   * @returns {Promise<number>}
   */
  addObject(object) {
    return this.#ask({ type: 'addObject', source: 'property', object: postable(object, 1) });
  }

  /**
   * Sets properties of an object: all of them or none. Rejects with a {@link HearthRangeError}.
   * @param {number} id
   * @param {Partial<HearthObject>} properties
   * @returns {Promise<void>}
   */
  changeObject(id, properties) {
    return this.#ask({ type: 'changeObject', source: 'property', id: postable(id), values: postable(properties, 1) });
  }

  /**
   * Removes an object. The next source becomes the first, which the parameters describe. Rejects
   * with a {@link HearthRangeError}.
   * @param {number} id
   * @returns {Promise<void>}
   */
  removeObject(id) {
    return this.#ask({ type: 'removeObject', source: 'property', id: postable(id) });
  }

  /**
   * Moves parameters to values, all of them or none; whether they arrived: false where something
   * else set one meanwhile. Rejects as `set` does.
   * @param {Partial<HearthParameters>} values
   * @param {HearthTransition} [how]
   * @returns {Promise<boolean>}
   */
  to(values, how) {
    this.#orders ??= [];
    const checked = this.#ask({ type: 'check', source: 'to', values: postable(values, 1) });
    const code = import('./element/transition.js').catch((why) => {
      this.#orders = undefined;
      this.#complain('load', `Transitions could not be loaded: ${why}`);
      throw why;
    });
    return quiet(code.then(({ run }) => run(this.#orders, this.#ways, checked, { ...how })));
  }

  /**
   * Puts these parameters, or all, back to their defaults; all: the model as well, and without a
   * preset.
   * @param {...(ParameterId | 'objects')} ids
   * @returns {Promise<void>}
   */
  restore(...ids) {
    if (ids.length > 0) return this.#ask({ type: 'restore', source: 'property', ids: postable(ids, 1) });
    this.#dropPreset();
    return this.#ask({ type: 'preset', source: 'property', name: 'default' });
  }

  /**
   * Lets the fire burn.
   * @returns {Promise<void>}
   */
  play() {
    return this.#setPaused(false);
  }

  /**
   * Lets the fire stand still.
   * @returns {Promise<void>}
   */
  pause() {
    return this.#setPaused(true);
  }

  /**
   * Starts again from nothing, with the same values.
   * @returns {Promise<void>}
   */
  reset() {
    return this.#ask({ type: 'reset' });
  }

  /**
   * Makes some steps, burning or not, then draws.
   * @param {number} [steps]
   * @returns {Promise<void>}
   */
  step(steps = 1) {
    return this.#ask({ type: 'step', steps: postable(steps) });
  }

  /**
   * Its settings: the preset, where that is not the default one, and what differs
   * from it. JSON of them can be kept, sent, and given to `importConfig` or `src`.
   * @returns {Promise<HearthConfig>}
   */
  exportConfig() {
    return this.#ask({ type: 'export' });
  }

  /**
   * Burns with these settings, or with those of this JSON: all of them or none. Rejects with a
   * {@link HearthRangeError}.
   * @param {HearthConfig | string} config
   * @returns {Promise<void>}
   */
  importConfig(config) {
    try {
      return this.#ask({ type: 'import', source: 'property', config: settings(config) });
    } catch (error) {
      const { message } = /** @type {Error} */ (error);
      return quiet(Promise.reject(this.#refused([{ id: 'config', value: config, message }])));
    }
  }

  /**
   * What is seen of the fire now, as a file of that type: PNG, `image/jpeg` or `image/webp`.
   * @param {string} [type]
   * @param {number} [quality] of JPEG and WebP, from 0 to 1
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
   * @returns {Promise<void>}
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
    return this.#ask({ type: 'stir', ...postable({ x, y, u, v }, 1) });
  }

  /**
   * Throws sparks from a place; the classic model has none.
   * @param {number} x metres from the middle
   * @param {number} y metres above the floor
   * @param {number} [count] from 1 to 200
   * @returns {Promise<void>}
   */
  sparks(x, y, count = 24) {
    return this.#ask({ type: 'sparks', ...postable({ x, y, count }, 1) });
  }

  /**
   * The place of the fire's world that a point of the element shows: in metres, from the middle of
   * the floor, y up. Null while there is no picture.
   * @param {number} x CSS pixels from the element's left edge
   * @param {number} y CSS pixels from its upper edge
   * @returns {HearthPoint | null}
   */
  toMetres(x, y) {
    return this.#view.place(this.#params)?.toMetres(x, y) ?? null;
  }

  /**
   * Where a place of the fire's world is shown, in CSS pixels from the element's upper left corner:
   * the inverse of `toMetres`.
   * @param {number} x metres from the middle
   * @param {number} y metres above the floor
   * @returns {HearthPoint | null}
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
  attributeChangedCallback(name, _old, value) {
    const id = ID_OF_ATTRIBUTE.get(name);
    this.#manners.change(name, value);
    if (name === 'loading') this.#link?.lookAgain();
    // Before, the fire starts with what its attributes say, wherever they stand.
    const begun = this.#started || this.#link?.live;
    if (name === 'model' && !begun) {
      // The first fire starts with its model.
    } else if (id !== undefined) {
      if (value !== null) this.#set({ [id]: value }, 'attribute');
      else this.#ask({ type: 'restore', source: 'attribute', ids: [id] });
    } else if (name === 'objects') {
      this.#readObjects(value);
    } else if (name === 'preset') {
      if (begun && !this.#dropping) this.#ask({ type: 'preset', source: 'preset', name: value ?? 'default' });
    } else if (name === 'quality') {
      this.#ask({ type: 'quality', source: 'attribute', quality: value ?? 'auto' });
    } else if (name === 'paused') {
      if ((value !== null) !== this.#paused) this.#setPaused(value !== null);
    } else if (name === 'src') {
      if (begun) this.#changeFile();
    } else if (name === 'warm') {
      const seconds = warmth(this);
      if (Number.isNaN(seconds)) this.#refuse(name, value ?? '', 'a number of seconds from 0 to 30');
      else if (begun) this.#ask({ type: 'warm', seconds });
    } else if (name === 'autoplay') {
      if (this.#link && !this.#started && !this.autoplay) this.#setPaused(true);
    } else if (name === 'reduced-motion' && this.#link) {
      this.#motion(motionIsReduced());
    }
  }

  /** Sets the objects that the attribute holds as JSON. @param {string | null} value */
  #readObjects(value) {
    if (value === null) {
      this.#ask({ type: 'restore', source: 'attribute', ids: ['objects'] });
      return;
    }
    try {
      this.#set({ objects: JSON.parse(value) }, 'attribute');
    } catch (error) {
      this.#refuse('objects', value.slice(0, 40), `JSON of an array of objects: ${/** @type {Error} */ (error).message}`);
    }
  }

  /** The attribute goes; its values are somebody else's to change. */
  #dropPreset() {
    this.#dropping = true;
    this.removeAttribute('preset');
    this.#dropping = false;
  }

  /** @param {Message} message */
  #ask(message) {
    // Where there can be no fire, nothing waits for one.
    const answer = this.#ready.failed ? this.#ready.promise : this.#requests.ask(message);
    this.#orders?.push([message, answer]);
    return answer;
  }

  /** @type {(values: {[id: string]: unknown}, source: string) => Promise<void>} */
  #set(values, source) {
    return this.#ask({ type: 'set', source, values: postable(values, DEEPEST) });
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
    if (config !== undefined) this.#ask({ type: 'import', source: 'src', config });
    // Without a file it burns as it would have without one.
    else if (!src) this.#ask({ type: 'preset', source: 'src', name: this.preset });
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
    return this.#ask({ type: paused ? 'pause' : 'play' });
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
      () => this.loading,
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
      return { preset, kept, values: { ...values, objects: this.#objects }, ownNumber, quality, paused };
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
      await this.#ask({ type: 'warm' }).catch(() => {});
    } else if (still) {
      await this.#ask({ type: 'burn', seconds: STILL_AFTER }).catch(() => {});
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
        this.#objects = message.objects;
        this.#ownNumber = message.ownNumber;
        this.#preset = message.preset;
        break;
      case 'changed':
        if (message.anew) this.#kept = {};
        else if ('model' in message.values) this.#kept = this.#params;
        this.#params = { ...this.#params, ...message.values };
        this.#objects = message.objects ?? this.#objects;
        this.#ownNumber = message.ownNumber;
        this.#preset = message.preset;
        if (message.anew) this.#reflectPreset();
        if (!this.#announced) break;
        for (const [id, value] of Object.entries(message.values)) {
          this.#emit('params-change', { id, value, source: message.source });
        }
        if (message.objects) this.#emit('objects-change', { objects: this.objects, source: message.source });
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
