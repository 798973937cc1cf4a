/**
 * The recipe of the scene Burning word: what makes a mask glow and burn along its outline.
 */

/** The properties of a solid that burns. */
export const WORD = { material: 'coal', plane: 'before', thermal: 'conducting', temperature: 800, heat_capacity: 400 };

/** Those of the source on its surface. */
export const SOURCE = { noise: 0.6, oxygen: 0.6, temperature: 900 };

/**
 * Power of a metre of outline [kW/m] and the height of the word [m] in the scene. The height of a flame grows with the
 * power of a metre of width to two thirds; that of small letters is as much smaller.
 */
const POWER = 119;
const HEIGHT = 0.291;

/** The numbers of the letters of a mask, from `A`, and the first ones of runs: see `opacity.js`. */
const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';
const CLEAR = 16;
const OPAQUE = 40;
const SHORT = 16;
const HALF = 7.5;

/** Length of the steps along pixels in lengths of the lines that they follow, on average over all directions. */
const STEPS = Math.PI / 4;

/**
 * The power of a solid by the length of its outline and its height [kW/m].
 * @param {{[property: string]: unknown}} solid a mask, or a box
 */
export function powerOf({ shape, mask, width, height }) {
  const [wide, high] = [Number(width), Number(height)];
  const power = POWER * Math.min((high / HEIGHT) ** 0.5, 1);
  if (shape !== 'mask') return power * 2 * (wide + high);
  const [, columns, rows, letters] = /^(\d+)x(\d+):(.*)$/.exec(String(mask)) ?? [0, 1, 1, ''];
  const pixels = pixelsOf(String(letters));
  const [across, up] = [Number(columns), Number(rows)];
  const isIn = (/** @type {number} */ x, /** @type {number} */ y) =>
    x >= 0 && y >= 0 && x < across && y < up && pixels[y * across + x];
  let length = 0;
  for (let y = 0; y <= up; y += 1) {
    for (let x = 0; x <= across; x += 1) {
      if (isIn(x, y) !== isIn(x - 1, y)) length += high / up;
      if (isIn(x, y) !== isIn(x, y - 1)) length += wide / across;
    }
  }
  return power * STEPS * length;
}

/** Whether each pixel of a mask is opaque. @param {string} letters */
function pixelsOf(letters) {
  /** @type {boolean[]} */
  const pixels = [];
  for (const letter of letters) {
    const number = LETTERS.indexOf(letter);
    if (number < CLEAR) {
      pixels.push(number > HALF);
    } else {
      const isOpaque = number >= OPAQUE;
      const run = number - (isOpaque ? OPAQUE : CLEAR);
      const length = run < SHORT ? run + 2 : 32 << (run - SHORT);
      for (let at = 0; at < length; at += 1) pixels.push(isOpaque);
    }
  }
  return pixels;
}
