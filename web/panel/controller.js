/**
 * The panel controller: the commands of the panel, for egui and for the accessible controls.
 *
 * Both send their commands through the undo history. The controller uses the fire's public API. It
 * changes the page on request only: clipboard, download, full screen.
 */

import { act } from './acts.js';
import { askForSettings, showKeys, showText } from './cards.js';
import { askForPicture } from './picture-card.js';
import { showScenes } from './scenes.js';
import { editingOf } from './editing.js';
import { download } from './download.js';
import { COPIES, beside, isSettings, settingsOf, textOf } from './exchange.js';
import { remember, remembered } from './memory.js';
import { copyOf, newObject } from './objects.js';
import { ownScenesOf } from './own-scenes.js';
import { PARAMETERS, PRESETS } from '../parameters.js';
import { Report } from './report.js';
import { DOMAINS, MODEL, hasSceneObjects, modelDefault, presetOf, sceneObjects, sceneOf, sceneProperty, sceneValue, valuesOf } from './scene.js';
import { pageLink } from '../share.js';

/** How long a button confirms its action [ms]. */
const DONE_MS = 2000;

/** The events after which the scene may have changed. */
const CHANGES = ['ready', 'params-change', 'objects-change'];

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../hearth-fire.js').HearthConfig} HearthConfig
 * @typedef {import('../parameters.js').ParameterId} Id
 * @typedef {import('./objects.js').Fields} Fields
 * @typedef {import('./objects.js').Kind} Kind
 * @typedef {import('../parameters.js').HearthParameters[Id]} Value
 * @typedef {Partial<import('../parameters.js').HearthParameters>} Values
 *
 * @typedef {object} State  What the panel shows of the controller.
 * @property {string} scene  The label of the scene, with a note if the fire has changed since.
 * @property {string} preset  The label of the scene.
 * @property {Values} values  The values of the scene.
 * @property {Fields[]} objects  The objects of the scene.
 * @property {number} [selected]  The id of the selected object.
 * @property {import('./editing.js').Letter} compared  The state that the fire shows, of the two that are compared.
 * @property {boolean} undo
 * @property {boolean} redo
 * @property {import('./exchange.js').CopyForm[]} copies  The forms that the page can copy: a link needs its URL, an
 *   iframe that of `embed.html`.
 * @property {boolean} fullscreen  Whether the browser allows full screen.
 * @property {string} done  The button whose action has just succeeded.
 * @property {string} message  About the last action, a success or a failure.
 */

/** The controller of one panel. It dispatches `change` when its state changes. */
export class PanelController extends EventTarget {
  #fire;
  #host;
  #page;
  /** For the texts that are copied. */
  #addresses;
  #editing;
  /** Ends what listens to the history and the selection. */
  #ended = new AbortController();
  #history;
  #report;
  /** @type {number | undefined} */
  #doneEnds;
  #done = '';
  #message = '';
  /** @type {import('./cards.js').Card | undefined} */
  #card;
  #scene = '';
  #preset = '';

  /** The value under the pointer and its label; undefined without one. @type {() => string[] | undefined} */
  hovered = () => undefined;

