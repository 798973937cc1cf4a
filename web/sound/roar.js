/**
 * The roar of a flame: the low band, which is the time derivative of its power, and the noise above it, whose level
 * follows the low band (Chadwick and James 2011).
 */

import { Filter, highPass, lowPass, section } from './filters.js';

/** Highest frequency of the low band [Hz], and its highest share of the rate of steps. */
const CUTOFF = 180;
const CUTOFF_SHARE = 0.35;
/** Lowest frequency that is heard [Hz]. */
const LOWEST = 25;
/** Exponent of the power spectral density of the noise (Clavin and Siggia 1991). */
export const NOISE_EXPONENT = 2.5;
/** Sections that make the slope between that of a low pass, 2, and the exponent, and their highest frequency [Hz]. */
const SECTIONS = 5;
const HIGHEST = 14_000;
/** Time over which the level of the low band is averaged [s]. */
const WINDOW = 0.04;
/** Change of the cut-off frequency that makes other filters. */
const CUTOFF_TOLERANCE = 0.1;
/** Frequencies at which the filters are integrated. */
const POINTS = 200;

/** The roar of one fire. */
export class Roar {
  #random;
  #rate;
  #cutoff = 0;
  #window;
  /** The low band, its upper octave, and the noise. @type {Filter[]} */
  #low;
  #octave = new Filter();
  /** @type {Filter[]} */
  #noise;
  /** Level of the noise over that of the upper octave. */
  #gain = 0;
  /** Mean square of the upper octave. */
  #level = 0;

  /** @param {() => number} random @param {number} rate sample rate [Hz] */
  constructor(random, rate) {
    this.#random = random;
    this.#rate = rate;
    this.#window = 1 - Math.exp(-1 / (WINDOW * rate));
    this.#low = [new Filter(), new Filter(highPass(LOWEST / rate))];
    this.#noise = Array.from({ length: SECTIONS + 2 }, () => new Filter());
    this.follow(CUTOFF / CUTOFF_SHARE);
  }

  /** Sets the filters for a rate of steps [1/s]. @param {number} steps */
  follow(steps) {
    const cutoff = Math.min(CUTOFF, CUTOFF_SHARE * steps);
    if (Math.abs(cutoff - this.#cutoff) <= CUTOFF_TOLERANCE * this.#cutoff) return;
    this.#cutoff = cutoff;
    const at = cutoff / this.#rate;
    this.#low[0].set(lowPass(at));
    this.#octave.set(highPass(0.5 * at));
    const ratio = (HIGHEST / cutoff) ** (1 / SECTIONS);
    const coefficients = [highPass(at), section(0.5 * at, Infinity)];
    for (let pole = at; coefficients.length < SECTIONS + 2; pole *= ratio)
      coefficients.push(section(pole, pole * ratio ** ((NOISE_EXPONENT - 2) / 2)));
    for (const [index, values] of coefficients.entries()) this.#noise[index].set(values);
    this.#match(at);
  }

  /** Finds the gain with which noise and low band have one spectral density at the cut-off. @param {number} cutoff */
  #match(cutoff) {
    let [octave, above, made] = [0, 0, 0];
    const [first, ratio] = [cutoff / 16, (8 / cutoff) ** (1 / POINTS)];
    for (let frequency = first; frequency < 0.5; frequency *= ratio) {
      const [angle, width] = [2 * Math.PI * frequency, frequency * (ratio - 1)];
      const density = (frequency / cutoff) ** -NOISE_EXPONENT * width;
      const low = this.#low[0].power(angle);
      octave += density * low * this.#octave.power(angle);
      above += density * this.#noise[0].power(angle);
      // White noise from −1 to 1 has the variance 1/3, spread from 0 to half of the rate.
      made += (2 / 3) * width * this.#noise.reduce((product, filter) => product * filter.power(angle), 1);
    }
    this.#gain = Math.sqrt(above / octave / made);
  }

  /** Advances by a sample, in which the power changes at that rate. @param {number} slope */
  run(slope) {
    const low = this.#low[1].run(this.#low[0].run(slope));
    const upper = this.#octave.run(low);
    this.#level += (upper * upper - this.#level) * this.#window;
    let noise = 2 * this.#random() - 1;
    for (const filter of this.#noise) noise = filter.run(noise);
    return low + noise * this.#gain * Math.sqrt(this.#level);
  }
}
