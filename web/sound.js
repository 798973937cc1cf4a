/**
 * The sound of a fire without a browser: samples from the series of its steps, which `series()` of `hearth-fire/sim`
 * gives. The element's sound has values of its own; here those of a caller are checked.
 *
 * @typedef {import('./sound.js').SynthesisOptions} SynthesisOptions
 */

import { between, fields, known, refusal, whole, words } from './sim/values.js';
import { STEP_NUMBERS, Synthesis as Sound } from './sound/synthesis.js';

export { STEP_NUMBERS };

/** The checks of the options. @type {{[name: string]: (name: string, value: any) => void}} */
const OPTIONS = {
  rate: (name, value) => between(name, value, 8000, 768_000),
  seed: (name, value) => whole(name, value, 0, 2 ** 32 - 1),
  volume: (name, value) => between(name, value, 0, 1),
  crackle: (name, value) => between(name, value, 0, 1),
  halfWidth: (name, value) => between(name, value, 0.001, 1000),
  air: (name, value) => {
    if (typeof value !== 'boolean') throw new TypeError(`${name} must be true or false, not ${words(value)}`);
  },
};

/** Above every number of a step; sums of larger ones overflow. */
const LARGEST = 1e6;

/** The only number of a step that may be negative: where it burns. */
const PLACE = 3;

/** The sound of one fire. */
export class Synthesis {
  #sound;

  /** @param {SynthesisOptions} [options] */
  constructor(options = {}) {
    const given = fields('options', options).filter(([, value]) => value !== undefined);
    for (const [name, value] of given) {
      known('option', name, Object.keys(OPTIONS));
      OPTIONS[name](name, value);
    }
    this.#sound = new Sound(Object.fromEntries(given));
  }

  /** Seconds of the clock for which there are samples. */
  get ahead() {
    return this.#sound.ahead;
  }

  /** Fades to another volume and crackle. @param {number} volume @param {number} crackle */
  mix(volume, crackle) {
    OPTIONS.volume('volume', volume);
    OPTIONS.crackle('crackle', crackle);
    this.#sound.mix(volume, crackle);
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
      numbers = Array.isArray(series) || ArrayBuffer.isView(series) ? Float64Array.from(series) : undefined;
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
    this.#sound.push(numbers, speed);
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
    this.#sound.render(left, right);
  }
}
