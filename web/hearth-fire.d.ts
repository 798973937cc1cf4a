// Generated from the class in web/hearth-fire.js, its types and the table of parameters by
// `cargo xtask codegen`; edit the JSDoc of the class or web/element/types.d.ts instead.

import type {
  HearthChangeDetail,
  HearthConfig,
  HearthErrorDetail,
  HearthFreeSolid,
  HearthHistory,
  HearthHistoryDetail,
  HearthMeasures,
  HearthObjectsDetail,
  HearthPicture,
  HearthPoint,
  HearthQuality,
  HearthQualityDetail,
  HearthRangeError,
  HearthSolidElement,
  HearthSoundDetail,
  HearthSourceElement,
  HearthTransition,
} from './element/types.js';
import type {
  HearthObject,
  HearthParameters,
  HearthProperties,
  HearthStats,
  HearthValues,
  ParameterId,
  PresetName,
} from './parameters.js';

export type * from './element/types.js';
export type * from './parameters.js';

/** The events of a fire. */
export interface HearthFireEventMap extends Omit<HTMLElementEventMap, 'error'> {
  /** The fire is shown or, out of sight, can be drawn. */
  ready: CustomEvent<null>;
  /** The fire plays again. */
  play: CustomEvent<null>;
  /** The fire is paused. */
  pause: CustomEvent<null>;
  /** A parameter has changed, from any source. */
  'params-change': CustomEvent<HearthChangeDetail>;
  /** An object was added, changed or removed. */
  'objects-change': CustomEvent<HearthObjectsDetail>;
  /** A step was made, undone or redone. */
  'history-change': CustomEvent<HearthHistoryDetail>;
  /** The quality has changed, to fit the speed of the device or on request. */
  'quality-change': CustomEvent<HearthQualityDetail>;
  /** The sound plays, waits for a gesture of the visitor, or has ended. */
  'sound-change': CustomEvent<HearthSoundDetail>;
  /** Measurements of the fire, about four times a second. */
  stats: CustomEvent<HearthStats>;
  /** A value is refused, a file could not be loaded, the fire has stopped, or the browser cannot show it. */
  error: CustomEvent<HearthErrorDetail>;
  /** The fire is back after its graphics context was lost or its engine has stopped. */
  restored: CustomEvent<null>;
}

/** Every parameter is a property as well; a value out of range is refused aloud and changes nothing. */
export interface HearthFire extends HearthProperties {}

