/**
 * Examples that burn when the reader asks for it, and that the reader may change: the text of one stands in the fragment
 * of the address, and nothing of a fragment runs before a press of *Run*. One example burns at a time.
 */

import { LONGEST, build, change, markupOf } from './markup.js';

/** What each example begins with, which the page does itself: the reader changes what follows. */
const BEGINNING = /^\s*<!doctype html>\s*<script type="module" src="\.\/web\/hearth-fire\.js"><\/script>\n?/;

/** How long the reader has not typed before the address has the text [ms]: browsers limit its changes. */
const PAUSE = 300;

/** The example that burns. @type {Example | undefined} */
let burning;

/** The number of the example and the text that a fragment names. @param {string} hash */
export function editOf(hash) {
  const [, number, code = ''] = hash.match(/^#edit-(\d{1,3})=(.*)$/s) ?? [];
  if (!number || code.length > 9 * LONGEST) return undefined;
  try {
    return { number: Number(number), text: decodeURIComponent(code) };
  } catch {
    return undefined;
  }
}

/** Shows the buttons of each example below a node, and the text of the address. @param {ParentNode} root */
export function runExamples(root) {
  const found = [...root.querySelectorAll('.example')];
  const examples = found.map((place, at) => new Example(/** @type {HTMLElement} */ (place), at + 1));
  const open = () => {
    const edit = editOf(location.hash);
    if (edit) examples[edit.number - 1]?.open(edit.text);
  };
  addEventListener('hashchange', open);
  open();
}

/** An example of the page. */
class Example {
  #place;
  #number;
  /** The text of the document. */
  #original;
  #beginning;
  #listing;
  #run = button('Run', () => (burning === this ? this.#stop() : this.#start()));
  #edit = button('Edit', () => (this.#field ? this.#close() : this.open(this.#original)));
  #copy = button('Copy', () => this.#copied());
  #status = document.createElement('p');
  /** The field with the text, while the reader changes it. @type {HTMLTextAreaElement | undefined} */
  #field;
  /** Where it burns, and what of. @type {{place: HTMLElement, markup: import('./markup.js').Markup[]} | undefined} */
  #fire;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #writing;

  /** @param {HTMLElement} place @param {number} number  On its page, from 1. */
  constructor(place, number) {
    this.#place = place;
    this.#number = number;
    this.#listing = /** @type {HTMLElement} */ (place.querySelector('pre'));
    const code = this.#listing.textContent ?? '';
    this.#beginning = code.match(BEGINNING)?.[0] ?? '';
    this.#original = code.slice(this.#beginning.length).trimEnd();
    this.#status.setAttribute('role', 'status');
    const buttons = document.createElement('p');
    buttons.append(this.#run, this.#edit, this.#copy);
    place.append(buttons, this.#status);
  }

  /** The text, changed or not. */
  get #text() {
    return this.#field?.value ?? this.#original;
  }

  /** Shows a text to change. @param {string} text */
  open(text) {
    if (!this.#field) {
      const field = document.createElement('textarea');
      field.setAttribute('aria-label', `${this.#listing.getAttribute('aria-label')}, to change`);
      field.maxLength = LONGEST;
      field.spellcheck = false;
      field.addEventListener('input', () => this.#typed());
      this.#listing.after(field);
      this.#listing.hidden = true;
      this.#field = field;
      this.#edit.textContent = 'Original';
    }
    if (this.#field.value === text) return;
    this.#field.value = text;
    this.#field.rows = Math.min(text.split('\n').length + 2, 30);
    this.#place.scrollIntoView({ block: 'nearest' });
    this.#show();
  }

  /** Back to the text of the document. */
  #close() {
    clearTimeout(this.#writing);
    this.#field?.remove();
    this.#field = undefined;
    this.#listing.hidden = false;
    this.#edit.textContent = 'Edit';
    history.replaceState(null, '', location.pathname + location.search);
    this.#show();
  }

  #typed() {
    this.#show();
    clearTimeout(this.#writing);
    this.#writing = setTimeout(() => {
      history.replaceState(null, '', `#edit-${this.#number}=${encodeURIComponent(this.#text)}`);
    }, PAUSE);
  }

  /** Says what is wrong with the text; a fire that burns becomes that of the text, or stays the last one. */
  #show() {
    const markup = this.#markup();
    if (!markup || !this.#fire) return;
    change(this.#fire.place, this.#fire.markup, markup);
    this.#fire.markup = markup;
  }

  #markup() {
    try {
      const markup = markupOf(this.#text);
      this.#status.textContent = '';
      return markup;
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      this.#status.textContent = error.message;
      return undefined;
    }
  }

  #start() {
    const markup = this.#markup();
    if (!markup) return;
    if (burning) burning.#stop();
    const place = document.createElement('div');
    place.className = 'burning';
    build(place, markup);
    this.#place.append(place);
    place.scrollIntoView({ block: 'nearest' });
    this.#fire = { place, markup };
    burning = this;
    this.#run.textContent = 'Stop';
    import('../hearth-fire.js').catch(() => {
      place.textContent = 'The code of the fire did not load. Load the page again.';
      this.#fire = undefined;
    });
  }

  #stop() {
    this.#place.querySelector('.burning')?.remove();
    this.#fire = undefined;
    this.#run.textContent = 'Run';
    if (burning === this) burning = undefined;
  }

  async #copied() {
    try {
      await navigator.clipboard.writeText(`${this.#beginning}${this.#text}\n`);
      this.#status.textContent = 'Copied: a whole page, to put beside the folder web.';
    } catch {
      this.#status.textContent = 'The browser does not let this page copy.';
    }
  }
}

/** @param {string} label @param {() => void} act */
function button(label, act) {
  const made = document.createElement('button');
  made.type = 'button';
  made.textContent = label;
  made.addEventListener('click', act);
  return made;
}
