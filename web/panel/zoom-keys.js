/**
 * The keys that enlarge and move the picture, as a wheel and two fingers do. They write the attributes `zoom` and
 * `pan`.
 */

import { keyOf } from '../editing/keys.js';

/** How much a key enlarges, the most of it, and how far an arrow key moves, in pictures. */
const STEP = 1.25;
const MOST = 10;
const MOVE = 0.1;

/** The position that the first step enlarges, from the left and from below: flames are below the middle. */
const FIRST = [0.5, 0.25];

/** Where an arrow key moves the view. @type {{[key: string]: [number, number]}} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };

/**
 * What a key does to the picture; `undefined` for a key of something else.
 * @param {import('../hearth-fire.js').HearthFire} fire
 * @param {KeyboardEvent} event without Ctrl and Alt
 * @returns {(() => void) | undefined}
 */
export function zoomKey(fire, event) {
  const [key, { shiftKey }, { zoom }] = [keyOf(event), event, fire];
  if (shiftKey && Object.hasOwn(ARROWS, key)) {
    // A share of what is hidden: a picture that is not enlarged hides nothing.
    return zoom > 1
      ? () =>
          setPan(
            fire,
            panOf(fire).map((at, axis) => at + (MOVE * ARROWS[key][axis]) / (zoom - 1)),
          )
      : undefined;
  }
  switch (key) {
    case '+':
    case '=':
      return () => {
        if (zoom === 1) setPan(fire, FIRST);
        fire.zoom = Math.min(zoom * STEP, MOST);
      };
    case '-':
      return () => {
        fire.zoom = Math.max(zoom / STEP, 1);
      };
    case '0':
      return () => {
        fire.removeAttribute('zoom');
        fire.removeAttribute('pan');
      };
    default:
      return undefined;
  }
}

/**
 * The position of the view in what is hidden, from the left and from below, 0–1.
 * @param {import('../hearth-fire.js').HearthFire} fire
 */
function panOf(fire) {
  const at = fire.pan.trim().split(/\s+/).map(Number);
  return at.length === 2 && at.every(Number.isFinite) ? at : [0.5, 0.5];
}

/** @type {(fire: import('../hearth-fire.js').HearthFire, pan: number[]) => void} */
function setPan(fire, pan) {
  fire.pan = pan.map((at) => Math.max(0, Math.min(at, 1)).toFixed(4)).join(' ');
}
