/**
 * The sound of one fire, computed from the series of its steps. It needs no browser: the page schedules its samples,
 * and `examples/` writes them to a file. The same series, seed and calls give the same samples. docs/sound.md has the
 * equations and their sources.
 */

import { Cracks } from './cracks.js';
import { Filter, generator, highPass, lowPass, shelf } from './filters.js';
import { Roar } from './roar.js';

/** Numbers of a step in the series: see `StepRecord` of the core. */
export const STEP_NUMBERS = 12;

/** Level of the roar: samples for a change of power by 1 kW/m in a second, at the reference power. */
const ROAR_LEVEL = 7e-5;
/**
 * Exponent of the loudness of the power, and the power at which the level is that of the constant above [kW/m]. The
 * level is smoothed over that time [s]. Below the least power the gain grows no more [kW/m].
 */
const LOUDNESS_EXPONENT = 0.6;
const REFERENCE_POWER = 300;
const LEAST_POWER = 2;
const POWER_TIME = 0.3;
/** Largest change of the power over its mean square root, in which that of the last half second counts. */
const CREST = 5;
const CREST_TIME = 0.5;
/** Rate at which the power of every flame may change [1/s]. */
const FLICKER_RATE = 4;
/** Heat of a particle of the classic model [kJ/m], with which its level is that of the other model. */
const PARTICLE_HEAT = 0.003;

/** Cracks for each spark thrown, gram of water dried, gram of char formed, and part broken off. */
export const CRACKS_PER_SPARK = 0.08;
const CRACKS_PER_DRIED = 3;
const CRACKS_PER_CHARRED = 4;
const CRACKS_PER_BREAK = 6;
/** Time over which events become a rate of cracks [s]. */
const RATE_TIME = 0.25;
/** Most cracks in a second. */
const MAX_RATE = 60;

/** Hiss of steam: its power for a gram in a second; and the ends of its band [Hz]. */
const STEAM_POWER = 1.5e-4;
const STEAM_BAND = [2500, 9000];
/** Hiss of a jet of 1 m/s. Its amplitude grows with the fourth power of the speed (Lighthill 1952). */
const JET_LEVEL = 0.008;
const JET_BAND = [900, 5000];
/** Level below which a hiss is not computed. */
const SILENCE = 1e-5;
/** Time in which a hiss follows [s]. */
const HISS_TIME = 0.04;

/** The strike that lights a narrow source: its level, and the times of the scratch and of the flare [s]. */
const STRIKE_LEVEL = 0.5;
const SCRATCH_TIME = 0.13;
const FLARE_TIME = 0.12;
/** Grains of the scratch in a second. */
const GRAIN_RATE = 90;
/** Power above which a fire is lit, and below which it is out [kW/m]. */
const LIT_POWER = 0.01;

/** Distance and air: what is above that frequency [Hz] is lower by that factor. */
const AIR_FREQUENCY = 3500;
const AIR_GAIN = 0.6;
/** Share of the width between the loudspeakers that places take. */
const PAN_WIDTH = 0.7;
/** Largest sample of one fire: four of them stay below full scale. */
const PEAK = 0.25;
/** Time of every fade [s]. */
export const FADE_TIME = 0.08;

/** @typedef {{duration: number, slope: number, gain: number, rate: number, load: number, pan: number, hiss: number,
 *   jet: number, strikes: boolean}} Segment  From mid-step to mid-step, in clock time */

/** A value that moves to another at a constant rate. */
class Ramp {
  value = 0;
  target = 0;

  /** @param {number} step the change in a sample from 0 to 1 */
  next(step) {
    const left = this.target - this.value;
    this.value = Math.abs(left) <= step ? this.target : this.value + Math.sign(left) * step;
    return this.value;
  }
}

/** The sound of one fire. */
export class Synthesis {
  #rate;
  #roar;
  #cracks;
  #random;
  #halfWidth;
  /** The segments that are not heard yet. @type {Segment[]} */
  #segments = [];
  /** The last step. @type {{length: number, power: number} | undefined} */
  #last;
  /** Mean square of the change of the power, and mean power. */
  #square = 0;
  #power = 0;
  /** Cracks that are due, of solids with fuel and of sparks. */
  #fuelCracks = 0;
  #sparkCracks = 0;
  #stepRate = 0;
  #gain = 0;
  #hiss = 0;
  #jet = 0;
  #steamBand;
  #jetBand;
  #air;
  /** Time since a strike [s]. */
  #strike = Infinity;
  #presence = new Ramp();
  #volume = new Ramp();
  #crackle = new Ramp();
  /** What is heard now. @type {Segment | undefined} */
  #segment;