/** The class of `<hearth-fire>`. A fire, simulated by smoothed particle hydrodynamics. */
export class HearthFire extends HTMLElement {
  /** The version of this module. */
  static readonly version: string;
  /** The URL of the wasm file, if it is not `wasm/hearth-engine_bg.wasm` beside this module. Set it before the first fire. */
  static wasmUrl: string | URL | undefined;
  /** Where the engine runs; `auto`: in a worker if workers can draw, else on the main thread. Set it before the first fire. */
  static engine: 'auto' | 'worker' | 'main';
  /** The named set of values that the fire starts from. A later change replaces every value. */
  preset: PresetName;
  /** The values of all parameters, by id. */
  readonly params: HearthParameters;
  /** Copies of the objects of the fire, each with its kind, its id and its properties. Setting the list replaces all objects. The attribute holds them as JSON; without it the fire has one source, which the parameters describe. */
  objects: Required<HearthObject>[];
  /** The latest measurements of the fire; null before the first. */
  readonly stats: HearthStats | null;
  /** The level of detail of simulation and picture; `auto` follows the speed of the device. */
  quality: 'auto' | HearthQuality;
  /** Resolves when the fire's picture is shown or, out of sight, when the fire can be drawn; rejects if it cannot. An element that is removed from the page gets a new promise. */
  readonly ready: Promise<void>;
  /** Whether the fire is paused. */
  paused: boolean;
  /** Whether the visitor has muted the fires of this origin. It is kept for the next visit. */
  muted: boolean;
  /** The node through which the sound of this fire goes to the loudspeakers, for a mix of your own in its `context`; null while there is no sound. */
  readonly audio: AudioNode | null;
  /** The steps that can be undone and redone. */
  readonly history: HearthHistory;
  /** `false`: the fire is paused until `play()`. */
  autoplay: boolean;
  /** The URL of a JSON file with settings, as `exportConfig()` returns them; empty without one. A fire begins without a file that takes longer than two seconds, and takes it over when it arrives. */
  src: string;
  /** When the fire is loaded: `auto`, at once if it is visible, else when the page has loaded; `lazy`, when it comes near the window; `eager`, at once. */
  loading: 'auto' | 'lazy' | 'eager';
  /** The URL of an image that is shown until the fire burns, and in browsers that cannot show it. */
  poster: string;
  /** The description for screen readers; without one the fire is decoration. */
  alt: string;
  /** The maximum number of pixels of the picture, from 1024 to 16777216; if empty, that of a 720p, 1080p or 1440p screen, by quality. */
  get maxPixels(): string;
  set maxPixels(value: number | string);
  /** The maximum frames per second, from 10 to 240; if empty, those of the display. */
  get fpsLimit(): string;
  set fpsLimit(value: number | string);
  /** Simulated seconds, 0 to 30, before the first frame of a new fire; 3 if the attribute has no value. The poster or the last frame stays meanwhile. */
  get warm(): number | false;
  set warm(value: number | boolean | string);
  /** The fire reacts to pointers: they stir it, a click emits sparks, a drag moves its source. Otherwise clicks pass through it. */
  interactive: boolean;
  /** How the domain fits the picture: `height` and `width` match that side, `contain` shows the whole domain, `cover` fills the picture with it. */
  fit: 'height' | 'contain' | 'cover' | 'width';
  /** Where the domain lies in the picture, in the keywords of CSS's `object-position`: `left`, `center` or `right`, and `top`, `center` or `bottom`. The default is `center bottom`. */
  align: string;
  /** How much the picture is enlarged, from 1 to 10. It changes the view, not the fire. Gestures of an interactive fire change it too. */
  zoom: number;
  /** Which part of the enlarged picture is seen: two numbers from 0 to 1, its position from the left and from below. The default is `0.5 0.5`, the middle. */
  pan: string;
  /** The volume of the fire's sound, from 0 to 1; 0 is silent. It begins with the visitor's first click, tap or key on the page. Its code is loaded on request. */
  sound: number;
  /** How loud the fire roars, from 0 to 2. At 1, the balance of roar, crackle and hiss is that of recorded fires. */
  roar: number;
  /** How loud the fire crackles, from 0 to 2. */
  crackle: number;
  /** How loud the fire hisses, from 0 to 2. */
  hiss: number;
  /** What touches of an interactive fire do to the page, as CSS's `touch-action`. The default is `pan-y`. */
  touchAction: string;
  /** Shows the panel of sliders inside the element, for all parameters or for a list of them. Its code is loaded on request. */
  controls: boolean | string;
  /** `auto`: visitors who prefer reduced motion get a paused fire with a play button. */
  reducedMotion: 'auto' | 'ignore';
  /** Returns the value of one parameter. */
  get<Id extends ParameterId>(id: Id): HearthParameters[Id];
  /** Sets one parameter. Rejects with a {@link HearthRangeError}. */
  set<Id extends ParameterId>(id: Id, value: HearthParameters[Id] | null | undefined): Promise<void>;
  /** Sets all of these parameters or none. Rejects with a {@link HearthRangeError}. */
  set(values: HearthValues): Promise<void>;
  /** Adds an object and resolves to its id. Rejects with a {@link HearthRangeError}. */
  addObject(object: HearthObject): Promise<number>;
  /** Sets properties of an object: all of them or none. Rejects with a {@link HearthRangeError}. */
  changeObject(id: number, properties: Partial<HearthObject>): Promise<void>;
  /** Removes an object. The next source becomes the first, which the parameters describe. Rejects with a {@link HearthRangeError}. */
  removeObject(id: number): Promise<void>;
  /** Changes parameters gradually, all of them or none. Resolves to false if another call sets one of them meanwhile. Rejects as `set` does. */
  to(values: Partial<HearthParameters>, how?: HearthTransition): Promise<boolean>;
  /** Restores the defaults of these parameters. Without ids it restores all parameters, the model included, and removes the preset. */
  restore(...ids: (ParameterId | 'objects')[]): Promise<void>;
  /** Plays the fire. */
  play(): Promise<void>;
  /** Pauses the fire. */
  pause(): Promise<void>;
  /** Restarts the simulation with the same values. */
  reset(): Promise<void>;
  /** Computes simulation steps, also while paused, then draws a frame. `stats` has the length of a step. */
  step(steps?: number): Promise<void>;
  /** Resolves to the settings of the fire: the preset, unless it is the default one, and the values that differ from it. As JSON they can be stored, sent, and loaded by `importConfig` or `src`. */
  exportConfig(): Promise<HearthConfig>;
  /** Applies settings, as an object or as JSON: all of them or none. Rejects with a {@link HearthRangeError}. */
  importConfig(config: HearthConfig | string): Promise<void>;
  /**
   * Resolves to the current frame as a file of type `image/png`, which keeps transparency, `image/jpeg` or `image/webp`. Waits for the first frame. An object `{type, quality, width, background}` draws the frame for the file: `width` from 16 to 8192 pixels, with the element's shape and at most 16,777,216 pixels in all; `background` is a CSS colour, `transparent` (fire and solids alone) or `scene` (as the element shows it). A refused width rejects with a `RangeError`.
   * @param quality of JPEG and WebP, from 0 to 1
   */
  toBlob(type?: string | HearthPicture, quality?: number): Promise<Blob>;
  /**
   * Resolves to the fire as a video stream for a recorder, a call or a `<video>`, with its sound if that is on.
   * @param fps maximum frames per second; all frames without it
   */
  captureStream(fps?: number): Promise<MediaStream>;
  /**
   * Accelerates the gas around a point for a twentieth of a second.
   * @param x metres from the middle of the floor
   * @param y metres above the floor
   * @param u velocity to the right in metres per second, at most 20
   * @param v velocity upwards in metres per second, at most 20
   */
  stir(x: number, y: number, u: number, v: number): Promise<void>;
  /**
   * Emits sparks from a point. The classic model has none.
   * @param x metres from the middle of the floor
   * @param y metres above the floor
   * @param count from 1 to 200
   */
  sparks(x: number, y: number, count?: number): Promise<void>;
  /**
   * Sprays water from a point within a twentieth of a second. It cools the gas, wets what it strikes and puts out what it cools and wets enough; the rest dries and burns on. The classic model has none.
   * @param x metres from the middle of the floor
   * @param y metres above the floor
   * @param u velocity to the right in metres per second, at most 20
   * @param v velocity upwards in metres per second, at most 20
   * @param grams for each metre of depth, at most 1000
   */
  spray(x: number, y: number, u?: number, v?: number, grams?: number): Promise<void>;
  /** Resolves to where the solids are that forces move, those with `motion` "free", in the order of the objects, then what has broken off them. `objects` has where they start. */
  freeSolids(): Promise<HearthFreeSolid[]>;
  /**
   * Resolves to what a probe at a point measures, the same along the vertical through it, and the flame as a whole.
   * @param x metres from the middle of the floor
   * @param y metres above the floor
   */
  measure(x: number, y: number): Promise<HearthMeasures>;
  /**
   * Lights a solid that has fuel: all of its surface, by its id, or what is within 0.1 m of a point. Dries the sources there too, so that those that water has put out burn again. Rejects if there is neither.
   * @param place the id, or metres from the middle of the floor
   * @param y metres above the floor
   */
  ignite(place: number, y?: number): Promise<void>;
  /**
   * Puts out a solid that has fuel, by its id, or all that is within a radius of a point: cools it and the gas there.
   * @param place the id, or metres from the middle of the floor
   * @param y metres above the floor
   * @param radius in metres, 0.2 without it
   */
  extinguish(place: number, y?: number, radius?: number): Promise<void>;
  /**
   * Converts a point of the element to the domain: metres from the middle of the floor, y upwards. Returns null while there is no picture.
   * @param x CSS pixels from the element's left edge
   * @param y CSS pixels from its upper edge
   */
  toMetres(x: number, y: number): HearthPoint | null;
  /**
   * Converts a point of the domain to CSS pixels from the element's upper left corner: the inverse of `toMetres`.
   * @param x metres from the middle of the floor
   * @param y metres above the floor
   */
  toPixels(x: number, y: number): HearthPoint | null;
  /** Stops the fire and frees its memory. The element makes a new fire when it is inserted into a page again; calls wait for that. */
  destroy(): Promise<void>;
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
    'hearth-source': HearthSourceElement;
    'hearth-solid': HearthSolidElement;
  }
}
