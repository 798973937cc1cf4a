/**
 * The tools that light fuels and sources, and put fuels out. Only the fuel that a solid gets is a step of the
 * history.
 *
 * @typedef {import('./geometry.js').Point} Point
 * @typedef {import('./gestures.js').Gesture} Gesture
 * @typedef {import('./gestures.js').ToolContext} ToolContext
 */

import { giveFuel, needCombustion } from '../editing/effects.js';
import { distance, isBody } from '../editing/objects.js';

/** How far a press lights, and the distance between two points that a drag lights [m]. */
const REACH = 0.1;
const APART = 0.05;

/** The radius in which a press puts out [m]. */
const RADIUS = 0.2;

/**
 * Acts at the press and then at equal distances along a drag. Only the press reports a refusal, because a drag also
 * crosses empty air.
 * @type {(context: ToolContext, from: Point, apart: number, act: (at: Point) => Promise<void>) => Gesture}
 */
function repeatAlong(context, from, apart, act) {
  let last = from;
  let done = context.attempt(() => act(from));
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
 * @type {(context: ToolContext, from: Point, pressed: import('./gestures.js').Owned | undefined) => Gesture}
 */
export function ignite(context, from, pressed) {
  const { fire, editing } = context;
  return repeatAlong(context, from, APART, async (at) => {
    needCombustion(fire, 'fuels');
    if (at === from && pressed && isBody(pressed)) await giveFuel(editing, pressed);
    // A source there may be wet.
    if (!context.objects().some((source) => source.kind === 'source' && distance(source, at.x, at.y) <= REACH))
      needFuel(context, at, REACH);
    await fire.ignite(at.x, at.y);
  });
}

/** Puts out what is around the pointer. @type {(context: ToolContext, from: Point) => Gesture} */
export function extinguish(context, from) {
  return repeatAlong(context, from, RADIUS / 2, async (at) => {
    needFuel(context, at, RADIUS);
    await context.fire.extinguish(at.x, at.y, RADIUS);
  });
}

/** Throws unless a solid with fuel is that near. @type {(context: ToolContext, at: Point, radius: number) => void} */
function needFuel({ objects }, { x, y }, radius) {
  if (!objects().some((solid) => isBody(solid) && solid.fuel !== 'none' && distance(solid, x, y) <= radius)) {
    throw new Error('Nothing there has fuel: press a solid.');
  }
}
