/**
 * The sound of a fire without a browser: samples from the series of its steps, which `series()` of `hearth-fire/sim`
 * gives.
 */

export { STEP_NUMBERS, Synthesis } from './sound/synthesis.js';
