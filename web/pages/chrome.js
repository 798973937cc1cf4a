/**
 * The chrome around the fire fades after a time without input and returns with the next input. The
 * attribute `data-chrome` is the state; CSS fades the chrome.
 */

/** The time without input after which the chrome fades [ms]. */
const IDLE_MS = 6000;

/** The events that bring the chrome back. */
const INPUT = ['pointermove', 'pointerdown', 'keydown', 'focusin', 'wheel', 'touchstart'];

/** What keeps the chrome visible: an open dialog, the pointer or the keyboard's focus in it. */
const KEEPS =
  'dialog[open], #word:not([hidden]), #head:hover, #scenes:hover, #head :focus-visible, #scenes :focus-visible';

/**
 * Starts to observe input.
 * @param {HTMLElement} root  Gets `data-chrome`: `near` or `back`.
 */
export function fadeChrome(root) {
  let last = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let planned;
  const check = () => {
    planned = undefined;
    const left = last + IDLE_MS - performance.now();
    if (left > 0) planned = setTimeout(check, left);
    else if (root.querySelector(KEEPS)) planned = setTimeout(check, IDLE_MS);
    else root.dataset.chrome = 'back';
  };
  const show = () => {
    last = performance.now();
    root.dataset.chrome = 'near';
    if (planned === undefined) planned = setTimeout(check, IDLE_MS);
  };
  for (const name of INPUT) root.addEventListener(name, show, { passive: true, capture: true });
  document.addEventListener('fullscreenchange', show);
  show();
}
