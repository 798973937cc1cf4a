/**
 * The types of `hearth-fire/three/webgpu`: those of `hearth-fire/three`. The depth of the scene is read without a
 * `depthTexture`.
 */

export * from '../three.js';
