/**
 * Colours as eyes and screens have them, of 8-bit sRGB.
 */

/** Light that a screen in a room reflects. Without it blacks that nobody can distinguish
    apart would differ by more than two oranges. */
const VEIL = 0.005;

/** Linear light of each code. */
export const LINEAR = Float64Array.from({ length: 256 }, (_, code) => {
  const share = code / 255;
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
});
const VEILED = LINEAR.map((light) => (light + VEIL) / (1 + VEIL));

/** As WCAG has it: 1 for white. @param {number} r @param {number} g @param {number} b */
export function relativeLuminance(r, g, b) {
  return 0.2126 * LINEAR[r] + 0.7152 * LINEAR[g] + 0.0722 * LINEAR[b];
}

/**
 * OkLab, times 100.
 * @param {number} r @param {number} g @param {number} b  sRGB, 0–255.
 * @returns {[number, number, number]}
 */
export function okLab(r, g, b) {
  const [red, green, blue] = [VEILED[r], VEILED[g], VEILED[b]];
  const l = Math.cbrt(0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue);
  const m = Math.cbrt(0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue);
  const s = Math.cbrt(0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue);
  return [
    100 * (0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s),
    100 * (1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s),
    100 * (0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s),
  ];
}
