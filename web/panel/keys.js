/**
 * The panel's keyboard shortcuts. They act while the focus is in the panel or on the fire; on a page
 * for one fire also while nothing has the focus. In a page that shows a fire among other things, a
 * key that acted does not reach the page. A key that types or presses a button never acts. Visitors
 * turn single keys off in the list of keys; pages do so with `data-shortcuts="off"` on the panel's
 * host, the fire or the root element.
 */

import { remembered } from './memory.js';

/** The keys, as people read them, and what each does. @type {[string[], string][]} */
export const KEYS = [
  [['Space'], 'hold the fire, or let it burn'],
  [['R'], 'start it again'],
  [['H'], 'hide the controls, or show them'],
  [['F'], 'full screen'],
  [['S'], 'save a picture'],
  [['Ctrl Z'], 'undo'],
  [['Ctrl Shift Z', 'Ctrl Y'], 'do again'],
  [['Ctrl C'], 'copy the value under the pointer'],
  [['/'], 'search'],
  [['?'], 'these keys'],
];

/** Kinds of input that take no text. */
const WORDLESS = ['range', 'checkbox', 'radio', 'button', 'submit', 'reset', 'color', 'file'];

/** What the space key presses by itself. */
const PRESSED = 'button, summary, a[href], input[type=checkbox], input[type=radio], input[type=button]';

/**
 * @param {object} parts
 * @param {EventTarget[]} parts.own  Where the panel stands, and the fire.
 * @param {boolean} parts.page  Whether the page is one for this fire.
 * @param {import('../hearth-fire.js').HearthFire} parts.fire
 * @param {import('./controller.js').PanelController} parts.controller
 * @param {() => void} [parts.hide]  Hides the panel or shows it, where the panel itself does.
 * @returns {() => void} ends it
 */
export function listenToKeys({ own, page, fire, controller, hide }) {
  const acts = new Map(Object.entries({
    ' ': () => (fire.paused ? controller.play() : controller.pause()),
    r: () => controller.reset(),
    f: () => controller.state.fullscreen && controller.fullscreen(),
    s: () => controller.picture(),
    '?': () => controller.help(),
    '/': () => controller.search(),
    ...(hide && { h: hide }),
  }));
  /** @type {EventTarget[]} */
  const nowhere = [document.body, document.documentElement];

  /** @param {KeyboardEvent} event */
  const wanted = (event) => {
    const key = event.key.toLowerCase();
    const command = event.ctrlKey || event.metaKey;
    if (event.altKey || event.isComposing) return undefined;
    if (command && key === 'z') return () => (event.shiftKey ? controller.redo() : controller.undo());
    if (command && key === 'y') return () => controller.redo();
    if (command && key === 'c' && !event.shiftKey) return controller.copyHovered;
    if (command || event.repeat || (event.shiftKey && !['?', '/'].includes(key))) return undefined;
    return areSilent(...own) ? undefined : acts.get(key);
  };

  const onKey = (/** @type {Event} */ event) => {
    const key = /** @type {KeyboardEvent} */ (event);
    const act = wanted(key);
    if (!act || isTaken(key)) return;
    const path = key.composedPath();
    if (page && !nowhere.includes(path[0]) && !own.some((one) => path.includes(one))) return;
    key.preventDefault();
    if (!page) key.stopPropagation();
    // What is refused is told by the element's error event.
    Promise.resolve(act()).catch(() => {});
  };
  const targets = page ? [document] : own;
  for (const target of targets) target.addEventListener('keydown', onKey);
  return () => {
    for (const target of targets) target.removeEventListener('keydown', onKey);
  };
}

/**
 * Whether the page forbids single keys.
 * @type {(...places: EventTarget[]) => boolean}
 */
export function areForbidden(...places) {
  return [document.documentElement, ...places].some((one) => /** @type {HTMLElement} */ (one).dataset?.shortcuts === 'off');
}

/**
 * Whether single keys do nothing.
 * @type {(...places: EventTarget[]) => boolean}
 */
export function areSilent(...places) {
  return remembered().silent === true || areForbidden(...places);
}

/**
 * Whether a key belongs to what has the focus.
 * @param {KeyboardEvent} event
 */
function isTaken(event) {
  const focused = event.composedPath()[0];
  if (!(focused instanceof HTMLElement)) return false;
  if (focused instanceof HTMLInputElement && !WORDLESS.includes(focused.type)) return true;
  if (focused.isContentEditable || ['TEXTAREA', 'SELECT'].includes(focused.tagName)) return true;
  return event.key === ' ' && focused.matches(PRESSED);
}
