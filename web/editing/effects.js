/**
 * What both the tools and the buttons of the panel do to the fire: the air, the water and the fuel that they give.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 */

/** Speed of the air that is blown [m/s]: a few times that of a pointer that stirs. */
export const SPEED = 16;

/** How often air and water are called for anew [ms]: one call acts for a twentieth of a second. */
export const EVERY_MS = 40;

/** Speed of the water downwards [m/s], and its mass in a call for each metre of the domain's height [g/m]. */
const FALL = 3;
const GRAMS = 4;

/** The fuels of materials; others do not burn by themselves. @type {{[material: string]: string}} */
const FUELS = { wood: 'wood', coal: 'coal', wax: 'wax', none: 'wood' };

/** The fuel of such a solid [kg/m²]: that of a log, which burns for half a minute. */
const LOAD = 12;

/**
 * Gives a solid without fuel that of its material: a step of the history.
 * @type {(editing: import('./editing.js').Editing, solid: import('./objects.js').Fields) => Promise<void>}
 */
export async function giveFuel(editing, { id, material, fuel }) {
  if (fuel !== 'none') return;
  const own = FUELS[material];
  if (!own) throw new Error(`A solid of ${material} has no fuel: choose wood, coal or wax.`);
  await editing.change(new Map([[id, { fuel: own, load: LOAD }]]));
}

/** Throws in the classic model. @type {(fire: HearthFire, what: string) => void} */
export function needCombustion(fire, what) {
  if (fire.params.model === 'classic') throw new Error(`The classic model has no ${what}.`);
}

/** Sprays water downwards from a point. @type {(fire: HearthFire, x: number, y: number) => Promise<void>} */
export async function pour(fire, x, y) {
  needCombustion(fire, 'water');
  await fire.spray(x, y, 0, -FALL, GRAMS * fire.params.domain_height);
}
