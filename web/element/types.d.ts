/** The types of the values of `<hearth-fire>`. */

import type { HearthFire } from '../hearth-fire.js';
import type { HearthObject, HearthParameters, HearthStats, ParameterId, PresetName } from '../parameters.js';

declare global {
  interface HTMLElementTagNameMap {
    'hearth-fire': HearthFire;
    'hearth-source': HearthSourceElement;
    'hearth-solid': HearthSolidElement;
  }
}

/** The own events of a fire. */
export interface HearthFireEvents {
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

/** The events of a fire. */
export interface HearthFireEventMap extends Omit<HTMLElementEventMap, keyof HearthFireEvents>, HearthFireEvents {}

/** The methods for the events of a target. */
export interface HearthListeners<Events> {
  addEventListener<Type extends keyof Events>(
    type: Type,
    listener: (this: this, event: Events[Type]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<Type extends keyof Events>(
    type: Type,
    listener: (this: this, event: Events[Type]) => unknown,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}

/** The level of detail of simulation and picture. */
export type HearthQuality = 'low' | 'medium' | 'high';

/**
 * The settings of a fire, which `exportConfig` returns and `importConfig` and `src` apply: the values that
 * differ from a preset, or from the defaults.
 */
export interface HearthConfig {
  /** The version of the format. */
  hearth?: 3;
  /** The preset, unless it is the default one. */
  preset?: PresetName;
  values: Partial<HearthParameters>;
  /** The objects, unless they are the preset's, each with the properties that differ from the defaults. */
  objects?: HearthObject[];
  /** A title, a description, an author and a licence for people; the fire ignores them. */
  label?: string;
  description?: string;
  author?: string;
  licence?: string;
}

/** How `toBlob` makes a picture. */
export interface HearthPicture {
  /** `image/png`, `image/jpeg` or `image/webp`; PNG without it. */
  type?: string;
  /** Of JPEG and WebP, from 0 to 1. */
  quality?: number;
  /** Its width [pixels], from 16 to 8192; the height follows from the element. Without it, that of the frame. */
  width?: number;
  /** What is behind fire and solids: a CSS colour, `transparent`, or `scene`, as the element shows them. */
  background?: string;
}

/** How far a film is. */
export interface HearthFilmProgress {
  /** Number of pictures so far, those in which the beginning of a loop is looked for included. */
  frame: number;
  /** Number of all pictures. */
  frames: number;
  /** Size of the file so far [B]. */
  bytes: number;
}

/** A film: see `record`. */
export interface HearthFilm {
  /**
   * `webp`, or `apng` where the browser encodes no WebP, without it. `zip` has PNG files, `png` is the first picture alone,
   * `sheet` has all pictures as tiles of one, and a description of them, `wav` the sound alone. `mp4` has no alpha and needs a
   * `background` or `stackedAlpha`.
   */
  format?: 'webp' | 'apng' | 'gif' | 'webm' | 'mp4' | 'zip' | 'png' | 'sheet' | 'wav';
  /** Length [s], up to 600, of a loop from 1 to 10; 5 without it. */
  seconds?: number;
  /** Pictures per second: 24, 25, 30, 50 or 60, of a GIF 20, 25, 33.33 or 50; 30 without it, of a GIF 25. */
  fps?: number;
  /** Width and height [pixels], from 16 to 4096; of `webm` and `mp4` even. Without both, those of the picture that is shown. */
  width?: number;
  height?: number;
  /** Seconds that pass before the first picture; 0 without it. */
  from?: number;
  /** Whether the end goes over into the beginning, which then is within the next four seconds. */
  loop?: boolean;
  /** Whether `webm` and `mp4` have the sound of the fire. */
  sound?: boolean;
  /** What is behind fire and solids: `scene`, as the element shows them, `transparent`, or a colour such as `#101018`. */
  background?: string;
  /** Whether an `mp4` is twice as high, with alpha as a grey in its lower half. */
  stackedAlpha?: boolean;
  /** Whether colours of a `sheet` are multiplied by alpha; without it, those of the edge go on where nothing is seen. */
  premultiplied?: boolean;
  /** Whether scene and seed are in the file, as a text that is a settings file; all formats but `wav` have a place for it. */
  describe?: boolean;
  /** Takes the file, which then is not kept in memory. It is closed at the end; a film that fails leaves nothing in it. */
  stream?: FileSystemWritableFileStream;
  /** Cancels the film. */
  signal?: AbortSignal;
  /** Is called after each picture. */
  onprogress?: (progress: HearthFilmProgress) => void;
}

/** A solid that forces move, one with `motion` "free", as it is now. */
export interface HearthFreeSolid {
  /** Its id, as in `objects`; above 1,000,000 that of a part that has broken off. */
  id: number;
  /** Its place [m], as that of a solid in `objects`. */
  x: number;
  y: number;
  /** Its angle from -180 to 180 [°]. */
  angle: number;
  /** Velocity of its centre of mass to the right [m/s]. */
  u: number;
  /** The same upwards [m/s]. */
  v: number;
  /** Angular velocity, counterclockwise [1/s]. */
  spin: number;
  /** Mass for each metre of depth [kg/m]; 0 of one of which nothing is left. */
  mass: number;
  /** Whether it rests until something moves it. */
  asleep: boolean;
  /** The id of the object that it is, or that it was a part of. */
  object: number;
}

/** What a probe measures at a place. What the model does not have is absent. */
export interface HearthProbe {
  /** Height of the place [m]. */
  y: number;
  /** Whether there is gas. Without any, as in a solid, all that follows is absent. */
  gas: boolean;
  /** Whether the place is in a solid. */
  solid: boolean;
  /** Temperature [K]. */
  temperature?: number;
  /** Velocity to the right [m/s]. */
  u?: number;
  /** Velocity upwards [m/s]. */
  v?: number;
  /** Density [kg/m³]. */
  density?: number;
  /** Fuel, as a share of the gas; of the combustion model. */
  fuel?: number;
  /** Oxygen, as a share of that of fresh air; of the combustion model. */
  oxygen?: number;
  /** Soot, in the amount that a full share of fuel leaves; of the combustion model. */
  soot?: number;
}

/** What is measured of a fire at one time. */
export interface HearthMeasures {
  /** Age of the fire [s]. */
  time: number;
  /**
   * Power of the combustion in the last step [kW/m]; absent in the classic model. `stats.power` is its moving average.
   */
  power?: number;
  /** From the lowest to the highest gas that is hotter than 900 K [m]. */
  flameHeight: number;
  /**
   * Light of that gas: its area [m²] if it had 1500 K and a full share's soot or, in the classic model, all of its
   * life.
   */
  luminosity: number;
  /** At the place. */
  place: HearthProbe;
  /** At 64 heights of the vertical through the place, from the floor to the top of the domain. */
  profile: HearthProbe[];
}

/** A point: of the element in CSS pixels with y downwards, or of the domain in metres with y upwards. */
export interface HearthPoint {
  x: number;
  y: number;
}

/** The error for a refused value. The other values of the same call are refused as well. */
export interface HearthRangeError extends RangeError {
  id: string;
  value: unknown;
  min?: number;
  max?: number;
}

/** The detail of an `error` event. */
export type HearthErrorDetail =
  | {
      kind: 'unsupported' | 'load' | 'context-lost' | 'stopped';
      message: string;
      /** The version of Hearth. */
      version: string;
      seed: number;
      /** URL parameters, with which the page of Hearth shows the same fire. */
      settings: string;
    }
  | {
      kind: 'bad-parameter';
      message: string;
      id: string;
      value: unknown;
      min?: number;
      max?: number;
    };

/**
 * The history of a fire. A step is what a visitor does at once; changes of the page besides are no steps, and undoing a
 * step keeps them.
 */
export interface HearthHistory {
  /** Whether there is a step to undo. */
  readonly canUndo: boolean;
  /** Whether there is a step to redo. */
  readonly canRedo: boolean;
  /** All present settings, without waiting for the fire: `importConfig` applies them, on another page too. */
  readonly settings: HearthConfig;
  /**
   * Runs a function and returns what it returns. The changes that it calls for before it returns or waits are a step;
   * with the key of the last step, they belong to that. Steps in a step belong to the outer one.
   */
  step<T>(act: () => T, key?: string): T;
  /** Undoes the last step. Resolves to false without one. */
  undo(): Promise<boolean>;
  /** Redoes the step that was undone last. Resolves to false without one. */
  redo(): Promise<boolean>;
}

/** The detail of `history-change`. */
export interface HearthHistoryDetail {
  /** Whether a step was made, undone or redone. */
  type: 'step' | 'undo' | 'redo';
  /** Its key. */
  key: string;
}

/** `<hearth-source>`: a child of `<hearth-fire>` that is a source of its fire. */
export interface HearthSourceElement extends HTMLElement {
  /** The id of its object in `objects`; null while the fire has none. */
  readonly objectId: number | null;
}

/** `<hearth-solid>`: a child of `<hearth-fire>` that is a solid in its fire. */
export interface HearthSolidElement extends HTMLElement {
  /** The id of its object in `objects`; null while the fire has none. */
  readonly objectId: number | null;
}

/** The options of `to`. */
export interface HearthTransition {
  /** In milliseconds; the default is 600. */
  duration?: number;
  /** An easing of CSS; the default is `ease-in-out`. */
  easing?: string;
}

/** The detail of a `params-change` event. */
export interface HearthChangeDetail {
  id: ParameterId;
  value: number | string | boolean;
  /** The origin of the change, such as `attribute`, `property`, `preset`, `src` or `to`. */
  source: string;
}

/** The detail of an `objects-change` event. */
export interface HearthObjectsDetail {
  objects: HearthObject[];
  /** The origin of the change, such as `attribute`, `child`, `property`, `preset` or `src`. */
  source: string;
}

/** The detail of a `quality-change` event. */
export interface HearthQualityDetail {
  quality: HearthQuality;
  /** The reason, for people. */
  reason: string;
}

/** The detail of a `sound-change` event. */
export interface HearthSoundDetail {
  /** `waiting`: the browser refuses to start sound until the visitor clicks, taps or presses a key. */
  state: 'silent' | 'waiting' | 'playing';
}

/**
 * The properties that reflect an attribute of the same name with hyphens. `element/attributes/attributes.js` defines
 * them on the prototype.
 */
export interface HearthReflected {
  /**
   * The URL of a JSON file with settings, as `exportConfig()` returns them; empty without one. A fire begins
   * without a file that takes longer than two seconds, and takes it over when it arrives.
   */
  src: string;
  /**
   * When the fire is loaded: `auto`, at once if it is visible, else when the page has loaded; `lazy`, when
   * it comes near the window; `eager`, at once.
   * @default auto
   */
  loading: 'auto' | 'lazy' | 'eager';
  /** The URL of an image that is shown until the fire burns, and in browsers that cannot show it. */
  poster: string;
  /** The description for screen readers; without one the fire is decoration. */
  alt: string;
  /**
   * The maximum number of pixels of the picture, from 1024 to 16777216; if empty, that of a 720p, 1080p or
   * 1440p screen, by quality.
   */
  get maxPixels(): string;
  set maxPixels(pixels: number | string);
  /** The maximum frames per second, from 10 to 240; if empty, those of the display. */
  get fpsLimit(): string;
  set fpsLimit(fps: number | string);
  /**
   * Simulated seconds, 0 to 30, before the first frame of a new fire; 3 if the attribute has no value. The
   * poster or the last frame stays meanwhile.
   */
  get warm(): number | false;
  set warm(seconds: number | boolean | string);
  /**
   * The fire reacts to pointers: they stir it, a click emits sparks, a drag moves its source. Otherwise
   * clicks pass through it.
   * @default false
   */
  interactive: boolean;
  /**
   * The fire is decoration alone: visitors who prefer reduced motion get a still picture without a play button.
   * @default false
   */
  decorative: boolean;
  /**
   * How the domain fits the picture: `height` and `width` match that side, `contain` shows the whole
   * domain, `cover` fills the picture with it.
   * @default height
   */
  fit: 'height' | 'contain' | 'cover' | 'width';
  /**
   * Where the domain lies in the picture, in the keywords of CSS's `object-position`: `left`, `center` or
   * `right`, and `top`, `center` or `bottom`. The default is `center bottom`.
   */
  align: string;
  /**
   * How much the picture is enlarged, from 1 to 10. It changes the view, not the fire. Gestures of an
   * interactive fire change it too.
   * @default 1
   */
  zoom: number;
  /**
   * Which part of the enlarged picture is seen: two numbers from 0 to 1, its position from the left and
   * from below. The default is `0.5 0.5`, the middle.
   */
  pan: string;
  /**
   * The volume of the fire's sound, from 0 to 1; 0 is silent. It begins with the visitor's first click, tap or key on
   * the page. Its code is loaded on request.
   * @default 0
   */
  sound: number;
  /**
   * How loud the fire roars, from 0 to 2. At 1, the balance of roar, crackle and hiss is that of recorded fires.
   * @default 1
   */
  roar: number;
  /**
   * How loud the fire crackles, from 0 to 2.
   * @default 1
   */
  crackle: number;
  /**
   * How loud the fire hisses, from 0 to 2.
   * @default 1
   */
  hiss: number;
  /** What touches of an interactive fire do to the page, as CSS's `touch-action`. The default is `pan-y`. */
  touchAction: string;
  /**
   * Shows the panel of sliders inside the element, for all parameters or for a list of them. Its code is
   * loaded on request.
   * @default false
   */
  controls: boolean | string;
  /**
   * `auto`: visitors who prefer reduced motion get a paused fire with a play button.
   * @default auto
   */
  reducedMotion: 'auto' | 'ignore';
}
