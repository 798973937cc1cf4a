/**
 * The dialog that embeds a fire in another page: a preview on the ground of that page, the choices, and the code. The
 * preview has the attributes that the code has.
 *
 * @typedef {import('../../hearth-fire.js').HearthFire} HearthFire
 */

import { element } from '../../element/controls/icon-button.js';
import { elementAttributes } from '../../share.js';
import { shareLink } from '../share-link.js';
import { FORMS, codeOf, valuesOn } from './codes.js';

/** The grounds of pages on which the preview is shown. */
const GROUNDS = ['Black', 'White', 'Brick', 'Picture'];

/** The choices of `fit` and `align`, the first of which is written nowhere. */
const FITS = ['height', 'contain', 'cover', 'width'];
const ALIGNS = ['center bottom', 'center', 'left bottom', 'right bottom', 'center top'];

/** The size of the element at first, and its limits [CSS px]. */
const SIZE = { width: 320, height: 400 };
const [SMALLEST, LARGEST] = [40, 4096];

/** The files of an element and its engine. */
const FILES =
  /\/(hearth-fire\.js|(element|engine|generated)\/[\w/-]+\.js|parts\.js|wasm\/hearth-engine[\w-]*\.(js|wasm))$/;

/**
 * Fills the dialog for a fire, and shows it.
 * @param {HTMLDialogElement} dialog
 * @param {HearthFire} fire
 */
export async function openEmbed(dialog, fire) {
  const form = new EmbedForm(dialog, fire, await fire.exportConfig());
  dialog.showModal();
  await form.show();
}

/** The dialog of one opening. */
class EmbedForm {
  #fire;
  #config;
  #preview = element('div', { class: 'preview', 'data-ground': 'black' });
  #code = element('textarea', { readonly: '', rows: '8', spellcheck: 'false', 'aria-label': 'Code' });
  #note = element('p', { class: 'note' });
  #copied = element('p', { id: 'copied', role: 'status' });
  /** @type {{[name: string]: HTMLInputElement | HTMLSelectElement}} */
  #fields = {};
  /** A number of each showing: a later one replaces those before. */
  #shown = 0;

  /**
   * @param {HTMLDialogElement} dialog
   * @param {HearthFire} fire
   * @param {import('../../hearth-fire.js').HearthConfig} config
   */
  constructor(dialog, fire, config) {
    this.#fire = fire;
    this.#config = config;
    const grounds = this.#select('ground', 'Page', GROUNDS);
    const sizes = /** @type {const} */ (['width', 'height']).map((side) => {
      const field = element('input', { type: 'number', min: `${SMALLEST}`, max: `${LARGEST}`, value: `${SIZE[side]}` });
      return this.#field(side, side === 'width' ? 'Width' : 'Height', field);
    });
    const fit = this.#select('fit', 'Fit', FITS, fire.getAttribute('fit') ?? FITS[0]);
    const align = this.#select('align', 'Align', ALIGNS, fire.getAttribute('align') ?? ALIGNS[0]);
    const behind = this.#select('behind', 'Behind', ['as the scene', 'the page alone']);
    const flags = [
      ['warm', 'Burns from the start', true],
      ['interactive', 'Reacts to pointers', fire.interactive],
      ['decorative', 'Decoration: no button', false],
    ].map(([name, label, on]) => {
      const box = element('input', { type: 'checkbox', ...(on && { checked: '' }) });
      return this.#field(String(name), String(label), box);
    });
    const forms = this.#select('form', 'Code for', []);
    forms.querySelector('select')?.append(...FORMS.map(([name, label]) => new Option(label, name)));
    const copy = element('button', { type: 'button', 'data-copies': 'code' }, 'Copy');
    const share = element(
      'button',
      { type: 'button', 'data-act': 'share' },
      'share' in navigator ? 'Share a link' : 'Copy a link',
    );
    copy.addEventListener('click', () => this.#copy());
    share.addEventListener('click', () => this.#share());
    const choices = element('form', { class: 'choices' }, grounds, ...sizes, fit, align, behind, ...flags, forms);
    choices.addEventListener('input', () => this.show());
    choices.addEventListener('submit', (event) => event.preventDefault());
    dialog.replaceChildren(
      element('h2', { id: 'embed-title' }, 'Put this fire on your page'),
      element('div', { class: 'embed' }, this.#preview, choices),
      this.#code,
      this.#note,
      element(
        'div',
        { class: 'buttons' },
        copy,
        share,
        element('form', { method: 'dialog' }, element('button', {}, 'Close')),
      ),
      this.#copied,
    );
    // The fire of the page waits: the preview needs the time.
    const plays = !fire.paused;
    if (plays) fire.pause();
    const ends = () => {
      this.#shown += 1;
      this.#preview.replaceChildren();
      if (plays) fire.play();
    };
    dialog.addEventListener('close', ends, { once: true });
  }

  /** @type {(name: string, label: string, field: HTMLInputElement | HTMLSelectElement) => HTMLLabelElement} */
  #field(name, label, field) {
    field.name = name;
    this.#fields[name] = field;
    return element('label', {}, ...(field.type === 'checkbox' ? [field, label] : [label, field]));
  }

  /** @type {(name: string, label: string, choices: string[], chosen?: string) => HTMLLabelElement} */
  #select(name, label, choices, chosen) {
    return this.#field(
      name,
      label,
      element(
        'select',
        {},
        ...choices.map((choice) => new Option(choice, choice.toLowerCase(), false, choice === chosen)),
      ),
    );
  }

