/** The number of a card: the mean over the last seconds of a fire, or how far it swings about its mean. */

/** So long [s of fire], and the shortest time that is shown. */
const LENGTH = 4;
const SHORTEST = 1;

export class Reading {
  /** @type {{time: number, value: number}[]} */
  #samples = [];
  #swings;

  /** @param {boolean} swings  Whether the number is the standard deviation. */
  constructor(swings = false) {
    this.#swings = swings;
  }

  /** Forgets what was before a change of the fire. */
  clear() {
    this.#samples = [];
  }

  /** @param {number} time  Age of the fire [s]. @param {number | undefined} value  Undefined where there is no gas. */
  add(time, value) {
    const last = this.#samples.at(-1)?.time ?? -Infinity;
    // The same fire from its start.
    if (time < last) this.clear();
    if (value === undefined || time === last) return;
    this.#samples.push({ time, value });
    this.#samples.splice(
      0,
      this.#samples.findIndex((sample) => sample.time >= time - LENGTH),
    );
  }

  /** Undefined until there is enough of it. */
  get value() {
    const [first, last] = [this.#samples[0], this.#samples.at(-1)];
    if (!first || !last || last.time - first.time < SHORTEST) return undefined;
    const mean = meanOf(this.#samples.map(({ value }) => value));
    return this.#swings ? Math.sqrt(meanOf(this.#samples.map(({ value }) => (value - mean) ** 2))) : mean;
  }
}

/** @param {number[]} values */
const meanOf = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
