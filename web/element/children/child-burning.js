/**
 * A solid that burns: the recipe of the scene Burning word for the attribute `burning`, and the word of the attribute
 * `text`. This code is loaded when a child has one of them.
 *
 * @typedef {{[property: string]: unknown}} Values
 * @typedef {{kind: string, id: number, values?: Values | null}} Sent a child for the engine
 */

import { maskOfText } from '../../mask.js';
import { SOURCE, WORD, powerOf } from '../../mask/burning.js';

/** The font of a word without one. */
const FONT = '800 1em system-ui, sans-serif';

/** Width of a word without one, as a share of the width of the domain, and the height of its lower edge [m]. */
const SHARE = 0.8;
const FOOT = 0.085;

/** The largest power of a source [kW/m]. */
const MAX_POWER = 3000;

/**
 * Spacings of the gas in the height of a solid, some more than in the scene: the flames along its outline are thin. And the numbers of
 * particles of the levels medium and high, which no fire exceeds unasked.
 */
const SPACINGS = 18;
const [MEDIUM, HIGH] = [3000, 6700];

/** How much finer the gas must become before it is changed again: a target may grow and shrink in each frame. */
const FINER = 1.1;

/**
 * The number of particles that the recipe has stated last of each fire, and whether that is answered.
 * @type {WeakMap<object, {number: number, isOpen: boolean}>}
 */
const STATED = new WeakMap();

/** What a solid that burns has where its attributes state nothing. @type {Values} */
export const SOLID = WORD;

/**
 * The source that burns along the outline of a solid.
 * @param {number} solid its id
 * @param {Values | null | undefined} placed what is known of the solid; null if it has no object
 */
export function sourceOn(solid, placed) {
  if (!placed) return null;
  return { shape: 'solid', solid, ...SOURCE, power: Math.min(Math.round(powerOf(placed)), MAX_POWER) };
}

/**
 * The place and the mask of a word.
 * @param {Element} element whose attributes state the word, its font, its width and its place
 * @param {number} across width of the domain [m]
 * @throws {RangeError} no glyph has ink, it is no font, or it has no such width
 */
export function wordOf(element, across) {
  const number = (/** @type {string} */ name, /** @type {number} */ otherwise) => {
    const text = element.getAttribute(name);
    return text === null || text.trim() === '' ? otherwise : Number(text);
  };
  const text = element.getAttribute('text') ?? '';
  const mask = maskOfText(text, element.getAttribute('font') ?? FONT, number('width', SHARE * across));
  const [x, y] = [number('x', 0), number('y', mask.height / 2 + FOOT)];
  return { ...mask, x, y };
}

/**
 * Makes the gas fine enough for the lowest solid that burns, unless the page states how fine it is. It takes at most the
 * particles of the level above the one that is requested or fits the device; a scene with more keeps them.
 * @param {import('../session/session.js').FireSession} session
 * @param {Sent[]} list the children
 */
export function refine(session, list) {
  const { fire, state } = session;
  const { values = {} } = state.settings;
  const last = STATED.get(session);
  const stated = values.spacing ?? values.particles;
  const isOthers = stated !== undefined && stated !== last?.number;
  if (!state.started || last?.isOpen || isOthers || fire.hasAttribute('particles') || fire.hasAttribute('spacing'))
    return;
  // Sources of the page have texts of attributes.
  const solids = list.filter(({ values }) => typeof values?.power === 'number').map((flame) => flame.values?.solid);
  const heights = list.filter(({ id }) => solids.includes(id)).map((solid) => Number(solid.values?.height));
  const { domain_width, domain_height, particles } = state.params;
  const needed = domain_width * domain_height * (SPACINGS / Math.min(...heights)) ** 2;
  const requested = fire.getAttribute('quality') ?? 'auto';
  const level = requested === 'auto' ? state.guess : requested;
  const [least, most] = [level === 'high' ? HIGH : particles, level === 'low' ? MEDIUM : HIGH];
  const number = Math.round(Math.max(Math.min(needed, most), least));
  if (!(needed > 0) || number < FINER * (stated ?? 0)) return;
  const call = { number, isOpen: true };
  STATED.set(session, call);
  const answered = () => (call.isOpen = false);
  session.call('set', { particles: number }, 'attribute').then(answered, answered);
}
