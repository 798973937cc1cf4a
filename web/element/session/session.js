/**
 * The fire behind an element: it opens and closes the connection to the engine, sends the element's
 * calls, and handles the engine's events.
 *
 * @typedef {import('../../engine/engine.js').Call} Call
 * @typedef {import('../../engine/engine.js').Message} Message
 * @typedef {import('../../hearth-fire.js').HearthFire} HearthFire
 */

import { EngineError } from '../../engine/engine.js';
import { missingFeature } from '../../engine/features.js';
import { prewarmed } from '../../engine/files.js';
import { trustedWorker } from '../../engine/trusted-worker.js';
import { ID_OF_ATTRIBUTE, isOn, warmth } from '../attributes/attributes.js';
import { postable, setOrRemove } from '../plain-data.js';
import { EngineConnection } from './engine-connection.js';
import { OnDemandCode } from './on-demand-code.js';
import { MUTED } from './muted.js';
import { PagePolicies } from '../attributes/page-policies.js';
import { Playback } from './playback.js';
import { Readiness } from './readiness.js';
import { Reports } from './reports.js';
import { Requests } from './requests.js';
import { DEPTH, reportedSettings } from '../attributes/settings.js';
import { SourceFile } from '../attributes/source-file.js';
import { FireHistory } from './history.js';
import { FireState } from './state.js';
import { hexOf } from '../attributes/values.js';
import { FireView } from '../view/view.js';

/** Simulated seconds before the frame of a fire that is paused for reduced motion. */
const STILL_AFTER = 2;

/** Simulated seconds, at most, before the first frame of a fire that follows a stopped one. */
const WARMTH = 3;

/** How long an element that is removed keeps its fire: frameworks insert it again after some tasks [ms]. */
const GRACE_MS = 500;

/** How long an element may have no box before a warning names it [ms]. */
const BOX_MS = 3000;

/** The types of the events that answer calls. */
const ANSWERS = ['ready', 'changed', 'done', 'refused'];

/** The session of one element. */
export class FireSession {
  #engine;
  #requests = new Requests();
  #policies;
  /** Settles when the engine has freed all fires before this one. */
  #gone = Promise.resolve();
  /** Whether the fire follows a stopped one. */
  #returns = false;
  /** Whether the `preset` attribute changes without a call to the engine. */
  #reflecting = false;
  /** @type {EngineConnection | null} */
  #connection = null;
  /** Whether the graphics context exists; a lost one may be restored. */
  drawable = true;
  #ready = new Readiness();
  #file = new SourceFile(this);
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #leaving;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #boxed;
  /** Whether the element was ever on a page. */
  #attached = false;
  code = new OnDemandCode(this);
  /** The last report of the engine. */
  state = new FireState();
  history = new FireHistory(this);
  /** For code that is loaded on request and must not load it a second time. */
  hexOf = hexOf;
  muted = MUTED;
  trustedWorker = trustedWorker;

