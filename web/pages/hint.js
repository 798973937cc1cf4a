/**
 * A hint, once for each visitor: what a pointer can do with the fire.
 */

import { recall, remember } from './memory.js';

/** How long the hint stays without being followed [ms]. */
const STAYS_MS = 8000;

/** A pointer that moved this far over the fire has blown into it [CSS pixels]. */
const BLOWN = 400;

const MOUSE = 'Move to blow, click for sparks, drag the fire';
const TOUCH = 'Swipe to blow, tap for sparks, drag the fire';

/**
 * Shows the hint, if this browser has not shown it before and the fire burns.
 * @param {HTMLElement} place
 * @param {import('../hearth-fire.js').HearthFire} fire
 */
export function showHint(place, fire) {
  // A fire that stands still for a visitor who wants less motion hears no pointer.
  if (recall('hint') || fire.paused || !fire.interactive) return;
  remember('hint', 'shown');
  place.textContent = matchMedia('(pointer: coarse)').matches ? TOUCH : MOUSE;
  const ended = new AbortController();
  const end = () => {
    ended.abort();
    clearTimeout(ends);
    place.replaceChildren();
  };
  const ends = setTimeout(end, STAYS_MS);
  let moved = 0;
  const move = (/** @type {PointerEvent} */ event) => {
    moved += Math.hypot(event.movementX ?? 0, event.movementY ?? 0);
    if (moved > BLOWN) end();
  };
  fire.addEventListener('pointermove', move, ended);
  fire.addEventListener('pointerdown', end, ended);
}
