/**
 * The bars for figures of a fire's pixels.
 */

const percent = (/** @type {number} */ share) => `${(100 * share).toFixed(1)} %`;

/**
 * @typedef {object} Bar
 * @property {string} id
 * @property {string} words  What is measured.
 * @property {string} bar
 * @property {(found: any) => any} figure
 * @property {(figure: any) => boolean} holds
 * @property {(figure: any) => string} show
 * @property {boolean} brief  Whether a few seconds suffice.
 * @property {string[]} [needs]  The traits of a scene without which it does not apply.
 */

/**
 * The traits of a scene by some of its values.
 * @param {{[id: string]: string}} values
 */
export function traits({ display_mode, palette, backdrop, background, wind, roundness }) {
  return Object.entries({
    fire: display_mode === 'fire',
    black_body: palette === 'blackbody',
    // A wall shines, and does not move.
    bare: backdrop === 'none' && background === 'transparent',
    // Smoke before a sky is of its colour.
    no_sky: background === 'transparent',
    calm: Number(wind) === 0,
    // A round flame stands still on its root, which is blue, and is smooth.
    sheets: !(Number(roundness) > 0),
  })
    .filter(([, has]) => has)
    .map(([trait]) => trait);
}

/** @type {Bar[]} */
export const BARS = [
  {
    id: 'flashes',
    words: 'general flashes of more than a quarter of a field, in any second',
    bar: '≤ 3',
    figure: (found) => found.flashes.general,
    holds: ({ passes }) => passes,
    show: ({ flashes, area }) => `${flashes}; ${percent(area)}`,
    brief: true,
  },
  {
    id: 'red',
    words: 'red flashes, the same',
    bar: '≤ 3',
    figure: (found) => found.flashes.red,
    holds: ({ passes }) => passes,
    show: ({ flashes, area }) => `${flashes}; ${percent(area)}`,
    brief: true,
  },
  {
    id: 'locus',
    words: 'Δxy of luminous pixels from a black body to the same camera, 99 % below',
    bar: '≤ 0.01',
    figure: (found) => found.locus.shown,
    holds: (off) => off <= 0.01,
    show: (off) => off.toFixed(4),
    brief: true,
    needs: ['fire', 'black_body', 'sheets'],
  },
  {
    id: 'warm',
    words: 'luminous pixels with R ≥ G ≥ B',
    bar: '≥ 95 %',
    figure: (found) => found.warm,
    holds: (share) => share >= 0.95,
    show: percent,
    brief: true,
    needs: ['fire', 'black_body', 'no_sky'],
  },
  {
    id: 'up',
    words: 'luminous area that moves, moving up',
    bar: '≥ 90 %',
    figure: (found) => found.up,
    holds: (share) => share >= 0.9,
    show: percent,
    brief: false,
    needs: ['fire', 'bare', 'calm', 'sheets'],
  },
  {
    id: 'asymmetry',
    words: 'left–right asymmetry of the mean',
    bar: '< 10 %',
    figure: (found) => found.asymmetry,
    holds: (share) => share < 0.1,
    show: percent,
    brief: false,
    needs: ['bare', 'calm'],
  },
  {
    id: 'jump',
    words: 'jump of luminance at the base, 95 % of columns',
    bar: '< 50 %',
    figure: (found) => found.jump,
    holds: (share) => share < 0.5,
    show: percent,
    brief: true,
    needs: ['fire', 'bare', 'sheets'],
  },
  {
    id: 'alpha',
    words: 'pixels with a colour above their alpha',
    bar: '0',
    figure: (found) => found.exceeds,
    holds: (count) => count === 0,
    show: String,
    brief: true,
  },
  {
    id: 'contrast',
    words: 'contrast with black, white, a photograph [OkLab / 100]',
    bar: '≥ 10',
    figure: (found) => found.contrast,
    holds: (/** @type {number[]} */ all) => all.every((value) => value >= 10),
    show: (/** @type {number[]} */ all) => all.map((value) => value.toFixed(0)).join(', '),
    brief: true,
    needs: ['fire', 'bare'],
  },
  {
    id: 'flat',
    words: 'luminous pixels of the most frequent colour',
    bar: '≤ 2 %',
    figure: (found) => found.flat,
    holds: (share) => share <= 0.02,
    show: percent,
    brief: false,
    needs: ['fire', 'black_body', 'sheets'],
  },
  {
    id: 'width',
    words: 'luminous width at 0.3 to 0.5 of the height, in widths of the source',
    bar: '',
    figure: (found) => found.width,
    holds: () => true,
    show: (width) => width.toFixed(2),
    brief: false,
    needs: ['fire', 'bare', 'calm'],
  },
  {
    id: 'jerk',
    words: 'second difference of the mean luminance of pictures, of the mean',
    bar: '',
    figure: (found) => found.jerk,
    holds: () => true,
    show: percent,
    brief: false,
    needs: ['fire'],
  },
];
