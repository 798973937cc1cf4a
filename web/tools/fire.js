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

/** The width of a finger [px]: a press finds what is that near. */
const FINGER_PX = 48;

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
 * Lights the nearest fuel or source within a finger's width. A solid without fuel that is pressed gets that of its
 * material.
 * @type {(context: ToolContext, from: Point, pressed: import('./gestures.js').Owned | undefined, perPixel: number) => Gesture}
 */
export function ignite(context, from, pressed, perPixel) {
  const { fire, editing } = context;
  const finger = Math.max(REACH, FINGER_PX * perPixel);
  return repeatAlong(context, from, APART, async (at) => {
    needCombustion(fire, 'fuels');
    let refusal = new Error('Nothing to light there: touch wood, another solid that burns, or a source.');
    if (at === from && pressed && isBody(pressed))
      await giveFuel(editing, pressed).catch((error) => {
        refusal = error;
      });
    const all = context.objects();
    const burns = all.filter((one) => (one.kind === 'source' ? one.power > 0 : isBody(one) && one.fuel !== 'none'));
    // A source may be the surface of a solid.
    const bodies = burns.map((one) => (one.shape === 'solid' && all.find(({ id }) => id === one.solid)) || one);
    const nearest = Math.min(...bodies.map((one) => distance(one, at.x, at.y)));
    if (!(nearest <= finger)) throw refusal;
    await fire.ignite(at.x, at.y, Math.max(REACH, nearest + REACH / 2));
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
