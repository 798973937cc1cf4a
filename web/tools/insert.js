/**
 * Words and pictures as solids: a form that asks for a word, and files that a visitor chooses, drops or
 * pastes. Each becomes a mask, whose code is loaded with the first one; nothing of a URL or a file is kept.
 *
 * @typedef {import('./geometry.js').Fields} Fields
 * @typedef {import('./geometry.js').Point} Point
 */

import { element } from '../element/controls/icon-button.js';
import { isSettings, settingsOf } from '../editing/exchange.js';
import { materialOptions } from './bar.js';
import { rounded } from './geometry.js';

/** The largest file [bytes], and the most pixels of an image. */
const MAX_BYTES = 20e6;
const MAX_PIXELS = 40e6;

/** The longest word. */
const MAX_LETTERS = 60;

/** Families that every browser has, and some that most computers have. */
const FAMILIES = [
  'serif',
  'sans-serif',
  'monospace',
  'cursive',
  'Georgia',
  'Impact',
  'Arial Black',
  'Courier New',
  'Brush Script MT',
];

/** Width of a letter [m], and the largest share of the visible width that a word or a picture takes. */
const LETTER = 0.25;
const LARGEST = 0.8;

/** A word that burns is as hot as embers, so that it is read before any wall. */
const GLOWING = { thermal: 'conducting', temperature: 800, heat_capacity: 400 };

/** Words and pictures on one fire. */
export class Inserts {
  #host;
  #overlay;
  #edits;
  #open;
  /** Closes the form that asks for a word. */
  close = () => {};

  /**
   * @param {HTMLElement} host
   * @param {import('./overlay.js').Overlay} overlay
   * @param {import('./edits.js').Edits} edits
   * @param {(config: import('../hearth-fire.js').HearthConfig | string) => Promise<void>} open  Opens settings.
   */
  constructor(host, overlay, edits, open) {
    this.#host = host;
    this.#overlay = overlay;
    this.#edits = edits;
    this.#open = open;
  }

  /**
   * Listens to files that are dropped on `targets` or pasted.
   * @type {(targets: EventTarget[], signal: AbortSignal) => void}
   */
  listen(targets, signal) {
    document.addEventListener('paste', (event) => this.#paste(event), { signal });
    for (const target of targets) {
      target.addEventListener(
        'dragover',
        (event) => {
          if (/** @type {DragEvent} */ (event).dataTransfer?.types.includes('Files')) event.preventDefault();
        },
        { signal },
      );
      target.addEventListener('drop', (event) => this.#drop(/** @type {DragEvent} */ (event)), { signal });
    }
  }

  /** Asks for a word at a point. @param {Point} at */
  askForText(at) {
    this.close();
    const { seen } = this.#overlay;
    const add = (/** @type {Fields} */ fields, /** @type {import('./edits.js').NewSolidStyle} */ style) => {
      // The whole word is seen.
      const aside = Math.max(0, (seen.width - fields.width) / 2);
      const x = Math.min(seen.x + aside, Math.max(seen.x - aside, at.x));
      return this.#edits.add(
        {
          ...fields,
          ...(style.burns && GLOWING),
          plane: 'before',
          x: rounded(x),
          y: rounded(Math.max(at.y, fields.height / 2)),
        },
        style,
      );
    };
    this.close = wordForm(this.#host, seen.width, this.#edits.material, add, () => (this.close = () => {}));
  }

  /**
   * Adds a picture, by default in the middle of what is seen.
   * @type {(file: Blob, at?: Point | null) => Promise<void>}
   */
  picture(file, at) {
    return this.#edits.attempt(async () => {
      const { width, x, y } = this.#overlay.seen;
      const fields = await pictureOf(file, width);
      await this.#edits.add({ ...fields, x: rounded(at?.x ?? x), y: rounded(at?.y ?? y) });
    });
  }

  /** @param {DragEvent} event */
  #drop(event) {
    const [file] = event.dataTransfer?.files ?? [];
    if (!file) return;
    event.preventDefault();
    event.stopPropagation();
    if (isSettings(file)) this.#edits.attempt(async () => this.#open(await settingsOf(file)));
    else this.picture(file, this.#overlay.metres(event));
  }

  /** @param {ClipboardEvent} event */
  #paste(event) {
    const typing = event
      .composedPath()
      .some((node) => /** @type {Partial<Element>} */ (node).matches?.('input, textarea'));
    const [file] = event.clipboardData?.files ?? [];
    if (!file || typing) return;
    event.preventDefault();
    if (isSettings(file)) this.#edits.attempt(async () => this.#open(await settingsOf(file)));
    else this.picture(file);
  }
}

/**
 * Asks for a word.
 * @param {HTMLElement} host  Gets the form.
 * @param {number} across  The width that is seen [m].
 * @param {string} chosen  The material at first.
 * @param {(fields: Fields, style: import('./edits.js').NewSolidStyle) => void} add  Adds the solid, which has no
 *   position yet.
 * @param {() => void} closed
 * @returns {() => void} closes the form
 */
