/**
 * A fire without an element, whose pictures other programs show in their own worlds.
 */

import type { HearthParameters, HearthStats, HearthValues, PresetName } from '../parameters.js';

/** What a fire starts with. */
export interface FireOptions {
  /** The scene; without it, the default one. Its wall, ground and background are left out. */
  preset?: PresetName;
  /** Values of parameters on top of the scene. */
  values?: HearthValues;
  /** The level of detail; without it, as much as the device computes in time. */
  quality?: 'low' | 'medium' | 'high';
  /** Seconds that the fire has burnt before its first picture, from 0 to 30. */
  warm?: number;
  /** Whether it starts paused. */
  paused?: boolean;
  /** Width of the picture, from 16 to 2048 [pixels]; 512 without it. */
  width?: number;
  /** Height of the picture, from 16 to 2048 [pixels]; 512 without it. */
  height?: number;
  /** How the domain of the scene fits the picture: `height` without it. */
  fit?: 'height' | 'contain' | 'cover' | 'width';
  /** Where the wasm is, if it is not beside its script. */
  wasmUrl?: string | URL;
  /** The thread of the engine: `auto`, a worker if one can draw, without it. */
  thread?: 'auto' | 'worker' | 'main';
}

/** A fire: its values, statistics and calls. */
export class FireSource {
  constructor(options: FireOptions, on: FireListener, sheets?: boolean);
  /** The values of all parameters; there are none before the fire burns. */
  readonly values: HearthParameters;
  /** Measurements, about four times a second. */
  readonly stats: Partial<HearthStats>;
  /** Settles when the fire burns. */
  readonly ready: Promise<void>;
  /** Sets parameters, all or none; `null` restores a default. */
  set(values: HearthValues): Promise<void>;
  /** Calls a method of the element by its name, such as `play`, `pause`, `advance`, `preset` or `sparks`. */
  call(name: string, ...rest: unknown[]): Promise<unknown>;
  /** The page has shown a picture. */
  shown(): void;
  /** Frees the fire. */
  dispose(): void;
}

/** What hears of a fire. */
export interface FireListener {
  /** A new picture, which is the listener's to close. */
  picture(picture: ImageBitmap): void;
  /** What the picture before shows: the event `lights` of the engine. */
  lights?(numbers: Float32Array): void;
  /** A value is refused, or there is no fire. */
  error(error: Error): void;
}

/** The light of a fire in a flat world. */
export interface FlatLight {
  /** Its place in the world. */
  readonly x: number;
  readonly y: number;
  /** Luminosity [m²]. */
  readonly intensity: number;
  /** Colour, as 0xrrggbb. */
  readonly color: number;
}
