/**
 * Spectrograms of six fires as a picture of JPEG, and the table by which sounds of fires differ:
 * `node tests/sim/spectrograms.mjs docs/sound.jpg`, after `cargo xtask build`. A headless Chromium encodes the picture.
 * Scenes after the name of the file are measured too.
 */
import { writeFileSync } from 'node:fs';
import { Browser } from '../e2e/driver.mjs';
import { createSimulation } from './library.mjs';
import { RATE, between, densityOf, measured, soundOfScene } from './sound-signal.mjs';

/** Seconds of each sound, those that the table leaves out, and those of the pictures. */
const [SECONDS, SETTLES, SHOWN] = [24, 1, 8];
/** Size of each spectrogram [pixels], and its range of frequencies [Hz] and of levels [dB]. */
const [WIDTH, HEIGHT] = [480, 150];
const [LOWEST, HIGHEST] = [30, 16_000];
const RANGE = 70;
/** Samples of a window. */
const WINDOW = 4096;

/** The fires of the picture. */
const FIRES = ['campfire', 'fireside', 'burning-logs', 'torch', 'wall-of-fire', 'gas-burner'];

/** The sound of a scene. @param {string} preset */
async function heard(preset) {
  const sim = await createSimulation({ preset, seed: 1 });
  const samples = await soundOfScene(sim, SECONDS, { seed: 1 });
  sim.free();
  return samples;
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

const [file = 'docs/sound.jpg', ...others] = process.argv.slice(2);
const all = [];
console.log('| fire | octaves [dB] | crackles [1/s]; half, a tenth [dB] | kurtosis | crest [dB] | level [dBFS] |');
console.log('|---|---|---|--:|--:|--:|');
for (const name of [...FIRES, ...others]) {
  const samples = await heard(name);
  const { octaves, crackles, half, tenth, kurtosis, crest, level } = measured(between(samples, SETTLES, SECONDS));
  const whole = (number) => number.toFixed(0).replace('-0', '0').replace('-', '−');
  const numbers = [octaves.map(whole).join(' '), `${crackles.toFixed(1)}; ${whole(half)}, ${whole(tenth)}`];
  console.log(`| ${[name, ...numbers, ...[kurtosis, crest, level].map(whole)].join(' | ')} |`);
  if (FIRES.includes(name)) all.push({ name, samples: between(samples, SECONDS - SHOWN, SECONDS) });
}
/** The loudest level of each sound, to which its picture refers. */
const loudestOf = (samples) => Math.max(...densityOf(samples, WINDOW).map((x, bin) => (x * bin * RATE) / WINDOW));

const browser = await Browser.start();
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
  all.map(({ name, samples }) => ({ name, rows: spectrogramOf(samples, loudestOf(samples)) })),
  WIDTH,
  HEIGHT,
);
await browser.close();
writeFileSync(file, Buffer.from(picture.split(',')[1], 'base64'));
