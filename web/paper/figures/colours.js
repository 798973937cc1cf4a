/**
 * The colours of a fire by its temperature, read from its pictures: the middle of a disc has the temperature of a
 * particle at birth.
 */

import { make } from './cells.js';
import { inSight } from './sight.js';

/** @typedef {import('../../hearth-fire.js').HearthFire} HearthFire */

/** The temperatures [K]. */
const FIRST = 1000;
const LAST = 2500;
const STEP = 100;
/** Every so many kelvins there is a visible label. */
const LABELLED = 500;
/** Steps until the fire has particles to look at. */
const STEPS = 60;

/** Red, green and blue of the brightest pixel. @param {ArrayLike<number>} pixels  Four numbers each. */
export function brightest(pixels) {
  let [best, at] = [-1, 0];
  for (let pixel = 0; pixel < pixels.length; pixel += 4) {
    const sum = pixels[pixel] + pixels[pixel + 1] + pixels[pixel + 2];
    if (sum > best) [best, at] = [sum, pixel];
  }
  return [pixels[at], pixels[at + 1], pixels[at + 2]];
}

/** @param {number[]} rgb */
export const hex = (rgb) => `#${rgb.map((channel) => channel.toString(16).padStart(2, '0')).join('')}`;

/** The colour of the hottest spot of a fire's picture. @param {HearthFire} fire */
async function hottest(fire) {
  await fire.step();
  const bitmap = await createImageBitmap(await fire.toBlob());
  const { width, height } = bitmap;
  const canvas = make('canvas', { width, height });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  return hex(brightest(context.getImageData(0, 0, width, height).data));
}

/**
 * Fills the scale, then lets the slider move the fire's temperature.
 * @param {HearthFire} fire @param {HTMLElement} scale @param {HTMLInputElement} slider @param {HTMLElement} words
 */
export async function showColours(fire, scale, slider, words) {
  await fire.ready;
  await fire.step(STEPS);
  const usual = fire.maximumTemperature;
  /** @type {Map<number, string>} */
  const colours = new Map();
  for (let kelvin = FIRST; kelvin <= LAST; kelvin += STEP) {
    await fire.set('maximum_temperature', kelvin);
    const colour = await inSight(fire, () => hottest(fire));
    colours.set(kelvin, colour);
    const label = make('span', { className: kelvin % LABELLED === 0 ? '' : 'unseen' }, `${kelvin} K`);
    const swatch = make('li', {}, label, make('span', { className: 'unseen' }, `: ${colour}`));
    swatch.style.setProperty('--colour', colour);
    scale.append(swatch);
  }
  const show = () => {
    const kelvin = Number(slider.value);
    words.textContent = `${kelvin} K, ${colours.get(kelvin)}`;
    slider.ariaValueText = words.textContent;
    fire.maximumTemperature = kelvin;
  };
  Object.assign(slider, {
    min: String(FIRST),
    max: String(LAST),
    step: String(STEP),
    value: String(usual),
    disabled: false,
  });
  slider.addEventListener('input', show);
  show();
}
