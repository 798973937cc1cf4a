/**
 * The panel controller: every command of the panel, for egui and for the accessible controls alike.
 *
 * A command goes through the undo history, whichever of the two sends it. The controller uses the
 * fire's public API. It touches the page only on request: clipboard, download, full screen.
 */

import { askForSettings, showKeys, showText } from './cards.js';
import { showScenes } from './scenes.js';
import { remember, remembered } from './memory.js';
import { PARAMETERS, PRESETS } from '../parameters.js';
import { UndoHistory } from './undo-history.js';
import { FILE as SHARE, elementCode, iframeCode, pageLink } from '../share.js';

/**
 * An address in the folder of `hearth-fire.js`. A bundler joins modules, or gives them the
 * addresses of its own disk, and drops the files that no module names; then the folder is
 * unknown. It is known where share.js is still the file that this module imports.
 */
const FOLDER = /^https?:/.test(SHARE) && SHARE.split('?')[0] === new URL('../share.js', import.meta.url).href
  ? SHARE : undefined;

/** How long a button says that it has done it [ms]. */
const DONE_MS = 2000;

/** @type {Map<string, Domains>} */
const DOMAINS = new Map(PARAMETERS.map(({ id, domains }) => [id, domains]));

/** Decides which parameters count. */
const MODEL = /** @type {import('../parameters.js').Parameter} */ (PARAMETERS.find(({ id }) => id === 'model'));

/** The model of a fire that names none. */
const DEFAULT_MODEL = /** @type {ModelName} */ (MODEL.default);

/** The parts of a domain. */
const PARTS = /** @type {const} */ (['default', 'min', 'max']);

/** What of a fire may make it another one. */
const NEWS = ['ready', 'params-change', 'objects-change'];

/** What can be copied, in the order of its buttons. */
export const COPIES = ['link', 'element', 'iframe', 'json'];

/** What each of them is called. @type {{[what: string]: string}} */
export const COPY_LABELS = {
  link: 'link', element: 'HTML of the element', iframe: 'HTML of an iframe', json: 'settings as JSON',
};

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../hearth-fire.js').HearthConfig} HearthConfig
 * @typedef {import('../parameters.js').ParameterId} Id
 * @typedef {import('../parameters.js').ModelName} ModelName
 * @typedef {import('../parameters.js').HearthParameters[Id]} Value
 * @typedef {Partial<import('../parameters.js').HearthParameters>} Values
 * @typedef {import('../parameters.js').Parameter['domains']} Domains
 *
 * @typedef {object} State  What there is to press and to say.
 * @property {string} scene  The scene that the fire started from, in words.
 * @property {string} preset  What that is called, changed or not.
 * @property {Values} values  What it names.
 * @property {boolean} undo
 * @property {boolean} redo
 * @property {boolean} link  Whether the page has an address that shows this fire.
 * @property {boolean} iframe  Whether there is a page to put into a frame.
 * @property {boolean} fullscreen  Whether the browser allows it.
 * @property {string} done  The button whose work is just done, for a while.
 * @property {string} said  What is just done, or went wrong, in words.
 */

/** The controller of one panel. It says `change` when its state is another one. */
export class PanelController extends EventTarget {
  #fire;
  #host;
  #page;
  #script;
  #embed;
  #history;
  /** @type {number | undefined} */
  #doneEnds;
  #done = '';
  #said = '';
  /** @type {import('./cards.js').Card | undefined} */
  #card;
  #scene = '';
  #preset = '';

  /** The value under the pointer and its label; nothing: the panel shows none. @type {() => string[] | undefined} */
  hovered = () => undefined;

