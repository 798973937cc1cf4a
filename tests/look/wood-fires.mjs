/**
 * Measures five scenes as films of wood fires were measured, and writes a table: `node wood-fires.mjs table.md`, or `node
 * wood-fires.mjs table.md default` for those whose names begin so; the columns of the others are kept if the file has them.
 * `cargo measure look` runs this. Each figure is the median of fires of three seeds, at medium quality over black, without
 * wall and ground.
 */
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { LINEAR } from './figures/colour.mjs';
import { PIECES_EVERY, extent, loose, rowsOf, threshold } from './figures/body.mjs';
import { decay, rollOff } from './figures/pace.mjs';
import { Painter } from './painter.mjs';

const SCENES = ['campfire', 'default', 'fireside', 'wall-of-fire', 'bonfire-in-wind'];
const SEEDS = [11, 12, 13];
/** Square pictures [px], a second, their number, and the age of the fire before the first [s]. */
const [SIZE, RATE, PICTURES, BURNT] = [400, 30, 240, 4];
/** Those of medium quality. */
const PARTICLES = 3000;
/** Temperatures of black bodies that colours are compared with [K]. */
const KELVINS = Array.from({ length: 401 }, (_, step) => 1000 + 5 * step);
/** A channel that a screen clips has no chromaticity. */
const CLIPPED = 250;

/** @typedef {{[id: string]: number}} Figures */

/** @type {{words: string, films: string, bar: string, show: (figures: Figures) => string}[]} */
const ROWS = [
  {
    words: 'decay of the total light to 1/e, without a running mean of 1.2 s [s]',
    films: '0.041–0.050',
    bar: '≤ 0.075',
    show: ({ decay }) => decay.toFixed(3),
  },
  {
    words: 'roll-off of its spectrum, 1.5–11 Hz [dB a decade]',
    films: '−22 to −9',
    bar: '−22 to −12',
    show: ({ slope }) => slope.toFixed(0).replace('-', '−'),
  },
  {
    words: 'share of the light in the lowest fifth of L50',
    films: '5–19 %',
    bar: '≤ 35 %',
    show: ({ lowest }) => percent(lowest),
  },
  {
    words: 'colour temperature of base, middle and tip [K]',
    films: 'whitest at mid-height',
    bar: 'base ≥ 2200',
    show: ({ base, middle, tip }) => [base, middle, tip].map((kelvin) => kelvin.toFixed(0)).join(', '),
  },
  {
    words: 'times that 1.2 L50 is luminous',
    films: '0.05–0.07',
    bar: '≤ 0.10',
    show: ({ above }) => (Number.isNaN(above) ? '–' : above.toFixed(2)),
  },
  {
    words: 'loose pieces of flame in a picture, their light',
    films: '2–9, 0.6–6 %, with sparks',
    bar: '≤ 8, ≤ 4 %',
    show: ({ pieces, light }) => `${pieces.toFixed(1)}, ${percent(light)}`,
  },
  { words: 'sparks', films: '–', bar: '', show: ({ sparks }) => sparks.toFixed(1) },
];

const percent = (/** @type {number} */ share) => `${(100 * share).toFixed(share < 0.1 ? 1 : 0)} %`;

const [file, ...begins] = process.argv.slice(2);
if (file === undefined) throw new Error('usage: node wood-fires.mjs table.md [SCENE...]');

const columns = keptColumns(existsSync(file) ? readFileSync(file, 'utf8') : '');

const painter = new Painter();
try {
  for (const lit of SCENES.filter((name) => begins.length === 0 || begins.some((begin) => name.startsWith(begin)))) {
    const all = [];
    for (const seed of SEEDS) all.push(await figures(lit, seed));
    const ids = Object.keys(all[0]);
    const medians = Object.fromEntries(ids.map((id) => [id, median(all.map((of) => of[id]))]));
    const column = ROWS.map(({ show }) => show(medians));
    columns.set(lit, column);
    console.log(lit, column.join(' | '));
  }
  const scenes = SCENES.filter((name) => columns.has(name));
  const table = [
    `| measure | films | ${scenes.join(' | ')} | bar |`,
    `|---${'|---'.repeat(scenes.length + 2)}|`,
    ...ROWS.map(({ words, films, bar }, row) => {
      return `| ${[words, films, ...scenes.map((name) => columns.get(name)?.[row]), bar].join(' | ')} |`;
    }),
  ];
  writeFileSync(file, `${table.join('\n')}\n`);
} finally {
  await painter.close();
}

/**
 * The columns of an earlier table by their scenes.
 * @param {string} table @returns {Map<string, string[]>}
 */
