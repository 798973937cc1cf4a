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

/** The weights of letters. */
const WEIGHTS = [
  ['Regular', '400'],
  ['Semi-bold', '600'],
  ['Bold', '800'],
];

/** The largest share of the visible width that a word takes, and that of a picture. */
const LARGEST = 0.8;
const PICTURE = 0.4;

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
    this.close = wordForm(this.#host, seen.width, add, () => (this.close = () => {}));
  }

  /**
   * Adds a picture, by default in the middle of what is seen.
   * @type {(file: Blob, at?: Point | null) => Promise<void>}
   */
  picture(file, at) {
    return this.#edits.attempt(async () => {
      const { width, x, y } = this.#overlay.seen;
      const { maskOfFile } = await import('../mask/file.js');
      const fields = await maskOfFile(file, PICTURE * width);
      await this.#edits.add({ kind: 'solid', ...fields, x: rounded(at?.x ?? x), y: rounded(at?.y ?? y) });
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
 * @param {(fields: Fields, style: import('./edits.js').NewSolidStyle) => void} add  Adds the solid, which has no
 *   position yet.
 * @param {() => void} closed
 * @returns {() => void} closes the form
 */
function wordForm(host, across, add, closed) {
  const text = { spellcheck: 'false', autocomplete: 'off' };
  const word = element('input', { ...text, value: 'FIRE', maxlength: String(MAX_LETTERS) });
  const family = element('input', { ...text, value: 'sans-serif', maxlength: '100', list: 'hearth-families' });
  const families = FAMILIES.map((name) => element('option', { value: name }));
  const weight = element(
    'select',
    {},
    ...WEIGHTS.map(([name, value]) => new Option(name, value, false, value === '800')),
  );
  const widest = LARGEST * across;
  const size = element('input', {
    type: 'range',
    min: '0.1',
    max: '1',
    step: '0.05',
    value: '0.6',
    'aria-label': 'Size',
  });
  const preview = element('output', { 'aria-hidden': 'true' });
  // Coal glows, so the word is read before any wall.
  const material = element('select', {}, ...materialOptions('coal'));
  const showPreview = () => {
    preview.textContent = word.value;
    Object.assign(preview.style, { fontFamily: family.value, fontWeight: weight.value });
    preview.style.fontSize = `${16 + 32 * Number(size.value)}px`;
  };
  const burns = element('input', { type: 'checkbox', checked: '' });
  const alert = element('p', { role: 'alert' });
  const done = element('button', { type: 'submit' }, 'Place it');
  const cancel = element('button', { type: 'button' }, 'Cancel');
  const form = element(
    'form',
    { class: 'hearth-text', 'aria-label': 'A word as a solid' },
    element('label', {}, 'Word', word),
    preview,
    element('label', { class: 'half' }, 'Font', family),
    element('label', { class: 'half' }, 'Weight', weight),
    element('label', {}, 'Size', size),
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
      const style = { family: family.value, weight: weight.value, width: widest * Number(size.value) };
      const fields = await textOf(word.value, style);
      if (!form.isConnected) return;
      close();
      add(fields, { material: material.value, burns: burns.checked });
    } catch (error) {
      alert.textContent = error instanceof Error ? error.message : String(error);
    }
    done.disabled = false;
  });
  form.addEventListener('input', showPreview);
  showPreview();
  host.append(form);
  word.select();
  word.focus();
  return close;
}

/**
 * A word as a solid.
 * @param {string} word
 * @param {{family: string, weight: string, width: number}} style  A CSS font family, or a list of them; its weight; the
 *   width of the word [m].
 * @returns {Promise<Fields>}
 * @throws {Error} there is no such font, or nothing of the word is seen
 */
async function textOf(word, { family, weight, width }) {
  if (word.trim() === '') throw new Error('A word has at least one letter.');
  const names = family
    .split(',')
    .map((name) => name.trim().replace(/^(["'])(.*)\1$/, '$2'))
    .filter(Boolean);
  const absent = names.find((name) => !isPresent(name));
  if (absent !== undefined || names.length === 0) throw new Error(`This computer has no font “${absent ?? family}”.`);
  const font = `${weight} 100px ${names.map((name) => (GENERIC.includes(name) ? name : JSON.stringify(name))).join(', ')}`;
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