  /**
   * @param {object} parts
   * @param {HearthFire} parts.fire
   * @param {HTMLElement} parts.host  The element of the panel and its cards.
   * @param {string | URL} [parts.page]  The URL of a page that applies its URL parameters.
   * @param {string | URL} [parts.script]  The URL of `hearth-fire.js` for other pages.
   * @param {string | URL} [parts.embed]  The URL of `embed.html` for other pages.
   * @param {string[]} [parts.only]  The parameters that the panel shows.
   */
  constructor({ fire, host, page, only, script = beside('hearth-fire.js'), embed = beside('embed.html') }) {
    super();
    this.#fire = fire;
    this.#host = host;
    this.#page = page;
    this.#addresses = { page, script, embed };
    const known = only?.map((id) => id.replaceAll('-', '_')).filter(isParameter);
    /** The parameters that the panel shows, in this order; undefined means all. */
    this.only = known?.length ? known : undefined;
    this.#restoreQuality();
    this.#report = new Report(fire);
    this.#editing = editingOf(fire);
    this.#history = this.#editing.history;
    this.#editing.watch(this.#changed, this.#ended.signal);
    for (const name of CHANGES) fire.addEventListener(name, this.#update);
    this.#update();
  }

  /** @returns {State} */
  get state() {
    return {
      scene: this.#scene,
      preset: presetOf(this.#fire)?.label ?? '',
      values: valuesOf(this.#fire),
      objects: sceneObjects(this.#fire),
      selected: this.#editing.id,
      compared: this.#editing.letter,
      undo: this.#history.canUndo,
      redo: this.#history.canRedo,
      copies: COPIES.filter(({ name }) => this.#addressOf(name) !== undefined),
      fullscreen: document.fullscreenEnabled === true,
      done: this.#done,
      message: this.#message,
    };
  }

  /** The URL that a form of copy needs; empty if it needs none. @param {string} form */
  #addressOf(form) {
    if (form === 'link') return this.#page;
    return form === 'iframe' ? this.#addresses.embed : '';
  }

  /** A new gesture begins: the next change is a new step. */
  press() {
    this.#history.press();
  }

  /** @type {(id: Id, value: Value) => Promise<void>} */
  set(id, value) {
    return this.#history.set(id, value);
  }

  /**
   * The value of a parameter in the scene; undefined if the current model does not use it.
   * @param {Id} id
   */
  defaultOf(id) {
    return sceneValue(this.#fire, id);
  }

  /**
   * Resets a parameter to its value in the scene.
   * @param {Id} id
   */
  restore(id) {
    return this.#history.restore(id);
  }

  /** The selected object. @returns {Fields | undefined} */
  get selected() {
    return this.#editing.selected;
  }

  /** Selects an object, or none. @param {number} [id] */
  select(id) {
    this.#editing.select(id);
  }

  /** Sets a property of an object. @type {(id: number, name: string, value: Value) => Promise<void>} */
  change(id, name, value) {
    return this.#history.change(id, { [name]: value });
  }

  /**
   * The value of a property in the scene; its default in an object that the scene lacks.
   * @type {(object: Fields, name: string) => Value | undefined}
   */
  propertyOf(object, name) {
    return sceneProperty(this.#fire, object, name);
  }

  /** Resets a property of an object to its value in the scene. @type {(id: number, name: string) => Promise<void>} */
  async restoreProperty(id, name) {
    const object = this.#editing.find(id);
    const value = object && this.propertyOf(object, name);
    if (value !== undefined) await this.change(id, name, value);
  }

  /** Adds an object of a kind beside the fire, and selects it. @param {Kind} kind */
  add(kind) {
    return this.#editing.add(() => newObject(this.#fire, kind));
  }

  /** Adds an object like another one beside it, and selects it. @param {number} id */
  duplicate(id) {
    return this.#editing.add(() => {
      const object = this.#editing.find(id);
      return object && copyOf(this.#fire, object);
    });
  }

  /** Removes an object. @param {number} id */
  remove(id) {
    return this.#editing.remove(id);
  }

  /** Moves a solid before all others, or behind them. @type {(id: number, front: boolean) => Promise<void>} */
  order(id, front) {
    return this.#editing.order([id], front);
  }

  /** Does one of `ACTS` at an object. @type {(name: string, id: number) => Promise<void>} */
  act(name, id) {
    return this.#try(() => act(this.#fire, this.#editing, name, id));
  }

  /**
   * Resets the parameters that the panel shows to their values in the scene, and the objects, if it shows
   * them. The model stays.
   */
  restoreAll() {
    const fire = this.#fire;
    const now = fire.params;
    const ids = (this.only ?? PARAMETERS.map(({ id }) => id)).filter((id) => id !== MODEL.id && DOMAINS.get(id)?.[now.model]);
    const defaults = ids.filter((id) => this.defaultOf(id) === modelDefault(id, now.model));
    const others = ids.filter((id) => !defaults.includes(id) && this.defaultOf(id) !== now[id]);
    return this.#history.all(async () => {
      if (!this.only && !hasSceneObjects(fire)) await fire.set({ objects: /** @type {any[]} */ (sceneObjects(fire)) });
      if (defaults.length > 0) await fire.restore(...defaults);
      if (others.length > 0) await fire.set(Object.fromEntries(others.map((id) => [id, this.defaultOf(id)])));
    }, { replaces: false });
  }

  /** @param {string} name */
  preset(name) {
    /** @type {HearthConfig} */
    const config = { hearth: 1, preset: /** @type {HearthConfig['preset']} */ (name), values: {} };
    return this.#history.all(() => this.#fire.importConfig(config), { replaces: true });
  }

  /** Shows one of two states. @param {import('./editing.js').Letter} letter */
  compare(letter) {
    return this.#editing.compare(letter);
  }

  /** Sets random values near those of the scene. */
  randomise() {
    return this.#editing.randomise();
  }

  /** Shows or hides the card of scenes. */
  scenes() {
    if (this.#card?.isOpen('scenes')) {
      this.#card.close();
      return;
    }
    this.#show(showScenes({
      host: this.#host,
      scenes: PRESETS,
      pictureOf: (name) => beside(`scenes/${name}.jpg`),
      current: () => this.#fire.preset,
      choose: (name) => this.#try(() => this.preset(name)).then(this.#update),
      own: ownScenesOf(this.#fire, (config) => this.#replace(config)),
    }));
  }

  /** Shows the fire of settings: one step. @param {HearthConfig | string} config */
  async #replace(config) {
    await this.#history.all(() => this.#fire.importConfig(config), { replaces: true });
    this.#update();
  }

