// Generated from the class in web/hearth-fire.js, its types and the table of parameters by
// `cargo xtask codegen`; edit the JSDoc of the class or web/element/types.d.ts instead.

import type {
  HearthChangeDetail,
  HearthConfig,
  HearthErrorDetail,
  HearthObjectsDetail,
  HearthPoint,
  HearthQuality,
  HearthQualityDetail,
  HearthTransition,
} from './element/types.js';
import type {
  HearthObject,
  HearthParameters,
  HearthProperties,
  HearthStats,
  ParameterId,
  PresetName,
} from './parameters.js';

export type * from './element/types.js';
export type * from './parameters.js';

/** The events of a fire. */
export interface HearthFireEventMap extends Omit<HTMLElementEventMap, 'error'> {
  /** The fire burns. */
  ready: CustomEvent<null>;
  /** It burns again. */
  play: CustomEvent<null>;
  /** It stands still. */
  pause: CustomEvent<null>;
  /** A value changed, whoever changed it. */
  'params-change': CustomEvent<HearthChangeDetail>;
  /** An object was added, changed or removed. */
  'objects-change': CustomEvent<HearthObjectsDetail>;
  /** The fire makes itself more or less work than before. */
  'quality-change': CustomEvent<HearthQualityDetail>;
  /** What the fire says about itself, about four times a second. */
  stats: CustomEvent<HearthStats>;
  /** Something is wrong: a value that was refused, a file that did not arrive, a browser that cannot. */
  error: CustomEvent<HearthErrorDetail>;
  /** The graphics context was lost and is back. */
  restored: CustomEvent<null>;
}

/** Every parameter is a property as well; a value out of range is refused aloud and changes nothing. */
export interface HearthFire extends HearthProperties {}

