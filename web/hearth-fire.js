/**
 * `<hearth-fire>`: a fire as an HTML element.
 *
 * The class is the element's public interface, and its JSDoc states it: types, manifest and React's
 * types are derived from here. The work is done in `element/`: attributes, properties and calls
 * become messages to the engine, and the engine's messages become promises and events. The element
 * checks no value; the engine's table of parameters does. Reading a value gives the last one that
 * the engine accepted.
 *
 * The module can be imported where there is no `window`; it then defines nothing.
 *
 * @typedef {import('./parameters.js').HearthParameters} HearthParameters
 * @typedef {import('./parameters.js').ParameterId} ParameterId
 * @typedef {import('./parameters.js').HearthObject} HearthObject
 * @typedef {import('./parameters.js').PresetName} PresetName
 * @typedef {import('./element/types.js').HearthConfig} HearthConfig
 * @typedef {import('./element/types.js').HearthPoint} HearthPoint
 * @typedef {import('./element/types.js').HearthQuality} HearthQuality
 * @typedef {import('./parameters.js').HearthStats} HearthStats
 * @typedef {import('./element/types.js').HearthTransition} HearthTransition
 */

import { FireAttributes, ID_OF_PROPERTY, keepEarlyProperties, setOrRemove } from './element/attributes.js';
import { postable, quiet } from './element/requests.js';
import { FireSession } from './element/session.js';
import { settings } from './element/settings.js';
import { seedOf } from './element/values.js';

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

  #session = new FireSession(this, () => [HearthFire.wasmUrl, HearthFire.engine]);

  /**
   * The named set of values that the fire starts from. Changed later, it replaces every value.
   * @attribute
   * @default default
   * @returns {PresetName}
   */
  get preset() {
    const { started, preset } = this.#session.state;
    return started ? preset : super.preset;
  }

  set preset(name) {
    super.preset = name;
  }

  /**
   * Every value that the fire burns with, by id.
   * @returns {HearthParameters}
   */
  get params() {
    return { ...this.#session.state.params };
  }

  /**
   * The objects of the fire: copies, each with its kind, its id and its properties. Setting them
   * replaces all. The attribute has them as JSON; without it the fire has one source, which the
   * parameters describe.
   * @attribute
   * @returns {Required<HearthObject>[]}
   */
  get objects() {
    return this.#session.state.objects.map((object) => ({ ...object }));
  }

  /** @param {HearthObject[]} objects */
  set objects(objects) {
    // Frameworks put undefined or null where there is no value any more.
    if (objects === undefined || objects === null) this.restore('objects');
    else this.#session.set({ objects }, 'property');
  }

  /**
   * What the fire last said about itself; null before it did.
   * @returns {HearthStats | null}
   */
  get stats() {
    const { stats } = this.#session.state;
    return stats && { ...stats };
  }

  /**
   * How much work the fire may make itself; `auto`: as much as fits.
   * @attribute
   * @default auto
   * @returns {'auto' | HearthQuality}
   */
  get quality() {
    return this.#session.state.quality;
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
    return this.#session.ready;
  }

  /**
   * Whether the fire stands still.
   * @attribute
   * @default false
   * @returns {boolean}
   */
  get paused() {
    return this.#session.playback.paused;
  }

  set paused(paused) {
    this.#session.playback.set(Boolean(paused));
  }

  /**
   * The value of one parameter.
   * @template {ParameterId} Id
   * @param {Id} id
   * @returns {HearthParameters[Id]}
   */
  get(id) {
    const { params } = this.#session.state;
    return /** @type {any} */ (Object.hasOwn(params, id) ? params[id] : undefined);
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
    return this.#session.set(typeof ids === 'object' && ids ? ids : { [String(ids)]: value }, 'property');
  }

  /**
   * Adds an object and resolves to its id. Rejects with a {@link HearthRangeError}.
   * @param {HearthObject} object
   * @returns {Promise<number>}
   */
  addObject(object) {
    return this.#session.ask('addObject', postable(object, 1), 'property');
  }

  /**
   * Sets properties of an object: all of them or none. Rejects with a {@link HearthRangeError}.
   * @param {number} id
   * @param {Partial<HearthObject>} properties
   * @returns {Promise<void>}
   */
  changeObject(id, properties) {
    return this.#session.ask('changeObject', postable(id), postable(properties, 1), 'property');
  }

  /**
   * Removes an object. The next source becomes the first, which the parameters describe. Rejects
   * with a {@link HearthRangeError}.
   * @param {number} id
   * @returns {Promise<void>}
   */
  removeObject(id) {
    return this.#session.ask('removeObject', postable(id), 'property');
  }

  /**
   * Moves parameters to values, all of them or none; whether they arrived: false where something
   * else set one meanwhile. Rejects as `set` does.
   * @param {Partial<HearthParameters>} values
   * @param {HearthTransition} [how]
   * @returns {Promise<boolean>}
   */
  to(values, how) {
    return this.#session.move(values, how);
  }

  /**
   * Puts these parameters, or all, back to their defaults; all: the model as well, and without a
   * preset.
   * @param {...(ParameterId | 'objects')} ids
   * @returns {Promise<void>}
   */
  restore(...ids) {
    if (ids.length > 0) return this.#session.ask('restore', postable(ids, 1), 'property');
    this.#session.dropPreset();
    return this.#session.ask('preset', 'default', 'property');
  }

  /**
   * Lets the fire burn.
   * @returns {Promise<void>}
   */
  play() {
    return this.#session.playback.set(false);
  }

  /**
   * Lets the fire stand still.
   * @returns {Promise<void>}
   */
  pause() {
    return this.#session.playback.set(true);
  }

  /**
   * Starts again from nothing, with the same values.
   * @returns {Promise<void>}
   */
  reset() {
    return this.#session.ask('reset');
  }

  /**
   * Makes some steps, burning or not, then draws.
   * @param {number} [steps]
   * @returns {Promise<void>}
   */
  step(steps = 1) {
    return this.#session.ask('step', postable(steps));
  }

  /**
   * Its settings: the preset, where that is not the default one, and what differs
   * from it. JSON of them can be kept, sent, and given to `importConfig` or `src`.
   * @returns {Promise<HearthConfig>}
   */
  exportConfig() {
    return this.#session.ask('export');
  }

  /**
   * Burns with these settings, or with those of this JSON: all of them or none. Rejects with a
   * {@link HearthRangeError}.
   * @param {HearthConfig | string} config
   * @returns {Promise<void>}
   */
  importConfig(config) {
    try {
      return this.#session.ask('import', settings(config), 'property');
    } catch (error) {
      const { message } = /** @type {Error} */ (error);
      return quiet(Promise.reject(this.#session.reports.refused([{ id: 'config', value: config, message }])));
    }
  }

  /**
   * What is seen of the fire now, as a file of that type: PNG, `image/jpeg` or `image/webp`.
   * @param {string} [type]
   * @param {number} [quality] of JPEG and WebP, from 0 to 1
   * @returns {Promise<Blob>}
   */
  toBlob(type = 'image/png', quality) {
    return this.#session.ofPicture((canvas) => new Promise((resolve, reject) => {
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
    return this.#session.ofPicture((canvas) => {
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
    await this.#session.close();
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
    return this.#session.ask('stir', ...postable([x, y, u, v], 1));
  }

  /**
   * Throws sparks from a place; the classic model has none.
   * @param {number} x metres from the middle
   * @param {number} y metres above the floor
   * @param {number} [count] from 1 to 200
   * @returns {Promise<void>}
   */
  sparks(x, y, count = 24) {
    return this.#session.ask('sparks', ...postable([x, y, count], 1));
  }

  /**
   * The place of the fire's world that a point of the element shows: in metres, from the middle of
   * the floor, y up. Null while there is no picture.
   * @param {number} x CSS pixels from the element's left edge
   * @param {number} y CSS pixels from its upper edge
   * @returns {HearthPoint | null}
   */
  toMetres(x, y) {
    return this.#session.view.place(this.params)?.toMetres(x, y) ?? null;
  }

  /**
   * Where a place of the fire's world is shown, in CSS pixels from the element's upper left corner:
   * the inverse of `toMetres`.
   * @param {number} x metres from the middle
   * @param {number} y metres above the floor
   * @returns {HearthPoint | null}
   */
  toPixels(x, y) {
    return this.#session.view.place(this.params)?.toPixels(x, y) ?? null;
  }

  connectedCallback() {
    keepEarlyProperties(this);
    if (this.getAttribute('seed') === 'auto') seedOf(this);
    this.#session.attach();
  }

  /** It was taken to another document, as a window beside the page. */
  adoptedCallback() {
    this.#session.view.dress();
  }

  disconnectedCallback() {
    // An element that is only moved is back before the microtask.
    queueMicrotask(() => this.isConnected || this.#session.close());
  }

  /** A move by `moveBefore` needs nothing. */
  connectedMoveCallback() {}

  /** @type {(name: string, old: string | null, value: string | null) => void} */
  attributeChangedCallback(name, _old, value) {
    this.#session.attribute(name, value);
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
