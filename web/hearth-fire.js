/**
 * `<hearth-fire>`: a fire as an HTML element.
 *
 * This class is the element's public interface. The compiler declares its types for the package, without members that
 * are internal. `cargo xtask codegen` derives from its JSDoc React's types, the manifest, the reference of the methods,
 * and what an iframe offers to its page. `@posted` offers a member there; `@example` shows it in the reference. The
 * code is in `element/`: attributes, properties and calls are messages to the engine, and the engine's messages become
 * promises and events. The engine validates every value. Reading a value returns the last one that the engine
 * accepted.
 *
 * The module can be imported without a `window`; it then defines no element.
 *
 * @typedef {import('./parameters.js').HearthParameters} HearthParameters
 * @typedef {import('./parameters.js').ParameterId} ParameterId
 * @typedef {import('./parameters.js').HearthObject} HearthObject
 * @typedef {import('./parameters.js').PresetName} PresetName
 * @typedef {FireElement} HearthFire
 * @typedef {import('./element/types.js').HearthConfig} HearthConfig
 * @typedef {import('./element/types.js').HearthFilm} HearthFilm
 * @typedef {import('./element/types.js').HearthFreeSolid} HearthFreeSolid
 * @typedef {import('./element/types.js').HearthHistory} HearthHistory
 * @typedef {import('./element/types.js').HearthMeasures} HearthMeasures
 * @typedef {import('./element/types.js').HearthPicture} HearthPicture
 * @typedef {import('./element/types.js').HearthPoint} HearthPoint
 * @typedef {import('./element/types.js').HearthQuality} HearthQuality
 * @typedef {import('./parameters.js').HearthStats} HearthStats
 * @typedef {import('./element/types.js').HearthTransition} HearthTransition
 * @typedef {import('./parameters.js').HearthValues} HearthValues
 */

import {
  FireAttributes,
  ID_OF_PROPERTY,
  defineProperty,
  isOn,
  upgradeProperties,
} from './element/attributes/attributes.js';
import { reportedSettings } from './element/attributes/settings.js';
import { isMuted, mute } from './element/session/muted.js';
import { postable, setOrRemove, stated } from './element/plain-data.js';
import { quiet } from './element/promises.js';
import { FireSession } from './element/session/session.js';
import { connect } from './engine/engine.js';
import { seedOf } from './element/attributes/values.js';
import { VERSION } from './generated/version.js';

/**
 * A fire, simulated by smoothed particle hydrodynamics.
 *
 * @slot poster  Content that is shown until the fire burns, and in browsers that cannot show it. The attribute `poster`
 *   applies if the slot is empty.
 * @csspart canvas  The canvas.
 * @csspart message  The message that explains why there is no fire.
 * @csspart retry  The button in that message that tries again.
 * @csspart play  The button that plays a fire that is paused for reduced motion, and pauses it again.
 * @csspart speaker  The button that starts a sound that waits for a gesture.
 * @csspart panel  The panel of sliders of the attribute `controls`.
 * @csspart scale  The colour bar of a display mode that shows a quantity.
 * @cssproperty --hearth-light  The power relative to its mean, from 0 to 1; 0.5 is the mean.
 * @cssproperty --hearth-glow  The colour of the light.
 * @cssstate burning  The fire is visible and plays.
 */
class FireElement extends FireAttributes {
  /**
   * The version of this module.
   * @returns {string}
   */
  static get version() {
    return VERSION;
  }

  /**
   * The URL of the wasm file, if it is not `wasm/hearth-engine_bg.wasm` beside this module. Set it
   * before the first fire.
   * @type {string | URL | undefined}
   */
  static wasmUrl;

  /**
   * Where the engine runs; `auto`: in a worker if workers can draw, else on the main thread. Set it
   * before the first fire.
   * @type {'auto' | 'worker' | 'main'}
   */
  static engine = 'auto';

  /**
   * `HearthFire.preload()` loads the engine before the first fire, which then begins sooner: its wasm is fetched and compiled once for all fires.
   * @returns {Promise<void>}
   */
  static async preload() {
    // A server has no document.
    if (globalThis.document) await connect(FireElement.wasmUrl, FireElement.engine);
  }

  #session = new FireSession(this, () => [FireElement.wasmUrl, FireElement.engine]);

