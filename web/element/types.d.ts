/**
 * The types of what `<hearth-fire>` takes and gives. The class itself is typed by the JSDoc of
 * `hearth-fire.js`, from which `cargo xtask codegen` makes `hearth-fire.d.ts`.
 */

import type { HearthObject, HearthParameters, ParameterId, PresetName } from '../parameters.js';

/** How much work a fire makes itself. */
export type HearthQuality = 'low' | 'medium' | 'high';

/**
 * The settings of a fire, as `exportConfig` gives them and `importConfig` and `src`
 * take them: what differs from a preset, or from the defaults.
 */
export interface HearthConfig {
  /** The version of this form. */
  hearth?: 1 | 2;
  /** The preset, where it is not the default one. */
  preset?: PresetName;
  values: Partial<HearthParameters>;
  /** Its objects, where they are not those of the preset: of the first source what differs. */
  objects?: HearthObject[];
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

/** What an `objects-change` event tells. */
export interface HearthObjectsDetail {
  objects: HearthObject[];
  /** Who changed them, as `attribute`, `property`, `preset` or `src`. */
  source: string;
}

/** What a `quality-change` event tells. */
export interface HearthQualityDetail {
  quality: HearthQuality;
  /** Why, in words. */
  reason: string;
}

/**
 * The properties that live in an attribute: each in the one of its name with hyphens.
 * `element/attributes.js` defines them on the prototype.
 */
export interface HearthReflected {
  /** The address of a JSON file with settings, as `exportConfig()` gives them; empty: none. */
  src: string;
  /**
   * When the fire is loaded: `auto`, in sight at once and elsewhere when the page has loaded;
   * `lazy`, when it comes near the window; `eager`, at once.
   * @default auto
   */
  loading: 'auto' | 'lazy' | 'eager';
  /** The address of a picture that is shown until the fire burns, and where it cannot. */
  poster: string;
  /** What a screen reader says of the fire; without it the fire is decoration. */
  alt: string;
  /**
   * Most pixels that the picture may have, from 1024 to 16777216; empty: those of a 720p, 1080p or
   * 1440p screen, by quality.
   */
  get maxPixels(): string;
  set maxPixels(pixels: number | string);
  /** Most pictures a second, from 10 to 240; empty: as many as the display shows. */
  get fpsLimit(): string;
  set fpsLimit(fps: number | string);
  /**
   * Seconds of fire, 0 to 30, that a new fire burns before it is shown: 3 where the attribute has no
   * value. The poster or the picture before stays meanwhile.
   */
  get warm(): number;
  set warm(seconds: number | boolean | string);
  /**
   * The fire takes pointers: they stir it, a click throws sparks, a drag moves its source. Without
   * this clicks go through it.
   * @default false
   */
  interactive: boolean;
  /**
   * How the fire's domain fits the picture: as high as it, all of it seen, nothing else seen, or as
   * wide as it.
   * @default height
   */
  fit: 'height' | 'contain' | 'cover' | 'width';
  /**
   * Where the domain stands in the picture, as CSS's `object-position`: `left`, `center` or `right`,
   * `top`, `center` or `bottom`; without it `center bottom`.
   */
  align: string;
  /** What fingers do on an interactive fire, as CSS's `touch-action`; without it `pan-y`. */
  touchAction: string;
  /**
   * Shows the panel of sliders inside the element, or those of a list of parameters; its code is
   * loaded only then.
   * @default false
   */
  controls: boolean | string;
  /**
   * `auto`: a still fire with a play button where the visitor wants less motion.
   * @default auto
   */
  reducedMotion: 'auto' | 'ignore';
}
