/**
 * The fire behind an element: it opens and closes the connection to the engine, sends the element's
 * calls, and handles the engine's events.
 *
 * @typedef {import('../engine/engine.js').Call} Call
 * @typedef {import('../engine/engine.js').Message} Message
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 */

import { EngineError } from '../engine/engine.js';
import { burning } from '../engine/files.js';
import { ID_OF_ATTRIBUTE, setOrRemove, warmth } from './attributes.js';
import { EngineConnection } from './engine-connection.js';
import { PagePolicies } from './page-policies.js';
import { Playback } from './playback.js';
import { Reports } from './reports.js';
import { Requests, deferred, postable, quiet } from './requests.js';
import { DEPTH, settings } from './settings.js';
import { SourceFile } from './source-file.js';
import { FireState } from './state.js';
import { hexOf } from './values.js';
import { FireView } from './view.js';

/** Simulated seconds before the frame of a fire that is paused for reduced motion. */
const STILL_AFTER = 2;

/** The session of one element. */
export class FireSession {
  #engine;
  #requests = new Requests();
  #policies;
  /** The style hooks, once they are loaded. @type {import('./css-hooks.js').CssHooks | undefined} */
  #css;
  /** @type {Promise<void> | undefined} */
  #loadsCss;
  /** Settles when the engine has freed all fires before this one. */
  #gone = Promise.resolve();
  #announced = false;
  /** Whether the `preset` attribute changes without a call to the engine. */
  #reflecting = false;
  /** @type {EngineConnection | null} */
  #connection = null;
  /** Whether the graphics context exists; a lost one may be restored. */
  #drawable = true;
  /** The calls since the first transition. @type {import('./transition.js').Calls | undefined} */
  #calls;
  #ready = deferred();
  #file = new SourceFile(this);
  /** What the engine reported last. */
  state = new FireState();
  /** For code that is loaded on request and must not load it a second time. */
  hexOf = hexOf;