/** The class of `<hearth-fire>`. A fire, simulated by smoothed particle hydrodynamics. */
export class HearthFire extends HTMLElement {
  /** Where the wasm file is, if it is not at `wasm/hearth-engine_bg.wasm` beside this module. Set it before the first fire. */
  static wasmUrl: string | URL | undefined;
  /** Where the engine runs; `auto`: in a worker where that can draw, else on the main thread. Set it before the first fire. */
  static engine: 'auto' | 'worker' | 'main';
  /** The named set of values that the fire starts from. Changed later, it replaces every value. */
  preset: PresetName;
  /** Every value that the fire burns with, by id. */
  readonly params: HearthParameters;
  /** The objects of the fire: copies, each with its kind, its id and its properties. Setting them replaces all. The attribute has them as JSON; without it the fire has one source, which the parameters describe. */
  objects: Required<HearthObject>[];
  /** What the fire last said about itself; null before it did. */
  readonly stats: HearthStats | null;
  /** How much work the fire may make itself; `auto`: as much as fits. */
  quality: 'auto' | HearthQuality;
  /** Resolves when the fire burns; rejects where it cannot. An element that was taken off the page has a new one. */
  readonly ready: Promise<void>;
  /** Whether the fire stands still. */
  paused: boolean;
  /** `false`: the fire stands still until `play()`. */
  autoplay: boolean;
  /** The address of a JSON file with settings, as `exportConfig()` gives them; empty: none. */
  src: string;
  /** When the fire is loaded: `auto`, in sight at once and elsewhere when the page has loaded; `lazy`, when it comes near the window; `eager`, at once. */
  loading: 'auto' | 'lazy' | 'eager';
  /** The address of a picture that is shown until the fire burns, and where it cannot. */
  poster: string;
  /** What a screen reader says of the fire; without it the fire is decoration. */
  alt: string;
  /** Most pixels that the picture may have, from 1024 to 16777216; empty: those of a 720p, 1080p or 1440p screen, by quality. */
  get maxPixels(): string;
  set maxPixels(value: number | string);
  /** Most pictures a second, from 10 to 240; empty: as many as the display shows. */
  get fpsLimit(): string;
  set fpsLimit(value: number | string);
  /** Seconds of fire, 0 to 30, that a new fire burns before it is shown: 3 where the attribute has no value. The poster or the picture before stays meanwhile. */
  get warm(): number;
  set warm(value: number | boolean | string);
  /** The fire takes pointers: they stir it, a click throws sparks, a drag moves its source. Without this clicks go through it. */
  interactive: boolean;
  /** How the fire's domain fits the picture: as high as it, all of it seen, nothing else seen, or as wide as it. */
  fit: 'height' | 'contain' | 'cover' | 'width';
  /** Where the domain stands in the picture, as CSS's `object-position`: `left`, `center` or `right`, `top`, `center` or `bottom`; without it `center bottom`. */
  align: string;
  /** What fingers do on an interactive fire, as CSS's `touch-action`; without it `pan-y`. */
  touchAction: string;
  /** Shows the panel of sliders inside the element, or those of a list of parameters; its code is loaded only then. */
  controls: boolean | string;
  /** `auto`: a still fire with a play button where the visitor wants less motion. */
  reducedMotion: 'auto' | 'ignore';
  /** The value of one parameter. */
  get<Id extends ParameterId>(id: Id): HearthParameters[Id];
  /** Sets one parameter; rejects with a {@link HearthRangeError}. */
  set<Id extends ParameterId>(id: Id, value: HearthParameters[Id]): Promise<void>;
  /** Sets all of these or none; rejects with a {@link HearthRangeError}. */
  set(values: Partial<HearthParameters> & {objects?: HearthObject[]}): Promise<void>;
  /** Adds an object and resolves to its id. Rejects with a {@link HearthRangeError}. */
  addObject(object: HearthObject): Promise<number>;
  /** Sets properties of an object: all of them or none. Rejects with a {@link HearthRangeError}. */
  changeObject(id: number, properties: Partial<HearthObject>): Promise<void>;
  /** Removes an object. The next source becomes the first, which the parameters describe. Rejects with a {@link HearthRangeError}. */
  removeObject(id: number): Promise<void>;
  /** Moves parameters to values, all of them or none; whether they arrived: false where something else set one meanwhile. Rejects as `set` does. */
  to(values: Partial<HearthParameters>, how?: HearthTransition): Promise<boolean>;
  /** Puts these parameters, or all, back to their defaults; all: the model as well, and without a preset. */
  restore(...ids: (ParameterId | 'objects')[]): Promise<void>;
  /** Lets the fire burn. */
  play(): Promise<void>;
  /** Lets the fire stand still. */
  pause(): Promise<void>;
  /** Starts again from nothing, with the same values. */
  reset(): Promise<void>;
  /** Makes some steps, burning or not, then draws. */
  step(steps?: number): Promise<void>;
  /** Its settings: the preset, where that is not the default one, and what differs from it. JSON of them can be kept, sent, and given to `importConfig` or `src`. */
  exportConfig(): Promise<HearthConfig>;
  /** Burns with these settings, or with those of this JSON: all of them or none. Rejects with a {@link HearthRangeError}. */
  importConfig(config: HearthConfig | string): Promise<void>;
  /**
   * What is seen of the fire now, as a file of that type: PNG, `image/jpeg` or `image/webp`.
   * @param quality of JPEG and WebP, from 0 to 1
   */
  toBlob(type?: string, quality?: number): Promise<Blob>;
  /**
   * The fire as a stream of video, for a recorder, a call or a `<video>`.
   * @param fps most pictures a second; without it, all
   */
  captureStream(fps?: number): Promise<MediaStream>;
  /** Puts the fire out and frees all that it holds. It burns again when the element is put on a page anew. */
  destroy(): Promise<void>;
  /**
   * Carries the gas around a place along, for a twentieth of a second.
   * @param x metres from the middle
   * @param y metres above the floor
   * @param u metres a second to the right, at most 20
   * @param v metres a second up, at most 20
   */
  stir(x: number, y: number, u: number, v: number): Promise<void>;
  /**
   * Throws sparks from a place; the classic model has none.
   * @param x metres from the middle
   * @param y metres above the floor
   * @param count from 1 to 200
   */
  sparks(x: number, y: number, count?: number): Promise<void>;
  /**
   * The place of the fire's world that a point of the element shows: in metres, from the middle of the floor, y up. Null while there is no picture.
   * @param x CSS pixels from the element's left edge
   * @param y CSS pixels from its upper edge
   */
  toMetres(x: number, y: number): HearthPoint | null;
  /**
   * Where a place of the fire's world is shown, in CSS pixels from the element's upper left corner: the inverse of `toMetres`.
   * @param x metres from the middle
   * @param y metres above the floor
   */
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
