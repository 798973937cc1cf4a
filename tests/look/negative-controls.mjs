/**
 * Pictures with drawing mistakes that no setting produces.
 */

/** @typedef {import('./painter.mjs').Pixels} Pixels */

const decode = (/** @type {number} */ x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
const encode = (/** @type {number} */ x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);

/**
 * A picture with another colour for each pixel, by linear light.
 * @param {(light: number[]) => number[]} change
 * @returns {(pixels: Pixels) => Pixels}
 */
const changed = (change) => (pixels) => {
  const rgba = Uint8Array.from(pixels.rgba);
  for (let at = 0; at < rgba.length; at += 4) {
    const light = [...rgba.subarray(at, at + 3)].map((code) => decode(code / 255));
    const wrong = change(light).map((x) => Math.round(255 * encode(Math.min(Math.max(x, 0), 1))));
    // A colour is never above its alpha.
    rgba.set(
      wrong.map((code) => Math.min(code, rgba[at + 3])),
      at,
    );
  }
  return { ...pixels, rgba };
};

/** The hue of OkLab turned by an angle. @param {number} degrees */
export const hueTurned = (degrees) => {
  const [cos, sin] = [Math.cos, Math.sin].map((of) => of((degrees * Math.PI) / 180));
  return changed(([red, green, blue]) => {
    const l = Math.cbrt(0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue);
    const m = Math.cbrt(0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue);
    const s = Math.cbrt(0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue);
    const L = 0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s;
    const a = 1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s;
    const b = 0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s;
    const [x, y] = [a * cos - b * sin, a * sin + b * cos];
    const [p, q, r] = [
      L + 0.3963377774 * x + 0.2158037573 * y,
      L - 0.1055613458 * x - 0.0638541728 * y,
      L - 0.0894841775 * x - 1.291485548 * y,
    ].map((root) => root ** 3);
    return [
      4.0767416621 * p - 3.3077115913 * q + 0.2309699292 * r,
      -1.2684380046 * p + 2.6097574011 * q - 0.3413193965 * r,
      -0.0041960863 * p - 0.7034186147 * q + 1.707614701 * r,
    ];
  });
};

/** Each channel compressed by itself, which turns orange to lemon. */
export const toneMappedByChannel = changed((shown) => {
  const peak = Math.max(...shown, 1e-6);
  const light = -Math.log(1 - Math.min(peak, 0.995));
  return shown.map((value) => 1 - Math.exp(-light * (value / peak)));
});
