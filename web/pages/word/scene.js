/**
 * The scene of a visitor's word or logo: the recipe of Burning word, framed for the shape of what burns.
 *
 * @typedef {import('../../mask.js').HearthMask} HearthMask
 */

import { SOURCE, WORD, powerOf } from '../../mask/burning.js';

/** The scene whose values it has. */
const PRESET = 'burning-word';

/** Its frame, the largest width and height of what burns there, and the height of the lower edge [m]. */
const FRAME = { width: 1.26, height: 1.05 };
const [WIDEST, HIGHEST, FOOT] = [1.008, 0.45, 0.085];

/** The height of the word that the frame is made for [m]. */
const HEIGHT = 0.291;

/** The id of the solid, which follows the source. */
const SOLID = 2;

/** Letters on a line, from which on a text of several words takes more lines. */
const LINE = 11;

/**
 * Settings in which a mask burns.
 * @param {HearthMask} mask
 * @returns {import('../../hearth-fire.js').HearthConfig}
 */
export function sceneOf(mask) {
  const ratio = mask.height / mask.width;
  const width = rounded(Math.min(WIDEST, HIGHEST / ratio));
  const height = rounded(Math.max(width * ratio, 0.002));
  const solid = { shape: 'mask', mask: mask.mask, width, height, x: 0, y: rounded(height / 2 + FOOT), ...WORD };
  const domain_height = rounded(FRAME.height + Math.max(height - HEIGHT, 0));
  return /** @type {any} */ ({
    hearth: 3,
    preset: PRESET,
    values: domain_height === FRAME.height ? {} : { domain_height },
    objects: [
      { kind: 'source', id: 1, shape: 'solid', solid: SOLID, ...SOURCE, power: Math.round(powerOf(solid)) },
      { kind: 'solid', id: SOLID, ...solid },
    ],
  });
}

/** Lengths are whole millimetres. @param {number} metres */
const rounded = (metres) => Math.round(1000 * metres) / 1000;

/**
 * The lines of a text: words of a long text share lines of nearly the same length.
 * @param {string} text
 */
export function linesOf(text) {
  const words = text.trim().split(/\s+/).filter(Boolean);
  const letters = [...words.join(' ')].length;
  const wanted = letters / Math.ceil(letters / LINE / 1.5);
  /** @type {string[]} */
  const lines = [];
  for (const word of words) {
    const last = lines.at(-1);
    const isFull = last === undefined || [...last].length + [...word].length / 2 > wanted;
    if (isFull) lines.push(word);
    else lines[lines.length - 1] = `${last} ${word}`;
  }
  return lines;
}
