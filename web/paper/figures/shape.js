/**
 * The shape of a fire, from the positions of its particles.
 *
 * @typedef {object} Shape
 * @property {number} width  Of the middle 90 % of the particles [m].
 * @property {number} height  Above the source, of all but the highest 5 % [m].
 * @property {number} neighbours  Mean number of others within twice the smoothing radius.
 * @property {number} nearest  Mean distance to the nearest other [m].
 */

/** Share of the particles that are left out at an end. */
const TAIL = 0.05;

/** The value below which a share of the sorted numbers lies. @param {number[]} sorted @param {number} share */
const quantile = (sorted, share) => sorted[Math.min(Math.floor(share * sorted.length), sorted.length - 1)] ?? 0;

/**
 * @param {ArrayLike<number>} positions  x and y of each particle [m].
 * @param {number} source  The height of the source [m].
 * @param {number} radius  The smoothing radius [m].
 * @returns {Shape}
 */
export function shapeOf(positions, source, radius) {
  const count = positions.length / 2;
  const sorted = (/** @type {0 | 1} */ axis) =>
    Array.from({ length: count }, (_, at) => positions[2 * at + axis]).sort((a, b) => a - b);
  const [across, up] = [sorted(0), sorted(1)];
  const reach = 4 * radius * radius;
  const nearest = new Float64Array(count).fill(Infinity);
  let pairs = 0;
  for (let i = 0; i < count; i += 1) {
    for (let j = 0; j < i; j += 1) {
      const x = positions[2 * i] - positions[2 * j];
      const y = positions[2 * i + 1] - positions[2 * j + 1];
      const square = x * x + y * y;
      if (square < reach) pairs += 1;
      if (square < nearest[i]) nearest[i] = square;
      if (square < nearest[j]) nearest[j] = square;
    }
  }
  return {
    width: quantile(across, 1 - TAIL) - quantile(across, TAIL),
    height: quantile(up, 1 - TAIL) - source,
    neighbours: count ? (2 * pairs) / count : 0,
    nearest: count > 1 ? nearest.reduce((sum, square) => sum + Math.sqrt(square), 0) / count : 0,
  };
}

/** The mean of each property. @param {Shape[]} shapes @returns {Shape} */
export function meanOf(shapes) {
  const mean = (/** @type {keyof Shape} */ name) => shapes.reduce((sum, shape) => sum + shape[name], 0) / shapes.length;
  return { width: mean('width'), height: mean('height'), neighbours: mean('neighbours'), nearest: mean('nearest') };
}
