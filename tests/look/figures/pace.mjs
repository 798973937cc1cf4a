/**
 * The pace of a fire's light: how soon it changes, and how its fast changes compare with its slow ones.
 */

/** Running mean that is removed before the decay: a drift within a short film is not its pace [s]. */
const DRIFT = 1.2;
/** Frequencies of the roll-off [Hz], and samples of a spectrum. */
const BAND = [1.5, 11];
const SAMPLES = 128;

/**
 * Seconds until the autocorrelation of the light, without its drift, falls to 1/e.
 * @param {number[]} light  Total light of each picture. @param {number} rate  Pictures a second.
 */
export function decay(light, rate) {
  const values = relative(light);
  const half = Math.round((DRIFT / 2) * rate);
  // Reflected at both ends.
  const at = (/** @type {number} */ k) => values[k < 0 ? -k : k >= values.length ? 2 * values.length - 2 - k : k];
  const fast = values.map((value, k) => {
    let sum = 0;
    for (let offset = -half; offset <= half; offset += 1) sum += at(k + offset);
    return value - sum / (2 * half + 1);
  });
  const correlation = (/** @type {number} */ lag) => {
    let sum = 0;
    for (let k = 0; k + lag < fast.length; k += 1) sum += fast[k] * fast[k + lag];
    return sum;
  };
  const whole = correlation(0);
  let before = 1;
  for (let lag = 1; lag < fast.length; lag += 1) {
    const now = correlation(lag) / whole;
    if (now < 1 / Math.E) return (lag - 1 + (before - 1 / Math.E) / (before - now)) / rate;
    before = now;
  }
  return NaN;
}

/**
 * Slope of the power spectrum of the light [dB a decade], from Hann windows that overlap by half.
 * @param {number[]} light @param {number} rate
 */
export function rollOff(light, rate) {
  const values = relative(light);
  const power = new Array(SAMPLES / 2 + 1).fill(0);
  for (let first = 0; first + SAMPLES <= values.length; first += SAMPLES / 2) {
    const part = values.slice(first, first + SAMPLES);
    const mean = part.reduce((sum, value) => sum + value, 0) / SAMPLES;
    const window = part.map((value, k) => (value - mean) * (0.5 - 0.5 * Math.cos((2 * Math.PI * k) / (SAMPLES - 1))));
    power.forEach((_, bin) => {
      let [real, imaginary] = [0, 0];
      window.forEach((value, k) => {
        const angle = (2 * Math.PI * bin * k) / SAMPLES;
        real += value * Math.cos(angle);
        imaginary += value * Math.sin(angle);
      });
      power[bin] += real ** 2 + imaginary ** 2;
    });
  }
  /** @type {[number, number][]} */
  const points = power
    .map((value, bin) => /** @type {[number, number]} */ ([(bin * rate) / SAMPLES, value]))
    .filter(([hertz]) => hertz >= BAND[0] && hertz <= BAND[1])
    .map(([hertz, value]) => [Math.log10(hertz), 10 * Math.log10(value)]);
  const [x, y] = [0, 1].map((k) => points.reduce((sum, point) => sum + point[k], 0) / points.length);
  const slope = points.reduce((sum, point) => sum + (point[0] - x) * (point[1] - y), 0);
  return slope / points.reduce((sum, point) => sum + (point[0] - x) ** 2, 0);
}

/** Differences from the mean, relative to it. @param {number[]} light */
function relative(light) {
  const mean = light.reduce((sum, value) => sum + value, 0) / light.length;
  return light.map((value) => value / mean - 1);
}
