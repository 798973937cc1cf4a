/**
 * Spectrograms of five fires as a picture of JPEG, and the table by which their sounds differ:
 * `node tests/sim/spectrograms.mjs docs/sound.jpg`, after `cargo xtask build`. A headless Chromium encodes the picture.
 */
import { writeFileSync } from 'node:fs';
import { STEP_NUMBERS, Synthesis } from '../../web/sound.js';
import { CRACKS_PER_SPARK } from '../../web/sound/synthesis.js';
import { RATE, between, densityOf, levelOf } from '../web/sound-signal.mjs';
import { Browser } from '../e2e/driver.mjs';
import { createSimulation } from './library.mjs';

/** Seconds of each fire, and those that the table leaves out. */
const [SECONDS, SETTLES] = [8, 2];
/** Size of each spectrogram [pixels], and its range of frequencies [Hz] and of levels [dB]. */
const [WIDTH, HEIGHT] = [480, 150];
const [LOWEST, HIGHEST] = [30, 16_000];
const RANGE = 70;
/** Samples of a window. */
const WINDOW = 4096;

/**
 * The fires: a name, a scene, and what happens to it.
 * @type {[name: string, preset: string, act?: (sim: any) => void][]}
 */
const FIRES = [
  ['campfire', 'campfire'],
  ['candle', 'candle'],
  ['forge', 'forge'],
  ['gas burner', 'gas-burner'],
  ['campfire, sprayed from 4 s on', 'campfire', (sim) => sim.time > 4 && sim.spray(0, 1, 0, -4, 4)],
];

/**
 * The left channel of a scene, and its mean rate of cracks [1/s].
 * @param {typeof FIRES[number]} fire
 */
async function heard([, preset, act = () => {}]) {
  const sim = await createSimulation({ preset, seed: 1 });
  const speed = sim.get('time_scale');
  const sound = new Synthesis({ rate: RATE, seed: 1 });
  let cracks = 0;
  sim.series();
  const samples = [];
  while (samples.length < SECONDS * RATE) {
    act(sim);
    const end = sim.time + speed / 60;
    while (sim.time < end) sim.step();
    const series = sim.series();
    sound.push(series, speed);
    const [left, right] = [0, 1].map(() => new Float32Array(Math.floor(sound.ahead * RATE)));
    sound.render(left, right);
    samples.push(...left);
    for (let at = 0; at < series.length; at += STEP_NUMBERS) cracks += CRACKS_PER_SPARK * series[at + 8];
  }
  sim.free();
  return { samples: Float32Array.from(samples), rate: cracks / SECONDS };
}

/** The mean frequency of a sound above the lowest that a loudspeaker of a laptop gives [Hz]. */
function centroidOf(samples) {
  const density = densityOf(samples);
  const width = RATE / 2 / density.length;
  let [sum, moment] = [0, 0];
  for (let bin = Math.ceil(100 / width); bin < density.length; bin += 1) {
    sum += density[bin];
    moment += density[bin] * bin * width;
  }
  return moment / sum;
}

/** Levels of a spectrogram from 0 to 255, row by row from the highest frequency. */
function spectrogramOf(samples, loudest) {
  const columns = Array.from({ length: WIDTH }, (_, at) => {
    const from = Math.round((at / WIDTH) * (samples.length - WINDOW));
    return densityOf(samples.subarray(from, from + WINDOW), WINDOW);
  });
  return Array.from({ length: HEIGHT }, (_, row) => {
    const frequency = HIGHEST * (LOWEST / HIGHEST) ** (row / HEIGHT);
    const bin = (frequency * WINDOW) / RATE;
    return columns.map((column) => {
      const [below, share] = [Math.floor(bin), bin % 1];
      const value = column[below] * (1 - share) + column[below + 1] * share;
      // A white spectrum of the band of a row is as bright at every height.
      const level = 10 * Math.log10((value * frequency) / loudest + 1e-12);
      return Math.max(0, Math.min(255 * (1 + level / RANGE), 255));
    });
  });
}

const all = [];
for (const fire of FIRES) all.push({ name: fire[0], ...(await heard(fire)) });
const loudest = Math.max(
  ...all.map(({ samples }) => Math.max(...densityOf(samples, WINDOW).map((x, bin) => (x * bin * RATE) / WINDOW))),
);

console.log('| fire | level [dBFS] | centroid [Hz] | cracks [1/s] |\n|---|---|---|---|');
for (const { name, samples, rate } of all) {
  const settled = between(samples, name.includes('sprayed') ? 4 : SETTLES, SECONDS);
  const level = (20 * Math.log10(levelOf(settled))).toFixed(0).replace('-', '−');
  console.log(`| ${name} | ${level} | ${centroidOf(settled).toFixed(0)} | ${rate.toFixed(1)} |`);
}

const browser = await Browser.start('chromium');
const tab = await browser.open('<p>A canvas.</p>');
const picture = await tab.evaluate(
  (panels, width, height) => {
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [2 * width + 30, 3 * (height + 26) + 4];
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    context.fillStyle = '#161210';
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.font = '14px sans-serif';
    for (const [at, { name, rows }] of panels.entries()) {
      const [left, top] = [10 + (at % 2) * (width + 10), 22 + Math.floor(at / 2) * (height + 26)];
      const pixels = context.createImageData(width, height);
      for (const [index, level] of rows.flat().entries()) {
        const heat = level / 255;
        const colour = [255 * Math.min(2 * heat, 1), 255 * heat ** 1.6, 255 * Math.max(2.5 * heat - 1.6, 0.08 * heat)];
        pixels.data.set([...colour, 255], 4 * index);
      }
      context.putImageData(pixels, left, top);
      context.fillStyle = '#f4ece4';
      context.fillText(name, left, top - 6);
      context.textAlign = 'right';
      for (const frequency of [100, 1000, 10_000]) {
        const label = frequency < 1000 ? `${frequency} Hz` : `${frequency / 1000} kHz`;
        const y = top + (height * Math.log(16_000 / frequency)) / Math.log(16_000 / 30);
        context.fillText(label, left + width - 4, y + 5);
      }
      context.textAlign = 'left';
    }
    return canvas.toDataURL('image/jpeg', 0.55);
  },
  all.map(({ name, samples }) => ({ name, rows: spectrogramOf(samples, loudest) })),
  WIDTH,
  HEIGHT,
);
await browser.close();
const [file = 'docs/sound.jpg'] = process.argv.slice(2);
writeFileSync(file, Buffer.from(picture.split(',')[1], 'base64'));
