/**
 * Crackle: cracks at random times, whose sizes follow a power law.
 */

import { Filter, bandPass } from './filters.js';

/** Amplitude of the smallest crack, relative to full scale. */
const SMALLEST = 0.016;
/** Amplitude of the largest over that of the smallest. */
const LARGEST_RATIO = 30;
/**
 * Exponent of the distribution of sizes: P(amplitude > a) ∝ a^−1, because energies E of crackling noise have the
 * density E^−1.5 (Sethna, Dahmen and Myers 2001).
 */
const SIZE_EXPONENT = 1;
/** Decay time of the smallest crack and the longest decay time [s]. */
const SHORTEST_DECAY = 0.001;
const LONGEST_DECAY = 0.03;
/** Rise of a crack [s]. */
const RISE = 0.0002;
/** Width of the band of a crack: the quality of its resonance. */
const BAND_QUALITY = 1.4;
/** Middle of the band of a solid of that load [Hz], [kg/m²]: light sheets crack higher than logs. */
const BAND = 1900;
const BAND_LOAD = 12;
/** The lowest and the highest middle of a band, and that of sparks without fuel [Hz]. */
const LOWEST_BAND = 1500;
const HIGHEST_BAND = 6000;
const SPARK_BAND = 2800;
/** Ratio of the highest to the lowest middle of cracks of the same solid. */
const BAND_SPREAD = 2.5;
/** Decay times after which a crack is silent. */
const DECAYS_HEARD = 7;
/** Most cracks at a time. */
const MAX_CRACKS = 32;

/**
 * @typedef {object} Crack
 * @property {number} amplitude
 * @property {number} rise  Share of its rise that has passed.
 * @property {number} decay  Share of the amplitude that is left after a sample.
 * @property {number} left  Samples until it is silent.
 * @property {Filter} filter
 * @property {number} pan  From −1, left, to 1, right.
 */

/** The cracks of one fire. */
export class Cracks {
  #random;
  #rate;
  /** Expected number of cracks until now, and that of the next. A Poisson process in that time has the rate 1. */
  #expected = 0;
  #next = 0;
  /** @type {Crack[]} */
  #all = [];
  left = 0;
  right = 0;

  /** @param {() => number} random @param {number} rate sample rate [Hz] */
  constructor(random, rate) {
    this.#random = random;
    this.#rate = rate;
    this.#wait();
  }

  #wait() {
    this.#next = this.#expected - Math.log(1 - this.#random());
  }

  /**
   * Advances by a sample, in which cracks begin at that rate [1/s]. Returns whether one begins.
   * @type {(rate: number, load: number, pan: number) => boolean}
   */
  advance(rate, load, pan) {
    this.#expected += rate / this.#rate;
    const begins = this.#expected >= this.#next;
    if (begins) {
      this.#wait();
      if (this.#all.length < MAX_CRACKS) this.#begin(load, pan);
    }
    this.left = this.right = 0;
    if (this.#all.length > 0) this.#sound();
    return begins;
  }

  /** @param {number} load @param {number} pan */
  #begin(load, pan) {
    const size = Math.min((1 - this.#random()) ** (-1 / SIZE_EXPONENT), LARGEST_RATIO);
    const decay = Math.min(SHORTEST_DECAY * size, LONGEST_DECAY) * this.#rate;
    const middle = load > 0 ? BAND * Math.sqrt(BAND_LOAD / load) : SPARK_BAND;
    const within = Math.min(Math.max(middle, LOWEST_BAND), HIGHEST_BAND);
    const band = within * BAND_SPREAD ** (this.#random() - 0.5);
    this.#all.push({
      amplitude: SMALLEST * size,
      rise: 0,
      decay: Math.exp(-1 / decay),
      left: DECAYS_HEARD * decay,
      filter: new Filter(bandPass(band / this.#rate, BAND_QUALITY)),
      pan,
    });
  }

  #sound() {
    for (const crack of this.#all) {
      crack.rise = Math.min(crack.rise + 1 / (RISE * this.#rate), 1);
      const sample = crack.filter.run(crack.amplitude * crack.rise * (2 * this.#random() - 1));
      crack.amplitude *= crack.decay;
      crack.left -= 1;
      this.left += sample * Math.sqrt(0.5 * (1 - crack.pan));
      this.right += sample * Math.sqrt(0.5 * (1 + crack.pan));
    }
    if (this.#all.some(({ left }) => left <= 0)) this.#all = this.#all.filter(({ left }) => left > 0);
  }
}
