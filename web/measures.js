/** The quantities of a place, in the order of the engine. */
const QUANTITIES = ['temperature', 'u', 'v', 'density', 'fuel', 'oxygen', 'soot'];

/** Numbers of each place: these and the distance from solids. */
const OF_PLACE = QUANTITIES.length + 1;

/**
 * What a probe has measured, from the numbers of the engine. What is not a number is absent.
 * @param {ArrayLike<number>} numbers
 * @param {number} y the height of the place [m]
 * @returns {import('./element/types.js').HearthMeasures}
 */
export function measuresOf(numbers, y) {
  const [seconds, fraction, height, power, flameHeight, luminosity, ...places] = Array.from(numbers);
  const rows = places.length / OF_PLACE - 1;
  const [place, ...profile] = Array.from({ length: rows + 1 }, (_, row) => {
    const read = places.slice(OF_PLACE * row);
    const known = QUANTITIES.map((name, at) => [name, read[at]]).filter(([, value]) => !Number.isNaN(value));
    return {
      y: row ? (height * (row - 0.5)) / rows : y,
      gas: known.length > 0,
      solid: read[OF_PLACE - 1] < 0,
      ...Object.fromEntries(known),
    };
  });
  return {
    time: seconds + fraction,
    ...(Number.isNaN(power) ? {} : { power }),
    flameHeight,
    luminosity,
    place,
    profile,
  };
}
