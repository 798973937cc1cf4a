/**
 * Digital filters of first and second order, and a seeded generator.
 */

/** A filter of second order in transposed direct form II. */
export class Filter {
  // Plain fields: this runs for every sample.
  b0 = 0;
  b1 = 0;
  b2 = 0;
  a1 = 0;
  a2 = 0;
  past1 = 0;
  past2 = 0;

  /** @param {number[]} coefficients b0, b1, b2, a1, a2, with a0 = 1 */
  constructor(coefficients = [0, 0, 0, 0, 0]) {
    this.set(coefficients);
  }

  /** Keeps what it has heard. @param {number[]} coefficients */
  set(coefficients) {
    [this.b0, this.b1, this.b2, this.a1, this.a2] = coefficients;
  }

  /** Filters a sample. @param {number} sample */
  run(sample) {
    const result = this.b0 * sample + this.past1;
    this.past1 = this.b1 * sample - this.a1 * result + this.past2;
    this.past2 = this.b2 * sample - this.a2 * result;
    return result;
  }

  /** Squared magnitude of the transfer function. @param {number} angle angular frequency [rad/sample] */
  power(angle) {
    const { b0, b1, b2, a1, a2 } = this;
    const [cos, sin, cos2, sin2] = [Math.cos(angle), Math.sin(angle), Math.cos(2 * angle), Math.sin(2 * angle)];
    const squared = (/** @type {number} */ c0, /** @type {number} */ c1, /** @type {number} */ c2) =>
      (c0 + c1 * cos + c2 * cos2) ** 2 + (c1 * sin + c2 * sin2) ** 2;
    return squared(b0, b1, b2) / squared(1, a1, a2);
  }
}

/** Frequencies are shares of the sample rate from here on, and warped for the bilinear transform. */
const warped = (/** @type {number} */ frequency) => Math.tan(Math.PI * Math.min(frequency, 0.49));

/** Butterworth's low pass of second order. @param {number} frequency */
export function lowPass(frequency) {
  const [, b1, b2, b0, a1, a2] = butterworth(frequency);
  return [b0, b1, b2, a1, a2];
}

/** Butterworth's high pass of second order. @param {number} frequency */
export function highPass(frequency) {
  const [high, , , , a1, a2] = butterworth(frequency);
  return [high, -2 * high, high, a1, a2];
}

/** Gain of the high pass, then b1, b2 and b0 of the low pass, then a1 and a2. @param {number} frequency */
function butterworth(frequency) {
  const k = warped(frequency);
  const norm = 1 / (1 + Math.SQRT2 * k + k * k);
  const low = k * k * norm;
  return [norm, 2 * low, low, low, 2 * (k * k - 1) * norm, (1 - Math.SQRT2 * k + k * k) * norm];
}

/**
 * A section of first order, (1 + s / zero) / (1 + s / pole); an infinite zero makes it a low pass.
 * @param {number} pole
 * @param {number} zero
 */
export function section(pole, zero) {
  const [p, z] = [1 / warped(pole), zero === Infinity ? 0 : 1 / warped(zero)];
  const norm = 1 / (1 + p);
  return [(1 + z) * norm, (1 - z) * norm, 0, (1 - p) * norm, 0];
}

/** A high shelf of first order. @param {number} frequency @param {number} gain of what is above it */
export function shelf(frequency, gain) {
  const k = warped(frequency);
  const norm = 1 / (1 + k);
  return [(gain + k) * norm, (k - gain) * norm, 0, (k - 1) * norm, 0];
}

/** A band pass with a peak of 1. @param {number} frequency @param {number} quality */
export function bandPass(frequency, quality) {
  const k = warped(frequency);
  const norm = 1 / (1 + k / quality + k * k);
  const peak = (k / quality) * norm;
  return [peak, 0, -peak, 2 * (k * k - 1) * norm, (1 - k / quality + k * k) * norm];
}

/**
 * A generator of numbers from 0 to 1 (mulberry32): the same seed gives the same numbers everywhere.
 * @param {number} seed
 */
export function generator(seed) {
  let state = seed | 0;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}
