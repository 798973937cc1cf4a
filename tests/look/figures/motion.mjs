/**
 * Which way a picture moves, block by block.
 *
 * Blocks are compared less their own means. Flames flicker: where one that only fades
 * towards its tip grows darker as a whole, what was dark is found further down, and gas
 * that rises would seem to fall. Of a block that brightens or darkens, its structure shows
 * where it went.
 */

/** Pixels on a side of a block. */
const BLOCK = 8;
/** How far a block is looked for: across, down, up. */
const [ACROSS, DOWN, UP] = [5, 6, 16];
/** How much the lightness in a block has to vary for its motion to be seen, and its best
    place to be better than staying, as a share. */
const [TEXTURE, BETTER] = [0.02, 0.7];

/**
 * Of the luminous area, how many blocks go up, how many go anywhere, and how many have
 * a motion that can be seen, if only that they stay.
 * @param {Float32Array} before @param {Float32Array} now  Luminances, from the upper left.
 * @param {number} width @param {number} height @param {number} luminous
 * @returns {[number, number, number]}
 */
export function rising(before, now, width, height, luminous) {
  // As an eye sees it: else only the brightest would count.
  const [a, b] = [before, now].map((picture) => picture.map(Math.cbrt));
  const [inA, inB] = [a, b].map((picture) => sums(picture, width, height));
  /** @param {number} x @param {number} y @param {number} dx @param {number} dy @param {number} enough */
  const off = (x, y, dx, dy, enough) => {
    const brighter = (inA(x, y) - inB(x + dx, y + dy)) / BLOCK ** 2;
    return apart(a, b, x, y, dx, dy, brighter, width, enough);
  };
  let [up, moving, all] = [0, 0, 0];
  for (let y = UP; y + BLOCK + DOWN <= height; y += BLOCK) {
    for (let x = ACROSS; x + BLOCK + ACROSS <= width; x += BLOCK) {
      if (!textured(a, x, y, width, Math.cbrt(luminous))) continue;
      const stays = off(x, y, 0, 0, Infinity);
      let [least, across, risen] = [Infinity, 0, 0];
      for (let dy = -UP; dy <= DOWN; dy += 1) {
        for (let dx = -ACROSS; dx <= ACROSS; dx += 1) {
          const found = off(x, y, dx, dy, least);
          if (found < least) [least, across, risen] = [found, dx, -dy];
        }
      }
      const stayed = risen === 0 && across === 0;
      // One that has changed more than it has moved shows nothing, nor does one at the end of
      // where it was looked for.
      if (!stayed && least > BETTER * stays) continue;
      if (Math.abs(across) === ACROSS || risen === UP || risen === -DOWN) continue;
      all += 1;
      if (!stayed) moving += 1;
      if (risen > 0) up += 1;
    }
  }
  return [up, moving, all];
}

/** Whether a block is luminous and not even. */
function textured(picture, x, y, width, luminous) {
  let [sum, squares] = [0, 0];
  for (let row = y; row < y + BLOCK; row += 1) {
    for (let at = row * width + x; at < row * width + x + BLOCK; at += 1) {
      sum += picture[at];
      squares += picture[at] ** 2;
    }
  }
  const mean = sum / BLOCK ** 2;
  return mean > luminous && squares / BLOCK ** 2 - mean ** 2 > TEXTURE ** 2;
}

/**
 * The sum over a block that begins there.
 * @param {Float32Array} picture @param {number} width @param {number} height
 * @returns {(x: number, y: number) => number}
 */
function sums(picture, width, height) {
  const stride = width + 1;
  const before = new Float64Array(stride * (height + 1));
  for (let y = 0; y < height; y += 1) {
    let row = 0;
    for (let x = 0; x < width; x += 1) {
      row += picture[y * width + x];
      before[(y + 1) * stride + x + 1] = before[y * stride + x + 1] + row;
    }
  }
  return (x, y) => {
    const [upper, lower] = [y * stride + x, (y + BLOCK) * stride + x];
    return before[lower + BLOCK] - before[lower] - before[upper + BLOCK] + before[upper];
  };
}

/** How different a block is from what stands there, moved, one picture later, but for
    being that much brighter as a whole. */
function apart(a, b, x, y, dx, dy, brighter, width, enough) {
  let sum = 0;
  for (let row = y; row < y + BLOCK; row += 1) {
    const shift = dy * width + dx;
    for (let at = row * width + x; at < row * width + x + BLOCK; at += 1) {
      sum += Math.abs(a[at] - b[at + shift] - brighter);
    }
    if (sum >= enough) return sum;
  }
  return sum;
}
