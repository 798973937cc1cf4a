/**
 * The full page: one fire, its chrome and its panel, and a URL that describes the fire.
 *
 * Without URL parameters the page shows the scene in its HTML. `?scene=seed&viscosity=0.01&paused` sets a
 * scene and attributes of the element; values without a scene change the scene of the page. The page and
 * the console report what is refused. Later changes are written back, so the URL always shows this fire; settings that
 * are too long for URL parameters are its fragment. `open=panel`, or the part that a button opens, opens that part.
 *
 * Scenes, panel and dialogs load after the first frame. If one of them fails, the page still has a fire.
 */

import { applyUrlParameters, readUrlParameters } from './url-parameters.js';
import '../hearth-fire.js';
import { fadeChrome } from './chrome.js';
import { KEPT, applyFragment, hasFragment, keep, keepLast } from './fragment.js';
import { frameScenes } from './framing.js';
import { offerAgain, showHint } from './hint.js';
import { PagePanel } from './panel.js';
import { fitsQuery, toQuery } from '../share.js';
import { offerTools } from '../tools/tools-button.js';

/** How long a message stays [ms]. */
const TOAST_MS = 8000;

/** The step and the largest value of the zoom. */
const ZOOM_STEP = 1.25;
const MAX_ZOOM = 10;

/** The maximum number of messages at a time. */
const TOASTS = 4;

/** About a fire that is too long for a URL. */
const TAB_ALONE =
  'This fire is too long for an address: only this tab has it. Save it among your scenes, or copy its JSON.';

/** The delay from a change to the URL [ms]: browsers refuse frequent changes. */
const URL_MS = 1000;

const fire = /** @type {import('../hearth-fire.js').HearthFire} */ (document.getElementById('fire'));
const toast = /** @type {HTMLElement} */ (document.getElementById('toast'));

/** The scene in the HTML of the page. */
const LANDING = fire.getAttribute('preset') ?? 'default';

/** The messages on the page. @type {string[]} */
const messages = [];
/** @type {ReturnType<typeof setTimeout> | undefined} */
let toastEnds;

/** Shows a message on the page. @param {string} message */
function notify(message) {
  clearTimeout(toastEnds);
  messages.push(message);
  const more = messages.length - TOASTS;
  const shown = messages.slice(0, TOASTS);
  if (more > 0) shown.push(`… and ${more} more in the console.`);
  toast.textContent = shown.join('\n');
  toastEnds = setTimeout(() => {
    messages.length = 0;
    toast.replaceChildren();
  }, TOAST_MS);
}

/** Applies the URL parameters, and shows which are refused. Returns the part of the page that they open. */
function applyLocation() {
  const parameters = readUrlParameters(location.search, ['open']);
  const refuse = (/** @type {string} */ message) => {
    console.warn(`Hearth: ${message}`);
    notify(message);
  };
  parameters.refused.forEach(refuse);
  const refused = (/** @type {CustomEvent<import('../element/types.js').HearthErrorDetail>} */ event) => {
    if (event.detail.kind === 'bad-parameter') notify(event.detail.message);
  };
  fire.addEventListener('error', refused);
  fire.ready.catch(() => {}).then(() => fire.removeEventListener('error', refused));
  applyUrlParameters(fire, parameters);
  const isUnwritten = applyFragment(fire, refuse);
  // The poster shows the landing scene, without changes.
  if (fire.getAttribute('preset') !== LANDING || parameters.values.length > 0 || hasFragment())
    document.getElementById('still')?.remove();
  // The settings contain the objects.
  const options = parameters.options.filter(([name]) => name !== 'objects');
  const plan = updateUrl([...options, ...parameters.unknown]);
  const opens = parameters.others.get('open');
  if (isUnwritten || opens) fire.ready.then(plan, () => {});
  return opens;
}

/**
 * The URL parameters that show this fire on this page.
 * @param {import('../share.js').HearthSharedConfig} config
 */
function queryOf(config) {
  const query = toQuery(config);
  if (config.preset === undefined) return ['scene=default', query].filter(Boolean).join('&');
  const { preset, values = {}, objects } = config;
  return preset === LANDING && Object.keys(values).length === 0 && !objects ? '' : query;
}

/** @param {import('../hearth-fire.js').HearthConfig} config */
async function fragmentOrKept(config) {
  const { fragmentOf } = await import('../share/fragment.js');
  return fragmentOf(config).catch(() => KEPT);
}

/**
 * Writes the settings of the fire into the URL after each change. The history gets no entry: "back" leaves the page
 * instead of stepping through positions of a slider. Returns what plans a writing.
 * @param {[string, string][]} options  The other URL parameters, which stay.
 */
function updateUrl(options) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let planned;
  /** Whether the fire has changed since it was asked for its settings. */
  let isStale = false;
  const write = async () => {
    isStale = false;
    const config = await fire.exportConfig();
    const query = queryOf(config);
    const others = new URLSearchParams(options).toString().replace(/=(?=&|$)/g, '');
    const url = new URL(location.href);
    const isShort = fitsQuery(config, query);
    url.search = [isShort ? query : '', others].filter(Boolean).join('&');
    if (!isShort) url.hash = await fragmentOrKept(config);
    else if (hasFragment()) url.hash = '';
    if (url.hash === KEPT) {
      if (location.hash !== KEPT) notify(TAB_ALONE);
      keep(url, config);
    } else if (url.href !== location.href) {
      keep(url);
    }
  };
  const plan = () => {
    isStale = true;
    planned ??= setTimeout(async () => {
      await write().catch((error) => console.warn('Hearth:', error));
      planned = undefined;
      if (isStale) plan();
    }, URL_MS);
  };
  fire.addEventListener('params-change', plan);
  fire.addEventListener('objects-change', plan);
  // A page that ends gets no answer of the fire any more; its tab keeps the settings that the URL does not have.
  addEventListener('pagehide', () => {
    if (planned !== undefined) keepLast(fire.history.settings);
  });
  return plan;
}

