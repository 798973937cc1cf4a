/**
 * Cards over the panel: text to copy manually, a field for settings, the shortcuts, the scenes
 * (scenes.js). They are elements of the page: text on a canvas can be neither selected, pasted nor read
 * by screen readers.
 *
 * @typedef {object} Card
 * @property {() => void} close
 * @property {(name: string) => boolean} isOpen  Whether it has that name and is open.
 * @property {() => void} [mark]  Marks the current item.
 */

import { KEYS, shortcutsForbidden } from './keys.js';
import { remember, remembered } from './memory.js';

/** The number of cards so far, which makes their ids. */
let cards = 0;

/**
 * Shows a text, selected.
 * @param {{host: HTMLElement, title: string, text: string}} what
 * @returns {Card}
 */
export function showText({ host, title, text }) {
  const card = openCard(host, 'copy', title);
  card.add('p', 'This browser does not let the panel copy. Copy the selected text yourself.');
  const field = card.field(title);
  field.readOnly = true;
  field.value = text;
  card.button('close', 'Close', card.close);
  field.focus({ preventScroll: true });
  field.select();
  return card;
}

/**
 * Reports that a fire is too long to be copied, and offers its file.
 * @param {{host: HTMLElement, title: string, why: string, save: () => void}} what
 * @returns {Card}
 */
export function offerFile({ host, title, why, save }) {
  const card = openCard(host, 'file', title);
  card.add('p', why).setAttribute('role', 'alert');
  card.button('save', 'Save the file', save).focus({ preventScroll: true });
  card.button('close', 'Close', card.close);
  return card;
}

/**
 * Asks for settings as JSON. If `apply` refuses them, the card shows the reason and stays open.
 * @param {{host: HTMLElement, apply: (text: string) => Promise<void>}} what
 * @returns {Card}
 */
export function askForSettings({ host, apply }) {
  const card = openCard(host, 'paste', 'Paste settings');
  const field = card.field('Settings as JSON');
  field.placeholder = '{"hearth": 2, "preset": "seed", "values": {"viscosity": 0.02}}';
  const alert = card.add('p', '');
  alert.setAttribute('role', 'alert');
  const use = async () => {
    alert.textContent = '';
    if (field.value.trim() === '') {
      alert.textContent = 'The field is empty: paste settings as JSON.';
      field.focus({ preventScroll: true });
      return;
    }
    try {
      await apply(field.value);
      card.close();
    } catch (error) {
      alert.textContent = error instanceof Error ? error.message : String(error);
      field.focus({ preventScroll: true });
    }
  };
  card.button('use', 'Apply', use);
  card.button('close', 'Cancel', card.close);
  field.focus({ preventScroll: true });
  return card;
}

/**
 * Lists the keyboard shortcuts, with a switch for single keys.
 * @param {{host: HTMLElement, fire: import('../hearth-fire.js').HearthFire}} where
 * @returns {Card}
 */
export function showKeys({ host, fire }) {
  const card = openCard(host, 'help', 'Keyboard shortcuts');
  const list = card.add('dl', '');
  for (const [keys, effect] of KEYS) {
    const term = document.createElement('dt');
    keys.forEach((key, at) => {
      const cap = document.createElement('kbd');
      cap.textContent = key;
      if (at > 0) term.append(' or ');
      term.append(cap);
    });
    const about = document.createElement('dd');
    about.textContent = effect;
    list.append(term, about);
  }
  if (!shortcutsForbidden(host, fire)) {
    const label = card.add('label', '');
    const box = document.createElement('input');
    box.type = 'checkbox';
    box.checked = remembered().shortcutsOff !== true;
    box.addEventListener('change', () => remember({ shortcutsOff: !box.checked }));
    label.append(box, ' Single-key shortcuts');
  }
  const close = card.button('close', 'Close', card.close);
  close.focus({ preventScroll: true });
  return card;
}

/**
 * An empty card. When it closes, the focus returns to the element that had it.
 * @param {HTMLElement} host
 * @param {string} name
 * @param {string} title
 */
export function openCard(host, name, title) {
  const root = /** @type {Document | ShadowRoot} */ (host.getRootNode());
  const before = /** @type {HTMLElement | null} */ (root.activeElement);
  const card = document.createElement('section');
  card.className = 'hearth-card';
  card.dataset.card = name;
  card.dir = 'ltr';
  card.setAttribute('role', 'dialog');
  const heading = document.createElement('h2');
  cards += 1;
  heading.id = `hearth-card-${cards}`;
  heading.textContent = title;
  card.setAttribute('aria-labelledby', heading.id);
  const content = document.createElement('div');
  content.className = 'hearth-card-content';
  const buttons = document.createElement('div');
  buttons.className = 'hearth-card-buttons';
  card.append(heading, content, buttons);

  const close = () => {
    const had = card.contains(root.activeElement);
    card.remove();
    if (had && before?.isConnected) before.focus({ preventScroll: true });
  };
  card.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    event.stopPropagation();
    close();
  });
  host.append(card);

  return {
    close,
    content,
    isOpen: (/** @type {string} */ other) => other === name && card.isConnected,
    /** @type {(tag: string, text: string) => HTMLElement} */
    add(tag, text) {
      const element = document.createElement(tag);
      element.textContent = text;
      content.append(element);
      return element;
    },
    /** @param {string} label */
    field(label) {
      const field = document.createElement('textarea');
      field.setAttribute('aria-label', label);
      field.spellcheck = false;
      content.append(field);
      return field;
    },
    /** @type {(action: string, text: string, press: () => void) => HTMLButtonElement} */
    button(action, text, press) {
      const button = document.createElement('button');
      button.type = 'button';
      button.dataset.card = action;
      button.textContent = text;
      button.addEventListener('click', press);
      buttons.append(button);
      return button;
    },
  };
}