  /** Shows the fire of a file that a visitor has dropped, or a message why not. @param {File} file */
  open(file) {
    return this.#try(async () => {
      if (!isSettings(file)) throw new Error(`“${file.name}” is no file of settings, whose name ends in “.json”.`);
      await this.#replace(await settingsOf(file));
      this.#notify('', `Opened “${file.name}”`);
    });
  }

  /** @param {string} name */
  quality(name) {
    this.#fire.quality = /** @type {HearthFire['quality']} */ (name);
    remember({ quality: name });
  }

  /** The folded groups of the last visit. */
  get folds() {
    return remembered();
  }

  /** @type {(folded: string[], times: boolean) => void} */
  rememberFolds(folded, times) {
    remember({ folded, times });
  }

  /** Focuses the search field. */
  search() {
    this.dispatchEvent(new Event('search'));
  }

  /** Copies the value under the pointer; undefined without one, or if text is selected. */
  get copyHovered() {
    const hovered = this.hovered();
    if (!hovered || !(getSelection()?.isCollapsed ?? true)) return undefined;
    const [value, label] = hovered;
    return () => this.#try(async () => {
      await navigator.clipboard.writeText(value);
      this.#notify('value', `Copied: ${label} ${value}`);
    });
  }

  play() {
    return this.#fire.play();
  }

  pause() {
    return this.#fire.pause();
  }

  reset() {
    return this.#fire.reset();
  }

  step() {
    return this.#fire.step(1);
  }

  undo() {
    return this.#history.undo();
  }

  redo() {
    return this.#history.redo();
  }

  /**
   * Copies the fire in one of several forms. If the browser refuses, a card shows the text.
   * @param {string} name  Of one of `COPIES`.
   */
  async copy(name) {
    const label = COPIES.find((form) => form.name === name)?.label;
    const config = await this.#try(() => this.#fire.exportConfig());
    // A fire that has failed has a report alone.
    const text = name === 'report'
      ? this.#report.text(this.#page && config && pageLink(config, this.#page), config)
      : config && textOf(name, config, this.#addresses);
    if (!text) return;
    try {
      await navigator.clipboard.writeText(text);
      this.#notify(`copy:${name}`, `Copied: ${label}`);
    } catch {
      this.#show(showText({ host: this.#host, title: `Copy the ${label}`, text }));
    }
  }

  /** Asks for settings as JSON. */
  paste() {
    const apply = async (/** @type {string} */ text) => {
      await this.#history.all(() => this.#fire.importConfig(text), { replaces: true });
      this.#notify('paste', 'The pasted settings are applied');
    };
    this.#show(askForSettings({ host: this.#host, apply }));
  }

  /** Asks for the size and the background of a picture, and saves it. */
  picture() {
    if (this.#card?.isOpen('picture')) {
      this.#card.close();
      return;
    }
    const save = async (/** @type {{scale: number, background: string}} */ { scale, background }) => {
      const plain = await this.#fire.toBlob('image/png');
      const { width } = await createImageBitmap(plain);
      const blob = scale === 1 && background === 'scene' ? plain : await this.#fire.toBlob({ width: scale * width, background });
      download(blob, 'hearth.png');
      this.#notify('picture', `Saved an image, ${scale * width} pixels wide`);
    };
    this.#show(askForPicture({ host: this.#host, save }));
  }

  /** Enters or leaves full screen: for the fire, or for a page about it. */
  async fullscreen() {
    const target = this.#page === undefined ? this.#fire : document.documentElement;
    await this.#try(() => (
      document.fullscreenElement ? document.exitFullscreen() : target.requestFullscreen()
    ));
  }

  /** Shows or hides the list of shortcuts. */
  help() {
    if (this.#card?.isOpen('help')) this.#card.close();
    else this.#show(showKeys({ host: this.#host, fire: this.#fire }));
  }

  /** Closes the card and stops listening. */
  close() {
    for (const name of CHANGES) this.#fire.removeEventListener(name, this.#update);
    this.#ended.abort();
    this.#report.close();
    clearTimeout(this.#doneEnds);
    this.#card?.close();
  }

  /** Compares the fire with its scene. */
  #update = () => {
    this.#card?.mark?.();
    const [scene, preset] = [sceneOf(this.#fire), this.#fire.preset];
    const isGone = this.#editing.id !== undefined && !this.selected;
    if (scene === this.#scene && preset === this.#preset && !isGone) return;
    [this.#scene, this.#preset] = [scene, preset];
    if (isGone) this.select();
    this.#changed();
  };

  /** Applies the quality of the last visit, unless the page or its URL sets one. */
  #restoreQuality() {
    const fire = this.#fire;
    const { quality } = remembered();
    const isSet = fire.hasAttribute?.('quality') || fire.quality !== 'auto';
    if (isSet || (quality !== 'low' && quality !== 'medium' && quality !== 'high')) return;
    fire.quality = quality;
  }

  /**
   * Does something that the fire or the browser may refuse; a refusal becomes a message.
   * @template T
   * @param {() => T | Promise<T>} act
   * @returns {Promise<T | undefined>}
   */
  async #try(act) {
    try {
      return await act();
    } catch (error) {
      this.#notify('', error instanceof Error ? error.message : String(error));
      return undefined;
    }
  }

  /** @param {import('./cards.js').Card} card */
  #show(card) {
    this.#card?.close();
    this.#card = card;
  }

  /** @type {(done: string, message: string) => void} */
  #notify(done, message) {
    [this.#done, this.#message] = [done, message];
    clearTimeout(this.#doneEnds);
    this.#doneEnds = setTimeout(() => {
      [this.#done, this.#message] = ['', ''];
      this.#changed();
    }, DONE_MS);
    this.#changed();
  }

  #changed = () => {
    this.dispatchEvent(new Event('change'));
  };
}

/** @type {(id: string) => id is Id} */
function isParameter(id) {
  return DOMAINS.has(id);
}