  /**
   * The named set of values that the fire starts from. A later change replaces every value.
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
   * The values of the parameters of its model, by id.
   * @posted
   * @returns {HearthParameters}
   */
  get params() {
    return this.#session.state.paramsOfModel;
  }

  /**
   * Copies of the objects of the fire, each with its kind, its id and its properties. Setting the list
   * replaces all objects. The attribute holds them as JSON; without it the fire has one source, which
   * the parameters describe.
   * @attribute
   * @posted
   * @returns {Required<HearthObject>[]}
   */
  get objects() {
    return this.#session.state.objects.map((object) => ({ ...object }));
  }

  /** @param {HearthObject[]} objects */
  set objects(objects) {
    this.#session.change(['set', { objects: stated(this, 'objects', objects) }]);
  }

  /**
   * The latest measurements of the fire; null before the first.
   * @posted
   * @returns {HearthStats | null}
   */
  get stats() {
    const { stats } = this.#session.state;
    return stats && { ...stats };
  }

  /**
   * The level of detail of simulation and picture; `auto` follows the speed of the device.
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
   * Resolves when the fire's picture is shown or, out of sight, when the fire can be drawn; rejects if it
   * cannot. An element that is removed from the page gets a new promise.
   * @posted
   * @returns {Promise<void>}
   */
  get ready() {
    return this.#session.ready;
  }

  /**
   * Whether the fire is paused.
   * @attribute
   * @default false
   * @returns {boolean}
   */
  get paused() {
    return this.#session.playback.paused;
  }

  set paused(paused) {
    const given = stated(this, 'paused', paused);
    if (given !== undefined) this.#session.playback.set(isOn(given));
  }

  /**
   * Whether the visitor has muted the fires of this origin. It is kept for the next visit.
   * @posted
   * @returns {boolean}
   */
  get muted() {
    return isMuted();
  }

  set muted(muted) {
    mute(Boolean(muted));
  }

  /**
   * The node through which the sound of this fire goes to the loudspeakers, for a mix of your own in its `context`;
   * null while there is no sound.
   * @returns {AudioNode | null}
   */
  get audio() {
    return this.#session.code.player?.audio ?? null;
  }

  /**
   * The steps that can be undone and redone.
   * @see History
   * @returns {HearthHistory}
   */
  get history() {
    return this.#session.history;
  }

  /**
   * Returns the value of one parameter.
   * @template {ParameterId} Id
   * @param {Id} id
   * @returns {HearthParameters[Id]}
   * @posted
   * @example <caption>Which model?</caption> this.textContent = fire.get('model')
   */
  get(id) {
    const { params } = this.#session.state;
    return /** @type {any} */ (typeof id === 'string' && Object.hasOwn(params, id) ? params[id] : undefined);
  }

  /**
   * Sets one parameter. Rejects with a {@link HearthRangeError}.
   * @template {ParameterId} Id
   * @overload
   * @param {Id} id
   * @param {HearthParameters[Id] | null} value
   * @returns {Promise<void>}
   */
  /**
   * Sets all of these parameters or none. Rejects with a {@link HearthRangeError}.
   * @overload
   * @param {HearthValues} values
   * @returns {Promise<void>}
   */
  /**
   * Sets one parameter, or several: all of them or none. `null` restores the default. Among several, `undefined`
   * states nothing. Rejects with a RangeError that names the allowed values.
   * @param {ParameterId | HearthValues} ids
   * @param {number | string | boolean | null} [value]
   * @returns {Promise<void>}
   * @posted
   * @example <caption>Strong and windy</caption> fire.set({ fuel_power: 350, wind: 0.5 })
   */
  set(ids, value) {
    // A missing value is refused by the words for it.
    const values = typeof ids === 'object' && ids ? ids : { [String(ids)]: value === undefined ? 'undefined' : value };
    return this.#session.change(['set', values]);
  }

  /**
   * Adds an object and resolves to its id. Rejects with a {@link HearthRangeError}.
   * @see Objects
   * @param {HearthObject} object
   * @returns {Promise<number>}
   * @posted
   */
  addObject(object) {
    return this.#session.change(['addObject', object]);
  }

  /**
   * Sets properties of an object: all of them or none. Rejects with a {@link HearthRangeError}.
   * @param {number} id
   * @param {Partial<HearthObject>} properties
   * @returns {Promise<void>}
   * @posted
   * @example <caption>Move the source</caption> fire.changeObject(fire.objects[0].id, { x: 0.2 })
   */
  changeObject(id, properties) {
    return this.#session.change(['changeObject', id, properties]);
  }