  /**
   * @param {object} [options]
   * @param {number} [options.rate] sample rate [Hz]
   * @param {number} [options.seed]
   * @param {number} [options.volume] from 0 to 1
   * @param {number} [options.crackle] from 0 to 1
   * @param {number} [options.halfWidth] distance of the edges of the picture from its middle [m]
   * @param {boolean} [options.air] whether distance and air lower high frequencies
   */
  constructor({ rate = 48_000, seed = 1, volume = 1, crackle = 0.5, halfWidth = 1, air = true } = {}) {
    this.#rate = rate;
    this.#random = generator(seed);
    this.#roar = new Roar(this.#random, rate);
    this.#cracks = new Cracks(this.#random, rate);
    this.#halfWidth = halfWidth;
    const band = (/** @type {number[]} */ [low, high]) => [
      new Filter(highPass(low / rate)),
      new Filter(lowPass(high / rate)),
    ];
    this.#steamBand = band(STEAM_BAND);
    this.#jetBand = band(JET_BAND);
    this.#air = [0, 1].map(() => new Filter(shelf(AIR_FREQUENCY / rate, air ? AIR_GAIN : 1)));
    this.mix(volume, crackle);
    [this.#volume.value, this.#crackle.value] = [this.#volume.target, this.#crackle.target];
  }

  /** Fades to another volume and crackle, from 0 to 1. @type {(volume: number, crackle: number) => void} */
  mix(volume, crackle) {
    // Equal steps of the slider are about equally loud.
    this.#volume.target = volume * volume;
    this.#crackle.target = 2 * crackle;
  }

  /** Seconds of the clock for which there are samples. */
  get ahead() {
    return this.#segments.reduce((sum, { duration }) => sum + duration, this.#segment?.duration ?? 0);
  }

  /** Drops the oldest steps beyond so many seconds of the clock. @param {number} seconds */
  trim(seconds) {
    let ahead = this.ahead;
    while (ahead > seconds && this.#segments.length > 0) {
      const dropped = this.#segment ?? this.#segments.shift();
      this.#segment = undefined;
      ahead -= dropped?.duration ?? 0;
    }
  }

  /**
   * Takes the next steps of the series: all numbers of one, then of the next.
   * @param {ArrayLike<number>} series
   * @param {number} [speed] seconds of fire in a second of the clock
   */
  push(series, speed = 1) {
    for (let at = 0; at + STEP_NUMBERS <= series.length; at += STEP_NUMBERS)
      this.#step(
        Array.from({ length: STEP_NUMBERS }, (_, number) => series[at + number]),
        speed,
      );
  }