  /**
   * @param {object} parts
   * @param {HearthFire} parts.fire
   * @param {HTMLElement} parts.host  Where the panel stands, and its cards.
   * @param {string | URL} [parts.page]  The address of a page that reads its query; the
   *   panel's own page, then.
   * @param {string | URL} [parts.script]  Where others find `hearth-fire.js`.
   * @param {string | URL} [parts.embed]  Where they find `embed.html`.
   * @param {string[]} [parts.only]  The parameters that the panel shows.
   */
  constructor({ fire, host, page, only, script = beside('hearth-fire.js'), embed = beside('embed.html') }) {
    super();
    this.#fire = fire;
    this.#host = host;
    this.#page = page;
    this.#script = script;
    this.#embed = embed;
    const known = only?.map((id) => id.replaceAll('-', '_')).filter(isParameter);
    /** The parameters that the panel shows, in this order; nothing: all. */
    this.only = known?.length ? known : undefined;
    this.#recallQuality();
    this.#history = new UndoHistory(fire, () => this.#changed(), usualOf, (id) => this.defaultOf(id));
    for (const name of NEWS) fire.addEventListener(name, this.#look);
    this.#look();
  }

  /** @returns {State} */
  get state() {
    return {
      scene: this.#scene,
      preset: presetOf(this.#fire)?.label ?? '',
      values: valuesOf(this.#fire),
      undo: this.#history.canUndo,
      redo: this.#history.canRedo,
      link: this.#page !== undefined,
      iframe: this.#embed !== undefined,
      fullscreen: document.fullscreenEnabled === true,
      done: this.#done,
      said: this.#said,
    };
  }

  /** A new gesture begins. */
  press() {
    this.#history.press();
  }

  /** @type {(id: Id, value: Value) => Promise<void>} */
  set(id, value) {
    return this.#history.set(id, value);
  }

  /**
   * What a parameter has in the scene, in the present model; nothing where that does
   * not use it.
   * @param {Id} id
   */
  defaultOf(id) {
    return sceneValue(this.#fire, id);
  }

  /**
   * Puts a parameter back to what it has in the scene.
   * @param {Id} id
   */
  restore(id) {
    return this.#history.restore(id);
  }

  /** Puts all that the panel shows of the model back to what it has in the scene. */
  restoreAll() {
    const fire = this.#fire;
    const now = fire.params;
    const ids = (this.only ?? PARAMETERS.map(({ id }) => id)).filter((id) => id !== MODEL.id && DOMAINS.get(id)?.[now.model]);
    const usual = ids.filter((id) => this.defaultOf(id) === usualOf(id, now.model));
    const others = ids.filter((id) => !usual.includes(id) && this.defaultOf(id) !== now[id]);
    return this.#history.all(async () => {
      if (usual.length > 0) await fire.restore(...usual);
      if (others.length > 0) await fire.set(Object.fromEntries(others.map((id) => [id, this.defaultOf(id)])));
    }, { anew: false });
  }

  /** @param {string} name */
  preset(name) {
    /** @type {HearthConfig} */
    const config = { hearth: 1, preset: /** @type {HearthConfig['preset']} */ (name), values: {} };
    return this.#history.all(() => this.#fire.importConfig(config), { anew: true });
  }

  /** Shows the scenes to start from, or hides them. */
  scenes() {
    if (this.#card?.isOpen('scenes')) {
      this.#card.close();
      return;
    }
    this.#show(showScenes({
      host: this.#host,
      scenes: PRESETS,
      pictureOf: (name) => beside(`scenes/${name}.jpg`),
      present: () => this.#fire.preset,
      choose: (name) => this.#try(() => this.preset(name)).then(this.#look),
    }));
  }

  /** @param {string} name */
  quality(name) {
    this.#fire.quality = /** @type {HearthFire['quality']} */ (name);
    remember({ quality: name });
  }

  /** What was folded at the last visit. */
  get folds() {
    return remembered();
  }

  /** @type {(folded: string[], times: boolean) => void} */
  rememberFolds(folded, times) {
    remember({ folded, times });
  }

  /** Gives the search the focus. */
  search() {
    this.dispatchEvent(new Event('search'));
  }

  /** What copies the value under the pointer; nothing: the key is not the panel's. */
  get copyHovered() {
    const hovered = this.hovered();
    if (!hovered || !(getSelection()?.isCollapsed ?? true)) return undefined;
    const [value, label] = hovered;
    return () => this.#try(async () => {
      await navigator.clipboard.writeText(value);
      this.#tell('value', `Copied: ${label} ${value}`);
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
   * Copies the fire as it is now; where the browser refuses, shows the text so that
   * it can be copied by hand.
   * @param {string} what  One of {@link COPIES}.
   */
  async copy(what) {
    const label = COPY_LABELS[what];
    const config = await this.#try(() => this.#fire.exportConfig());
    if (!config) return;
    const text = this.#written(what, config);
    try {
      await navigator.clipboard.writeText(text);
      this.#tell(`copy:${what}`, `Copied: ${label}`);
    } catch {
      this.#show(showText({ host: this.#host, title: `Copy the ${label}`, text }));
    }
  }

  /** Asks for settings as JSON. */
  paste() {
    const take = async (/** @type {string} */ text) => {
      await this.#history.all(() => this.#fire.importConfig(text), { anew: true });
      this.#tell('paste', 'The settings are those that were pasted');
    };
    this.#show(askForSettings({ host: this.#host, take }));
  }

  /** Saves the picture of the moment as a file. */
  async picture() {
    const blob = await this.#try(() => this.#fire.toBlob('image/png'));
    if (!blob) return;
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = 'hearth.png';
    link.click();
    // The download has begun by then, also where it asks first.
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
    this.#tell('picture', 'Saved a picture');
  }

  /** All of the screen for the fire, or its page; or the window again. */
  async fullscreen() {
    const whole = this.#page === undefined ? this.#fire : document.documentElement;
    await this.#try(() => (
      document.fullscreenElement ? document.exitFullscreen() : whole.requestFullscreen()
    ));
  }

  /** Shows the keys, or hides them. */
  help() {
    if (this.#card?.isOpen('help')) this.#card.close();
    else this.#show(showKeys({ host: this.#host, fire: this.#fire }));
  }

  /** Ends what is open. */
  close() {
    for (const name of NEWS) this.#fire.removeEventListener(name, this.#look);
    clearTimeout(this.#doneEnds);
    this.#card?.close();
  }

  /** Another scene, or not quite the same any more? */
  #look = () => {
    this.#card?.mark?.();
    const [scene, preset] = [sceneOf(this.#fire), this.#fire.preset];
    if (scene === this.#scene && preset === this.#preset) return;
    [this.#scene, this.#preset] = [scene, preset];
    this.#changed();
  };

  /** The quality of the last visit, unless the page or its address names one. */
  #recallQuality() {
    const fire = this.#fire;
    const { quality } = remembered();
    const names = fire.hasAttribute?.('quality') || fire.quality !== 'auto';
    if (names || (quality !== 'low' && quality !== 'medium' && quality !== 'high')) return;
    fire.quality = quality;
  }

  /** @type {(what: string, config: HearthConfig) => string} */
  #written(what, config) {
    switch (what) {
      case 'link':
        return pageLink(config, this.#page ?? location.href);
      case 'element':
        return elementCode(config, this.#script);
      case 'iframe':
        return iframeCode(config, this.#embed ?? '');
      default:
        return JSON.stringify(config, null, 2);
    }
  }

  /**
   * Does something that the fire or the browser may refuse, and says so then.
   * @template T
   * @param {() => T | Promise<T>} act
   * @returns {Promise<T | undefined>}
   */
  async #try(act) {
    try {
      return await act();
    } catch (error) {
      this.#tell('', error instanceof Error ? error.message : String(error));
      return undefined;
    }
  }

  /** @param {import('./cards.js').Card} card */
  #show(card) {
    this.#card?.close();
    this.#card = card;
  }

  /** @type {(done: string, said: string) => void} */
  #tell(done, said) {
    [this.#done, this.#said] = [done, said];
    clearTimeout(this.#doneEnds);
    this.#doneEnds = setTimeout(() => {
      [this.#done, this.#said] = ['', ''];
      this.#changed();
    }, DONE_MS);
    this.#changed();
  }

  #changed() {
    this.dispatchEvent(new Event('change'));
  }
}

/** What a parameter has in a model unless a scene says otherwise. @type {(id: Id, model: ModelName) => Value | undefined} */
function usualOf(id, model) {
  return DOMAINS.get(id)?.[model]?.default;
}

/** @type {(id: string) => id is Id} */
function isParameter(id) {
  return DOMAINS.has(id);
}

/** The scene that a fire started from. @param {Pick<HearthFire, 'preset' | 'params'>} fire */
function presetOf({ preset: name = 'default' }) {
  return PRESETS.find((preset) => preset.name === name);
}

/** What that scene names, and the model. @param {Pick<HearthFire, 'preset' | 'params'>} fire @returns {Values} */
function valuesOf(fire) {
  return { model: DEFAULT_MODEL, ...presetOf(fire)?.values };
}

/**
 * What a parameter has in the scene, in the present model: there, what the scene says
 * of another model holds for what both share.
 * @type {(fire: Pick<HearthFire, 'preset' | 'params'>, id: Id) => Value | undefined}
 */
function sceneValue(fire, id) {
  const values = valuesOf(fire);
  /** @type {Domains} */
  const domains = DOMAINS.get(id) ?? {};
  const domain = domains[fire.params?.model ?? DEFAULT_MODEL];
  const there = domains[values.model ?? DEFAULT_MODEL];
  const shared = there && PARTS.every((part) => there[part] === domain?.[part]);
  return domain && ((domain === there || shared) ? values[id] ?? domain.default : domain.default);
}

/**
 * The scene that a fire started from, and whether it is another fire by now.
 * @param {Pick<HearthFire, 'preset' | 'params' | 'objects'>} fire
 */
function sceneOf(fire) {
  const scene = presetOf(fire);
  if (!scene) return '';
  const { params } = fire;
  const same = PARAMETERS.every(({ id }) => [undefined, params?.[id]].includes(sceneValue(fire, id)));
  // Every scene has one source.
  const alone = (fire.objects ?? [0]).length === 1;
  return same && alone ? scene.label : `${scene.label}, changed`;
}

/** @param {string} file */
function beside(file) {
  return FOLDER ? new URL(file, FOLDER) : undefined;
}
