/**
 * The fires of each figure. What they differ in from a scene is here; the scene's own values are in its file.
 *
 * @typedef {object} Cell
 * @property {import('../../parameters.js').PresetName} preset
 * @property {{[id: string]: any}} values  The values that differ from the preset's.
 * @property {string} [parameter]  Its value begins the caption.
 * @property {string} [words]  The caption, or what follows the value.
 * @property {boolean} [measured]  Whether its numbers are shown: yes unless false.
 * @property {number} [from]  Makes a slider for the parameter, from this value to the preset's.
 */

import { PRESETS } from '../../parameters.js';

/**
 * A scene at three values of its parameter, the last being the scene's own; a slider moves the middle one.
 * @param {import('../../parameters.js').PresetName} preset @param {string} parameter @param {number} low @param {number}
 *   middle
 * @returns {Cell[]}
 */
const three = (preset, parameter, low, middle) => [
  { preset, parameter, values: { [parameter]: low } },
  { preset, parameter, values: { [parameter]: middle }, from: low },
  { preset, parameter, values: {} },
];

/** By the id of the figure's heading. @type {{[id: string]: Cell[]}} */
export const COMPARISONS = {
  'figure-3': [
    { preset: 'paper-fire', values: {}, words: 'As the paper draws it' },
    {
      preset: 'paper-fire',
      values: { display_mode: 'fire' },
      words: 'The same particles as Hearth draws them',
      measured: false,
    },
  ],
  'figure-4': three('paper-smoothing', 'smoothing_radius', 0.015, 0.03),
  'figure-5': [
    ...three('paper-stiffness', 'gas_constant', 0.06, 0.6),
    {
      preset: 'paper-stiffness',
      parameter: 'gas_constant',
      values: { printed_kernel: true },
      words: 'kernel as printed',
    },
  ],
  'figure-6': [
    ...three('paper-viscosity', 'viscosity', 0.001, 0.008),
    {
      preset: 'paper-viscosity',
      parameter: 'viscosity',
      values: { printed_viscosity: false },
      words: 'force corrected',
    },
  ],
  buoyancy: three('paper-buoyancy', 'buoyancy', 0.02, 0.3),
};

/** The value of a parameter in a preset. @param {string} preset @param {string} id @returns {number} */
export function valueIn(preset, id) {
  /** @type {readonly {name: string, values: {[id: string]: any}}[]} */
  const presets = PRESETS;
  return presets.find(({ name }) => name === preset)?.values[id];
}
