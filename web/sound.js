/**
 * The sound of a fire without a browser: samples from the series of its steps, which `series()` of `hearth-fire/sim`
 * gives. The element's sound has values of its own; here those of a caller are checked.
 *
 * @typedef {import('./sound.js').SynthesisOptions} SynthesisOptions
 * @typedef {import('./sound.js').SoundMix} SoundMix
 */

import { loaded } from './sim/loading.js';
import { between, fields, known, refusal, whole, words } from './sim/values.js';

/** Numbers of a step in the series: see `StepRecord` of the core. */
export const STEP_NUMBERS = 15;

/** The checks of a mix. @type {{[name: string]: (name: string, value: any) => void}} */
const MIX = {
  volume: (name, value) => between(name, value, 0, 1),
  roar: (name, value) => between(name, value, 0, 2),
  crackle: (name, value) => between(name, value, 0, 2),
  hiss: (name, value) => between(name, value, 0, 2),
};

/** The checks of the options. @type {typeof MIX} */
const OPTIONS = {
  rate: (name, value) => between(name, value, 8000, 768_000),
  seed: (name, value) => whole(name, value, 0, 2 ** 32 - 1),
  halfWidth: (name, value) => between(name, value, 0.001, 1000),
  ...MIX,
};

/** Above every number of a step; sums of larger ones overflow. */
const LARGEST = 1e6;

/** The only number of a step that may be negative: where it burns. */
const PLACE = 3;

/** Most samples of one call: those of ten minutes. */
const MOST_SAMPLES = 600 * 48_000;

/**
 * Makes the sound of a fire. Rejects with a `RangeError` for values out of range. It shares the wasm of the simulations.
 * @param {SynthesisOptions} [options]
 * @returns {Promise<import('./sound.js').Synthesis>}
 */
export async function createSynthesis(options = {}) {
  const given = checked('options', options, OPTIONS);
  const { rate = 48_000, seed = 1, halfWidth = 1, volume = 1, roar = 1, crackle = 1, hiss = 1 } = given;
  const { Synthesis: Sound } = await loaded(undefined);
  return new Synthesis(new Sound(rate, seed, volume, roar, crackle, hiss), halfWidth, { volume, roar, crackle, hiss });
}

/** The sound of one fire. */
class Synthesis {
  #sound;
  #halfWidth;
  #mix;

  /**
   * @param {any} sound in wasm
   * @param {number} halfWidth
   * @param {Required<SoundMix>} mix
   */
  constructor(sound, halfWidth, mix) {
    this.#sound = sound;
    this.#halfWidth = halfWidth;
    this.#mix = mix;
  }

  /** Seconds of the clock for which there are samples. */
  get ahead() {
    return this.#sound.ahead();
  }

  /** Fades to another mix; what it does not have stays. @param {SoundMix} mix */
  mix(mix) {
    Object.assign(this.#mix, checked('mix', mix, MIX));
    const { volume, roar, crackle, hiss } = this.#mix;
    this.#sound.mix(volume, roar, crackle, hiss);
  }

  /** Drops the oldest steps beyond so many seconds of the clock. @param {number} seconds */
  trim(seconds) {
    between('seconds', seconds, 0, Infinity);
    this.#sound.trim(seconds);
  }

  /**
   * Takes the next steps of the series: all numbers of one, then of the next.
   * @param {ArrayLike<number>} series
   * @param {number} [speed] seconds of fire in a second of the clock
   */
  push(series, speed = 1) {
    between('speed', speed, 0.01, 100);
    let numbers;
    try {
      numbers = Array.isArray(series) || ArrayBuffer.isView(series) ? Float32Array.from(series) : undefined;
    } catch (cause) {
      throw new TypeError('series cannot be read', { cause });
    }
    if (!numbers) throw new TypeError(`series must be an array of numbers, not ${words(series)}`);
    if (numbers.length % STEP_NUMBERS > 0) {
      const message = `series has ${numbers.length} numbers: it must have ${STEP_NUMBERS} for each step`;
      throw refusal([{ id: 'series', message }]);
    }
    const at = numbers.findIndex(
      (number, index) => !(number <= LARGEST && number >= (index % STEP_NUMBERS === PLACE ? -LARGEST : 0)),
    );
    if (at >= 0) {
      const message = `series[${at}] = ${numbers[at]} is refused: it must be a number from 0 to ${LARGEST}`;
      throw refusal([{ id: 'series', message }]);
    }
    this.#sound.push(numbers, speed, this.#halfWidth);
  }

  /**
   * Fills both channels. Where the series ends, the sound fades.
   * @param {Float32Array} left
   * @param {Float32Array} right
   */
  render(left, right) {
    for (const [name, channel] of Object.entries({ left, right }))
      if (!(ArrayBuffer.isView(channel) && channel instanceof Float32Array))
        throw new TypeError(`${name} must be a Float32Array, not ${words(channel)}`);
    if (left.length !== right.length) {
      const message = `right has ${right.length} samples: it must have as many as left, ${left.length}`;
      throw refusal([{ id: 'right', message }]);
    }
    between('left.length', left.length, 0, MOST_SAMPLES);
    const samples = this.#sound.render(left.length);
    left.set(samples.subarray(0, left.length));
    right.set(samples.subarray(left.length));
  }
}

/**
 * The values that are given, each of which has passed its check.
 * @type {(what: string, values: object, checks: typeof MIX) => {[name: string]: any}}
 */
function checked(what, values, checks) {
  const given = fields(what, values).filter(([, value]) => value !== undefined);
  for (const [name, value] of given) {
    known('option', name, Object.keys(checks));
    checks[name](name, value);
  }
  return Object.fromEntries(given);
}
