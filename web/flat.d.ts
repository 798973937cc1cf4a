/**
 * The types of `hearth-fire/flat`: a fire for an engine that shows pictures.
 */

import type { FireOptions, FireSource, FlatLight } from './worlds/source.js';

export type { FireOptions, FireSource, FlatLight };

/** What shows a fire. */
export interface FlatListener {
  /** A new picture with premultiplied colours, which is the listener's to close. */
  picture(picture: ImageBitmap): void;
  /** A value is refused, or there is no fire; the console has it, too. */
  error?(error: Error): void;
}

/** A fire whose picture lies in a flat world so that its source is at a target, and what has left it stays. */
export class FlatFire {
  constructor(options: FireOptions, on: FlatListener);
  /** The fire: its values, statistics and calls. */
  readonly fire: FireSource;
  /** Its light. */
  readonly light: FlatLight;
  /** Edges of its picture in the fire [m]. */
  readonly area: [left: number, lower: number, right: number, upper: number];
  /**
   * Moves the source to a target; returns where the upper left corner of the picture is then. `height` is that of the
   * picture, and `up` the direction of y: -1, downwards, without it.
   */
  follow(target: { x: number; y: number }, height: number, up?: 1 | -1): { x: number; y: number };
  /** Frees the fire. */
  dispose(): void;
}
