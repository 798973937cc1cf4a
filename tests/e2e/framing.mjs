/**
 * Measures the framing of the landing page's fire: the height of its bright part, and the
 * distance of its base from the lower edge, as shares of the stage's height. `node
 * framing.mjs` measures all sizes, `node framing.mjs 390x844` one; `--query scene=campfire`
 * measures another scene. `HEARTH_SITE` names the site, `HEARTH_HEADLESS_SHELL` the browser.
 *
 * The fire is paused and burns by requested steps, so every machine measures the same
 * seconds.
 */
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { Browser } from './driver.mjs';

/** The sizes of a page that are measured. @type {[number, number][]} */
export const SIZES = [
  [320, 568],
  [390, 844],
  [844, 390],
  [768, 1024],
  [1280, 800],
  [1920, 1080],
  [3440, 1440],
];

/** The measures that hold, in shares of the stage's height. */
export const BARS = { height: [0.42, 0.7], base: [0.02, 0.1] };

/** What is brighter than this counts as the flame, from 0 to 1. */
const BRIGHT = 0.5;

/**
 * How bright a pixel is: by the numbers of its channels, or by the light that they stand for.
 * @typedef {'coded' | 'linear'} Scale
 */

/** How many moments are measured, and how far they are apart [s]. */
const MOMENTS = 40;
const APART = 0.25;

/** How long the fire burns before the first [s]. */
const BURNT = 3;

/** Number of steps from which the length of a step is found. */
const TRIED = 400;

/** Pixels that are enough for these measures: a software renderer computes each one. */
const PIXELS = 80_000;

/** Widest screen [device pixels]; a wider page is drawn with fewer pixels, in the same layout. */
const WIDEST = 860;

/**
 * Measures the page's fire in a page of that size.
 * @param {Browser} browser
 * @param {[number, number]} size
 * @param {string} [query]  Of the page's address.
 * @param {number} [moments]
 * @returns {Promise<{[scale in Scale]: Measure} & {stage: number[]}>}
 *
 * @typedef {object} Measure  Medians, in shares of the stage's height.
 * @property {number} height
 * @property {number} base
 * @property {number[]} heights  Each of them.
 */
export async function measure(browser, [width, height], query = '', moments = MOMENTS) {
  const values = new URLSearchParams({ quality: 'low', ...Object.fromEntries(new URLSearchParams(query)) });
  values.set('paused', '');
  values.set('max-pixels', `${PIXELS}`);
  const touch = Math.min(width, height) < 500;
  const tab = await browser.open(`index.html?${values}`, { width, height, touch, ratio: Math.min(1, WIDEST / width) });
  await tab.ready();
  const { stage, rows } = await tab.fire(
    async (fire, tried, burnt, moments, apart, bright) => {
      // Sparks are bright and fly to the top, and are no flame.
      await fire.set('ember_rate', 0);
      await fire.reset();
      const canvas = fire.shadowRoot.querySelector('canvas');
      /** @type {{[scale in Scale]: number[]}[]} */
      const found = [];
      // The fire reports its time a few times a second, so the length of a step is found once.
      let [made, reported] = [tried, false];
      await fire.step(tried);
      fire.addEventListener(
        'stats',
        () => {
          reported = true;
        },
        { once: true },
      );
      for (; !reported; made += 1) await fire.step(1);
      const step = fire.stats.time / made;
      for (let at = 0; at < moments; at += 1) {
        for (const ends = Math.round((burnt + at * apart) / step); made < ends; ) {
          const some = Math.min(50, ends - made);
          await fire.step(some);
          made += some;
        }
        await new Promise(requestAnimationFrame);
        const copy = new OffscreenCanvas(canvas.width, canvas.height);
        const context = /** @type {OffscreenCanvasRenderingContext2D} */ (
          copy.getContext('2d', { willReadFrequently: true })
        );
        context.drawImage(canvas, 0, 0);
        const { data } = context.getImageData(0, 0, copy.width, copy.height);
        const linear = Array.from({ length: 256 }, (_, value) =>
          value <= 10 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4,
        );
        const coded = Array.from({ length: 256 }, (_, value) => value / 255);
        const extent = (light) => {
          let [top, bottom] = [-1, -1];
          for (let row = 0; row < copy.height; row += 1) {
            for (let column = 0; column < copy.width; column += 1) {
              const at = 4 * (row * copy.width + column);
              const [r, g, b] = [light[data[at]], light[data[at + 1]], light[data[at + 2]]];
              if (0.2126 * r + 0.7152 * g + 0.0722 * b <= bright) continue;
              if (top < 0) top = row;
              bottom = row;
              break;
            }
          }
          return top < 0 ? [0, 0] : [(bottom + 1 - top) / copy.height, 1 - (bottom + 1) / copy.height];
        };
        found.push({ coded: extent(coded), linear: extent(linear) });
      }
      const box = fire.getBoundingClientRect();
      return { stage: [box.width, box.height], rows: found };
    },
    TRIED,
    BURNT,
    moments,
    APART,
    BRIGHT,
  );
  if (tab.problems.length > 0) throw new Error(tab.problems.join('\n'));
  const of = (/** @type {Scale} */ scale) => {
    const heights = rows.map((row) => row[scale][0]);
    return { height: median(heights), base: median(rows.map((row) => row[scale][1])), heights };
  };
  return { stage, coded: of('coded'), linear: of('linear') };
}

/** @param {number[]} numbers */
function median(numbers) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return (sorted[(sorted.length - 1) >> 1] + sorted[sorted.length >> 1]) / 2;
}

if (process.argv[1] && path.resolve(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const asked = process.argv.slice(2);
  const at = asked.indexOf('--query');
  const query = at < 0 ? '' : asked.splice(at, 2)[1];
  const sizes = asked.length === 0 ? SIZES : SIZES.filter((size) => asked.includes(size.join('x')));
  const percent = (share) => `${(100 * share).toFixed(1)} %`;
  const within = (/** @type {number[]} */ [least, most], /** @type {number} */ share) =>
    share >= least && share <= most ? 'holds' : 'FAILS';
  const browser = await Browser.launch();
  try {
    for (const size of sizes) {
      const measured = await measure(browser, size, query);
      console.log(`${size.join(' × ')} (stage ${measured.stage.join(' × ')})`);
      for (const scale of /** @type {const} */ (['coded', 'linear'])) {
        const { height, base, heights } = measured[scale];
        const [low, high] = [Math.min(...heights), Math.max(...heights)].map(percent);
        console.log(
          `  ${scale}: height ${percent(height)} ${within(BARS.height, height)} (${low} to ${high}), ` +
            `base ${percent(base)} ${within(BARS.base, base)}`,
        );
      }
    }
  } finally {
    await browser.close();
  }
}