function keptColumns(table) {
  const [head = [], , ...rows] = table
    .trim()
    .split('\n')
    .map((row) => row.split('|').map((cell) => cell.trim()));
  const places = [...head.keys()].filter((place) => SCENES.includes(head[place]));
  return new Map(places.map((place) => [head[place], ROWS.map((_, row) => rows[row]?.[place] ?? '–')]));
}

/** The figures of a fire without a wall and a ground. @param {string} lit @param {number} seed @returns {Promise<Figures>} */
async function figures(lit, seed) {
  const values = { background: '#000000', backdrop: 'none', ground: 'none', seed };
  const bodies = await painter.ask('locus', { kelvins: KELVINS });
  const start = await painter.ask('film', {
    lit,
    particles: PARTICLES,
    values,
    burnt: BURNT,
    width: SIZE,
    height: SIZE,
  });
  /** @type {Float32Array[]} */
  const luminance = [];
  /** @type {Buffer[]} */
  const colours = [];
  const withSparks = [];
  for (let picture = 0; picture < PICTURES; picture += 1) {
    const time = start + picture / RATE;
    const { bytes } = await painter.call('picture', { time, sparks: false });
    luminance.push(luminances(bytes));
    if (picture % PIECES_EVERY !== 0) continue;
    colours.push(bytes);
    withSparks.push(luminances((await painter.call('picture', { time })).bytes));
  }
  const light = luminance.map((of) => of.reduce((sum, value) => sum + value, 0));
  const pictures = { width: SIZE, height: SIZE, luminance };
  const level = threshold(pictures);
  const body = extent(pictures, level);
  const [flame, all] = [luminance.filter((_, k) => k % PIECES_EVERY === 0), withSparks].map((list) =>
    list.map((of) => loose(of, SIZE, level, body)),
  );
  const mean = (/** @type {number[]} */ list) => list.reduce((sum, value) => sum + value, 0) / list.length;
  const pieces = mean(flame.map((of) => of.pieces));
  const fifth = (/** @type {number} */ k) => {
    const [from, to] = rowsOf(body, k / 5, (k + 1) / 5);
    return luminance.reduce((sum, of) => sum + of.subarray(from * SIZE, to * SIZE).reduce((a, b) => a + b, 0), 0);
  };
  const fifths = [0, 1, 2, 3, 4].map(fifth);
  const [base, middle, tip] = [0, 1, 2].map((third) => {
    return temperature(colours, level, rowsOf(body, third / 3, (third + 1) / 3), bodies);
  });
  return {
    decay: decay(light, RATE),
    slope: rollOff(light, RATE),
    lowest: fifths[0] / fifths.reduce((sum, value) => sum + value, 0),
    ...{ base, middle, tip },
    above: body.intermittency(1.2),
    pieces,
    light: mean(flame.map((of) => of.light)),
    sparks: mean(all.map((of) => of.pieces)) - pieces,
  };
}

/** x and y of linear sRGB. @param {number[]} rgb */
function chromaticityOf([r, g, b]) {
  const x = 0.4123908 * r + 0.3575843 * g + 0.1804808 * b;
  const y = 0.212639 * r + 0.7151687 * g + 0.0721923 * b;
  const z = 0.0193308 * r + 0.1191948 * g + 0.9505322 * b;
  return [x / (x + y + z), y / (x + y + z)];
}

/** Relative luminance of each pixel. @param {Buffer} rgba */
function luminances(rgba) {
  return Float32Array.from({ length: rgba.length / 4 }, (_, at) => {
    const [r, g, b] = [LINEAR[rgba[4 * at]], LINEAR[rgba[4 * at + 1]], LINEAR[rgba[4 * at + 2]]];
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  });
}

/**
 * Colour temperature of the luminous, unclipped light between two rows.
 * @param {Buffer[]} pictures @param {number} level @param {[number, number]} rows @param {[number, number][]} bodies
 */
function temperature(pictures, level, [from, to], bodies) {
  const sum = [0, 0, 0];
  for (const rgba of pictures) {
    for (let at = from * SIZE; at < to * SIZE; at += 1) {
      const codes = [rgba[4 * at], rgba[4 * at + 1], rgba[4 * at + 2]];
      const linear = codes.map((code) => LINEAR[code]);
      if (0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2] <= level || Math.max(...codes) >= CLIPPED)
        continue;
      linear.forEach((value, k) => {
        sum[k] += value;
      });
    }
  }
  const [x, y] = chromaticityOf(sum);
  const off = bodies.map(([u, v]) => (u - x) ** 2 + (v - y) ** 2);
  return KELVINS[off.indexOf(Math.min(...off))];
}

/** A figure that a fire lacks has no median. @param {number[]} list */
function median(list) {
  if (list.some(Number.isNaN)) return NaN;
  return list.toSorted((a, b) => a - b)[Math.floor(list.length / 2)];
}
