/**
 * The body of a flame in a film: where its light is, how often its top is luminous, and what is loose of it.
 */

/** Luminous is a pixel of this share of the 99th percentile of what is not dark. */
const [LUMINOUS, DARK] = [0.12, 0.02];
/** A row is luminous with this share of the widest row's mean count. */
const ROW = 0.04;
/** The base is the lowest row that is nearly always so wide. */
const [BASE_ROW, BASE_TIMES] = [0.3, 0.9];
/** Half of the heights over which it is averaged how often a row is luminous. */
const ROWS_AROUND = 0.03;
/** A piece has so many pixels of a picture of 400 lines. */
const PIECE = 12;
/** What reaches into this share of the height above the base belongs to the flame. */
const SEATED = 0.25;
/** Pieces are counted in every so many pictures. */
export const PIECES_EVERY = 3;

/** @typedef {{width: number, height: number, luminance: Float32Array[]}} Pictures */

/**
 * Luminance above which a pixel is luminous.
 * @param {Pictures} pictures
 */
export function threshold({ luminance }) {
  const bright = luminance
    .filter((_, k) => k % 4 === 0)
    .flatMap((of) => Array.from(of).filter((value) => value > DARK));
  bright.sort((a, b) => a - b);
  return LUMINOUS * bright[Math.floor(0.99 * (bright.length - 1))];
}

/**
 * Base and height of the flame [rows], from the upper edge. L50 is the height up to which a row is luminous half of the time.
 * @param {Pictures} pictures @param {number} level
 */
export function extent({ width, height, luminance }, level) {
  const counts = luminance.map((of) => {
    const rows = new Array(height).fill(0);
    of.forEach((value, at) => {
      if (value > level) rows[Math.floor(at / width)] += 1;
    });
    return rows;
  });
  const rows = Array.from({ length: height }, (_, row) => row);
  const times = (/** @type {number} */ row, /** @type {number} */ least) =>
    counts.filter((of) => of[row] >= least).length / counts.length;
  const widest = Math.max(...rows.map((row) => counts.reduce((sum, of) => sum + of[row], 0) / counts.length));
  const base = rows.findLast((row) => times(row, BASE_ROW * widest) > BASE_TIMES) ?? height - 1;
  const present = rows.map((row) => times(row, ROW * widest));
  const top = present.findIndex((share) => share >= 0.5);
  const tall = base - top;
  // The mean of a few rows: one row of a short film is noise. A flame that leaves the picture has none above it.
  const around = (/** @type {number} */ of) => {
    if ((of + ROWS_AROUND) * tall > base) return NaN;
    const [from, to] = rowsOf({ base, tall }, of - ROWS_AROUND, of + ROWS_AROUND);
    return present.slice(from, to).reduce((sum, share) => sum + share, 0) / Math.max(to - from, 1);
  };
  return { base, tall, intermittency: around };
}

/**
 * Rows of a part of the height, whose ends are shares of it: first and one behind the last.
 * @param {{base: number, tall: number}} extent @param {number} low @param {number} high @returns {[number, number]}
 */
export function rowsOf({ base, tall }, low, high) {
  return [Math.max(0, Math.round(base - high * tall)), Math.round(base - low * tall)];
}

/**
 * Luminous regions that are not connected with the flame's lower part: their number, and their share of the light.
 * @param {Float32Array} picture @param {number} width @param {number} level @param {{base: number, tall: number}} extent
 */
export function loose(picture, width, level, { base, tall }) {
  const seen = new Uint8Array(picture.length);
  const seat = [base - SEATED * tall, base];
  let [pieces, light, all] = [0, 0, 0];
  for (let first = 0; first < picture.length; first += 1) {
    if (seen[first] || picture[first] <= level) continue;
    const region = [first];
    seen[first] = 1;
    let [sum, seated] = [0, false];
    for (const at of region) {
      sum += picture[at];
      const [x, y] = [at % width, Math.floor(at / width)];
      seated ||= y >= seat[0] && y <= seat[1];
      for (let dy = -1; dy <= 1; dy += 1) {
        for (let dx = -1; dx <= 1; dx += 1) {
          const next = at + dy * width + dx;
          if (x + dx < 0 || x + dx >= width || seen[next] !== 0 || !(picture[next] > level)) continue;
          seen[next] = 1;
          region.push(next);
        }
      }
    }
    if (region.length < PIECE) continue;
    all += sum;
    if (!seated) [pieces, light] = [pieces + 1, light + sum];
  }
  return { pieces, light: all > 0 ? light / all : 0 };
}
