/**
 * What keys mean wherever a fire is edited: in the panel, in the toolbar and on a page about one fire.
 */

import { remembered } from './memory.js';

/** Types of `<input>` without text. */
const TEXTLESS = ['range', 'checkbox', 'radio', 'button', 'submit', 'reset', 'color', 'file'];

/** Elements that the space key presses. */
const PRESSED = 'button, summary, a[href], input[type=checkbox], input[type=radio], input[type=button]';

/** What a key does to the history. @type {(event: KeyboardEvent) => 'undo' | 'redo' | undefined} */
export function historyKey({ key, ctrlKey, metaKey, shiftKey, altKey }) {
  if (altKey || !(ctrlKey || metaKey)) return undefined;
  const letter = key.toLowerCase();
  if (letter === 'y') return 'redo';
  return letter === 'z' ? (shiftKey ? 'redo' : 'undo') : undefined;
}

/**
 * Whether the focus is in no dialog, which hides the fire. A thumbnail or a link of the page keeps the focus after a
 * press.
 * @param {EventTarget} focused
 */
export function hasNoDialog(focused) {
  return !(focused instanceof Element && focused.closest('dialog, [role=dialog]'));
}

/**
 * Whether the page turns single-key shortcuts off.
 * @type {(...elements: EventTarget[]) => boolean}
 */
export function shortcutsForbidden(...elements) {
  const all = /** @type {HTMLElement[]} */ ([document.documentElement, ...elements]);
  return all.some(({ dataset }) => dataset?.shortcuts === 'off');
}

/**
 * Whether single-key shortcuts are off.
 * @type {(...elements: EventTarget[]) => boolean}
 */
export function shortcutsOff(...elements) {
  return remembered().shortcutsOff === true || shortcutsForbidden(...elements);
}

/**
 * Whether the focused element handles a key itself.
 * @param {KeyboardEvent} event
 */
export function isTaken(event) {
  const focused = event.composedPath()[0];
  if (!(focused instanceof HTMLElement)) return false;
  if (focused instanceof HTMLInputElement && !TEXTLESS.includes(focused.type)) return true;
  if (focused.isContentEditable || ['TEXTAREA', 'SELECT'].includes(focused.tagName)) return true;
  return event.key === ' ' && focused.matches(PRESSED);
}
