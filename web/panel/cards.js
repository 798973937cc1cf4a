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

import { element } from '../element/controls/icon-button.js';
import { shortcutsForbidden } from '../editing/keys.js';
import { KEYS } from './keys.js';
import { remember, remembered } from '../editing/memory.js';

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
  field.placeholder = '{"hearth": 3, "preset": "seed", "values": {"viscosity": 0.02}}';
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
    const caps = keys.flatMap((key, at) => [...(at > 0 ? [' or '] : []), element('kbd', {}, key)]);
    list.append(element('dt', {}, ...caps), element('dd', {}, effect));
  }
  if (!shortcutsForbidden(host, fire)) {
    const box = element('input', { type: 'checkbox' });
    box.checked = remembered().shortcutsOff !== true;
    box.addEventListener('change', () => remember({ shortcutsOff: !box.checked }));
    card.add('label', '').append(box, ' Single-key shortcuts');
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
  cards += 1;
  const id = `hearth-card-${cards}`;
  const content = element('div', { class: 'hearth-card-content' });
  const buttons = element('div', { class: 'hearth-card-buttons' });
  const card = element(
    'section',
    { class: 'hearth-card', 'data-card': name, dir: 'ltr', role: 'dialog', 'aria-labelledby': id },
    element('h2', { id }, title),
    content,
    buttons,
  );

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
    /** @type {(tag: keyof HTMLElementTagNameMap, text: string) => HTMLElement} */
    add(tag, text) {
      const added = element(tag, {}, text);
      content.append(added);
      return added;
    },
    /** @param {string} label */
    field(label) {
      const field = element('textarea', { 'aria-label': label, spellcheck: 'false' });
      content.append(field);
      return field;
    },
    /** @type {(action: string, text: string, press: () => void) => HTMLButtonElement} */
    button(action, text, press) {
      const button = element('button', { type: 'button', 'data-card': action }, text);
      button.addEventListener('click', press);
      buttons.append(button);
      return button;
    },
  };
}