  /**
   * @param {HearthFire} fire
   * @param {() => Parameters<typeof import('../engine/engine.js').connect>} engine the engine of a new fire
   */
  constructor(fire, engine) {
    this.fire = fire;
    this.#engine = engine;
    this.reports = new Reports(fire);
    this.view = new FireView(fire);
    this.playback = new Playback(this, (paused) => this.#play(paused));
    this.#policies = new PagePolicies(this);
  }

  /** Settles when the fire burns, or cannot. @returns {Promise<void>} */
  get ready() {
    return this.#ready.promise;
  }

  /** Calls the engine. @type {(...call: Call) => Promise<any>} */
  call(...call) {
    // These replace every value, and so those of a file that has not arrived.
    if (call[0] === 'import' || call[0] === 'preset') this.#file.drop();
    // A fire that failed answers nothing.
    const answer = this.#ready.failed ? this.ready : this.#requests.call(...call);
    this.#calls?.push([call, answer]);
    return answer;
  }

  /** Calls the engine without waiting for an answer. @type {(...call: Call) => void} */
  send(...call) {
    this.#connection?.send(...call);
  }

  /** @type {(values: {[id: string]: unknown}, source?: string) => Promise<void>} */
  set(values, source = 'property') {
    return this.call('set', postable(values, DEPTH), source);
  }

  /**
   * Starts a transition. From now on, the calls of the fire are recorded for it.
   * @type {(values: object, how: import('./types.js').HearthTransition | undefined) => Promise<boolean>}
   */
  move(values, how) {
    this.#calls ??= [];
    const calls = this.#calls;
    const checked = this.call('check', postable(values, 1));
    const code = this.reports.loads(import('./transition.js'), 'The code for transitions');
    code.catch(() => (this.#calls = undefined));
    return quiet(code.then(({ run }) => run(calls, this, checked, { ...how })));
  }

  /**
   * Settings of the page as plain data; reports those that are refused.
   * @param {unknown} config
   * @param {string} id their name in errors
   * @throws {Error} they are refused
   */
  settings(config, id) {
    try {
      return settings(config, id);
    } catch (error) {
      throw this.reports.refused([{ id, value: config, message: /** @type {Error} */ (error).message }]);
    }
  }

  /** Calls a function of `capture.js` when the canvas shows a frame. @type {(name: 'toBlob' | 'captureStream', ...options: any) => Promise<any>} */
  capture(name, ...options) {
    const frame = this.ready.then(() => this.view.drawn());
    const code = /** @type {Promise<{[name: string]: Function}>} */ (this.reports.loads(import('./capture.js'), 'The code for pictures'));
    return quiet(Promise.all([frame, code]).then(([canvas, functions]) => functions[name](canvas, this.#drawable, ...options)));
  }

  /** Sets the preset attribute and keeps the values. */
  reflectPreset(preset = 'default') {
    this.#reflecting = true;
    setOrRemove(this.fire, 'preset', preset === 'default' ? null : preset);
    this.#reflecting = false;
  }

  /** The element is on a page. */
  attach() {
    this.#policies.checkNames();
    // A fire that failed tries again.
    if (this.#connection && this.#ready.failed) this.close();
    if (!this.#connection) this.#open();
  }

  /** Whether there is a fire, or was one. */
  get begun() {
    return this.state.started || Boolean(this.#connection?.live);
  }

  /** An attribute has changed. @type {(name: string, value: string | null) => void} */
  attribute(name, value) {
    const id = ID_OF_ATTRIBUTE.get(name);
    this.#policies.change(name, value);
    // A fire that has not begun starts with its attributes, whatever their order.
    const { begun } = this;
    if (id !== undefined) {
      if (name === 'model' && !begun) return;
      if (value !== null) this.set({ [id]: value }, 'attribute');
      else this.call('restore', [id], 'attribute');
    } else if (name === 'objects') {
      this.#setObjects(value);
    } else if (name === 'preset') {
      if (begun && !this.#reflecting) this.call('preset', value ?? 'default', 'preset');
    } else if (name === 'quality') {
      this.call('quality', value ?? 'auto');
    } else if (name === 'paused') {
      if ((value !== null) !== this.playback.paused) this.playback.set(value !== null);
    } else if (name === 'src') {
      this.#file.change();
    } else if (name === 'warm') {
      const seconds = warmth(this.fire);
      if (Number.isNaN(seconds)) this.reports.refuse(name, value ?? '', 'a number of seconds from 0 to 30');
      else if (begun) this.call('warm', seconds);
    } else if (name === 'autoplay') {
      if (this.#connection && !this.state.started && !this.fire.autoplay) this.playback.set(true);
    } else if (name === 'loading') {
      this.#connection?.reschedule();
    } else if (name === 'reduced-motion' && this.#connection) {
      this.playback.follow();
    }
  }

  /** Sets the objects of the attribute, which are JSON. @param {string | null} value */
  #setObjects(value) {
    try {
      if (value === null) this.call('restore', ['objects'], 'attribute');
      else this.set({ objects: this.settings(value, 'objects') }, 'attribute');
    } catch {
      // It is reported.
    }
  }

  /** Frees the fire; settles when the engine has done so. */
  close() {
    if (this.#connection) this.#close();
    return this.#gone;
  }

  /** The fire plays or pauses. @type {(paused: boolean) => Promise<void>} */
  #play(paused) {
    this.#updateState();
    // A fire that has not begun receives the state with its start.
    if (!this.#connection?.live) return this.ready;
    return this.call(paused ? 'pause' : 'play');
  }

  /** Sets or removes `:state(burning)`. The code is loaded with the first frame. */
  #updateState() {
    const burning = this.view.shows && this.#drawable && !this.playback.paused;
    if (burning) {
      this.#loadsCss ??= this.reports.loads(import('./css-hooks.js'), 'The code for style hooks').then(({ CssHooks }) => {
        this.#css = new CssHooks(this.fire, this.view);
        this.#updateState();
      }, () => {});
    }
    this.#css?.burning(burning);
  }

  /** Makes a fire. */
  #open() {
    if (this.#ready.failed) this.#ready = deferred();
    const { view, fire } = this;
    const canvas = view.newCanvas();
    view.show('loading');
    if (fire.warm) view.fade();
    const connection = new EngineConnection(fire, canvas, this.#requests, {
      message: (message) => this.#receive(message, connection),
      frame: (frame) => view.draw(frame),
      start: () => this.#begin(connection, still),
      motion: (reduced) => this.playback.follow(reduced),
    });
    this.#connection = connection;
    this.#policies.begin();
    const still = this.playback.start(!this.state.started && !fire.autoplay);
    connection.open(
      () => fire.loading,
      this.#engine,
      () => this.#prepare(),
      (state) => ({
        ...this.state.start(fire, this.playback.paused, this.#file.config), warm: fire.warm, state, view: view.camera,
      }),
    ).catch((error) => connection.closed || this.#fail(error.kind ?? 'load', error.message));
  }

  /** Loads what a fire starts with: its file and its burning state. Waits for the last event of the fire before. */
  async #prepare() {
    const { fire } = this;
    const state = fire.warm && !fire.src ? burning(fire.preset) : undefined;
    const file = this.state.started ? undefined : this.#file.begin();
    await this.#gone;
    await file;
    return state;
  }

  /**
   * The fire has its values.
   * @param {EngineConnection} connection
   * @param {boolean} still
   */
  async #begin(connection, still) {
    if (this.fire.warm) {
      // The engine may treat the fire as invisible before.
      if (!document.hidden) await connection.observed;
      await this.call('warm').catch(() => {});
    } else if (still) {
      await this.call('burn', STILL_AFTER).catch(() => {});
    }
    if (!connection.live) return;
    this.view.show('shown');
    this.playback.offer();
    this.#announced = true;
    this.view.drawn().then(() => this.#updateState(), () => {});
    this.#policies.burns();
    this.#ready.resolve();
    this.reports.emit('ready');
  }

  #close() {
    this.#calls?.end?.();
    // `ready` now stands for the next fire.
    if (this.#announced) this.#ready = deferred();
    this.#connection?.close();
    // A connection without a fire has none to free; the fire before may still exist.
    const gone = this.#connection?.gone;
    this.#gone = this.#gone.then(() => gone);
    this.#connection = null;
    this.#announced = false;
    this.state.stats = null;
    this.#policies.end();
    this.view.dropCanvas();
    this.playback.offer('');
    this.view.show('loading');
    this.#drawable = true;
    this.#updateState();
    this.#css?.light();
  }

  /** @type {(message: Message, connection: EngineConnection) => void} */
  #receive(message, connection) {
    const { state, reports } = this;
    const { type } = message;
    // A removed fire only answers earlier calls.
    if (connection.closed && !['ready', 'changed', 'done', 'refused'].includes(type)) return;
    if (type === 'ready') {
      state.take(message);
    } else if (type === 'changed') {
      state.take(message);
      if (message.replaced && (this.fire.getAttribute('preset') ?? 'default') !== state.preset) this.reflectPreset(state.preset);
      if (!this.#announced) return;
      const { source } = message;
      for (const [id, value] of Object.entries(message.values)) reports.emit('params-change', { id, value, source });
      if (message.objects) reports.emit('objects-change', { objects: this.fire.objects, source });
    } else if (type === 'done') {
      this.#requests.settle(message.request, undefined, message.value);
    } else if (type === 'refused') {
      const error = reports.refused(message.errors);
      if (message.request !== undefined) this.#requests.settle(message.request, error);
    } else if (type === 'stats') {
      const { stats } = message;
      state.stats = { ...stats, engine: connection.place };
      this.#policies.measure(state.params.display_mode, stats.scale);
      this.#css?.light(stats.scale ? 0 : stats.power, state.params);
      reports.emit('stats', { ...state.stats });
    } else if (type === 'quality') {
      const { requested, quality, reason } = message;
      state.quality = requested;
      if (this.#announced) reports.emit('quality-change', { quality, reason });
    } else if (type === 'state') {
      reports.emit(message.playing ? 'play' : 'pause');
    } else if (type === 'warming') {
      this.view.fade();
    } else if (type === 'restored') {
      this.#drawable = true;
      this.#updateState();
      reports.emit('restored');
    } else if (message.kind === 'context-lost') {
      // The last frame stays visible.
      this.#drawable = false;
      this.#updateState();
      reports.emit('error', { kind: message.kind, message: message.message });
    } else if (message.burns) {
      reports.warn(message.kind, message.message);
    } else if (type === 'error') {
      this.#fail(message.kind, message.message);
    }
  }

  /**
   * There is no fire: shows the poster and the reason.
   * @param {'unsupported' | 'load'} kind
   * @param {string} message
   */
  #fail(kind, message) {
    this.view.show('failed', message);
    this.playback.offer('');
    this.#updateState();
    this.#policies.end();
    const error = new EngineError(kind, message);
    this.#connection?.abandon(error);
    // A resolved `ready` stays resolved; a new one rejects.
    if (this.#announced) this.#ready = deferred();
    this.#ready.reject(error);
    this.reports.warn(kind, message);
  }
}
