/**
 * The chrome around the fire fades after a time without input and returns with the next input. The
 * attribute `data-chrome` holds the state, and CSS does the rest.
 */

/** How long the chrome waits for input before it steps back [ms]. */
const PATIENCE_MS = 6000;

/** What brings the chrome back. */
const INPUT = ['pointermove', 'pointerdown', 'keydown', 'focusin', 'wheel', 'touchstart'];

/** What the chrome waits for: an open dialog, a pointer or the keyboard's focus in it. */
const HELD = 'dialog[open], #head:hover, #scenes:hover, #head :focus-visible, #scenes :focus-visible';

/**
 * Starts to watch for input.
 * @param {HTMLElement} root  Gets `data-chrome`: `near` or `back`.
 */
export function stepBack(root) {
  let last = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let planned;
  const look = () => {
    planned = undefined;
    const left = last + PATIENCE_MS - performance.now();
    if (left > 0) planned = setTimeout(look, left);
    else if (root.querySelector(HELD)) planned = setTimeout(look, PATIENCE_MS);
    else root.dataset.chrome = 'back';
  };
  const wake = () => {
    last = performance.now();
    root.dataset.chrome = 'near';
    if (planned === undefined) planned = setTimeout(look, PATIENCE_MS);
  };
  for (const name of INPUT) root.addEventListener(name, wake, { passive: true, capture: true });
  document.addEventListener('fullscreenchange', wake);
  wake();
}
