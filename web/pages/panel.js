/**
 * The panel of the page: beside the fire on a wide screen, a sheet below it on a narrow one. On a narrow
 * screen its code is loaded when the visitor opens it.
 */

import { recall, remember } from './memory.js';
import { hasNoDialog, historyKey, isTaken, keyOf, shortcutsOff } from '../editing/keys.js';

/** The screens on which the panel stands beside the fire and opens by itself. */
const WIDE = '(width >= 720px) and (height >= 480px)';

/** The maximum wait for an idle moment before the panel loads [ms]. */
const IDLE_MS = 1500;

/** The panel, the button that shows and hides it, and the keys that work without it. */
export class PagePanel {
  #fire;
  #notify;
  #root = document.documentElement;
  #host = /** @type {HTMLElement} */ (document.getElementById('panel'));
  #toggle = /** @type {HTMLElement} */ (document.getElementById('toggle'));
  #wide = matchMedia(WIDE);
  /** Settles when the panel is loaded; undefined before it loads. @type {Promise<void> | undefined} */
  #loading;
  /** Whether the panel handles keys itself. */
  #hasKeys = false;
  /** Whether the panel was shown before full screen. */
  #before = false;

  /**
   * @param {import('../hearth-fire.js').HearthFire} fire
   * @param {(message: string) => void} notify
   */
  constructor(fire, notify) {
    this.#fire = fire;
    this.#notify = notify;
    this.#set(this.#wide.matches && recall('panel') !== 'hidden');
    this.#toggle.addEventListener('click', () => this.#choose(!this.#shown));
    document.addEventListener('keydown', (event) => this.#key(event));
    document.addEventListener('fullscreenchange', () => this.#fullscreen());
    // A browser drops files only where the event is cancelled; a file that nobody takes replaces the page.
    document.addEventListener('dragover', (event) => {
      if (event.dataTransfer?.types.includes('Files')) event.preventDefault();
    });
    document.addEventListener('drop', (event) => this.#drop(event));
  }

  /** Shows the panel, whatever the visitor has chosen before. */
  show() {
    this.#set(true);
  }

  /** The fire burns: loads the panel if it is open. */
  begin() {
    const load = () => this.#shown && this.#load();
    if ('requestIdleCallback' in window) requestIdleCallback(load, { timeout: IDLE_MS });
    else setTimeout(load);
  }

  /** There is no fire to control. */
  remove() {
    this.#set(false);
    this.#toggle.hidden = true;
  }

  get #shown() {
    return this.#root.dataset.panel === 'shown';
  }

  /** @param {boolean} shown */
  #set(shown) {
    this.#root.dataset.panel = shown ? 'shown' : 'hidden';
    this.#toggle.setAttribute('aria-expanded', String(shown));
  }

  /** The visitor shows or hides the panel. @param {boolean} shown */
  #choose(shown) {
    if (this.#toggle.hidden) return;
    this.#set(shown);
    // On a small screen the panel starts hidden at every visit.
    if (this.#wide.matches && !document.fullscreenElement) remember('panel', shown ? 'shown' : 'hidden');
    if (shown) this.#load();
  }

  /** Full screen hides the panel; the key H shows it there. */
  #fullscreen() {
    if (document.fullscreenElement) {
      this.#before = this.#shown;
      this.#set(false);
    } else if (this.#before) {
      this.#set(true);
    }
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const { ctrlKey, metaKey, altKey, shiftKey, repeat } = event;
    const key = keyOf(event);
    if (event.defaultPrevented || isTaken(event)) return;
    const [target, ...around] = event.composedPath();
    const move = historyKey(event);
    // Once they are loaded, the panel and the tools handle these keys.
    if (move && !this.#hasKeys && this.#root.dataset.tools !== 'shown' && hasNoDialog(target)) {
      event.preventDefault();
      // The fire reports a refusal.
      this.#fire.history[move]().catch(() => {});
    }
    if (ctrlKey || metaKey || altKey || repeat) return;
    const near =
      [document.body, this.#root, this.#toggle].some((element) => element === target) ||
      [this.#host, this.#fire].some((element) => around.includes(element) || element === target);
    if (!near || shortcutsOff(this.#host, this.#fire)) return;
    if (key === 'h') this.#choose(!this.#shown);
    // The panel shows their cards and its search.
    const shows = ['s', '?', '/'].includes(key) && (!shiftKey || key === '?' || key === '/');
    if (shows && !this.#shown) this.#choose(true);
    // The panel handles the other keys once it is loaded.
    if (this.#hasKeys) return;
    if (shows || '+=-0r'.includes(key)) {
      event.preventDefault();
      // The target may be gone by then.
      this.#load().then(() => {
        const again = new KeyboardEvent('keydown', { key, shiftKey, bubbles: true, composed: true });
        if (this.#hasKeys) document.body.dispatchEvent(again);
      });
      return;
    }
    if (shiftKey) return;
    if (key === 'f') {
      const { fullscreenElement, documentElement } = document;
      const asked = fullscreenElement ? document.exitFullscreen() : documentElement.requestFullscreen?.();
      asked?.catch(() => {});
    } else if (key === ' ' && event.target === document.body) {
      event.preventDefault();
      if (this.#fire.paused) this.#fire.play();
      else this.#fire.pause();
    }
  }

  /** Opens a file of settings, unless the panel or a tool has taken it. @param {DragEvent} event */
  async #drop(event) {
    const [file] = event.dataTransfer?.files ?? [];
    if (!file || this.#hasKeys || event.defaultPrevented) return;
    event.preventDefault();
    try {
      const { isSettings, settingsOf } = await import('../editing/exchange.js');
      if (!isSettings(file)) throw new Error(`“${file.name}” is no file of settings, whose name ends in “.json”.`);
      await this.#fire.importConfig(await settingsOf(file));
    } catch (error) {
      this.#notify(/** @type {Error} */ (error).message);
    }
  }

  /** Loads the panel once; shows a message if it does not load. */
  #load() {
    this.#loading ??= this.#mount();
    return this.#loading;
  }

  async #mount() {
    try {
      const { mountPanel } = await import('../panel.js');
      this.#hasKeys = true;
      await mountPanel({ host: this.#host, fire: this.#fire, page: location.href });
    } catch (error) {
      this.#hasKeys = false;
      this.#loading = undefined;
      console.warn('Hearth: the panel could not be loaded.', error);
      const message = document.createElement('p');
      message.className = 'words';
      message.textContent =
        'The controls could not be loaded. The fire burns without them. Close and open the panel to try again.';
      this.#host.replaceChildren(message);
    }
  }
}