  /**
   * Removes an object. The next source becomes the first, which the parameters describe. Rejects
   * with a {@link HearthRangeError}.
   * @param {number} id
   * @returns {Promise<void>}
   * @posted
   */
  removeObject(id) {
    return this.#session.change(['removeObject', id]);
  }

  /**
   * Changes parameters gradually, all of them or none. Resolves to false if another call sets one of
   * them meanwhile. Rejects as `set` does.
   * @see Transitions
   * @param {Partial<HearthParameters>} values
   * @param {HearthTransition} [how]
   * @returns {Promise<boolean>}
   * @posted
   * @example <caption>Flare up</caption> fire.to({ source_width: 0.5 }, { duration: 1500 })
   */
  to(values, how) {
    return this.#session.code.move(values, how);
  }

  /**
   * Restores the defaults of these parameters. Without ids it restores all parameters, the model
   * included, and removes the preset.
   * @param {...(ParameterId | 'objects')} ids
   * @returns {Promise<void>}
   * @posted
   * @example <caption>All defaults</caption> fire.restore()
   */
  restore(...ids) {
    if (ids.length > 0)
      return this.set(Object.fromEntries(ids.map((id) => [typeof id === 'string' ? id : typeof id, null])));
    this.#session.reflectPreset();
    // The page states that seed.
    const values = this.getAttribute('seed') === 'auto' ? { seed: 'auto' } : {};
    return this.#session.change(['import', { values }], this.#session.history.sourceOfScene('property'));
  }

  /**
   * Plays the fire.
   * @returns {Promise<void>}
   * @posted
   * @example <caption>Play or pause</caption> fire.paused ? fire.play() : fire.pause()
   */
  play() {
    return this.#session.playback.set(false);
  }

  /**
   * Pauses the fire.
   * @returns {Promise<void>}
   * @posted
   */
  pause() {
    return this.#session.playback.set(true);
  }

  /**
   * Restarts the simulation with the same values.
   * @returns {Promise<void>}
   * @posted
   * @example <caption>Restart</caption> fire.reset()
   */
  reset() {
    return this.#session.call('reset');
  }

  /**
   * Computes simulation steps, also while paused, then draws a frame. `stats` has the length of a step.
   * @param {number} [steps]
   * @returns {Promise<void>}
   * @posted
   * @example <caption>Ten steps</caption> fire.step(10)
   */
  step(steps = 1) {
    return this.#session.call('step', postable(steps));
  }

  /**
   * Computes this time of fire, at most 1000 seconds, also while paused, then draws a frame. The last two steps are
   * shorter where that is needed: a paused fire is then older by exactly that time. One that plays burns on
   * from there by its clock. A fire that loads or warms up does so first.
   * @param {number} seconds
   * @returns {Promise<void>}
   * @posted
   * @example <caption>The next frame of a film</caption> fire.advance(1 / 30)
   */
  advance(seconds) {
    return this.#session.call('advance', postable(seconds));
  }

  /**
   * Resolves to the settings of the fire: the preset, unless it is the default one, and the values that differ from
   * it. As JSON they can be stored, sent, and loaded by `importConfig` or `src`.
   * @see Settings
   * @returns {Promise<HearthConfig>}
   * @posted
   */
  exportConfig() {
    return this.#session.call('export');
  }

