/**
 * The tool that lights what has fuel. It is no step of the history, but for the fuel that a solid gets.
 *
 * @typedef {import('./geometry.js').Point} Point
 * @typedef {import('./gestures.js').Gesture} Gesture
 * @typedef {import('./gestures.js').Hands} Hands
 */

import { distance } from '../panel/objects.js';

/** How far a press lights, and the distance of the places that a drag lights [m]. */
const REACH = 0.1;
const APART = 0.05;

/** The fuels of materials; others do not burn by themselves. @type {{[material: string]: string}} */
const FUELS = { wood: 'wood', coal: 'coal', wax: 'wax', none: 'wood' };

/** The fuel of such a solid [kg/m²]: that of a log, which burns for half a minute. */
const LOAD = 12;

/**
 * Lights what is under the pointer. A solid without fuel gets that of its material.
 * @type {(hands: Hands, from: Point, pressed: import('./gestures.js').Owned | undefined) => Gesture}
 */
export function ignite(hands, from, pressed) {
  const { fire, editing } = hands;
  const light = async (/** @type {Point} */ at) => {
    if (fire.params.model === 'classic') throw new Error('The classic model has no fuels.');
    const bare = at === from && pressed?.kind === 'solid' && pressed.fuel === 'none' ? pressed : undefined;
    const fuel = bare && FUELS[bare.material];
    if (bare && !fuel) throw new Error(`A solid of ${bare.material} has no fuel: draw one of wood, coal or wax.`);
    if (bare) await editing.history.change(bare.id, { fuel, load: LOAD });
    needFuel(hands, at);
    await fire.ignite(at.x, at.y);
  };
  let last = from;
  // One place after the other. Only what the press meets is told: a drag crosses the air.
  let done = hands.attempt(() => light(from));
  return {
    move(to) {
      if (Math.hypot(to.x - last.x, to.y - last.y) < APART) return;
      last = to;
      done = done.then(() => light(to)).catch(() => {});
    },
    end() {},
    cancel() {},
  };
}

/** Throws unless a solid with fuel is near. @type {(hands: Hands, at: Point) => void} */
function needFuel({ objects }, { x, y }) {
  if (!objects().some((one) => one.kind === 'solid' && one.fuel !== 'none' && distance(one, x, y) <= REACH)) {
    throw new Error('Nothing there has fuel: press a solid.');
  }
}
