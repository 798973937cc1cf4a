/**
 * A fire in a scene of three.js that `WebGPURenderer` draws.
 *
 *     import { FireObject } from 'hearth-fire/three/webgpu';
 */

import { FireBody } from './body.js';
import { nodeMaterials } from './nodes.js';

/** A fire for `WebGPURenderer`. */
export class FireObject extends FireBody {
  /** @param {import('../three.js').FireObjectOptions} [options] */
  constructor(options = {}) {
    super(options, nodeMaterials);
  }
}