  /**
   * Applies settings, as an object or as JSON: all of them or none. Rejects with a
   * {@link HearthRangeError}.
   * @param {HearthConfig | string} config
   * @returns {Promise<void>}
   * @posted
   */
  importConfig(config) {
    try {
      const settings = reportedSettings(config, 'config', this.#session.reports);
      return this.#session.change(['import', settings], this.#session.history.sourceOfScene('property'));
    } catch (error) {
      return quiet(Promise.reject(error));
    }
  }

  /**
   * Resolves to the current frame as a file of type `image/png`, which keeps transparency, `image/jpeg` or
   * `image/webp`. Waits for the first frame. An object `{type, quality, width, background}` draws the frame for the
   * file: `width` from 16 to 8192 pixels, with the element's shape and at most 16,777,216 pixels in all; `background`
   * is a CSS colour, `transparent` (fire and solids alone) or `scene` (as the element shows it). A refused width
   * rejects with a `RangeError`.
   * @param {string | HearthPicture} [type]
   * @param {number} [quality] of JPEG and WebP, from 0 to 1
   * @returns {Promise<Blob>}
   * @posted
   */
  toBlob(type = 'image/png', quality) {
    return this.#session.code.capture('toBlob', type, quality);
  }

  /**
   * Resolves to the fire as a video stream for a recorder, a call or a `<video>`, with its sound if that is on.
   * @param {number} [fps] maximum frames per second; all frames without it
   * @returns {Promise<MediaStream>}
   */
  captureStream(fps) {
    return this.#session.code.capture('captureStream', fps);
  }

  /**
   * Records a film, a loop or the sound by the clock of the simulation, however long that takes, and resolves to its file.
   * The fire waits meanwhile and then goes on where it was. One film of a fire is recorded at a time.
   * @see Films
   * @param {HearthFilm} [options]
   * @returns {Promise<Blob | undefined>} the file, unless it is written into a `stream`
   * @example <caption>Save a film</caption> fire.record({ seconds: 2, width: 256, height: 256 }).then((file) => { this.textContent = `${file.size} bytes` }, ({ message }) => { this.textContent = message })
   */
  record(options) {
    return this.#session.code.capture('record', options);
  }

  /**
   * Accelerates the gas around a point for a twentieth of a second.
   * @param {number} x metres from the middle of the floor
   * @param {number} y metres above the floor
   * @param {number} u velocity to the right in metres per second, at most 20
   * @param {number} v velocity upwards in metres per second, at most 20
   * @returns {Promise<void>}
   * @posted
   * @example <caption>Blow</caption> fire.stir(0, 0.5, 6, 0)
   */
  stir(x, y, u, v) {
    return this.#session.call('stir', ...postable([x, y, u, v], 1));
  }

  /**
   * Emits sparks from a point. The classic model has none.
   * @param {number} x metres from the middle of the floor
   * @param {number} y metres above the floor
   * @param {number} [count] from 1 to 200
   * @returns {Promise<void>}
   * @posted
   * @example <caption>Sparks</caption> fire.sparks(0, 0.5, 60)
   */
  sparks(x, y, count = 24) {
    return this.#session.call('sparks', ...postable([x, y, count], 1));
  }

  /**
   * Sprays water from a point within a twentieth of a second. It cools the gas, wets what it strikes and
   * puts out what it cools and wets enough; the rest dries and burns on. The classic model has none.
   * @param {number} x metres from the middle of the floor
   * @param {number} y metres above the floor
   * @param {number} [u] velocity to the right in metres per second, at most 20
   * @param {number} [v] velocity upwards in metres per second, at most 20
   * @param {number} [grams] for each metre of depth, at most 1000
   * @returns {Promise<void>}
   * @posted
   * @example <caption>Spray</caption> fire.spray(0, 1, 0, -4, 20)
   */
  spray(x, y, u = 0, v = -4, grams = 5) {
    return this.#session.call('spray', ...postable([x, y, u, v, grams], 1));
  }

  /**
   * Resolves to where the solids are that forces move, those with `motion` "free", in the order of the
   * objects, then what has broken off them. `objects` has where they start.
   * @returns {Promise<HearthFreeSolid[]>}
   * @posted
   * @example <caption>Drop a plank</caption> fire.addObject({ kind: 'solid', y: 1, angle: 20, motion: 'free', material: 'wood' })
   * @example <caption>How high are the planks?</caption> fire.freeSolids().then((all) => { this.textContent = all.map(({ y }) => `${y.toFixed(2)} m`).join(', ') })
   */
  async freeSolids() {
    const [numbers, { freeSolidsOf }] = await Promise.all([
      this.#session.call('freeSolids'),
      import('./free-solids.js'),
    ]);
    return freeSolidsOf(numbers);
  }

  /**
   * Resolves to what a probe at a point measures, the same along the vertical through it, and the flame
   * as a whole.
   * @see Measures
   * @param {number} x metres from the middle of the floor
   * @param {number} y metres above the floor
   * @returns {Promise<HearthMeasures>}
   * @posted
   * @example <caption>How hot is it?</caption> fire.measure(0, 0.5).then(({ place }) => { this.textContent = place.gas ? `${place.temperature.toFixed(0)} K` : 'no gas' })
   */
  async measure(x, y) {
    const [numbers, { measuresOf }] = await Promise.all([
      this.#session.call('measure', ...postable([x, y], 1)),
      import('./measures.js'),
    ]);
    return measuresOf(numbers, y);
  }

  /**
   * Lights a solid that has fuel: all of its surface, by its id, or what is within a radius of a point.
   * Dries the sources there and at a solid there too, so that those that water has put out burn again. Rejects if there is neither.
   * @param {number} place the id, or metres from the middle of the floor
   * @param {number} [y] metres above the floor
   * @param {number} [radius] in metres, 0.1 without it
   * @returns {Promise<void>}
   * @posted
   * @example <caption>A log that burns</caption> fire.addObject({ kind: 'solid', x: 0.3, fuel: 'wood', material: 'wood' }).then((id) => fire.ignite(id))
   */
  ignite(place, y, radius = 0.1) {
    return this.#session.call('light', true, ...postable([y === undefined ? -1 : radius, place, y ?? 0], 1));
  }

  /**
   * Puts out a solid that has fuel, by its id, or all that is within a radius of a point: cools it and the
   * gas there.
   * @param {number} place the id, or metres from the middle of the floor
   * @param {number} [y] metres above the floor
   * @param {number} [radius] in metres, 0.2 without it
   * @returns {Promise<void>}
   * @posted
   * @example <caption>Extinguish the log</caption> fire.extinguish(0.3, 0.5, 0.4)
   */
  extinguish(place, y, radius = 0.2) {
    return this.#session.call('light', false, ...postable([y === undefined ? -1 : radius, place, y ?? 0], 1));
  }

  /**
   * Converts a point of the element to the domain: metres from the middle of the floor, y upwards. Returns
   * null while there is no picture.
   * @see Places
   * @param {number} x CSS pixels from the element's left edge
   * @param {number} y CSS pixels from its upper edge
   * @returns {HearthPoint | null}
   */
  toMetres(x, y) {
    return this.#session.view.viewport(this.params)?.toMetres(...numbers({ x, y })) ?? null;
  }

  /**
   * Converts a point of the domain to CSS pixels from the element's upper left corner: the inverse of
   * `toMetres`.
   * @param {number} x metres from the middle of the floor
   * @param {number} y metres above the floor
   * @returns {HearthPoint | null}
   */
  toPixels(x, y) {
    return this.#session.view.viewport(this.params)?.toPixels(...numbers({ x, y })) ?? null;
  }

  /**
   * Stops the fire and frees its memory. The element makes a new fire when it is inserted into a page
   * again; calls wait for that.
   * @returns {Promise<void>}
   * @example <caption>Put it out</caption> fire.destroy()
   */
  async destroy() {
    await this.#session.close();
  }

  /** @internal */
  connectedCallback() {
    upgradeProperties(this);
    if (this.getAttribute('seed') === 'auto') seedOf(this);
    this.#session.attach();
  }

  /** The element has moved to another document, for instance another window. @internal */
  adoptedCallback() {
    this.#session.replaceCanvas();
  }

  /** @internal */
  disconnectedCallback() {
    this.#session.detach();
  }

  /** Without this callback, `moveBefore` would disconnect the element. @internal */
  connectedMoveCallback() {}

  /** @internal @type {(name: string, old: string | null, value: string | null) => void} */
  attributeChangedCallback(name, _old, value) {
    this.#session.attribute(name, value);
  }
}

for (const [property, id] of ID_OF_PROPERTY) {
  defineProperty(
    FireElement,
    property,
    (fire) => fire.get(/** @type {ParameterId} */ (id)),
    (/** @type {any} */ fire, value) => fire.set({ [id]: stated(fire, property, value) }),
  );
}

/** The coordinates of a point, if they are numbers. @param {{x: number, y: number}} point @returns {[number, number]} */
function numbers({ x, y }) {
  if (!Number.isFinite(x) || !Number.isFinite(y)) throw new RangeError('x and y must be finite numbers');
  return [x, y];
}

/** The class that another copy of this module has defined. */
const other = /** @type {typeof FireElement | undefined} */ (globalThis.customElements?.get('hearth-fire'));
if (other)
  console.warn(`<hearth-fire>: version ${other.version} is defined already; version ${VERSION} exports that class.`);
else globalThis.customElements?.define('hearth-fire', FireElement);

/** The class of the element, whichever copy of this module has defined it. */
export const HearthFire = other ?? FireElement;
