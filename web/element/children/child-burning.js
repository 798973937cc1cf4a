/**
 * A solid that burns: the recipe of the scene Burning word for the attribute `burning`, and the word of the attribute
 * `text`. This code is loaded when a child has one of them.
 *
 * @typedef {{[property: string]: unknown}} Values
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
