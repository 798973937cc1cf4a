/**
 * The buttons of the panel that act on the fire at an object: light it, put it out, spray it, throw sparks from it,
 * blow at it. Only the fuel that a solid gets is a step of the history. The tools do the same at a pointer.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('./editing.js').Editing} Editing
 * @typedef {import('./objects.js').Fields} Fields
 *
 * @typedef {object} Act
 * @property {string} name
 * @property {string} label
 * @property {(fire: HearthFire, body: Fields, object: Fields, editing: Editing) => Promise<void>} on  Does it at an
 *   object, whose body is where it is now.
 */

import { EVERY_MS, SPEED, giveFuel, needCombustion, pour } from './effects.js';
import { sizeOf } from './objects.js';

/** How often a press of a button calls for air or water. */
const CALLS = 12;

/** The distance from the object at which sparks and air begin, and that of water above it [m]. */
const NEAR = 0.03;
const ABOVE = 0.15;

/** In the order of the panel. @type {Act[]} */
export const ACTS = [
  { name: 'ignite', label: 'Ignite', on: ignite },
  { name: 'extinguish', label: 'Extinguish', on: extinguish },
  {
    name: 'water',
    label: 'Water',
    on: (fire, body) => again(() => pour(fire, body.x, topOf(body) + ABOVE)),
  },
  { name: 'sparks', label: 'Sparks', on: (fire, body) => fire.sparks(body.x, topOf(body) + NEAR) },
  {
    name: 'blow',
    label: 'Blow',
    on: (fire, body) => again(() => fire.stir(body.x - sizeOf(body).width / 2 - NEAR, body.y, SPEED, 0)),
  },
];

/**
 * Does one of {@link ACTS} at an object.
 * @type {(fire: HearthFire, editing: Editing, name: string, id: number) => Promise<void>}
 */
export async function act(fire, editing, name, id) {
  const found = ACTS.find((candidate) => candidate.name === name);
  const object = editing.find(id);
  if (found && object) await found.on(fire, await bodyOf(fire, editing, object), object, editing);
}

/** Lights a solid, or a source that water has put out. @type {Act['on']} */
async function ignite(fire, { x, y }, object, editing) {
  needCombustion(fire, 'fuels');
  if (object.kind === 'source') {
    await fire.ignite(x, y);
    return;
  }
  await giveFuel(editing, object);
  await fire.ignite(object.id);
}

/** Puts out a solid. @type {Act['on']} */
async function extinguish(fire, _body, { kind, id, fuel }) {
  if (kind === 'source') throw new Error('A source has no fuel: switch it off, or spray it with water.');
  if (fuel === 'none') throw new Error('The selected solid has no fuel.');
  await fire.extinguish(id);
}

/**
 * An object, or the solid whose surface it is, where it is now: forces move some solids.
 * @type {(fire: HearthFire, editing: Editing, object: Fields) => Promise<Fields>}
 */
async function bodyOf(fire, editing, object) {
  const isSurface = object.kind === 'source' && object.shape === 'solid';
  const body = (isSurface && editing.find(object.solid)) || object;
  const moved = body.motion === 'free' ? (await fire.freeSolids()).find(({ id }) => id === body.id) : undefined;
  const { x, y, angle } = moved ?? body;
  return { ...body, x, y, angle };
}

/** @param {Fields} body */
function topOf(body) {
  return body.y + sizeOf(body).height / 2;
}

/** Calls {@link CALLS} times within half a second. @param {() => Promise<void>} call */
async function again(call) {
  for (let at = 0; at < CALLS; at += 1) {
    await call();
    await new Promise((resolve) => setTimeout(resolve, EVERY_MS));
  }
}