  /**
   * @param {HearthFire} fire
   * @param {() => Parameters<typeof import('../../engine/engine.js').connect>} engine the engine of a new fire
   */
  constructor(fire, engine) {
    /** @type {HearthFire} */
    this.fire = fire;
    this.#engine = engine;
    this.reports = new Reports(fire);
    this.view = new FireView(fire);
    this.playback = new Playback(this, (paused) => this.#play(paused));
    this.#policies = new PagePolicies(this);
  }

  /** Settles when the fire is presented, or cannot be. @returns {Promise<void>} */
  get ready() {
    this.#checkBox();
    return this.#ready.promise;
  }

  /** Warns once of an element that has no box after a while, or is on no page though someone waits for its fire. */
  #checkBox() {
    this.#boxed ??= setTimeout(() => {
      const { fire } = this;
      if (fire.isConnected ? fire.offsetWidth * fire.offsetHeight : this.#attached) return;
      import('../view/box.js').then(
        ({ warnOfBox }) => warnOfBox(fire),
        () => {},
      );
    }, BOX_MS);
  }

  /** Calls the engine. @type {(...call: Call) => Promise<any>} */
  call(...call) {
    // These replace every value, and so those of a file that has not arrived.
    if (call[0] === 'import' || call[0] === 'preset') this.#file.drop();
    if (call[0] !== 'children') this.code.sendChildren();
    // A fire that failed answers nothing.
    const answer = this.#ready.failed ? this.ready : this.#requests.call(...call);
    this.code.record(call, answer);
    return answer;
  }

  /** Calls the engine without waiting for an answer. @type {(...call: Call) => void} */
  send(...call) {
    this.#connection?.send(...call);
  }

  /** Changes settings. @type {(call: Call, source?: string) => Promise<any>} */
  change([method, ...given], source = this.history.source('property')) {
    const rest = method === 'set' && Object(given[0]).model !== undefined ? [this.#stated] : [];
    return this.call(method, ...postable(given, 1 + DEPTH), source, ...rest);
  }

  /** What attributes state. @returns {{[id: string]: string}} */
  get #stated() {
    const values = [...ID_OF_ATTRIBUTE].map(([name, id]) => [id, this.fire.getAttribute(name)]);
    return Object.fromEntries(values.filter(([, value]) => value !== null));
  }

  /** Sets the preset attribute and keeps the values. */
  reflectPreset(preset = 'default') {
    this.#reflecting = true;
    setOrRemove(this.fire, 'preset', preset === 'default' ? null : preset);
    this.#reflecting = false;
  }

  /** The element is on a page. */
  attach() {
    this.#attached = true;
    this.#checkBox();
    this.#policies.checkNames();
    // A fire that failed tries again.
    if (this.#connection && this.#ready.failed) this.close();
    if (!this.#connection) this.#open();
  }

  /** The element is on no page; perhaps it only moves. */
  detach() {
    clearTimeout(this.#leaving);
    this.#leaving = setTimeout(() => this.fire.isConnected || this.close(), GRACE_MS);
  }

  /** Shows the fire on another canvas: a move to another document has taken the last one away. */
  replaceCanvas() {
    this.view.applyStyles();
    if (this.#connection) this.#connection.watch(this.view.replaceCanvas());
    // Some documents take the listeners of their elements along.
    this.#policies.listenAgain();
    this.playback.listenAgain();
  }

  /** Whether the engine has the fire. */
  get live() {
    return Boolean(this.#connection?.live);
  }

  /** The connection to the engine, if it has the fire. */
  get connection() {
    return this.live ? this.#connection : null;
  }

  /** Whether there is a fire, or was one. */
  get begun() {
    return this.state.started || this.live;
  }

  /** An attribute has changed. @type {(name: string, value: string | null) => void} */
  attribute(name, value) {
    const id = ID_OF_ATTRIBUTE.get(name);
    this.#policies.change(name, value);
    // A fire that has not begun starts with its attributes, whatever their order.
    const { begun } = this;
    if (id !== undefined) {
      if (name === 'model' && !begun) return;
      this.change(['set', { [id]: value }], 'attribute');
    } else if (name === 'objects') {
      this.#setObjects(value);
    } else if (name === 'preset') {
      if (begun && !this.#reflecting) this.call('preset', value ?? 'default', this.history.sourceOfScene('preset'));
    } else if (name === 'quality') {
      this.call('quality', value ?? 'auto');
    } else if (name === 'paused') {
      if (isOn(value) !== this.playback.paused) this.playback.set(isOn(value));
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
    } else if (name === 'decorative') {
      this.playback.showButton();
    }
  }

  /** Sets the objects of the attribute, which are JSON. @param {string | null} value */
  #setObjects(value) {
    try {
      this.change(['set', { objects: value && reportedSettings(value, 'objects', this.reports) }], 'attribute');
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
    this.updateBurning();
    // A fire that has not begun receives the state with its start.
    if (!this.live) return this.ready;
    return this.call(paused ? 'pause' : 'play');
  }

  /** Sets or removes `:state(burning)`. */
  updateBurning() {
    this.code.setBurning(this.view.shows && this.drawable && !this.playback.paused);
  }

  /** Makes a fire. The picture of a stopped one stays until it is followed by another. */
  #open() {
    if (this.#ready.failed) this.#ready.renew();
    const { view, fire } = this;
    const missing = missingFeature();
    if (missing) {
      // The page's own script may listen to errors by then.
      setTimeout(() => this.#fail('unsupported', missing));
      return;
    }
    const canvas = (this.#returns && view.canvas) || view.newCanvas();
    if (!view.shows) view.show('loading');
    if (this.#warmth()) view.fade();
    const connection = new EngineConnection(fire, canvas, this.#requests, {
      message: (message) => this.#receive(message, connection),
      frame: (frame) => {
        view.draw(frame);
        // An engine on the page's own thread is still in its frame, and listeners are the page's code.
        queueMicrotask(() => this.#present(connection));
      },
      visible: () => this.#present(connection),
      start: () => this.#begin(connection, still),
      motion: (reduced) => this.playback.follow(reduced),
    });
    this.#connection = connection;
    this.#policies.begin();
    const still = this.playback.start(!this.state.started && !fire.autoplay);
    connection
      .open(
        () => fire.loading,
        this.#engine,
        () => this.#prepare(),
        (state) => ({
          ...this.state.start(fire, this.playback.paused, this.#file.config),
          warm: this.#warmth(),
          children: this.code.hasChildren,
          state,
          view: view.camera,
        }),
      )
      .catch((error) => {
        if (connection.closed) return;
        if (this.#returns) this.#stop(error.message);
        else this.#fail(error.kind ?? 'load', error.message);
      });
  }

  /** Simulated seconds before the first frame. A fire that follows a stopped one is as old, up to a limit. */
  #warmth() {
    return this.fire.warm || (this.#returns && Math.min(this.state.stats?.time ?? 0, WARMTH));
  }

  /** Loads what a fire starts with: its file and its burning state. Waits for the last event of the fire before. */
  async #prepare() {
    const { fire } = this;
    const state = this.#warmth() && !fire.src ? prewarmed(fire.preset) : undefined;
    const file = this.state.started ? undefined : this.#file.begin();
    await this.#gone;
    await this.code.loadChildren(true);
    await file;
    return state;
  }

  /**
   * The fire has its values.
   * @param {EngineConnection} connection
   * @param {boolean} still
   */
  async #begin(connection, still) {
    if (this.#warmth()) {
      // The engine may treat the fire as invisible before.
      if (!document.hidden) await connection.observed;
      await this.call('warm').catch(() => {});
    } else if (still) {
      await this.call('advance', STILL_AFTER).catch(() => {});
    }
    if (!connection.live) return;
    this.view.show('shown');
    this.playback.showButton();
    this.view.drawn().then(
      () => this.updateBurning(),
      () => {},
    );
    this.#policies.burns();
    this.#ready.await((message) => this.#stop(message));
    this.#present(connection);
  }

  /**
   * Reports that the fire is ready when its picture is shown, or, out of sight, when it can be drawn.
   * @param {EngineConnection} connection
   */
  #present(connection) {
    if (!this.#ready.awaited || !this.drawable || !(connection.pictured || connection.unseen)) return;
    // Later fires of this element are as warm as its attribute.
    if (this.#returns) this.send('warm', Number(this.fire.warm));
    this.#returns = false;
    const { announced } = this.#ready;
    this.#ready.resolve();
    this.history.begun = true;
    this.reports.emit(announced ? 'restored' : 'ready');
  }

  /** Ends the connection of a fire that is removed or has stopped. */
  #end() {
    this.code.endTransitions();
    this.#ready.cancel();
    this.drawable = true;
    this.#connection?.close();
    this.code.sound();
  }

  #close() {
    this.#end();
    if (this.#ready.announced) this.#ready.renew();
    // A connection without a fire has none to free; the fire before may still exist.
    const gone = this.#connection?.gone;
    this.#gone = this.#gone.then(() => gone);
    this.#connection = null;
    this.#returns = false;
    this.state.stats = null;
    this.#policies.end();
    this.view.dropCanvas();
    this.playback.showButton('');
    this.view.show('loading');
    this.updateBurning();
    this.code.setLight();
  }

  /** @type {(message: Message, connection: EngineConnection) => void} */
  #receive(message, connection) {
    // A removed fire only answers earlier calls.
    if (connection.closed && !ANSWERS.includes(message.type)) return;
    this.#receivers[message.type]?.(message, connection);
  }

  /** What each type of event does. @type {{[type: string]: (message: Message, connection: EngineConnection) => void}} */
  #receivers = {
    ready: (message) => {
      this.state.take(message);
      this.code.sound(true);
      this.code.loadChildren();
      this.code.reportToChildren(message);
    },
    changed: (message) => this.#change(message),
    done: ({ request, value }) => this.#requests.settle(request, undefined, value),
    refused: ({ request, errors }) => {
      const error = this.reports.refused(this.code.named(errors, this.#requests.promise(request)));
      if (request !== undefined) this.#requests.settle(request, error);
    },
    samples: (message) => this.code.playSamples(message),
    stats: ({ stats }, { engineThread }) => {
      const { state } = this;
      state.stats = { ...stats, engine: engineThread };
      this.#policies.measure(state.params.display_mode, stats.scale);
      this.code.setLight(stats.scale ? 0 : stats.power, stats.glow);
      this.reports.emit('stats', { ...state.stats });
    },
    quality: ({ requested, quality, reason }) => {
      this.state.quality = requested;
      if (this.#ready.announced) this.reports.emit('quality-change', { quality, reason });
    },
    state: ({ playing }) => this.reports.emit(playing ? 'play' : 'pause'),
    warming: () => this.view.fade(),
    restored: (_, connection) => {
      this.drawable = true;
      this.updateBurning();
      if (this.#ready.announced && !this.#returns) this.reports.emit('restored');
      this.#present(connection);
    },
    error: ({ kind, message, burns }) => {
      if (kind === 'context-lost') {
        // The last frame stays visible.
        this.drawable = false;
        this.updateBurning();
        this.reports.failure(kind, message);
      } else if (burns) this.reports.warn(kind, message);
      else if (kind === 'stopped') this.#stop(message);
      else this.#fail(kind, message);
    },
  };

  /** Settings have changed. @param {Message} message */
  #change(message) {
    // These values apply to a saved picture alone.
    if (message.source === 'picture') return;
    const { state, reports } = this;
    const [source, key] = message.source.split(/:(.*)/s);
    message.source = source;
    const { objects } = state;
    state.take(message);
    if (key !== undefined) this.history.record(key, message.undo, message.redo);
    this.code.reportToChildren(message);
    if (message.redo.preset && (this.fire.getAttribute('preset') ?? 'default') !== state.preset)
      this.reflectPreset(state.preset);
    if (!this.#ready.announced) return;
    for (const [id, value] of Object.entries(message.values)) reports.emit('params-change', { id, value, source });
    if (state.objects !== objects) reports.emit('objects-change', { objects: this.fire.objects, source });
  }

  /**
   * The fire has stopped: another one follows with its settings, unless it stops again and again.
   * @param {string} message
   */
  #stop(message) {
    const { stops, pause } = this.#ready.stop();
    if (pause === Infinity) {
      this.#fail('stopped', `The fire has stopped ${stops} times in a minute. ${message}`);
      return;
    }
    const connection = this.#connection;
    connection?.abandon(new EngineError('stopped', message));
    this.#end();
    this.#returns = true;
    this.updateBurning();
    this.reports.warn('stopped', message);
    // What failed at once has some time before it fails again.
    setTimeout(() => connection === this.#connection && this.#open(), pause);
  }

  /**
   * There is no fire: shows the poster, the reason, and a button that tries again.
   * @param {'unsupported' | 'load' | 'stopped'} kind
   * @param {string} message
   */
  #fail(kind, message) {
    const error = new EngineError(kind, message);
    this.#connection?.abandon(error);
    this.#requests.abandon(0, error);
    this.#end();
    this.#returns = false;
    this.view.show('failed', message, kind !== 'unsupported' && (() => this.#retry()));
    this.playback.showButton('');
    this.updateBurning();
    this.#policies.end();
    this.#ready.reject(error);
    this.reports.warn(kind, message);
  }

  /** Restarts a failed fire on request. */
  #retry() {
    this.#ready.forget();
    this.#close();
    this.#open();
  }
}
