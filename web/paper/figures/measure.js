/** The mean shape of a fire in its second and third second. */

import { burn } from '../burn.js';
import { meanOf, shapeOf } from './shape.js';

/**
 * @param {import('../../parameters.js').PresetName} preset
 * @param {{[id: string]: any}} params
 * @param {() => Promise<unknown>} pause  Lets others run; throws once the result is no longer needed.
 */
export async function measure(preset, params, pause) {
  /** @type {import('./shape.js').Shape[]} */
  const shapes = [];
  await burn({ preset, params }, pause, (sim) => {
    const { source_height: source, smoothing_radius: radius } = sim.params;
    shapes.push(shapeOf(sim.positions(), source, radius));
  });
  return meanOf(shapes);
}
