/**
 * What keys mean wherever a fire is edited: in the panel, in the toolbar and on a page about one fire.
 */

import { remembered } from './memory.js';

/** Types of `<input>` without text. */
const TEXTLESS = ['range', 'checkbox', 'radio', 'button', 'submit', 'reset', 'color', 'file'];

/** Elements that the space key presses. */
const PRESSED = 'button, summary, a[href], input[type=checkbox], input[type=radio], input[type=button]';

/** Letters and digits of scripts without the letters of shortcuts; a Hebrew keyboard has an apostrophe for the W. */
const OTHER_SCRIPT = /^(?:[^\p{Script=Latin}\P{L}]|\p{M}|[^0-9\P{Nd}])/u;

/** What keys type on a keyboard for English, by their codes. @type {{[code: string]: string}} */
const ENGLISH = { BracketLeft: '[', BracketRight: ']', Slash: '/' };

/**
 * The key of a shortcut: a letter is small. Where a key types no Latin letter, its place on the keyboard counts.
 * @param {{key: string, code?: string}} event
 */
export function keyOf({ key, code = '' }) {
  if (OTHER_SCRIPT.test(key) || (key === "'" && code === 'KeyW'))
    return ENGLISH[code] ?? /^(?:Key|Digit)(.)$/.exec(code)?.[1].toLowerCase() ?? key;
  return key.length === 1 ? key.toLowerCase() : key;
}

/** What a key does to the history. @type {(event: KeyboardEvent) => 'undo' | 'redo' | undefined} */
export function historyKey(event) {
  const { ctrlKey, metaKey, shiftKey, altKey } = event;
  if (altKey || !(ctrlKey || metaKey)) return undefined;
  const letter = keyOf(event);
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