/** Opens what a button names: a dialog, the strip of scenes, the form of a word, or a second fire. Code is loaded with the first one. */
function openParts() {
  const part = (/** @type {string} */ id) => /** @type {any} */ (document.getElementById(id));
  const openWord = async (/** @type {File | undefined} */ file = undefined) =>
    (await import('./word/word.js')).openWord(part('word'), fire, notify, file);
  const attempt = async (/** @type {() => unknown} */ open) => {
    try {
      await open();
    } catch (error) {
      console.warn('Hearth: a part of the page could not be opened.', error);
      notify('This part could not be opened. Reload the page and try again.');
    }
  };
  for (const button of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('[data-opens]'))) {
    const id = button.dataset.opens ?? '';
    button.addEventListener('click', () =>
      attempt(async () => {
        if (id === 'word') await openWord();
        else if (id === 'beside') await (await import('./beside.js')).toggleBeside(fire, button);
        else if (id === 'scenes') part(id).querySelector('[tabindex="0"]')?.focus({ focusVisible: true });
        else await (await import('./dialogs.js')).openDialog(id, fire);
      }),
    );
  }
  // A picture that is dropped on the page is a logo, unless the tools take it.
  const takes = (/** @type {DragEvent} */ { dataTransfer }) =>
    document.documentElement.dataset.tools !== 'shown' && dataTransfer?.types.includes('Files');
  document.addEventListener('dragover', (event) => takes(event) && event.preventDefault());
  document.addEventListener(
    'drop',
    (event) => {
      const [file] = event.dataTransfer?.files ?? [];
      if (!takes(event) || !file?.type.startsWith('image/')) return;
      event.preventDefault();
      event.stopPropagation();
      attempt(() => openWord(file));
    },
    true,
  );
}

/** The button that opens the share sheet of the system, where there is one. */
function offerShare() {
  const button = /** @type {HTMLButtonElement} */ (document.getElementById('share'));
  button.hidden = !('share' in navigator);
  button.addEventListener('click', async () => {
    try {
      await (await import('./share-link.js')).shareLink(fire);
    } catch (error) {
      notify(error instanceof Error ? error.message : String(error));
    }
  });
}

/** The buttons that enlarge and reduce the picture. */
function offerZoom() {
  for (const button of document.querySelectorAll('[data-zooms]')) {
    const by = /** @type {HTMLElement} */ (button).dataset.zooms === 'in' ? ZOOM_STEP : 1 / ZOOM_STEP;
    button.addEventListener('click', () => (fire.zoom = Math.min(Math.max(fire.zoom * by, 1), MAX_ZOOM)));
  }
}

/** Shows the strip of scenes; the panel has them as well. */
async function showScenes() {
  try {
    const { showStrip } = await import('./scenes.js');
    showStrip(/** @type {HTMLElement} */ (document.getElementById('scenes')), fire, LANDING, notify);
  } catch (error) {
    console.warn('Hearth: the scenes could not be loaded.', error);
  }
}

/** Shows the speaker button and its sliders. */
async function showSpeaker() {
  try {
    const { speakerControls } = await import('../sound/speaker.js');
    const { parts } = speakerControls(fire, '');
    parts[0].id = 'speaker';
    document.getElementById('head')?.append(...parts);
  } catch (error) {
    console.warn('Hearth: the speaker button could not be loaded.', error);
  }
}

const opens = applyLocation();
frameScenes(fire);
fadeChrome(document.documentElement);
openParts();
offerShare();
offerZoom();
const panel = new PagePanel(fire, notify);
fire.ready.then(
  () => {
    document.documentElement.dataset.fire = 'shown';
    if (opens === 'panel') panel.show();
    panel.begin();
    const [button, host] = ['draw', 'tools'].map((id) => /** @type {HTMLElement} */ (document.getElementById(id)));
    const shown = (/** @type {boolean} */ open) => (document.documentElement.dataset.tools = open ? 'shown' : 'hidden');
    const failed = (/** @type {unknown} */ why) => {
      console.warn('Hearth: the tools could not be loaded.', why);
      notify('The tools could not be loaded. Reload the page and try again.');
    };
    offerTools({ button, host, fire, page: true, shown, failed });
    button.hidden = false;
    showSpeaker();
    const hint = /** @type {HTMLElement} */ (document.getElementById('hint'));
    showHint(hint, fire);
    offerAgain(hint, fire);
    for (const id of ['handle', 'zoom']) document.getElementById(id)?.removeAttribute('hidden');
    const buttons = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('[data-opens]')]);
    buttons.find((button) => button.dataset.opens === opens)?.click();
    return showScenes();
  },
  // Without a fire there is nothing to control; the element shows the reason.
  () => panel.remove(),
);
