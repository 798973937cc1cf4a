/**
 * The full page: one fire, its panel, and the fire in the address.
 *
 * `?scene=seed&viscosity=0.01&paused` sets what it says, by the names of the
 * element's attributes; whatever of it is refused is said in the console and on
 * the page. What is changed later is written back, so that the address, copied
 * or loaded anew, is always this fire. The panel is loaded after the fire burns
 * and a page without it still has a fire.
 */

import { applyAddress, readAddress } from './address.js';
import './hearth-fire.js';
import { toQuery } from './share.js';

/** How long a message stays on the page [ms]. */
const TOAST_MS = 8000;

/** Most messages that it shows at one time. */
const TOASTS = 4;

/** The address is at least so old when it is written [ms]: browsers refuse many in a short time. */
const ADDRESS_MS = 1000;

const fire = /** @type {import('./hearth-fire.js').HearthFire} */ (document.getElementById('fire'));
const panel = /** @type {HTMLElement} */ (document.getElementById('panel'));
const toggle = /** @type {HTMLElement} */ (document.getElementById('toggle'));
const toast = /** @type {HTMLElement} */ (document.getElementById('toast'));

/** @type {string[]} */
const said = [];
/** @type {ReturnType<typeof setTimeout> | undefined} */
let toastEnds;

/** @param {string} words */
function say(words) {
  clearTimeout(toastEnds);
  said.push(words);
  const more = said.length - TOASTS;
  const shown = said.slice(0, TOASTS);
  if (more > 0) shown.push(`… and ${more} more, in the console.`);
  toast.textContent = shown.join('\n');
  toastEnds = setTimeout(() => {
    said.length = 0;
    toast.replaceChildren();
  }, TOAST_MS);
}

/** Sets what the address asks for, and says what of it could not be. */
function setFromAddress() {
  const address = readAddress(location.search);
  for (const words of address.refused) {
    console.warn(`Hearth: ${words}`);
    say(words);
  }
  const refused = (event) => {
    if (event.detail.kind === 'bad-parameter') say(event.detail.message);
  };
  fire.addEventListener('error', refused);
  fire.ready.catch(() => {}).then(() => fire.removeEventListener('error', refused));
  applyAddress(fire, address);
  keepAddress(address.options);
}

/**
 * Writes what the fire burns with into the address, a while after it changed: the
 * scene and what differs from it. No entry of the history is made, for "back"
 * leads away from the page and not through positions of a slider.
 * @param {[string, string][]} options  What the address said besides; it stays.
 */
function keepAddress(options) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let planned;
  const write = async () => {
    planned = undefined;
    const query = toQuery(await fire.exportConfig());
    const others = new URLSearchParams(options).toString().replace(/=(?=&|$)/g, '');
    const address = new URL(location.href);
    address.search = [query, others].filter(Boolean).join('&');
    if (address.href !== location.href) history.replaceState(history.state, '', address);
  };
  fire.addEventListener('params-change', () => {
    planned ??= setTimeout(() => write().catch((error) => console.warn('Hearth:', error)), ADDRESS_MS);
  });
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
    await mountPanel({ host: panel, fire, page: location.href });
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
