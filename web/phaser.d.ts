/**
 * The types of `hearth-fire/phaser`: a fire in a scene of Phaser.
 */

import type { GameObjects, Scene } from 'phaser';
import type { FireOptions, FireSource, FlatLight } from './worlds/source.js';

export type { FireOptions, FireSource, FlatLight };

/** An image that burns. Its display height is that of the picture. */
export class FireImage extends GameObjects.Image {
  constructor(scene: Scene, options?: FireOptions);
  /** What carries the source: an object or a place in the world. */
  target: { x: number; y: number };
  /** The fire: its values, statistics and calls. */
  readonly fire: FireSource;
  /** Its light, in the world. */
  readonly light: FlatLight;
}
