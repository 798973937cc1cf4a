/** Series of steps, the sound of them, and what is measured of it. */
import { STEP_NUMBERS, Synthesis } from '../../web/sound.js';
import { generator } from '../../web/sound/filters.js';

/** Sample rate [Hz]. */
export const RATE = 48_000;

/** The numbers of a step in their order. */
const NAMES = 'length power load place jet dried charred broken sparks steam births deaths'.split(' ');

/**
 * The series of so many seconds, with steps of lengths around 1/400 s.
 * @param {number} seconds
 * @param {(time: number, random: () => number) => {[name: string]: number}} of  The numbers of a step that are not 0.
 * @param {number} [seed]
 */
export function seriesOf(seconds, of, seed = 7) {
  const random = generator(seed);
  const numbers = [];
  for (let time = 0; time < seconds; ) {
    const length = (0.5 + random()) / 400;
    const step = { length, ...of(time, random) };
    numbers.push(...NAMES.map((name) => step[name] ?? 0));
    time += length;
  }
  return Float32Array.from(numbers);
}

/** A flame of that power [kW/m], which flickers at random. */
export function flame(power) {
  let flicker = 0;
  return (_, random) => {
    flicker += 0.15 * (random() + random() + random() - 1.5 - flicker);
    return { power: Math.max(power * (1 + 0.02 * flicker), 0) };
  };
}

/**
 * The left channel of a sound: the series in pieces of a sixtieth of a second, then `rest` seconds without any.
 * @param {Float32Array} series
 * @param {import('../../web/sound.js').SynthesisOptions} [options]
 * @param {{rest?: number, act?: (sound: Synthesis, time: number) => void}} [how] `act` runs before each piece
 */
export function soundOf(series, options, { rest = 0, act = () => {} } = {}) {
  const sound = new Synthesis({ rate: RATE, ...options });
  /** @type {number[][]} */
  const [left, right] = [[], []];
  const render = (frames) => {
    const [first, second] = [new Float32Array(frames), new Float32Array(frames)];
    sound.render(first, second);
    left.push(...first);
    right.push(...second);
  };
  let from = 0;
  let seconds = 0;
  for (let at = 0; at < series.length; at += STEP_NUMBERS) {
    seconds += series[at];
    if (seconds < 1 / 60 && at + STEP_NUMBERS < series.length) continue;
    act(sound, left.length / RATE);
    sound.push(series.subarray(from, at + STEP_NUMBERS));
    render(Math.floor(sound.ahead * RATE));
    [from, seconds] = [at + STEP_NUMBERS, 0];
  }
  render(Math.round(rest * RATE));
  return { left: Float32Array.from(left), right: Float32Array.from(right) };
}

/** The samples between two times [s]. */
export const between = (samples, from, to) => samples.subarray(Math.round(from * RATE), Math.round(to * RATE));

/** Root of the mean square. */
export const levelOf = (samples) => Math.sqrt(samples.reduce((sum, x) => sum + x * x, 0) / samples.length);

/** The largest magnitude. */
export const peakOf = (samples) => samples.reduce((most, x) => Math.max(most, Math.abs(x)), 0);

/** The largest difference of two samples in a row. */
export const jumpOf = (samples) => peakOf(samples.map((x, at) => x - samples[Math.max(at - 1, 0)]));

/** Power spectral density by Welch's method, of windows of that length; bins are `RATE / length` wide. */
export function densityOf(samples, length = 8192) {
  const sums = new Float64Array(length / 2);
  const window = Float64Array.from({ length }, (_, at) => 0.5 - 0.5 * Math.cos((2 * Math.PI * at) / length));
  for (let from = 0; from + length <= samples.length; from += length / 2) {
    const real = window.map((weight, at) => weight * samples[from + at]);
    const imaginary = new Float64Array(length);
    transform(real, imaginary);
    for (let bin = 0; bin < sums.length; bin += 1) sums[bin] += real[bin] ** 2 + imaginary[bin] ** 2;
  }
  return sums;
}

/** The exponent of a density between two frequencies [Hz]: the slope of its logarithms. */
export function exponentOf(density, from, to) {
  const bins = 2 * density.length;
  const points = [];
  for (let frequency = from; frequency < to; frequency *= 1.1) {
    const [first, end] = [frequency, 1.1 * frequency].map((edge) => Math.round((edge * bins) / RATE));
    const some = density.subarray(first, Math.max(end, first + 1));
    points.push([Math.log(frequency), Math.log(some.reduce((sum, x) => sum + x, 0) / some.length)]);
  }
  const [x, y] = [0, 1].map((axis) => points.map((point) => point[axis]));
  const [meanX, meanY] = [x, y].map((all) => all.reduce((sum, value) => sum + value, 0) / all.length);
  const covariance = points.reduce((sum, point) => sum + (point[0] - meanX) * (point[1] - meanY), 0);
  return covariance / x.reduce((sum, value) => sum + (value - meanX) ** 2, 0);
}

/** The discrete Fourier transform, in place; the length is a power of two. */
function transform(real, imaginary) {
  const { length } = real;
  for (let at = 1, to = 0; at < length; at += 1) {
    let bit = length >> 1;
    for (; to & bit; bit >>= 1) to ^= bit;
    to ^= bit;
    if (at < to) {
      [real[at], real[to]] = [real[to], real[at]];
      [imaginary[at], imaginary[to]] = [imaginary[to], imaginary[at]];
    }
  }
  for (let size = 2; size <= length; size *= 2) {
    for (let from = 0; from < length; from += size) {
      for (let at = from; at < from + size / 2; at += 1) {
        const angle = (-2 * Math.PI * (at - from)) / size;
        const [cos, sin, other] = [Math.cos(angle), Math.sin(angle), at + size / 2];
        const turned = [real[other] * cos - imaginary[other] * sin, real[other] * sin + imaginary[other] * cos];
        [real[other], imaginary[other]] = [real[at] - turned[0], imaginary[at] - turned[1]];
        real[at] += turned[0];
        imaginary[at] += turned[1];
      }
    }
  }
}
