/**
 * Write your word: a form in which a visitor types a word or chooses a logo, which burns at once. It is loaded with the
 * first word.
 */

import { maskOfFile } from '../../mask/file.js';
import { maskOfImage } from '../../mask.js';
import { shareLink } from '../share-link.js';
import { linesOf, sceneOf } from './scene.js';

/** The pause of typing after which a word burns [ms]. */
const TYPING_MS = 300;

/** Height of a line of letters in its font, the font, and the most pixels across. */
const LINE = 1.1;
const FONT = 'system-ui, "Noto Sans", sans-serif';
const PIXELS = 2048;

/** The forms of fires. @type {WeakMap<HTMLElement, WordForm>} */
const FORMS = new WeakMap();

/**
 * Shows the form.
 * @param {HTMLFormElement} form
 * @param {import('../../hearth-fire.js').HearthFire} fire
 * @param {(message: string) => void} notify
 * @param {File} [file]  A logo that burns at once.
 */
export function openWord(form, fire, notify, file) {
  const opened = FORMS.get(form) ?? new WordForm(form, fire, notify);
  FORMS.set(form, opened);
  opened.show(file);
}

class WordForm {
  #form;
  #fire;
  #notify;
  #input;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #planned;
  /** A number of each showing: its words are one step of undo. */
  #shown = 0;

  /**
   * @param {HTMLFormElement} form
   * @param {import('../../hearth-fire.js').HearthFire} fire
   * @param {(message: string) => void} notify
   */
  constructor(form, fire, notify) {
    this.#form = form;
    this.#fire = fire;
    this.#notify = notify;
    this.#input = /** @type {HTMLInputElement} */ (form.querySelector('input[name=word]'));
    const file = /** @type {HTMLInputElement} */ (form.querySelector('input[type=file]'));
    this.#input.addEventListener('input', () => {
      clearTimeout(this.#planned);
      this.#planned = setTimeout(() => this.#write(), TYPING_MS);
    });
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      clearTimeout(this.#planned);
      this.#write();
      // On a phone, the keyboard makes room for the fire.
      this.#input.blur();
    });
    form.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.#close();
      // Letters of the word are no shortcuts.
      event.stopPropagation();
    });
    file.addEventListener('change', () => {
      this.#burn(file.files?.[0]);
      // The same file can be chosen again.
      file.value = '';
    });
    const act = (/** @type {string} */ name, /** @type {() => unknown} */ press) =>
      form.querySelector(`[data-act=${name}]`)?.addEventListener('click', press);
    act('logo', () => file.click());
    act('close', () => this.#close());
    act('share', () => this.#share());
  }

  /** @param {File} [file] */
  show(file) {
    this.#shown += 1;
    this.#form.hidden = false;
    document.documentElement.dataset.word = 'shown';
    this.#input.focus();
    this.#input.select();
    if (file) this.#burn(file);
    else this.#write();
  }

  #close() {
    this.#form.hidden = true;
    delete document.documentElement.dataset.word;
    document.querySelector('#head [data-opens=word]')?.dispatchEvent(new Event('closed'));
  }

  /** The word burns; without a letter, the last one burns on. */
  #write() {
    const lines = linesOf(this.#input.value);
    if (lines.length > 0) this.#show(() => maskOfLines(lines));
  }

  /** A logo burns. @param {File | undefined} file */
  #burn(file) {
    if (file) this.#show(() => maskOfFile(file, 1));
  }

  /** @param {() => import('../../mask.js').HearthMask | Promise<import('../../mask.js').HearthMask>} draw */
  async #show(draw) {
    try {
      const config = sceneOf(await draw());
      await this.#fire.history.step(() => this.#fire.importConfig(config), `word ${this.#shown}`);
    } catch (error) {
      this.#notify(error instanceof Error ? error.message : String(error));
    }
  }

  /** Shares the link, which has the word in its fragment. */
  async #share() {
    try {
      await shareLink(this.#fire);
    } catch (error) {
      this.#notify(error instanceof Error ? error.message : String(error));
    }
    if (!navigator.share) this.#notify('The link is copied.');
  }
}

/** Lines of letters, one below the other, as wide as the widest. @param {string[]} lines */
function maskOfLines(lines) {
  const context = /** @type {CanvasRenderingContext2D} */ (document.createElement('canvas').getContext('2d'));
  const style = (/** @type {number} */ size) => {
    context.font = `800 ${size}px ${FONT}`;
    return lines.map((line) => context.measureText(line));
  };
  const widest = Math.max(...style(100).map((ink) => ink.actualBoundingBoxLeft + ink.actualBoundingBoxRight));
  const size = Math.min((100 * PIXELS) / Math.max(widest, 1), 400);
  const inks = style(size);
  const left = Math.max(...inks.map((ink) => ink.actualBoundingBoxLeft));
  const above = Math.max(inks[0].actualBoundingBoxAscent, 1);
  const last = inks[inks.length - 1];
  const [right] = [Math.max(...inks.map((ink) => ink.actualBoundingBoxRight))];
  context.canvas.width = Math.ceil(left + right) || 1;
  context.canvas.height = Math.ceil(above + (lines.length - 1) * LINE * size + last.actualBoundingBoxDescent) || 1;
  style(size);
  lines.forEach((line, at) => {
    const [ink] = [inks[at]];
    const aside = (left + right - ink.actualBoundingBoxLeft - ink.actualBoundingBoxRight) / 2;
    context.fillText(line, aside + ink.actualBoundingBoxLeft, above + at * LINE * size);
  });
  return maskOfImage(context.canvas, 1);
}
