/**
 * The full page: one fire, its panel, and parameters in the address.
 *
 * `?preset=seed&viscosity=0.01&paused` sets what it says, by the names of the
 * element's attributes; whatever of it is refused is said in the console and on
 * the page. The panel is loaded after the fire burns
 * and a page without it still has a fire.
 */

import { OWN_ATTRIBUTES } from './fire-attributes.js';
import './hearth-fire.js';

/** How long a message stays on the page [ms]. */
const TOAST_MS = 8000;

const fire = /** @type {import('./hearth-fire.js').HearthFire} */ (document.getElementById('fire'));
const panel = /** @type {HTMLElement} */ (document.getElementById('panel'));
const toggle = /** @type {HTMLElement} */ (document.getElementById('toggle'));
const toast = /** @type {HTMLElement} */ (document.getElementById('toast'));

/** @type {number | undefined} */
let toastEnds;

/** @param {string} words */
function say(words) {
  clearTimeout(toastEnds);
  toast.textContent = [toast.textContent, words].filter(Boolean).join('\n');
  toastEnds = setTimeout(() => toast.replaceChildren(), TOAST_MS);
}

/** Sets what the address asks for; each key by itself, so that one bad value spoils no other. */
function setFromAddress() {
  const wanted = new URLSearchParams(location.search);
  const refused = (event) => {
    if (event.detail.kind === 'bad-parameter') say(event.detail.message);
  };
  fire.addEventListener('error', refused);
  fire.ready.catch(() => {}).then(() => fire.removeEventListener('error', refused));
  // The element's own attributes first: a preset would replace single values.
  for (const name of OWN_ATTRIBUTES) {
    const value = wanted.get(name);
    if (value !== null) fire.setAttribute(name, value);
    wanted.delete(name);
  }
  // Then the model, which decides what the others may be.
  const values = [...wanted].map(([key, value]) => [key.replaceAll('-', '_'), value]);
  values.sort(([a], [b]) => Number(b === 'model') - Number(a === 'model'));
  for (const [id, value] of values) fire.set(id, value);
}

/** @param {boolean} shown */
function showPanel(shown) {
  document.documentElement.dataset.panel = shown ? 'shown' : 'hidden';
  toggle.setAttribute('aria-expanded', String(shown));
}

function panelIsShown() {
  return document.documentElement.dataset.panel !== 'hidden';
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

toggle.addEventListener('click', () => showPanel(!panelIsShown()));
document.addEventListener('keydown', (event) => {
  const plain = !(event.ctrlKey || event.metaKey || event.altKey || event.repeat);
  if (plain && event.key.toLowerCase() === 'h' && !isTyping(event)) showPanel(!panelIsShown());
});

/** Shows the panel, or says why it is not there. */
async function loadPanel() {
  try {
    const { mountPanel } = await import('./panel.js');
    await mountPanel({ host: panel, fire });
  } catch (error) {
    console.warn('Hearth: the panel could not be loaded.', error);
    const words = document.createElement('p');
    words.className = 'words';
    words.textContent = 'The controls could not be loaded. The fire burns without them.';
    panel.replaceChildren(words);
  }
}

setFromAddress();
fire.ready.then(loadPanel, () => {
  // Without a fire there is nothing to control; the fire itself says why.
  showPanel(false);
  toggle.hidden = true;
});
