/**
 * The spectrum of a signal whose samples are not evenly spaced, as those of a fire that is measured once a frame.
 *
 * @typedef {{time: number, value: number}} Sample
 * @typedef {{frequency: number, power: number}} Line
 */

/** Length of a segment and of the shortest signal that has a spectrum [s]. */
const SEGMENT = 8;
export const SHORTEST = 5;

/** The highest frequency [Hz], as a share of the sampling rate and at all. */
const NYQUIST = 0.4;
const HIGHEST = 8;

/** Distance of frequencies, and the lowest one that may be the peak, in resolutions of a segment. */
const FINE = 0.5;
const SLOWEST = 2;

/**
 * Frequency times power over frequency, relative to the greatest: a slow drift does not outweigh a beat. It is the mean
 * over segments that overlap by half, each without its trend and under a Hann window (Welch's method).
 * @param {Sample[]} samples  In the order of their times.
 * @returns {Line[]} none while the signal is too short or does not change
 */
export function spectrumOf(samples) {
  const [start, end] = [samples[0]?.time ?? 0, samples.at(-1)?.time ?? 0];
  if (end - start < SHORTEST) return [];
  const length = Math.min(SEGMENT, end - start);
  const step = FINE / length;
  const highest = Math.min(HIGHEST, (NYQUIST * samples.length) / (end - start));
  const lines = Array.from({ length: Math.floor(highest / step) }, (_, at) => ({
    frequency: (at + 1) * step,
    power: 0,
  }));
  for (let from = end - length; from > start - 1e-6; from -= length / 2) {
    add(
      lines,
      samples.filter(({ time }) => time > from - 1e-6 && time <= from + length),
      from,
      length,
    );
  }
  const most = Math.max(...lines.map(({ power }) => power));
  return most > 0 ? lines.map(({ frequency, power }) => ({ frequency, power: power / most })) : [];
}

/** Adds the power of a segment. @type {(lines: Line[], samples: Sample[], from: number, length: number) => void} */
function add(lines, samples, from, length) {
  const { at, slope, value: middle } = trendOf(samples);
  const shaped = samples.map(({ time, value }, here) => {
    const window = 0.5 - 0.5 * Math.cos((2 * Math.PI * (time - from)) / length);
    // A sample stands for the time around it.
    const span = ((samples[here + 1]?.time ?? time) - (samples[here - 1]?.time ?? time)) / 2;
    return { time: time - from, weight: span * window * (value - middle - slope * (time - at)) };
  });
  for (const line of lines) {
    const turn = 2 * Math.PI * line.frequency;
    let [re, im] = [0, 0];
    for (const { time, weight } of shaped) {
      re += weight * Math.cos(turn * time);
      im += weight * Math.sin(turn * time);
    }
    line.power += line.frequency * (re * re + im * im);
  }
}

/** The line of least squares. @param {Sample[]} samples */
function trendOf(samples) {
  const mean = (/** @type {(sample: Sample) => number} */ of) =>
    samples.reduce((sum, sample) => sum + of(sample), 0) / samples.length;
  const [at, value] = [mean(({ time }) => time), mean((sample) => sample.value)];
  const spread = mean(({ time }) => (time - at) ** 2);
  return { at, value, slope: spread > 0 ? mean((sample) => (sample.time - at) * (sample.value - value)) / spread : 0 };
}

/** The frequency of the most power [Hz]; undefined without a spectrum. @param {Line[]} spectrum */
export function peakOf(spectrum) {
  const [first] = spectrum;
  // The trend hides slower swings.
  const able = spectrum.filter(({ frequency }) => frequency >= (SLOWEST / FINE) * first.frequency);
  return able.length > 0 ? able.reduce((most, line) => (line.power > most.power ? line : most)).frequency : undefined;
}
