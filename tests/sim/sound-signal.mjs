/** Series of steps, the sound of them, and what is measured of it. */
import { load } from './library.mjs';

const { STEP_NUMBERS, createSynthesis } = await load('sound.js');

/** Sample rate [Hz]. */
export const RATE = 48_000;

/** A generator of numbers from 0 to 1 (mulberry32). @param {number} seed */
function generator(seed) {
  let state = seed | 0;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** The numbers of a step in their order. */
const NAMES = 'length power load place jet flutter wall dried charred broken sparks pops steam births deaths'.split(
  ' ',
);

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
 * Both channels of a sound: the series in pieces of a sixtieth of a second, then `rest` seconds without any.
 * @param {Float32Array} series
 * @param {object} [options] of the synthesis
 * @param {{rest?: number, speed?: number, act?: (sound: any, time: number) => void}} [how] `act` runs before each piece
 */
export async function soundOf(series, options, { rest = 0, speed = 1, act = () => {} } = {}) {
  const sound = await createSynthesis({ rate: RATE, ...options });
  /** @type {number[][]} */
  const [left, right] = [[], []];
  const render = (frames) => {
    const [first, second] = [new Float32Array(frames), new Float32Array(frames)];
    sound.render(first, second);
    for (let at = 0; at < frames; at += 1) {
      left.push(first[at]);
      right.push(second[at]);
    }
  };
  let from = 0;
  let seconds = 0;
  for (let at = 0; at < series.length; at += STEP_NUMBERS) {
    seconds += series[at];
    if (seconds < 1 / 60 && at + STEP_NUMBERS < series.length) continue;
    act(sound, left.length / RATE);
    sound.push(series.subarray(from, at + STEP_NUMBERS), speed);
    render(Math.floor(sound.ahead * RATE));
    [from, seconds] = [at + STEP_NUMBERS, 0];
  }
  render(Math.round(rest * RATE));
  return { left: Float32Array.from(left), right: Float32Array.from(right) };
}

/**
 * The sound of so many seconds of a scene, which nobody touches, as the mean of both channels.
 * @param {any} sim
 * @param {number} seconds of the clock
 * @param {object} [options] of the synthesis
 */
export async function soundOfScene(sim, seconds, options) {
  const speed = sim.get('time_scale');
  sim.series();
  /** @type {number[]} */
  const series = [];
  while (sim.time < seconds * speed) {
    sim.step(10);
    series.push(...sim.series());
  }
  const halfWidth = sim.get('domain_width') / 2;
  const { left, right } = await soundOf(Float32Array.from(series), { halfWidth, ...options }, { speed });
  return left.map((sample, at) => 0.5 * (sample + right[at]));
}

/**
 * What is compared with recordings: levels of the octaves from 31 Hz to 16 kHz, relative to the loudest [dB]; crackles in
 * a second, which are frames of 2 ms whose energy above 1 kHz rises over eight times the median, and how far half and a
 * tenth of them are above it [dB]; the kurtosis of what is above 1 kHz; crest and level [dB].
 * @param {Float32Array} samples
 */
export function measured(samples) {
  const decibels = (ratio) => 10 * Math.log10(ratio);
  const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
  const density = densityOf(samples);
  const bin = RATE / 2 / density.length;
  const levels = [31, 63, 125, 250, 500, 1000, 2000, 4000, 8000, 16_000].map((middle) => {
    const [from, to] = [Math.SQRT1_2, Math.SQRT2].map((ratio) => Math.ceil((middle * ratio) / bin));
    return decibels(density.subarray(from, to).reduce((sum, power) => sum + power, 0));
  });
  const high = above(samples, 1000);
  const frame = Math.round(0.002 * RATE);
  const energies = Array.from({ length: Math.floor(high.length / frame) }, (_, at) =>
    mean(high.subarray(at * frame, (at + 1) * frame).map((x) => x * x)),
  );
  const bed = energies.toSorted((a, b) => a - b)[energies.length >> 1];
  const crackles = energies.filter((energy, at) => at > 0 && energy > 8 * bed && energies[at - 1] <= 8 * bed);
  const sorted = crackles.map((energy) => decibels(energy / bed)).toSorted((a, b) => a - b);
  const square = mean(high.map((x) => x * x));
  return {
    octaves: levels.map((level) => level - Math.max(...levels)),
    crackles: (crackles.length * RATE) / samples.length,
    half: sorted[Math.floor(0.5 * sorted.length)] ?? 0,
    tenth: sorted[Math.floor(0.9 * sorted.length)] ?? 0,
    kurtosis: mean(high.map((x) => x ** 4)) / square ** 2,
    crest: 20 * Math.log10(peakOf(samples) / levelOf(samples)),
    level: 20 * Math.log10(levelOf(samples)),
  };
}

/** What is above a frequency [Hz]. @param {Float32Array} samples @param {number} frequency */
export function above(samples, frequency) {
  const length = 2 ** Math.ceil(Math.log2(samples.length));
  const [real, imaginary] = [new Float64Array(length), new Float64Array(length)];
  real.set(samples);
  transform(real, imaginary);
  const edge = (frequency / RATE) * length;
  for (let at = 0; at < length; at += 1) {
    if (Math.min(at, length - at) >= edge) continue;
    real[at] = 0;
    imaginary[at] = 0;
  }
  // The inverse transform is that of the conjugate, but for its length.
  transform(
    real,
    imaginary.map((x) => -x),
  );
  return real.subarray(0, samples.length).map((x) => x / length);
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
