/**
 * Random values of a scene, in three strengths. Mild values stay near those of the scene, so a candle remains a candle.
 * Bold ones go three times as far, mostly with colours of their own. Wild ones are bold ones of another scene.
 *
 * @typedef {'mild' | 'bold' | 'wild'} Strength
 */

import { DOMAINS, sceneValue } from './scene.js';

/**
 * @typedef {import('../parameters.js').ParameterId} Id
 * @typedef {Partial<import('../parameters.js').HearthParameters>} Values
 */

/** The largest ratio of a value to the scene's. @type {Partial<Record<Id, number>>} */
const RATIOS = {
  fuel_power: 1.5,
  emission_rate: 1.5,
  emission_speed: 1.6,
  lifetime_max: 1.4,
  maximum_temperature: 1.2,
  burn_time: 1.6,
  flame_rise: 1.25,
  soot_life: 1.6,
  buoyancy: 1.2,
  turbulence_scale: 1.6,
  bloom: 1.8,
  smoke_opacity: 2.5,
  ember_rate: 3,
  particle_size: 1.3,
};

/** The largest difference of a value from the scene's. @type {Partial<Record<Id, number>>} */
const DIFFERENCES = {
  wind: 0.5,
  turbulence: 1.5,
  vorticity_confinement: 0.25,
  emission_noise: 0.25,
  exposure: 0.5,
  detail: 0.4,
};

/** @type {Strength[]} */
export const STRENGTHS = ['mild', 'bold', 'wild'];

/** How far values go beyond the largest ratios and differences, and the share of results with colours of their own. */
const FARTHER = { mild: 1, bold: 3, wild: 3 };
const COLOURED = { mild: 0.35, bold: 0.8, wild: 0.6 };

/** Pages of the paper show its equations, not a fire that may surprise. */
const PAPER = /^(paper-|classic$)/;

/**
 * The name of another scene.
 * @param {readonly {name: string}[]} scenes @param {string} present @param {() => number} [random]
 */
export function otherScene(scenes, present, random = Math.random) {
  const others = scenes.filter(({ name }) => name !== present && !PAPER.test(name));
  return /** @type {import('../parameters.js').PresetName} */ (others[Math.floor(random() * others.length)].name);
}

/**
 * Values for `set`.
 * @param {import('./scene.js').Fire} fire
 * @param {Strength} strength
 * @param {() => number} [random]  A number of 0 to 1, without 1.
 * @returns {Values}
 */
export function randomValues(fire, strength, random = Math.random) {
  const model = fire.params.model;
  /** @type {{[id: string]: number | string}} */
  const values = {};
  /** @type {(table: typeof RATIOS, move: (value: number, most: number, by: number) => number) => void} */
  const draw = (table, move) => {
    for (const [id, most] of Object.entries(table)) {
      const domain = DOMAINS.get(id)?.[model];
      const value = sceneValue(fire, /** @type {Id} */ (id));
      if (!domain || typeof value !== 'number') continue;
      const moved = Number(move(value, most, FARTHER[strength] * (2 * random() - 1)).toPrecision(3));
      values[id] = Math.min(Math.max(moved, Number(domain.min)), Number(domain.max));
    }
  };
  draw(RATIOS, (value, most, by) => value * most ** by);
  draw(DIFFERENCES, (value, most, by) => value + most * by);
  const hue = 360 * random();
  if (random() < COLOURED[strength]) {
    values.palette = 'custom';
    values.hot_colour = hex(hue + 20 + 40 * random(), 0.65);
    values.cool_colour = hex(hue, 0.5);
  } else {
    values.palette = String(sceneValue(fire, 'palette'));
  }
  return values;
}

/** A saturated colour as hexadecimal digits. @param {number} hue  In degrees. @param {number} lightness */
function hex(hue, lightness) {
  const channel = (/** @type {number} */ n) => {
    const k = (n + hue / 30) % 12;
    const value = lightness - Math.min(lightness, 1 - lightness) * Math.max(-1, Math.min(k - 3, 9 - k, 1));
    return Math.round(255 * value)
      .toString(16)
      .padStart(2, '0');
  };
  return `#${channel(0)}${channel(8)}${channel(4)}`;
}
