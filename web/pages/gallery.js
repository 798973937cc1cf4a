/**
 * The gallery: a still picture burns while the pointer or the keyboard's focus is on it, or from one press to the next.
 * One burns at a time, and under reduced motion none without a press. The code of the fire is loaded with the first one.
 *
 * @typedef {import('../share.js').HearthSharedConfig} Config
 */

import { copyText } from './copy.js';
import { WHOLE } from './framing.js';

/** How long a pointer stays on a picture before that burns: one that crosses the page lights nothing [ms]. */
const STAY_MS = 150;

/** The longest download of a scene [ms]. */
const FILE_MS = 10_000;

const still = matchMedia('(prefers-reduced-motion: reduce)');
const status = /** @type {HTMLElement} */ (document.getElementById('status'));
const field = /** @type {HTMLTextAreaElement} */ (document.getElementById('copy'));

/** The card that burns, and whether a press has lit it. @type {{card: HTMLElement, pressed: boolean} | undefined} */
let burning;

/** @param {HTMLElement} card @returns {HTMLButtonElement} */
const pictureOf = (card) => /** @type {HTMLButtonElement} */ (card.querySelector('.still'));

/** @param {HTMLElement} card */
const labelOf = (card) => card.querySelector('h2')?.textContent ?? '';

/** The file of a card of the community; undefined for a preset's. @param {HTMLElement} card */
const fileOf = ({ dataset: { community } }) =>
  community && new URL(`../../community/${community}.json`, import.meta.url).href;

/** The settings of a card, without what people read. @param {HTMLElement} card @returns {Promise<Config>} */
async function settingsOf(card) {
  const file = fileOf(card);
  if (!file) return { hearth: 3, preset: card.dataset.scene, values: {} };
  const answer = await fetch(file, { signal: AbortSignal.timeout(FILE_MS) });
  if (!answer.ok) throw new Error(`The scene did not load: the server answers ${answer.status}.`);
  const { hearth, preset, values, objects } = await answer.json();
  return { hearth, values, objects, ...(preset && { preset }) };
}

function putOut() {
  burning?.card.querySelector('hearth-fire')?.remove();
  if (burning) pictureOf(burning.card).setAttribute('aria-pressed', 'false');
  burning = undefined;
}

/** @param {HTMLElement} card @param {boolean} pressed */
function burn(card, pressed) {
  pictureOf(card).setAttribute('aria-pressed', String(pressed));
  if (burning?.card === card) {
    burning.pressed = pressed;
    return;
  }
  putOut();
  burning = { card, pressed };
  const fire = document.createElement('hearth-fire');
  const { scene = '' } = card.dataset;
  const file = fileOf(card);
  /** @type {{[name: string]: string}} */
  const attributes = {
    ...(file ? { src: file } : { preset: scene }),
    ...((file || WHOLE.includes(scene)) && { fit: 'contain' }),
    // It is lit on request alone.
    'reduced-motion': 'ignore',
    loading: 'eager',
    decorative: '',
    alt: '',
  };
  for (const [name, value] of Object.entries(attributes)) fire.setAttribute(name, value);
  // The picture stays until the fire is there.
  const poster = /** @type {HTMLImageElement} */ (card.querySelector('img')?.cloneNode());
  poster.slot = 'poster';
  fire.append(poster);
  card.append(fire);
  import('../hearth-fire.js').catch(() => {
    putOut();
    status.textContent = 'The code of the fire did not load. Load the page again.';
  });
}

/** @param {unknown} error */
function report(error) {
  status.textContent = error instanceof Error ? error.message : String(error);
}

/** @param {HTMLElement} card @returns {NodeListOf<HTMLAnchorElement>} */
const linksOf = (card) => card.querySelectorAll('.acts a');

/** What puts the settings of a scene that is no preset into the links of its card. @type {Map<HTMLElement, Promise<void>>} */
const linking = new Map();

/** @param {HTMLElement} card */
function link(card) {
  const begin = async () => {
    try {
      const { fragmentOf } = await import('../share/fragment.js');
      const fragment = await fragmentOf(await settingsOf(card));
      for (const link of linksOf(card)) link.hash = fragment;
    } catch (error) {
      // The next pointer tries again.
      linking.delete(card);
      report(error);
    }
  };
  const linked = linking.get(card) ?? begin();
  linking.set(card, linked);
  return linked;
}

/** Keeps the links of a card from leading to a page without the scene. @param {HTMLElement} card */
function offerLinks(card) {
  for (const name of ['pointerenter', 'focusin']) card.addEventListener(name, () => link(card));
  for (const to of linksOf(card)) {
    to.addEventListener('click', async (event) => {
      if (to.hash) return;
      event.preventDefault();
      await link(card);
      if (to.hash) location.assign(to.href);
    });
  }
}

/** @param {HTMLElement} card */
async function copy(card) {
  const { codeOf } = await import('./embed/codes.js');
  const at = (/** @type {string} */ file) => new URL(`../${file}`, import.meta.url);
  const fit = card.dataset.community || WHOLE.includes(card.dataset.scene ?? '');
  const shown = { attributes: { warm: '', ...(fit && { fit: 'contain' }) } };
  const addresses = { script: at('hearth-fire.js'), embed: at('embed.html') };
  await copyText(field, status, await codeOf('html', await settingsOf(card), shown, addresses));
  status.textContent = `${labelOf(card)}: ${status.textContent}`;
}

/** @param {HTMLElement} card */
function offer(card) {
  const picture = pictureOf(card);
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let waiting;
  const begin = () => !still.matches && burn(card, burning?.card === card && burning.pressed);
  const leave = () => {
    clearTimeout(waiting);
    if (burning?.card === card && !burning.pressed) putOut();
  };
  picture.addEventListener('pointerenter', ({ pointerType }) => {
    // A finger presses.
    if (pointerType !== 'touch') waiting = setTimeout(begin, STAY_MS);
  });
  picture.addEventListener('pointerleave', leave);
  picture.addEventListener('focus', () => picture.matches(':focus-visible') && begin());
  picture.addEventListener('blur', leave);
  picture.addEventListener('click', () => {
    clearTimeout(waiting);
    if (burning?.card === card && burning.pressed) putOut();
    else burn(card, true);
  });
  card.addEventListener('keydown', ({ key }) => key === 'Escape' && putOut());
  if (fileOf(card)) offerLinks(card);
  card.querySelector('[data-act="copy"]')?.addEventListener('click', () => copy(card).catch(report));
}

for (const card of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('.card'))) offer(card);