function wordForm(host, across, chosen, add, closed) {
  const text = { spellcheck: 'false', autocomplete: 'off' };
  const word = element('input', { ...text, value: 'FIRE', maxlength: String(MAX_LETTERS) });
  const family = element('input', { ...text, value: 'sans-serif', maxlength: '100', list: 'hearth-families' });
  const families = FAMILIES.map((name) => element('option', { value: name }));
  const material = element('select', {}, ...materialOptions(chosen));
  const burns = element('input', { type: 'checkbox', checked: '' });
  const alert = element('p', { role: 'alert' });
  const done = element('button', { type: 'submit' }, 'Place it');
  const cancel = element('button', { type: 'button' }, 'Cancel');
  const form = element(
    'form',
    { class: 'hearth-text', 'aria-label': 'A word as a solid' },
    element('label', {}, 'Word', word),
    element('label', {}, 'Font', family),
    element('datalist', { id: 'hearth-families' }, ...families),
    element('label', {}, 'Material', material),
    element('label', {}, burns, 'On fire'),
    alert,
    done,
    cancel,
  );
  const close = () => {
    form.remove();
    closed();
  };
  cancel.addEventListener('click', close);
  form.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') close();
    // Letters of the word are no shortcuts.
    event.stopPropagation();
  });
  form.addEventListener('submit', async (event) => {
    event.preventDefault();
    if (done.disabled) return;
    done.disabled = true;
    try {
      const fields = await textOf(word.value, family.value, across);
      if (!form.isConnected) return;
      close();
      add(fields, { material: material.value, burns: burns.checked });
    } catch (error) {
      alert.textContent = error instanceof Error ? error.message : String(error);
    }
    done.disabled = false;
  });
  host.append(form);
  word.select();
  word.focus();
  return close;
}

/**
 * A word as a solid.
 * @param {string} word
 * @param {string} family  A CSS font family, or a list of them.
 * @param {number} across  The width that is seen [m].
 * @returns {Promise<Fields>}
 * @throws {Error} there is no such font, or nothing of the word is seen
 */
async function textOf(word, family, across) {
  if (word.trim() === '') throw new Error('A word has at least one letter.');
  const names = family
    .split(',')
    .map((name) => name.trim().replace(/^(["'])(.*)\1$/, '$2'))
    .filter(Boolean);
  const absent = names.find((name) => !isPresent(name));
  if (absent !== undefined || names.length === 0) throw new Error(`This computer has no font “${absent ?? family}”.`);
  const font = `700 100px ${names.map((name) => (GENERIC.includes(name) ? name : JSON.stringify(name))).join(', ')}`;
  const width = Math.min(LARGEST * across, LETTER * [...word.trim()].length);
  const { maskOfText } = await import('../mask.js');
  return { kind: 'solid', ...maskOfText(word.trim(), font, width) };
}

const GENERIC = ['serif', 'sans-serif', 'monospace', 'cursive', 'fantasy', 'system-ui'];

/** Whether the browser has a font: without it, it shows the letters of the next family. @param {string} name */
function isPresent(name) {
  if (GENERIC.includes(name)) return true;
  const context = document.createElement('canvas').getContext('2d');
  if (!context) return true;
  const widthIn = (/** @type {string} */ font) => {
    context.font = `100px ${font}`;
    return context.measureText('mmmwwwiii0123').width;
  };
  return ['serif', 'monospace'].some((next) => widthIn(`${JSON.stringify(name)}, ${next}`) !== widthIn(next));
}

/**
 * An image file as a solid: what is opaque in it.
 * @param {Blob} file
 * @param {number} across  The width that is seen [m].
 * @returns {Promise<Fields>}
 * @throws {Error} it is no image, too large, or nothing in it is opaque
 */
async function pictureOf(file, across) {
  const name = 'name' in file && file.name ? `“${file.name}”` : 'What was pasted';
  if (!file.type.startsWith('image/')) throw new Error(`${name} is no image.`);
  if (file.size > MAX_BYTES)
    throw new Error(`${name} has ${Math.round(file.size / 1e6)} MB; an image has at most ${MAX_BYTES / 1e6} MB.`);
  if (file.type.includes('svg')) {
    const { MAX_DRAWN, elementsDrawn } = await import('../mask/svg-elements.js');
    if (elementsDrawn(await file.text()) > MAX_DRAWN) throw new Error(`${name} draws more than ${MAX_DRAWN} elements.`);
  }
  const image = new Image();
  const url = URL.createObjectURL(file);
  try {
    const { maskOfImage } = await import('../mask.js');
    image.src = url;
    await new Promise((resolve, reject) => {
      image.onload = resolve;
      image.onerror = () => reject(new Error(`${name} cannot be read as an image.`));
    });
    const pixels = image.naturalWidth * image.naturalHeight;
    if (pixels > MAX_PIXELS)
      throw new Error(`${name} has ${Math.round(pixels / 1e6)} megapixels; an image has at most ${MAX_PIXELS / 1e6}.`);
    return { kind: 'solid', ...maskOfImage(image, 0.4 * across) };
  } finally {
    URL.revokeObjectURL(url);
  }
}
