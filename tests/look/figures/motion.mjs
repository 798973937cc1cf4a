/**
 * Which way a picture moves, block by block.
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
  let [up, moving, all] = [0, 0, 0];
  for (let y = UP; y + BLOCK + DOWN <= height; y += BLOCK) {
    for (let x = ACROSS; x + BLOCK + ACROSS <= width; x += BLOCK) {
      if (!textured(a, x, y, width, Math.cbrt(luminous))) continue;
      const stays = apart(a, b, x, y, 0, 0, width, Infinity);
      let [least, across, risen] = [Infinity, 0, 0];
      for (let dy = -UP; dy <= DOWN; dy += 1) {
        for (let dx = -ACROSS; dx <= ACROSS; dx += 1) {
          const off = apart(a, b, x, y, dx, dy, width, least);
          if (off < least) [least, across, risen] = [off, dx, -dy];
        }
      }
      const stayed = risen === 0 && across === 0;
      // One that has changed more than it has moved says nothing, nor one at the end of
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

/** How different a block is from what stands there, moved, one picture later. */
function apart(a, b, x, y, dx, dy, width, enough) {
  let sum = 0;
  for (let row = y; row < y + BLOCK; row += 1) {
    const shift = dy * width + dx;
    for (let at = row * width + x; at < row * width + x + BLOCK; at += 1) {
      sum += Math.abs(a[at] - b[at + shift]);
    }
    if (sum >= enough) return sum;
  }
  return sum;
}
