/**
 * The fire behind an element: it opens and closes the connection to the engine, passes on what
 * the element asks for, and takes what the engine answers.
 *
 * @typedef {import('../engine/engine.js').Call} Call
 * @typedef {import('../engine/engine.js').Message} Message
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 */

import { EngineError } from '../engine/engine.js';
import { burning } from '../engine/files.js';
import { ID_OF_ATTRIBUTE, warmth } from './attributes.js';
import { FireLink } from './engine-connection.js';
import { PagePolicies } from './page-policies.js';
import { Playback } from './playback.js';
import { Reports } from './reports.js';
import { Requests, deferred, postable, quiet } from './requests.js';
import { DEEPEST, settings, settingsOfFile } from './settings.js';
import { FireState } from './state.js';
import { CssHooks } from './css-hooks.js';
import { hexOf } from './values.js';
import { FireView } from './view.js';

/** Seconds of fire that a still picture has burnt, so that it shows a fire. */
const STILL_AFTER = 2;

/** The session of one element. */
export class FireSession {
  #engine;
  #requests = new Requests();
  #policies;
  #css;
  #state = new FireState();
  /** Settles when the engine has freed all fires before this one. */
  #gone = Promise.resolve();
  #announced = false;
  /** Whether the preset's attribute changes without a request for other values. */
  #dropping = false;
  /** @type {FireLink | null} */
  #link = null;
  /** Whether the graphics context is there; a lost one may come back. */
  #drawable = true;
  /** What is asked of the fire, since the page asked for a transition. @type {import('./transition.js').Orders | undefined} */
  #orders;
  #ready = deferred();
  /** For code that is loaded on request and must not load it a second time. */
  hexOf = hexOf;

