/**
 * Loops without a seam: which moments of a fire are alike, and what is shown between them.
 */

/** Longest time over which the end of a loop becomes its beginning, and time in which that is looked for [s]. */
const FADE_SECONDS = 0.3;
const SEARCH_SECONDS = 4;

/** A loop of so many pictures. Numbers count pictures from the start of the search. @type {(count: number, fps: number) => {fade: number, ends: number, searched: number}} */
export function loopOf(count, fps) {
  const fade = Math.max(1, Math.min(Math.round(FADE_SECONDS * fps), Math.floor(count / 4)));
  const ends = fade + Math.max(1, Math.round(SEARCH_SECONDS * fps));
  return { fade, ends, searched: ends + count };
}

/**
 * The number of the picture at which a loop begins: those that are mixed have the least distance.
 * @param {Uint8ClampedArray[]} pictures all that were searched, premultiplied
 * @param {number} count
 * @param {number} fps
 */
export function startOf(pictures, count, fps) {
  const { fade, ends } = loopOf(count, fps);
  const pairs = Array.from({ length: ends }, (_, at) => distance(pictures[at], pictures[at + count]));
  const sums = pairs.map((_, start) => pairs.slice(start - fade, start).reduce((sum, part) => sum + part, 0));
  const starts = Array.from({ length: ends - fade }, (_, at) => fade + at);
  return starts.reduce((best, start) => (sums[start] < sums[best] ? start : best), fade);
}

/** The share of the picture a loop's length before that of this number in the loop. @type {(number: number, count: number, fade: number) => number} */
export function shareOfEarlier(number, count, fade) {
  return Math.max(0, number + 1 + fade - count) / (fade + 1);
}

/** @type {(a: Uint8ClampedArray, b: Uint8ClampedArray) => number} */
function distance(a, b) {
  let sum = 0;
  for (let at = 0; at < a.length; at += 1) sum += Math.abs(a[at] - b[at]);
  return sum;
}

/** The transfer function of sRGB, from the value to the light. @param {number} value */
const decoded = (value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);

/** Steps of light in the table of values. */
const STEPS = 8192;

/** @type {{light: Float32Array, value: Uint8Array} | undefined} */
let tables;

/**
 * Mixes the light of two pictures with straight alpha, weighted by alpha, into the first.
 * @type {(pixels: Uint8ClampedArray, earlier: Uint8ClampedArray, share: number) => void}
 */
export function mix(pixels, earlier, share) {
  tables ??= {
    light: Float32Array.from({ length: 256 }, (_, value) => decoded(value / 255)),
    value: Uint8Array.from({ length: STEPS + 1 }, (_, step) => {
      const light = step / STEPS;
      return Math.round(255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055));
    }),
  };
  const { light, value } = tables;
  for (let at = 0; at < pixels.length; at += 4) {
    const [own, other] = [(1 - share) * pixels[at + 3], share * earlier[at + 3]];
    const alpha = own + other;
    if (alpha === 0) continue;
    for (let channel = at; channel < at + 3; channel += 1) {
      const mixed = (own * light[pixels[channel]] + other * light[earlier[channel]]) / alpha;
      pixels[channel] = value[Math.round(mixed * STEPS)];
    }
    pixels[at + 3] = alpha;
  }
}
