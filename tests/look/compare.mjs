/**
 * The visible difference of two pictures, in structure and in colour. Only lit pixels
 * count: a fire fills a third of its picture, and the empty rest would dilute every
 * difference.
 */

import { okLab } from './figures/colour.mjs';

/** @typedef {{width: number, height: number, rgb: Uint8Array}} Picture */

/** Pixels on a side of the windows in which structure is compared. */
const WINDOW = 7;

/** A pixel that differs by less from what is behind it shows nothing. */
const SEEN = 6;

/** A pixel of less chroma is grey. */
const GREY = 5;

/** SSIM's constants for values from 0 to 100. */
const [C1, C2] = [(0.01 * 100) ** 2, (0.03 * 100) ** 2];

/** A picture's OkLab, channel by channel. @param {Picture} picture */
function labs({ width, height, rgb }) {
  const count = width * height;
  const planes = [0, 1, 2].map(() => new Float64Array(count));
  for (let at = 0; at < count; at += 1) {
    okLab(rgb[3 * at], rgb[3 * at + 1], rgb[3 * at + 2]).forEach((value, k) => {
      planes[k][at] = value;
    });
  }
  return planes;
}

/**
 * Where either of two pictures shows something: not one of the colours that can be
 * behind a fire, black and white.
 * @param {Picture} a @param {Picture} b
 */
function shown(a, b) {
  const seen = new Uint8Array(a.width * a.height);
  for (const { rgb } of [a, b]) {
    for (let at = 0; at < seen.length; at += 1) {
      const [r, g, blue] = rgb.subarray(3 * at, 3 * at + 3);
      const least = Math.min(r, g, blue);
      if (Math.max(r, g, blue) > SEEN && least < 255 - SEEN) seen[at] = 1;
    }
  }
  return seen;
}

/**
 * What differs between two pictures of the same size.
 * @param {Picture} a @param {Picture} b
 */
export function compare(a, b) {
  if (a.width !== b.width || a.height !== b.height) {
    throw new Error(`${a.width} × ${a.height} and ${b.width} × ${b.height} cannot be compared`);
  }
  const seen = shown(a, b);
  const [ofA, ofB] = [labs(a), labs(b)];
  const differences = [];
  const distances = new Float64Array(seen.length);
  const shift = [0, 0, 0];
  let coloured = 0;
  for (let at = 0; at < seen.length; at += 1) {
    const apart = [0, 1, 2].map((k) => ofA[k][at] - ofB[k][at]);
    distances[at] = Math.hypot(...apart);
    if (seen[at]) differences.push(distances[at]);
    if (Math.max(...[ofA, ofB].map(([, x, y]) => Math.hypot(x[at], y[at]))) > GREY) {
      apart.forEach((component, k) => {
        shift[k] += component;
      });
      coloured += 1;
    }
  }
  differences.sort((low, high) => low - high);
  const mean = differences.reduce((sum, difference) => sum + difference, 0) / Math.max(differences.length, 1);
  return {
    /** Mean difference of colour: 100 from black to white, 2 to be seen. */
    colour: mean,
    /** By how much all that has a colour has another one: what rounding does cancels out. */
    shift: Math.hypot(...shift) / Math.max(coloured, 1),
    /** Exceeded by one pixel of a hundred. */
    worst: differences[Math.floor(0.99 * differences.length)] ?? 0,
    /** 1 where the structure is the same. */
    structure: structure(a, seen, ofA[0], ofB[0]),
    /** Share of the picture that shows something. */
    seen: differences.length / seen.length,
    /** Difference of colour of every pixel. */
    distances,
  };
}

/**
 * SSIM of lightness, the mean of all windows in whose middle there is something.
 * @param {Picture} size @param {Uint8Array} seen @param {Float64Array} a @param {Float64Array} b
 */
function structure({ width, height }, seen, a, b) {
  const half = WINDOW >> 1;
  let [sum, count] = [0, 0];
  for (let y = half; y < height - half; y += 2) {
    for (let x = half; x < width - half; x += 2) {
      if (!seen[y * width + x]) continue;
      let [ma, mb, aa, bb, ab] = [0, 0, 0, 0, 0];
      for (let dy = -half; dy <= half; dy += 1) {
        for (let at = (y + dy) * width + x - half; at <= (y + dy) * width + x + half; at += 1) {
          ma += a[at];
          mb += b[at];
          aa += a[at] * a[at];
          bb += b[at] * b[at];
          ab += a[at] * b[at];
        }
      }
      const n = WINDOW * WINDOW;
      ma /= n;
      mb /= n;
      const [va, vb, cov] = [aa / n - ma * ma, bb / n - mb * mb, ab / n - ma * mb];
      sum += ((2 * ma * mb + C1) * (2 * cov + C2)) / ((ma * ma + mb * mb + C1) * (va + vb + C2));
      count += 1;
    }
  }
  return count === 0 ? 1 : sum / count;
}
