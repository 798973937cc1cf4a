/**
 * Where the fire's domain lies in its picture. These functions are pure, and `camera.rs` of the renderer
 * computes the same.
 */

/** @type {{[word: string]: number}} */
const ACROSS = { left: 0, center: 0.5, right: 1 };
/** @type {{[word: string]: number}} */
const UP = { bottom: 0, center: 0.5, top: 1 };

/**
 * An alignment in the words of CSS's `object-position`, as shares from left and from below.
 * @param {string} words
 * @returns {[number, number] | undefined} nothing where they are none
 */
export function alignment(words) {
  const [one, other = 'center', ...more] = words.trim().toLowerCase().split(/\s+/);
  if (more.length > 0) return undefined;
  for (const [across, up] of [[one, other], [other, one]]) {
    if (Object.hasOwn(ACROSS, across) && Object.hasOwn(UP, up)) return [ACROSS[across], UP[up]];
  }
  return undefined;
}

/**
 * Pixels in a metre, and where the middle of the floor is, in pixels from the lower left.
 * @param {{fit: string, x: number, y: number}} camera
 * @param {number} across width of the domain [m]
 * @param {number} up its height
 * @param {number} width of the picture in pixels
 * @param {number} height
 */
export function viewportOf({ fit, x, y }, across, up, width, height) {
  const [wide, high] = [width / across, height / up];
  const scale = { height: high, width: wide, contain: Math.min(wide, high), cover: Math.max(wide, high) }[fit] ?? high;
  return { scale, left: width * x + across * scale * (0.5 - x), bottom: (height - up * scale) * y };
}
