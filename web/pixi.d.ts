/**
 * The types of `hearth-fire/pixi`: a fire in a scene of PixiJS.
 */

import type { Sprite } from 'pixi.js';
import type { FireOptions, FireSource, FlatLight } from './worlds/source.js';

export type { FireOptions, FireSource, FlatLight };

/** A sprite that burns. Its height is that of the picture; its colours are premultiplied. */
export class FireSprite extends Sprite {
  constructor(options?: FireOptions);
  /** What carries the source: an object or a place in the parent's coordinates. */
  target: { x: number; y: number };
  /** The fire: its values, statistics and calls. */
  readonly fire: FireSource;
  /** Its light, in the parent's coordinates. */
  readonly light: FlatLight;
}
