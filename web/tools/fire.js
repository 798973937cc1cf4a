/**
 * The tools that light what has fuel, and put it out. Neither is a step of the history, but for the fuel that a
 * solid gets.
 *
 * @typedef {import('./geometry.js').Point} Point
 * @typedef {import('./gestures.js').Gesture} Gesture
 * @typedef {import('./gestures.js').Hands} Hands
 */

import { giveFuel, needCombustion } from '../panel/effects.js';
import { distance } from '../panel/objects.js';

/** How far a press lights, and the distance of the places that a drag lights [m]. */
const REACH = 0.1;
const APART = 0.05;

/** The radius in which a press puts out [m]. */
const RADIUS = 0.2;

/**
 * Does something at the press and along the way of a drag, one place after the other. Only what the press meets is
 * told: a drag crosses the air.
 * @type {(hands: Hands, from: Point, apart: number, act: (at: Point) => Promise<void>) => Gesture}
 */
function along(hands, from, apart, act) {
  let last = from;
  let done = hands.attempt(() => act(from));
  return {
    move(to) {
      if (Math.hypot(to.x - last.x, to.y - last.y) < apart) return;
      last = to;
      done = done.then(() => act(to)).catch(() => {});
    },
    end() {},
    cancel() {},
  };
}

/**
 * Lights what is under the pointer, a wet source too. A solid without fuel gets that of its material.
 * @type {(hands: Hands, from: Point, pressed: import('./gestures.js').Owned | undefined) => Gesture}
 */
export function ignite(hands, from, pressed) {
  const { fire, editing } = hands;
  return along(hands, from, APART, async (at) => {
    needCombustion(fire, 'fuels');
    if (at === from && pressed?.kind === 'solid') await giveFuel(editing, pressed);
    // A source there may be wet.
    if (!hands.objects().some((one) => one.kind === 'source' && distance(one, at.x, at.y) <= REACH)) needFuel(hands, at, REACH);
    await fire.ignite(at.x, at.y);
  });
}

/** Puts out what is around the pointer. @type {(hands: Hands, from: Point) => Gesture} */
export function extinguish(hands, from) {
  return along(hands, from, RADIUS / 2, async (at) => {
    needFuel(hands, at, RADIUS);
    await hands.fire.extinguish(at.x, at.y, RADIUS);
  });
}

/** Throws unless a solid with fuel is that near. @type {(hands: Hands, at: Point, radius: number) => void} */
function needFuel({ objects }, { x, y }, radius) {
  if (!objects().some((one) => one.kind === 'solid' && one.fuel !== 'none' && distance(one, x, y) <= radius)) {
    throw new Error('Nothing there has fuel: press a solid.');
  }
}
