/**
 * Where the domain lies in its picture. `viewport.rs` of the renderer computes the same.
 *
 * @typedef {object} Camera
 * @property {string} fit how the domain fits the picture
 * @property {number} x where it lies: shares from the left
 * @property {number} y and from below
 * @property {number} zoom how much the picture is enlarged
 * @property {number} panX which part is seen: shares from the left
 * @property {number} panY and from below
 */

/** @type {{[word: string]: number}} */
const HORIZONTAL = { left: 0, center: 0.5, right: 1 };
/** @type {{[word: string]: number}} */
const VERTICAL = { bottom: 0, center: 0.5, top: 1 };

/**
 * An alignment in the keywords of CSS's `object-position`, as shares from the left and from below.
 * @param {string} words
 * @returns {[number, number] | undefined} undefined if it is invalid
 */
export function alignment(words) {
  const [first, other = 'center', ...more] = words.trim().toLowerCase().split(/\s+/);
  for (const [x, y] of more.length > 0
    ? []
    : [
        [first, other],
        [other, first],
      ]) {
    if (Object.hasOwn(HORIZONTAL, x) && Object.hasOwn(VERTICAL, y)) return [HORIZONTAL[x], VERTICAL[y]];
  }
  return undefined;
}

/**
 * A part of an enlarged picture: two shares, from the left and from below.
 * @param {string} words
 * @returns {number[] | undefined} undefined if it is invalid
 */
export function panning(words) {
  const shares = words.trim().split(/\s+/).map(Number);
  return shares.length === 2 && shares.every((share) => share >= 0 && share <= 1) ? shares : undefined;
}

/**
 * Pixels per metre, and the middle of the floor in pixels from the lower left corner.
 * @param {Camera} camera
 * @param {number} across width of the domain [m]
 * @param {number} up its height [m]
 * @param {number} width of the picture in pixels
 * @param {number} height
 */
export function viewportOf({ fit, x, y, zoom, panX, panY }, across, up, width, height) {
  const [wide, high] = [width / across, height / up];
  const scale = { width: wide, contain: Math.min(wide, high), cover: Math.max(wide, high) }[fit] ?? high;
  return {
    scale: scale * zoom,
    left: (width * x + across * scale * (0.5 - x)) * zoom - width * panX * (zoom - 1),
    bottom: (height - up * scale) * y * zoom - height * panY * (zoom - 1),
  };
}