  /** The settings and how they are shown, by the choices. */
  get #chosen() {
    const { width, height, fit, align, behind, ground } = this.#fields;
    const { params } = this.#fire;
    // On a white page, the page is behind the fire in any case.
    /** @type {HTMLElement} */ (behind.parentElement).hidden = ground.value === 'white';
    const isAlone = behind.value !== 'as the scene';
    const values = valuesOn(ground.value, isAlone, this.#config.values ?? {}, /** @type {any} */ (params));
    /** @type {{[name: string]: string}} */
    const attributes = {};
    for (const name of ['warm', 'interactive', 'decorative'])
      if (/** @type {HTMLInputElement} */ (this.#fields[name]).checked) attributes[name] = '';
    if (fit.value !== FITS[0]) attributes.fit = fit.value;
    if (align.value !== ALIGNS[0]) attributes.align = align.value;
    for (const name of ['zoom', 'pan']) {
      const own = this.#fire.getAttribute(name);
      if (own !== null) attributes[name] = own;
    }
    const size = (/** @type {string} */ text) =>
      Math.min(Math.max(Math.round(Number(text)) || SMALLEST, SMALLEST), LARGEST);
    const shown = { width: size(width.value), height: size(height.value), attributes };
    return { config: { .../** @type {any} */ (this.#config), values }, shown };
  }

  /** Shows the preview and the code of the choices. */
  async show() {
    const shown = ++this.#shown;
    const { config, shown: how } = this.#chosen;
    this.#preview.dataset.ground = this.#fields.ground.value;
    this.#showPreview(elementAttributes(config, how), how);
    const form = this.#fields.form.value;
    const beside = (/** @type {string} */ file) => new URL(`../../${file}`, import.meta.url);
    const addresses = { script: beside('hearth-fire.js'), embed: beside('embed.html') };
    const code = await codeOf(form, config, how, addresses).catch(({ message }) => message);
    if (shown !== this.#shown) return;
    this.#code.value = code;
    this.#code.dataset.code = form;
    const note = FORMS.find(([name]) => name === form)?.[2] ?? '';
    this.#note.textContent = [note, sizeInWords()].filter(Boolean).join(' ');
  }

  /** The element of the code, reduced to the room that there is. @type {(attributes: [string, string][], size: {width: number, height: number}) => void} */
  #showPreview(attributes, { width, height }) {
    const present = this.#preview.querySelector('hearth-fire');
    const preview = present ?? document.createElement('hearth-fire');
    const named = new Map(attributes);
    for (const name of preview.getAttributeNames())
      if (!named.has(name) && !['style', 'loading', 'paused'].includes(name)) preview.removeAttribute(name);
    for (const [name, value] of named)
      if (name !== 'style' && preview.getAttribute(name) !== value) preview.setAttribute(name, value);
    preview.setAttribute('loading', 'eager');
    const { clientWidth, clientHeight } = this.#preview;
    const scale = Math.min(clientWidth / width, clientHeight / height, 1);
    Object.assign(/** @type {HTMLElement} */ (preview).style, {
      width: `${width}px`,
      height: `${height}px`,
      scale: `${scale}`,
    });
    if (!present) this.#preview.append(preview);
  }

  async #copy() {
    this.#code.select();
    try {
      await navigator.clipboard.writeText(this.#code.value);
      this.#copied.textContent = 'Copied.';
    } catch {
      this.#code.focus();
      this.#copied.textContent = 'This browser does not let the page copy. Copy the selected text yourself.';
    }
  }

  async #share() {
    try {
      await shareLink(this.#fire);
      this.#copied.textContent = 'share' in navigator ? '' : 'The link is copied.';
    } catch (error) {
      this.#copied.textContent = error instanceof Error ? error.message : String(error);
    }
  }
}

/** What a page loads for this fire, by what this page has loaded for it. */
function sizeInWords() {
  const loaded = /** @type {PerformanceResourceTiming[]} */ (performance.getEntriesByType('resource'));
  const bytes = loaded
    .filter(({ name }) => FILES.test(name.split('?')[0]))
    .reduce((sum, { encodedBodySize }) => sum + encodedBodySize, 0);
  return bytes > 0 ? `A page loads about ${Math.round(bytes / 1000)} KB for it from this server.` : '';
}
