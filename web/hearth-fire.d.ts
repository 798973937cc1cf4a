/**
 * The types of `<hearth-fire>`. Which parameters there are is generated from
 * the table of parameters: see `parameters.d.ts`.
 */

import type { HearthParameters, HearthProperties, HearthStats, ParameterId, PresetName } from './parameters.js';

export type * from './parameters.js';

/** How much work a fire makes itself. */
export type HearthQuality = 'low' | 'medium' | 'high';

/**
 * The settings of a fire, as `exportConfig` gives them and `importConfig` and `src`
 * take them: what differs from a preset, or from the defaults.
 */
export interface HearthConfig {
  /** The version of this form. */
  hearth?: 1;
  /** The preset, where it is not the default one. */
  preset?: PresetName;
  values: Partial<HearthParameters>;
  /** What it is called and what it shows, for people: the fire leaves both alone. */
  label?: string;
  description?: string;
}

/** A point: of the element in CSS pixels, y down, or of the fire's world in metres, y up. */
export interface HearthPoint {
  x: number;
  y: number;
}

/** A value that a fire refused. Every value of the same call is refused with it. */
export interface HearthRangeError extends RangeError {
  id: string;
  value: unknown;
  min?: number;
  max?: number;
}

/** What an `error` event tells. */
export type HearthErrorDetail =
  | { kind: 'unsupported' | 'load' | 'context-lost'; message: string }
  | {
      kind: 'bad-parameter';
      message: string;
      id: string;
      value: unknown;
      min?: number;
      max?: number;
    };

/** How `to` moves values. */
export interface HearthTransition {
  /** In milliseconds; 600 without it. */
  duration?: number;
  /** An easing of CSS; `ease-in-out` without it. */
  easing?: string;
}

/** What a `params-change` event tells. */
export interface HearthChangeDetail {
  id: ParameterId;
  value: number | string | boolean;
  /** Who changed it, as `attribute`, `property`, `preset`, `src` or `to`. */
  source: string;
}

/** What a `quality-change` event tells. */
export interface HearthQualityDetail {
  quality: HearthQuality;
  /** Why, in words. */
  reason: string;
}

/** The events of a fire. */
export interface HearthFireEventMap extends Omit<HTMLElementEventMap, 'error'> {
  ready: CustomEvent<null>;
  play: CustomEvent<null>;
  pause: CustomEvent<null>;
  stats: CustomEvent<HearthStats>;
  'params-change': CustomEvent<HearthChangeDetail>;
  'quality-change': CustomEvent<HearthQualityDetail>;
  error: CustomEvent<HearthErrorDetail>;
  restored: CustomEvent<null>;
}

/** Every parameter is a property as well; a value out of range is refused aloud and changes nothing. */
export interface HearthFire extends HearthProperties {}

/** The class of `<hearth-fire>`. */
export class HearthFire extends HTMLElement {
  /** Where the wasm file is, if it is not beside the module. Set it before the first fire. */
  static wasmUrl: string | URL | undefined;
  /** Where the engine runs: in a worker where that can draw, or as told. Set it before the first fire. */
  static engine: 'auto' | 'worker' | 'main';

