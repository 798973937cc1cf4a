/** Quantities as schools teach them. */

/** Oxygen in fresh air, by volume [%]. */
export const FRESH_AIR = 21;

/** The mean luminosity of the scene *Candle* [m²]: a real candle shines with about one candela. */
export const CANDLE = 0.0033;

/** @param {number} kelvin */
export const celsius = (kelvin) => kelvin - 273.15;

/** A temperature on both scales. @param {number} kelvin */
export const temperature = (kelvin) => `${celsius(kelvin).toFixed(0)} °C (${kelvin.toFixed(0)} K)`;

/** Oxygen by volume, from a share of that of fresh air. @param {number} share */
export const oxygen = (share) => `${(FRESH_AIR * share).toFixed(share > 0 && share < 0.45 ? 1 : 0)} %`;
