/**
 * A hint about what a pointer does to the fire, shown once to each visitor, and the offer to burn again what has burnt
 * down.
 */

import { recall, remember } from './memory.js';

/** How long the hint stays [ms]. */
const HINT_MS = 8000;

/** The movement over the fire after which the hint disappears [CSS pixels]. */
const MOVED = 400;

/** The power below which a fire is over [kW/m]. */
const COLD = 1;

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

/**
 * Offers to burn again while nothing is left of the fuel of the scene.
 * @param {HTMLElement} element
 * @param {import('../hearth-fire.js').HearthFire} fire
 */
export function offerAgain(element, fire) {
  const again = document.createElement('button');
  Object.assign(again, { type: 'button', textContent: 'Burn again', title: 'Burn again (R)' });
  again.addEventListener('click', () => {
    again.remove();
    fire.reset();
  });
  fire.addEventListener('stats', ({ detail: { fuel, power } }) => {
    const isOver = /^(burnt|out)$/.test(fuel) && power < COLD;
    if (isOver && !again.isConnected) element.replaceChildren(again);
    else if (!isOver) again.remove();
  });
}