  /** @type {(numbers: number[], speed: number) => void} */
  #step([seconds, burnt, load, place, jet, dried, charred, broken, sparks, steam, births, deaths], speed) {
    const length = seconds / speed;
    if (!(length > 0)) return;
    const power = burnt + (PARTICLE_HEAT * (births + deaths)) / (2 * seconds);
    const last = this.#last ?? { length, power };
    this.#last = { length, power };
    const duration = 0.5 * (last.length + length);
    const follow = (/** @type {number} */ time) => 1 - Math.exp(-duration / time);
    this.#power += (power - this.#power) * follow(POWER_TIME);
    // A preset or a new particle count changes the power at once, which no flame does.
    const most = CREST * Math.sqrt(this.#square) + FLICKER_RATE * Math.min(this.#power, power);
    const slope = Math.max(-most, Math.min((power - last.power) / duration, most));
    this.#square += (slope * slope - this.#square) * follow(CREST_TIME);
    const spent = 1 - follow(RATE_TIME);
    this.#fuelCracks *= spent;
    this.#sparkCracks *= spent;
    this.#fuelCracks += 1000 * (CRACKS_PER_DRIED * dried + CRACKS_PER_CHARRED * charred) + CRACKS_PER_BREAK * broken;
    this.#sparkCracks += CRACKS_PER_SPARK * sparks;
    this.#stepRate += (1 / length - this.#stepRate) * (this.#stepRate === 0 ? 1 : follow(POWER_TIME));
    this.#segments.push({
      duration,
      slope,
      gain: ROAR_LEVEL * (Math.max(this.#power, LEAST_POWER) / REFERENCE_POWER) ** (LOUDNESS_EXPONENT - 1),
      rate: Math.min((this.#fuelCracks > 0.01 ? this.#fuelCracks : this.#sparkCracks) / RATE_TIME, MAX_RATE),
      load,
      pan: PAN_WIDTH * Math.max(-1, Math.min(place / this.#halfWidth, 1)),
      hiss: Math.sqrt((STEAM_POWER * 1000 * (steam + dried)) / length),
      jet: JET_LEVEL * jet ** 4,
      strikes: jet > 0 && power > LIT_POWER && last.power <= LIT_POWER,
    });
    this.#roar.follow(this.#stepRate);
  }

  /**
   * Fills both channels. Where the series ends, the sound fades.
   * @type {(left: Float32Array, right: Float32Array) => void}
   */
  render(left, right) {
    const dt = 1 / this.#rate;
    const fade = dt / FADE_TIME;
    for (let at = 0; at < left.length; at += 1) {
      const slope = this.#advance(dt);
      const segment = this.#segment;
      this.#presence.target = segment ? 1 : 0;
      const presence = this.#presence.next(fade) * this.#volume.next(fade);
      const crackle = this.#crackle.next(fade);
      // The roar fades when the series ends.
      this.#gain = segment?.gain ?? this.#gain;
      const all = this.#gain * this.#roar.run(slope) + this.#hissing(segment, dt);
      this.#cracks.advance(segment?.rate ?? 0, segment?.load ?? 0, segment?.pan ?? 0);
      const channels = [this.#cracks.left, this.#cracks.right];
      left[at] = limited(presence * this.#air[0].run(all + crackle * channels[0]));
      right[at] = limited(presence * this.#air[1].run(all + crackle * channels[1]));
    }
  }

  /** Advances by a sample. Returns the mean change of the power in it [kW/(m·s)]. @param {number} dt */
  #advance(dt) {
    let [left, change] = [dt, 0];
    while (left > 0) {
      if (!this.#segment) {
        this.#segment = this.#segments.shift();
        if (this.#segment?.strikes) this.#strike = 0;
      }
      const segment = this.#segment;
      if (!segment) {
        // The next step follows a pause.
        this.#last = undefined;
        break;
      }
      const part = Math.min(left, segment.duration);
      change += part * segment.slope;
      segment.duration -= part;
      left -= part;
      if (segment.duration <= 0) this.#segment = undefined;
    }
    return change / dt;
  }

  /** A sample of steam, jet and strike. @type {(segment: Segment | undefined, dt: number) => number} */
  #hissing(segment, dt) {
    const follow = dt / HISS_TIME;
    this.#hiss += ((segment?.hiss ?? 0) - this.#hiss) * follow;
    this.#jet += ((segment?.jet ?? 0) - this.#jet) * follow;
    const strike = this.#striking(dt);
    if (this.#hiss + this.#jet + strike < SILENCE) return 0;
    const white = 2 * this.#random() - 1;
    const [steam, jet] = [this.#steamBand, this.#jetBand].map(([low, high]) => high.run(low.run(white)));
    return this.#hiss * steam + this.#jet * jet + strike * (0.6 * steam + 0.4 * jet);
  }

  /** The level of the strike. @param {number} dt */
  #striking(dt) {
    if (this.#strike > SCRATCH_TIME + 8 * FLARE_TIME) return 0;
    this.#strike += dt;
    const time = this.#strike;
    if (time < SCRATCH_TIME) return STRIKE_LEVEL * (time / SCRATCH_TIME) * Math.sin(Math.PI * GRAIN_RATE * time) ** 2;
    return STRIKE_LEVEL * Math.exp((SCRATCH_TIME - time) / FLARE_TIME);
  }
}

/** A sample below the peak: small ones are as they were. @param {number} sample */
function limited(sample) {
  return PEAK * Math.tanh(sample / PEAK);
}
