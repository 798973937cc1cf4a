/**
 * A hint about what a pointer does to the fire, shown once to each visitor.
 */

import { recall, remember } from './memory.js';

/** How long the hint stays [ms]. */
const HINT_MS = 8000;

/** The movement over the fire after which the hint disappears [CSS pixels]. */
const MOVED = 400;

const MOUSE = 'Move to blow, click for sparks, drag the base';
const TOUCH = 'Swipe to blow, tap for sparks, drag the base';

/**
 * Shows the hint if this browser has not shown it before and the fire plays.
 * @param {HTMLElement} element
 * @param {import('../hearth-fire.js').HearthFire} fire
 */
export function showHint(element, fire) {
  // A fire that is paused for reduced motion does not react to a pointer.
  if (recall('hint') || fire.paused || !fire.interactive) return;
  remember('hint', 'shown');
  element.textContent = matchMedia('(pointer: coarse)').matches ? TOUCH : MOUSE;
  const ended = new AbortController();
  const end = () => {
    ended.abort();
    clearTimeout(ends);
    element.replaceChildren();
  };
  const ends = setTimeout(end, HINT_MS);
  let moved = 0;
  const move = (/** @type {PointerEvent} */ event) => {
    moved += Math.hypot(event.movementX ?? 0, event.movementY ?? 0);
    if (moved > MOVED) end();
  };
  fire.addEventListener('pointermove', move, ended);
  fire.addEventListener('pointerdown', end, ended);
}
