/**
 * The full page: one fire, its chrome and its panel, and an address that describes the fire.
 *
 * An address that names no scene and no value shows the scene in the HTML of the page.
 * `?scene=seed&viscosity=0.01&paused` sets what it says, by the names of the
 * element's attributes; values without a scene change the scene `default`. The console
 * and the page say what is refused. Later changes are written back, so that the
 * address, copied or loaded anew, always shows this fire.
 *
 * Scenes, panel and dialogs load after the fire burns; a page without them still has
 * a fire.
 */

import { applyAddress, readAddress } from './url-parameters.js';
import '../hearth-fire.js';
import { stepBack } from './chrome.js';
import { showHint } from './hint.js';
import { PagePanel } from './panel.js';
import { toQuery } from '../share.js';

/** How long a message stays on the page [ms]. */
const TOAST_MS = 8000;

/** How many messages the page shows at a time. */
const TOASTS = 4;

/** The address is at least this old when it is written [ms]: browsers refuse many changes in a short time. */
const ADDRESS_MS = 1000;

const fire = /** @type {import('../hearth-fire.js').HearthFire} */ (document.getElementById('fire'));
const toast = /** @type {HTMLElement} */ (document.getElementById('toast'));

/** The scene in the HTML of the page, which an empty address shows. */
const LANDING = fire.getAttribute('preset') ?? 'default';

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

/** Sets what the address asks for, and says what of it is refused. */
function setFromAddress() {
  const address = readAddress(location.search);
  for (const words of address.refused) {
    console.warn(`Hearth: ${words}`);
    say(words);
  }
  const refused = (/** @type {CustomEvent<import('../hearth-fire.js').HearthErrorDetail>} */ event) => {
    if (event.detail.kind === 'bad-parameter') say(event.detail.message);
  };
  fire.addEventListener('error', refused);
  fire.ready.catch(() => {}).then(() => fire.removeEventListener('error', refused));
  // Links from before the page had a scene of its own name values alone.
  if (address.scene === undefined && address.values.length > 0) fire.removeAttribute('preset');
  applyAddress(fire, address);
  // The still picture shows the landing scene and no other.
  if (fire.getAttribute('preset') !== LANDING) document.getElementById('still')?.remove();
  // The fire tells its objects.
  const options = address.options.filter(([name]) => name !== 'objects');
  keepAddress([...options, ...address.unknown]);
}

/**
 * The query that shows this fire on this page.
 * @param {import('../share.js').HearthSharedConfig} config
 */
function queryOf(config) {
  const query = toQuery(config);
  if (config.preset === undefined) return ['scene=default', query].filter(Boolean).join('&');
  const { preset, values = {}, objects } = config;
  return preset === LANDING && Object.keys(values).length === 0 && !objects ? '' : query;
}

/**
 * Writes what the fire burns with into the address, a while after it changed: the
 * scene and what differs from it. The history gets no entry, for "back"
 * leads away from the page and not through positions of a slider.
 * @param {[string, string][]} options  What the address said besides; it stays.
 */
function keepAddress(options) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let planned;
  const write = async () => {
    planned = undefined;
    const query = queryOf(await fire.exportConfig());
    const others = new URLSearchParams(options).toString().replace(/=(?=&|$)/g, '');
    const address = new URL(location.href);
    address.search = [query, others].filter(Boolean).join('&');
    if (address.href !== location.href) history.replaceState(history.state, '', address);
  };
  const plan = () => {
    if (planned !== undefined) return;
    planned = setTimeout(() => write().catch((error) => console.warn('Hearth:', error)), ADDRESS_MS);
  };
  fire.addEventListener('params-change', plan);
  fire.addEventListener('objects-change', plan);
}

/** Opens the dialog that a button names. Its code is loaded with the first one. */
function openDialogs() {
  for (const button of document.querySelectorAll('[data-opens]')) {
    const id = /** @type {HTMLElement} */ (button).dataset.opens ?? '';
    button.addEventListener('click', async () => {
      try {
        const { openDialog } = await import('./dialogs.js');
        await openDialog(id, fire);
      } catch (error) {
        console.warn('Hearth: the dialog could not be opened.', error);
        say('The dialog could not be opened.');
      }
    });
  }
}

/** Shows the strip of scenes; without it the panel still has them. */
async function showScenes() {
  try {
    const { showStrip } = await import('./scenes.js');
    showStrip(/** @type {HTMLElement} */ (document.getElementById('scenes')), fire, LANDING, say);
  } catch (error) {
    console.warn('Hearth: the scenes could not be loaded.', error);
  }
}

setFromAddress();
stepBack(document.documentElement);
openDialogs();
const panel = new PagePanel(fire);
fire.ready.then(
  () => {
    panel.begin();
    showHint(/** @type {HTMLElement} */ (document.getElementById('hint')), fire);
    return showScenes();
  },
  // Without a fire there is nothing to control; the fire itself says why.
  () => panel.drop(),
);
