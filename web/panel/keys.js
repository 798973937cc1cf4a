/**
 * The panel's keyboard shortcuts. They work while the panel or the fire has the focus; on a page about
 * one fire also while nothing has the focus. On any other page, the event of a shortcut stops at the
 * panel. A key that types text or presses a button is no shortcut. Visitors turn single-key shortcuts off
 * in the list of shortcuts; pages do so with `data-shortcuts="off"` on the panel's host, the fire or the
 * root element.
 */

import { hasNoDialog, historyKey, isTaken, keyOf, shortcutsOff } from '../editing/keys.js';

/** The names of the keys, and their effects. @type {[string[], string][]} */
export const KEYS = [
  [['Space'], 'pause or play'],
  [['R'], 'restart'],
  [['H'], 'hide or show the controls'],
  [['F'], 'full screen'],
  [['S'], 'save an image or a film'],
  [['M'], 'sound on or off'],
  [['+', '-'], 'enlarge, reduce the picture'],
  [['0'], 'the whole picture'],
  [['Shift arrow keys'], 'move an enlarged picture'],
  [['Ctrl Z'], 'undo'],
  [['Ctrl Shift Z', 'Ctrl Y'], 'redo'],
  [['Ctrl C'], 'copy the value under the pointer'],
  [['/'], 'search'],
  [['?'], 'keyboard shortcuts'],
];

/**
 * Starts to listen.
 * @param {object} options
 * @param {EventTarget[]} options.own  The panel's host, and the fire.
 * @param {boolean} options.page  Whether the page is about this fire.
 * @param {import('../hearth-fire.js').HearthFire} options.fire
 * @param {import('./controller.js').PanelController} options.controller
 * @param {() => void} [options.hide]  Hides or shows the panel, unless the page does.
 * @param {typeof import('./zoom-keys.js').zoomKey} options.zoomKey  What a key does to the picture.
 * @returns {() => void} stops
 */
export function listenToKeys({ own, page, fire, controller, hide, zoomKey }) {
  const actions = new Map(
    Object.entries({
      ' ': () => (fire.paused ? fire.play() : fire.pause()),
      r: () => fire.reset(),
      f: () => controller.state.fullscreen && controller.fullscreen(),
      s: () => controller.picture(),
      // The code of the button is loaded on request.
      m: () => import('../sound/speaker.js').then(({ toggleSound }) => toggleSound(fire)),
      '?': () => controller.help(),
      '/': () => controller.search(),
      ...(hide && { h: hide }),
    }),
  );
  /** @param {KeyboardEvent} event */
  const actionOf = (event) => {
    const key = keyOf(event);
    const command = event.ctrlKey || event.metaKey;
    if (event.altKey || event.isComposing) return undefined;
    const move = historyKey(event);
    if (move) return () => controller[move]();
    if (command && key === 'c' && !event.shiftKey) return controller.copyHovered;
    // Tools use some of its keys, and the controls of the panel the arrow keys.
    const used = event.defaultPrevented || (key.startsWith('Arrow') && event.composedPath().includes(own[0]));
    const zooms = command || used ? undefined : zoomKey(fire, event);
    if (zooms) return shortcutsOff(...own) ? undefined : zooms;
    if (command || event.repeat || (event.shiftKey && !['?', '/'].includes(key))) return undefined;
    return shortcutsOff(...own) ? undefined : actions.get(key);
  };

  const onKey = (/** @type {Event} */ event) => {
    const key = /** @type {KeyboardEvent} */ (event);
    const act = actionOf(key);
    if (!act || isTaken(key)) return;
    const path = key.composedPath();
    const idle = historyKey(key) ? hasNoDialog : isIdle;
    if (page && !idle(path[0]) && !own.some((element) => path.includes(element))) return;
    key.preventDefault();
    if (!page) key.stopPropagation();
    // The element's error event reports a refusal.
    Promise.resolve(act()).catch(() => {});
  };
  const targets = page ? [document] : own;
  for (const target of targets) target.addEventListener('keydown', onKey);
  return () => {
    for (const target of targets) target.removeEventListener('keydown', onKey);
  };
}

/**
 * Whether the focus of a page is on nothing that has keys of its own: a button of the page keeps the focus after a press.
 * @param {EventTarget} focused
 */
function isIdle(focused) {
  if (focused === document.body || focused === document.documentElement) return true;
  return focused instanceof HTMLButtonElement && hasNoDialog(focused) && !focused.closest('[role=toolbar]');
}
