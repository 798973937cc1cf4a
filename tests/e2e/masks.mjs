/**
 * Reads the texts of masks.
 */
import assert from 'node:assert/strict';

/** The opacity of a mask's pixels, from 0 to 15, at a share of its width and height. @param {string} mask */
export function decoded(mask) {
  const [size, letters] = mask.split(':');
  const [columns, rows] = size.split('x').map(Number);
  const run = (/** @type {number} */ number) => (number < 16 ? number + 2 : 32 << (number - 16));
  const pixels = [...letters].flatMap((letter) => {
    const value = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_'.indexOf(letter);
    if (value < 16) return [value];
    return value < 40 ? Array(run(value - 16)).fill(0) : Array(run(value - 40)).fill(15);
  });
  assert.equal(pixels.length, columns * rows);
  return {
    at: (/** @type {number} */ x, /** @type {number} */ y) =>
      pixels[Math.floor(y * rows) * columns + Math.floor(x * columns)],
  };
}
