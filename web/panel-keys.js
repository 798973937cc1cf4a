/**
 * The panel's keys. On a page of its own they act wherever the focus is; in a page
 * that shows a fire among other things, only while the focus is in the panel, and
 * the page does not hear of a key that acted. A key that types or that presses a
 * button is never taken.
 */

/** The keys, as people read them, and what each does. @type {[string[], string][]} */
export const KEYS = [
  [['Space'], 'hold the fire, or let it burn'],
  [['R'], 'start it again'],
  [['H'], 'hide the controls, or show them'],
  [['F'], 'full screen'],
  [['S'], 'save a picture'],
  [['Ctrl Z'], 'undo'],
  [['Ctrl Shift Z', 'Ctrl Y'], 'do again'],
  [['?'], 'these keys'],
];

/** Kinds of input that take no text. */
const WORDLESS = ['range', 'checkbox', 'radio', 'button', 'submit', 'reset', 'color', 'file'];

/** What the space key presses by itself. */
const PRESSED = 'button, summary, a[href], input[type=checkbox], input[type=radio], input[type=button]';

/**
 * @param {object} parts
 * @param {Document | HTMLElement} parts.target  Where keys are heard.
 * @param {any} parts.fire
 * @param {import('./panel-desk.js').Desk} parts.desk
 * @param {() => void} [parts.hide]  Hides the panel or shows it, where the panel itself does.
 * @returns {() => void} ends it
 */
export function listenToKeys({ target, fire, desk, hide }) {
  const acts = new Map(Object.entries({
    ' ': () => (fire.paused ? desk.play() : desk.pause()),
    r: () => desk.reset(),
    f: () => desk.state.fullscreen && desk.fullscreen(),
    s: () => desk.picture(),
    '?': () => desk.help(),
    ...(hide && { h: hide }),
  }));
  const owns = target !== document;

  /** @param {KeyboardEvent} event */
  const wanted = (event) => {
    const key = event.key.toLowerCase();
    const command = event.ctrlKey || event.metaKey;
    if (event.altKey || event.isComposing) return undefined;
    if (command && key === 'z') return () => (event.shiftKey ? desk.redo() : desk.undo());
    if (command && key === 'y') return () => desk.redo();
    if (command || event.repeat || (event.shiftKey && key !== '?')) return undefined;
    return acts.get(key);
  };

  const heard = (/** @type {Event} */ event) => {
    const key = /** @type {KeyboardEvent} */ (event);
    const act = wanted(key);
    if (!act || isTaken(key)) return;
    key.preventDefault();
    if (owns) key.stopPropagation();
    // What is refused is told by the element's error event.
    Promise.resolve(act()).catch(() => {});
  };
  target.addEventListener('keydown', heard);
  return () => target.removeEventListener('keydown', heard);
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
