/**
 * The types of `hearth-fire/three`: a fire in a scene of three.js.
 */

import type { DepthTexture, Object3D, Object3DEventMap, PointLight, Vector3 } from 'three';
import type { FireOptions, FireSource } from './worlds/source.js';

export type { FireOptions, FireSource };

/** What a fire in a scene starts with. */
export interface FireObjectOptions extends FireOptions {
  /** Whether the light casts shadows. */
  shadow?: boolean;
  /** Depth of the scene without the fire, for soft edges at things. */
  depthTexture?: DepthTexture;
  /** Distance over which the fire fades at things [m]; without it, by the width of its source. */
  soft?: number;
  /** How bright the light is; 1, as the fire, without it. */
  intensity?: number;
}

/** The events of a fire in a scene. */
export interface FireObjectEventMap extends Object3DEventMap {
  /** A value is refused, or there is no fire. */
  error: { error: Error };
  /** A new picture: a scene in which nothing else moves is drawn then, and no more often. */
  picture: object;
}

/** A fire in a scene. Its origin is on the floor, below its source. */
export class FireObject extends Object3D<FireObjectEventMap> {
  constructor(options?: FireObjectOptions);
  readonly isFireObject: true;
  /** The fire: its values, statistics and calls. */
  readonly fire: FireSource;
  /** Its light, which flickers and sways as the fire does. */
  readonly light: PointLight;
  /** What carries the source: its motion along the sheets moves the source through the gas. */
  readonly source: Object3D;
  /** Wind in the world [m/s]. */
  readonly wind: Vector3;
  /** Depth of the scene without the fire, for soft edges at things. */
  depthTexture?: DepthTexture | undefined;
  /** How bright the light is; 1: as the fire. */
  intensity: number;
  /** Frees the fire, and all that it has on the graphics card. */
  dispose(): void;
}
