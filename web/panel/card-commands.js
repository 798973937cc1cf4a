/**
 * The commands of the panel that open a card, or that leave the page and come back: scenes, copies, files, pictures.
 */

import { askForSettings, offerFile, showKeys, showText } from './cards.js';
import { saveSettings } from '../editing/download.js';
import { editingOf } from '../editing/editing.js';
import { COPIES, isSettings, settingsOf, shownAs, textOf, urlBesideModule } from '../editing/exchange.js';
import { ownScenesOf } from './own-scenes.js';
import { Report } from './report.js';
import { showScenes } from './scenes.js';
import { PRESETS } from '../parameters.js';
import { pageLink } from '../share.js';

/** How long a button confirms its action [ms]. */
const DONE_MS = 2000;

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../hearth-fire.js').HearthConfig} HearthConfig
 *
 * @typedef {object} PanelOptions
 * @property {HearthFire} fire
 * @property {HTMLElement} host  The element of the panel and its cards.
 * @property {string | URL} [page]  The URL of a page that applies its URL parameters.
 * @property {string | URL} [script]  The URL of `hearth-fire.js` for other pages.
 * @property {string | URL} [embed]  The URL of `embed.html` for other pages.
 * @property {string[]} [only]  The parameters that the panel shows.
 */

/** The cards of one panel, of which one at most is open, and the message about the last action. */
export class CardCommands extends EventTarget {
  #fire;
  #host;
  #addresses;
  #report;
  /** @type {import('./cards.js').Card | undefined} */
  #card;
  /** @type {number | undefined} */
  #doneEnds;
  /** The button whose action has just succeeded. */
  done = '';
  /** About the last action, a success or a failure. */
  message = '';

  /** @param {PanelOptions} options */
  constructor({ fire, host, page, script = urlBesideModule('hearth-fire.js'), embed = urlBesideModule('embed.html') }) {
    super();
    this.#fire = fire;
    this.#host = host;
    this.#addresses = { page, script, embed };
    this.#report = new Report(fire);
  }

  /** Shows the fire of settings: one step. @param {HearthConfig | string} config */
  async replace(config) {
    await editingOf(this.#fire).group()(() => this.#fire.importConfig(config));
  }

  /**
   * Does something that the fire or the browser may refuse; a refusal becomes a message.
   * @template T
   * @param {() => T | Promise<T>} act
   * @returns {Promise<T | undefined>}
   */
  async attempt(act) {
    try {
      return await act();
    } catch (error) {
      this.notify('', error instanceof Error ? error.message : String(error));
      return undefined;
    }
  }

  /** Shows a message for a while, and which button has succeeded. @type {(done: string, message: string) => void} */
  notify(done, message) {
    [this.done, this.message] = [done, message];
    clearTimeout(this.#doneEnds);
    this.#doneEnds = setTimeout(() => {
      [this.done, this.message] = ['', ''];
      this.changed();
    }, DONE_MS);
    this.changed();
  }

  changed = () => {
    this.dispatchEvent(new Event('change'));
  };

  /** The forms that the page can copy: a link needs its URL, an iframe that of `embed.html`. */
  get copies() {
    const { page, embed } = this.#addresses;
    return COPIES.filter(
      ({ name }) => (name !== 'link' || page !== undefined) && (name !== 'iframe' || embed !== undefined),
    );
  }

  /** Shows or hides the card of scenes. */
  scenes() {
    if (this.#card?.isOpen('scenes')) {
      this.#card.close();
      return;
    }
    this.#show(
      showScenes({
        host: this.#host,
        scenes: PRESETS,
        pictureOf: (name) => urlBesideModule(`scenes/${name}.jpg`),
        current: () => this.#fire.preset,
        choose: (name) => this.attempt(() => this.replace(settingsOfPreset(name))),
        own: ownScenesOf(this.#fire, (config) => this.replace(config)),
      }),
    );
  }

  /** Shows the fire of a file that a visitor has dropped, or a message why not. @param {File} file */
  open(file) {
    return this.attempt(async () => {
      if (!isSettings(file)) throw new Error(`“${file.name}” is no file of settings, whose name ends in “.json”.`);
      await this.replace(await settingsOf(file));
      this.notify('', `Opened “${file.name}”`);
    });
  }

  /**
   * Copies the fire in one of several forms. If the browser refuses, a card shows the text.
   * @param {string} name  Of one of `COPIES`.
   */
  async copy(name) {
    const label = COPIES.find((form) => form.name === name)?.label;
    const config = await this.attempt(() => this.#fire.exportConfig());
    const { page } = this.#addresses;
    // A fire that has failed has a report alone.
    if (!config && name !== 'report') return;
    let text;
    try {
      text =
        name === 'report'
          ? this.#report.text(page && config && (await pageLink(config, page).catch(() => undefined)), config)
          : await textOf(name, /** @type {HearthConfig} */ (config), this.#addresses, shownAs(this.#fire));
    } catch (error) {
      const { message } = /** @type {Error} */ (error);
      this.notify('', message);
      this.#show(offerFile({ host: this.#host, title: `No ${label}`, why: message, save: () => saveSettings(config) }));
      return;
    }
    try {
      await navigator.clipboard.writeText(text);
      this.notify(`copy:${name}`, `Copied: ${label}`);
    } catch {
      this.#show(showText({ host: this.#host, title: `Copy the ${label}`, text }));
    }
  }

  /** Asks for settings as JSON. */
  paste() {
    const apply = async (/** @type {string} */ text) => {
      await this.replace(text);
      this.notify('paste', 'The pasted settings are applied');
    };
    this.#show(askForSettings({ host: this.#host, apply }));
  }

  /** Opens the dialog that saves an image or a film. */
  picture() {
    return this.attempt(async () => {
      const { openRecorder } = await import('../record/dialog.js');
      openRecorder(this.#fire, (message) => this.notify('picture', message));
    });
  }

  /** Shows or hides the list of shortcuts. */
  help() {
    if (this.#card?.isOpen('help')) this.#card.close();
    else this.#show(showKeys({ host: this.#host, fire: this.#fire }));
  }

  /** @param {import('./cards.js').Card} card */
  #show(card) {
    this.#card?.close();
    this.#card = card;
  }

  /** Marks the current item of the card. */
  mark() {
    this.#card?.mark?.();
  }

  /** Closes the card and stops listening. */
  close() {
    clearTimeout(this.#doneEnds);
    this.#report.close();
    this.#card?.close();
  }
}

/** The settings of a preset. @param {string} name @returns {HearthConfig} */
function settingsOfPreset(name) {
  return { hearth: 3, preset: /** @type {HearthConfig['preset']} */ (name), values: {} };
}