  /**
   * @param {HearthFire} fire
   * @param {() => Parameters<typeof import('../engine/engine.js').connect>} engine which engine a new fire connects to
   */
  constructor(fire, engine) {
    this.fire = fire;
    this.#engine = engine;
    this.reports = new Reports(fire);
    this.view = new FireView(fire, () => this.playback.press());
    this.playback = new Playback(fire, this.view, (paused) => this.#play(paused));
    this.#css = new CssHooks(fire, this.view);
    this.#policies = new PagePolicies(this);
  }

  /** What the engine has told. */
  get state() {
    return this.#state;
  }

  /** Settles when the fire burns, or cannot. @returns {Promise<void>} */
  get ready() {
    return this.#ready.promise;
  }

  /** Calls the engine. @type {(...call: Call) => Promise<any>} */
  ask(...call) {
    // Where there can be no fire, nothing waits for one.
    const answer = this.#ready.failed ? this.ready : this.#requests.ask(...call);
    this.#orders?.push([call, answer]);
    return answer;
  }

  /** Calls the engine, whose answer nobody waits for. @type {(...call: Call) => void} */
  send(...call) {
    this.#link?.send(...call);
  }

  /** @type {(values: {[id: string]: unknown}, source: string) => Promise<void>} */
  set(values, source) {
    return this.ask('set', postable(values, DEEPEST), source);
  }

  /**
   * Moves values. What is asked of the fire is kept from now on, for the moves to hear.
   * @type {(values: object, how: import('./types.js').HearthTransition | undefined) => Promise<boolean>}
   */
  move(values, how) {
    this.#orders ??= [];
    const orders = this.#orders;
    const checked = this.ask('check', postable(values, 1));
    const code = import('./transition.js').catch((why) => {
      this.#orders = undefined;
      this.reports.warn('load', `Transitions could not be loaded: ${why}`);
      throw why;
    });
    return quiet(code.then(({ run }) => run(orders, this, checked, { ...how })));
  }

  /**
   * What `make` makes of the canvas, when there is a picture on it.
   * @template T
   * @param {(canvas: HTMLCanvasElement) => T | Promise<T>} make
   * @returns {Promise<T>}
   */
  ofPicture(make) {
    return quiet(this.ready.then(() => this.view.drawn()).then(make));
  }

  /** The attribute goes, and its values stay until another message changes them. */
  dropPreset(preset = 'default') {
    this.#dropping = true;
    if (preset === 'default') this.fire.removeAttribute('preset');
    else this.fire.setAttribute('preset', preset);
    this.#dropping = false;
  }

  /** The element is on a page. */
  attach() {
    this.#policies.watch();
    // One that failed tries again, also where it was taken off and put back at once.
    if (this.#link && this.#ready.failed) this.close();
    if (!this.#link) this.#open();
  }

  /** An attribute has changed. @type {(name: string, value: string | null) => void} */
  attribute(name, value) {
    const id = ID_OF_ATTRIBUTE.get(name);
    this.#policies.change(name, value);
    if (name === 'loading') this.#link?.lookAgain();
    // Before, the fire starts with what its attributes say, wherever they stand.
    const begun = this.#state.started || this.#link?.live;
    if (name === 'model' && !begun) {
      // The first fire starts with its model.
    } else if (id !== undefined) {
      if (value !== null) this.set({ [id]: value }, 'attribute');
      else this.ask('restore', [id], 'attribute');
    } else if (name === 'objects') {
      this.#setObjects(value);
    } else if (name === 'preset') {
      if (begun && !this.#dropping) this.ask('preset', value ?? 'default', 'preset');
    } else if (name === 'quality') {
      this.ask('quality', value ?? 'auto');
    } else if (name === 'paused') {
      if ((value !== null) !== this.playback.paused) this.playback.set(value !== null);
    } else if (name === 'src') {
      if (begun) this.#changeFile();
    } else if (name === 'warm') {
      const seconds = warmth(this.fire);
      if (Number.isNaN(seconds)) this.reports.refuse(name, value ?? '', 'a number of seconds from 0 to 30');
      else if (begun) this.ask('warm', seconds);
    } else if (name === 'autoplay') {
      if (this.#link && !this.#state.started && !this.fire.autoplay) this.playback.set(true);
    } else if (name === 'reduced-motion' && this.#link) {
      this.playback.follow();
    }
  }

  /** Sets the objects that the attribute has as JSON. @param {string | null} value */
  #setObjects(value) {
    if (value === null) {
      this.ask('restore', ['objects'], 'attribute');
      return;
    }
    try {
      this.set({ objects: settings(value, 'objects') }, 'attribute');
    } catch (error) {
      const { message } = /** @type {Error} */ (error);
      this.reports.refused([{ id: 'objects', value, message }]);
    }
  }

  /** Frees the fire and all that belongs to it; settles when the engine has done so. */
  close() {
    if (this.#link) this.#close();
    return this.#gone;
  }

  /** The fire plays or stands still. @type {(paused: boolean) => Promise<void>} */
  #play(paused) {
    this.#signal();
    // A fire that is still to come is told how it starts.
    if (!this.#link?.live) return this.ready;
    return this.ask(paused ? 'pause' : 'play');
  }

  /** Tells style sheets whether it is seen to burn. */
  #signal() {
    this.#css.burning(this.view.shows && this.#drawable && !this.playback.paused);
  }

  /** The settings in the file that `src` names; undefined, with a warning, where there are none. */
  async #settingsOfFile() {
    const { src } = this.fire;
    if (!src) return undefined;
    try {
      return await settingsOfFile(src);
    } catch (error) {
      const { message } = /** @type {Error} */ (error);
      if (error instanceof RangeError) this.reports.refused([{ id: 'src', value: src, message }]);
      else this.reports.warn('load', message);
      return undefined;
    }
  }

  /** Another file: the fire takes over what is in it. */
  async #changeFile() {
    const { src } = this.fire;
    const config = await this.#settingsOfFile();
    if (src !== this.fire.src) return;
    if (config !== undefined) this.ask('import', config, 'src');
    // Without a file it burns as it would have without one.
    else if (!src) this.ask('preset', this.fire.preset, 'src');
  }

  /** Makes a fire. */
  #open() {
    if (this.#ready.failed) this.#ready = deferred();
    const { view } = this;
    const fire = this.fire;
    const canvas = view.newCanvas();
    view.describe(fire.alt);
    view.show('loading');
    if (fire.warm) view.fade();
    const link = new FireLink(fire, canvas, this.#requests, {
      heard: (message) => this.#receive(message, link),
      drawn: (picture) => view.draw(picture),
      begun: () => this.#begin(link, still),
      motion: (reduced) => this.playback.follow(reduced),
    });
    this.#link = link;
    this.#policies.begin();
    const still = this.playback.start(!this.#state.started && !fire.autoplay);
    const opened = link.open(
      () => fire.loading,
      this.#engine,
      () => this.#prepare(),
      ({ config, state }) => ({
        ...this.#state.start(fire, this.playback.paused, config), warm: fire.warm, state, view: view.camera,
      }),
    );
    opened.catch((error) => link.closed || this.#fail(error.kind ?? 'load', error.message));
  }

  /** What a fire waits for: all that the one before it has to tell, or its file; and a kept fire. */
  async #prepare() {
    const fire = this.fire;
    const state = fire.warm && !fire.src ? burning(fire.preset) : undefined;
    await this.#gone;
    let config;
    let src;
    do {
      src = fire.src;
      config = this.#state.started ? undefined : await this.#settingsOfFile();
      // Another file may have been named meanwhile.
    } while (src !== fire.src);
    return { config, state: await state };
  }

  /**
   * The fire is there and has its values.
   * @param {FireLink} link
   * @param {boolean} still
   */
  async #begin(link, still) {
    if (this.fire.warm) {
      // Until then the engine may treat the fire as invisible.
      if (!document.hidden) await link.looked;
      await this.ask('warm').catch(() => {});
    } else if (still) {
      await this.ask('burn', STILL_AFTER).catch(() => {});
    }
    if (!link.live) return;
    this.view.show('shown');
    this.playback.offer();
    this.#announced = true;
    this.view.drawn().then(() => this.#signal(), () => {});
    this.#policies.burns();
    this.#ready.resolve();
    this.reports.emit('ready');
  }

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
    this.#state.stats = null;
    this.#policies.end();
    this.view.dropCanvas();
    this.view.offer('');
    this.view.show('loading');
    this.#drawable = true;
    this.#signal();
    this.#css.light();
  }

  /** @type {(message: Message, link: FireLink) => void} */
  #receive(message, link) {
    // Of a fire that was taken off only what it was given before still counts.
    if (link.closed && !['ready', 'changed', 'done', 'refused'].includes(message.type)) return;
    const state = this.#state;
    const { reports } = this;
    switch (message.type) {
      case 'ready':
        state.take(message);
        break;
      case 'changed':
        state.take(message);
        if (message.replaced && (this.fire.getAttribute('preset') ?? 'default') !== state.preset) this.dropPreset(state.preset);
        if (!this.#announced) break;
        for (const [id, value] of Object.entries(message.values)) {
          reports.emit('params-change', { id, value, source: message.source });
        }
        if (message.objects) reports.emit('objects-change', { objects: this.fire.objects, source: message.source });
        break;
      case 'done':
        this.#requests.settle(message.request, undefined, message.value);
        break;
      case 'refused': {
        const error = reports.refused(message.errors);
        if (message.request !== undefined) this.#requests.settle(message.request, error);
        break;
      }
      case 'stats':
        state.stats = { ...message.stats, engine: link.place };
        this.#policies.measure(state.params.display_mode, message.stats.scale);
        this.#css.light(message.stats.scale ? 0 : message.stats.power, state.params);
        reports.emit('stats', { ...state.stats });
        break;
      case 'quality': {
        const { requested, quality, reason } = message;
        state.quality = requested;
        if (this.#announced) reports.emit('quality-change', { quality, reason });
        break;
      }
      case 'state':
        reports.emit(message.playing ? 'play' : 'pause');
        break;
      case 'warming':
        this.view.fade();
        break;
      case 'restored':
        this.#drawable = true;
        this.#signal();
        reports.emit('restored');
        break;
      case 'error':
        // Its last picture stays where it goes on.
        if (message.kind === 'context-lost') {
          this.#drawable = false;
          this.#signal();
          reports.emit('error', { kind: message.kind, message: message.message });
        } else if (message.burns) reports.warn(message.kind, message.message);
        else this.#fail(message.kind, message.message);
        break;
    }
  }

  /**
   * There is no fire and why not: the poster stays, with words.
   * @param {'unsupported' | 'load'} kind
   * @param {string} message
   */
  #fail(kind, message) {
    this.view.show('failed', message);
    this.view.offer('');
    this.#signal();
    this.#policies.end();
    const error = new EngineError(kind, message);
    this.#link?.abandon(error);
    // A promise that was kept cannot be broken; what comes now is refused.
    if (this.#announced) this.#ready = deferred();
    this.#ready.reject(error);
    this.reports.warn(kind, message);
  }
}
