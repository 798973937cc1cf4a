/**
 * The panel of the page: beside the fire on a wide screen, a sheet below it on a narrow one. On a narrow
 * screen its code is loaded when the visitor opens it.
 */

import { recall, remember } from './memory.js';
import { areSilent } from '../panel/keys.js';

/** Where the panel has room beside the fire and opens by itself. */
const WIDE = '(width >= 720px) and (height >= 480px)';

/** Longest wait for a moment without work, before the panel loads [ms]. */
const IDLE_MS = 1500;

/** The panel, the button that shows and hides it, and the keys that work without it. */
export class PagePanel {
  #fire;
  #root = document.documentElement;
  #host = /** @type {HTMLElement} */ (document.getElementById('panel'));
  #toggle = /** @type {HTMLElement} */ (document.getElementById('toggle'));
  #wide = matchMedia(WIDE);
  /** Whether the panel is loaded, or loading. */
  #asked = false;
  /** Whether the panel hears keys itself. */
  #hears = false;
  /** What was shown before the full screen. */
  #before = false;

  /** @param {import('../hearth-fire.js').HearthFire} fire */
  constructor(fire) {
    this.#fire = fire;
    this.#set(this.#wide.matches && recall('panel') !== 'hidden');
    this.#toggle.addEventListener('click', () => this.#choose(!this.#shown));
    document.addEventListener('keydown', (event) => this.#key(event));
    document.addEventListener('fullscreenchange', () => this.#fullscreen());
  }

  /** The fire burns: the panel may load, where it stands open. */
  begin() {
    const load = () => this.#shown && this.#load();
    if ('requestIdleCallback' in window) requestIdleCallback(load, { timeout: IDLE_MS });
    else setTimeout(load);
  }

  /** There is no fire to control. */
  drop() {
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

  /** Somebody shows or hides it. @param {boolean} shown */
  #choose(shown) {
    if (this.#toggle.hidden) return;
    this.#set(shown);
    // On a small screen the fire has the screen at every visit.
    if (this.#wide.matches && !document.fullscreenElement) remember('panel', shown ? 'shown' : 'hidden');
    if (shown) this.#load();
  }

  /** The full screen is for the fire alone; the key H brings the panel there. */
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
    const { key, ctrlKey, metaKey, altKey, shiftKey, repeat } = event;
    if (ctrlKey || metaKey || altKey || repeat || event.defaultPrevented || isTyping(event)) return;
    const [target, ...around] = event.composedPath();
    const near = [document.body, this.#root, this.#toggle].some((place) => place === target)
      || [this.#host, this.#fire].some((place) => around.includes(place) || place === target);
    if (!near || areSilent(this.#host, this.#fire)) return;
    if (key.toLowerCase() === 'h') this.#choose(!this.#shown);
    // The panel hears the other keys, once it is there.
    if (this.#hears || shiftKey) return;
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

  /** Loads the panel once, or says why it is not there. */
  async #load() {
    if (this.#asked) return;
    this.#asked = true;
    try {
      const { mountPanel } = await import('../panel.js');
      this.#hears = true;
      await mountPanel({ host: this.#host, fire: this.#fire, page: location.href });
    } catch (error) {
      this.#hears = this.#asked = false;
      console.warn('Hearth: the panel could not be loaded.', error);
      const words = document.createElement('p');
      words.className = 'words';
      words.textContent = 'The controls could not be loaded. The fire burns without them.';
      this.#host.replaceChildren(words);
    }
  }
}

/**
 * Whether a key belongs to what is being typed.
 * @param {KeyboardEvent} event
 */
function isTyping(event) {
  const target = event.composedPath()[0];
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement) return !['range', 'checkbox', 'button'].includes(target.type);
  return target.isContentEditable || ['TEXTAREA', 'SELECT'].includes(target.tagName);
}
