/** Positions of a slider and the values that they stand for. */

/** Positions from one end to the other. */
export const POSITIONS = 60;

/**
 * The value at a position, in two significant digits.
 * @param {number} position  0 to {@link POSITIONS}
 * @param {number} from @param {number} to
 * @param {boolean} log  Whether equal distances are equal ratios.
 */
export function valueAt(position, from, to, log) {
  const share = position / POSITIONS;
  const value = log ? from * (to / from) ** share : from + share * (to - from);
  return Number(value.toPrecision(2));
}

/**
 * The position whose value is nearest.
 * @param {number} value @param {number} from @param {number} to @param {boolean} log
 */
export function positionOf(value, from, to, log) {
  const share = log ? Math.log(value / from) / Math.log(to / from) : (value - from) / (to - from);
  return Math.round(POSITIONS * Math.min(Math.max(share, 0), 1));
}