  /** Every value that the fire burns with. */
  readonly params: HearthParameters;
  /** What it last said about itself; null before it did. */
  readonly stats: HearthStats | null;
  /**
   * Resolves when it burns; rejects where it cannot. An element that was taken off the page
   * has a new one.
   */
  readonly ready: Promise<void>;
  paused: boolean;
  autoplay: boolean;
  /** The preset that its values started from. */
  preset: PresetName;
  /** How much work it may make itself; `auto`: as much as fits. */
  quality: 'auto' | HearthQuality;
  /** What a screen reader says; without it the fire is decoration. */
  alt: string;
  /** `auto`: a still fire where the visitor wants less motion. */
  reducedMotion: 'auto' | 'ignore';
  /** Where the JSON file of its settings is; empty where there is none. */
  src: string;
  /** When it is made: in sight at once and elsewhere when the page has loaded; when it comes into sight; at once. */
  loading: 'auto' | 'lazy' | 'eager';
  /** A picture that is shown until it burns, and where it cannot. */
  poster: string;
  /** Most pixels of its picture, from 1024 to 16777216; empty: those of a 720p, 1080p or 1440p screen, by quality. */
  get maxPixels(): string;
  set maxPixels(pixels: number | string);
  /** Most pictures a second, from 10 to 240; empty: as many as the display shows. */
  get fpsLimit(): string;
  set fpsLimit(fps: number | string);
  /** Seconds of fire that a new fire burns before it is shown. */
  get warm(): number;
  set warm(seconds: number | boolean | string);
  /** Whether a pointer stirs it, throws sparks and moves its source. */
  interactive: boolean;
  /** How its domain fits the picture: as high, all of it seen, nothing else seen, as wide. */
  fit: 'height' | 'contain' | 'cover' | 'width';
  /** Where the domain stands in the picture, as CSS's `object-position`: `left`, `center` or `right`, `top`, `center` or `bottom`; empty: `center bottom`. */
  align: string;
  /** What a finger on an interactive fire may do with the page, as CSS has it. */
  touchAction: string;
  /** Whether it has its panel of sliders, or for which parameters. */
  get controls(): boolean | string;
  set controls(parameters: boolean | string);

  get<Id extends ParameterId>(id: Id): HearthParameters[Id];
  /** Sets one parameter; rejects with a {@link HearthRangeError}. */
  set<Id extends ParameterId>(id: Id, value: HearthParameters[Id]): Promise<void>;
  /** Sets all of these or none; rejects with a {@link HearthRangeError}. */
  set(values: Partial<HearthParameters>): Promise<void>;
  /**
   * Moves these to values, all or none; rejects with a {@link HearthRangeError}. Whether all
   * arrived: false where something else set one meanwhile.
   */
  to(values: Partial<HearthParameters>, how?: HearthTransition): Promise<boolean>;
  /** Puts these, or all, back to their defaults; all: the model as well, and without a preset. */
  restore(...ids: ParameterId[]): Promise<void>;
  play(): Promise<void>;
  pause(): Promise<void>;
  /** Starts again from nothing, with the same values. */
  reset(): Promise<void>;
  /** Makes some steps, burning or not, then draws. */
  step(steps?: number): Promise<void>;
  /** Its settings, to be kept or sent. */
  exportConfig(): Promise<HearthConfig>;
  /** Burns with these settings, or with nothing of them; rejects with a {@link HearthRangeError}. */
  importConfig(config: HearthConfig | string): Promise<void>;
  /** What is seen of it, as a file; PNG, if nothing else is said. */
  toBlob(type?: string, quality?: number): Promise<Blob>;
  /** The fire as a stream of video. */
  captureStream(fps?: number): Promise<MediaStream>;
  /** Puts it out and frees all that it holds; it burns again when it is put on a page anew. */
  destroy(): Promise<void>;
  /** Carries the gas around a place [m] along as fast as that, at most 20 m/s each way; rejects with a {@link HearthRangeError}. */
  stir(x: number, y: number, u: number, v: number): Promise<void>;
  /** Throws 1 to 200 sparks from a place [m], 24 if nothing is said; rejects with a {@link HearthRangeError}. The classic model has none. */
  sparks(x: number, y: number, count?: number): Promise<void>;
  /**
   * The place [m] that a point [CSS pixels from the element's upper left corner]
   * shows: from the middle of the floor, y up. Null while there is no picture.
   */
  toMetres(x: number, y: number): HearthPoint | null;
  /** Where a place [m] is shown [CSS pixels]: the inverse of `toMetres`. */
  toPixels(x: number, y: number): HearthPoint | null;

  addEventListener<Type extends keyof HearthFireEventMap>(
    type: Type,
    listener: (this: HearthFire, event: HearthFireEventMap[Type]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<Type extends keyof HearthFireEventMap>(
    type: Type,
    listener: (this: HearthFire, event: HearthFireEventMap[Type]) => unknown,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}

declare global {
  interface HTMLElementTagNameMap {
    'hearth-fire': HearthFire;
  }
}
