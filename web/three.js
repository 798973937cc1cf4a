/**
 * A fire in a scene of three.js: sheets with depth between them, embers, and a light.
 *
 *     const fire = new FireObject({ preset: 'campfire' });
 *     scene.add(fire);
 *
 * The engine simulates and draws in its worker; the page uploads a picture.
 */

import { ShaderMaterial } from 'three';
import { BLENDED, FireBody } from './three/body.js';
import { EMBER_FRAGMENT, EMBER_VERTEX, FRAGMENT, VERTEX } from './three/sheets.js';

/** A fire for `WebGLRenderer`. */
export class FireObject extends FireBody {
  /** @param {import('./three.js').FireObjectOptions} [options] */
  constructor(options = {}) {
    super(options, (values) => {
      const named = Object.entries(values).map(([name, value]) => [name, { value }]);
      const uniforms = { ...Object.fromEntries(named), sceneDepth: { value: null } };
      const material = (/** @type {string} */ vertexShader, /** @type {string} */ fragmentShader) =>
        new ShaderMaterial({ ...BLENDED, uniforms, vertexShader, fragmentShader });
      return { uniforms, sheets: material(VERTEX, FRAGMENT), embers: material(EMBER_VERTEX, EMBER_FRAGMENT) };
    });
  }
}
