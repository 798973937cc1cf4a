/**
 * The types of a fire in an iframe: see `embed-client.js`.
 */

import type {
  HearthChangeDetail,
  HearthConfig,
  HearthErrorDetail,
  HearthFreeSolid,
  HearthMeasures,
  HearthObject,
  HearthObjectsDetail,
  HearthParameters,
  HearthPicture,
  HearthQualityDetail,
  HearthStats,
  ParameterId,
} from './hearth-fire.js';

/** The element's own attributes that `option` reads and sets. */
export type FrameOption =
  | 'align'
  | 'alt'
  | 'autoplay'
  | 'controls'
  | 'fit'
  | 'fps-limit'
  | 'interactive'
  | 'loading'
  | 'max-pixels'
  | 'objects'
  | 'pan'
  | 'paused'
  | 'quality'
  | 'reduced-motion'
  | 'touch-action'
  | 'warm'
  | 'zoom';

/** The events of an embedded fire. */
export interface FrameFireEventMap {
  ready: CustomEvent<null>;
  play: CustomEvent<null>;
  pause: CustomEvent<null>;
  'params-change': CustomEvent<HearthChangeDetail>;
  'objects-change': CustomEvent<HearthObjectsDetail>;
  'quality-change': CustomEvent<HearthQualityDetail>;
  stats: CustomEvent<HearthStats>;
  error: CustomEvent<HearthErrorDetail>;
  restored: CustomEvent<null>;
}

/**
 * A fire in an iframe. Requests wait until its page has loaded, and reject if the page does not answer.
 */
export interface FrameFire extends EventTarget {
  /** Resolves when the fire burns; rejects if it cannot. */
  ready(): Promise<void>;
  play(): Promise<void>;
  pause(): Promise<void>;
  /** Restarts the simulation with the same values. */
  reset(): Promise<void>;
  step(steps?: number): Promise<void>;
  set<Id extends ParameterId>(id: Id, value: HearthParameters[Id]): Promise<void>;
  /** Sets all of these parameters or none. */
  set(values: Partial<HearthParameters> & { objects?: HearthObject[] }): Promise<void>;
  get<Id extends ParameterId>(id: Id): Promise<HearthParameters[Id]>;
  params(): Promise<HearthParameters>;
  objects(): Promise<Required<HearthObject>[]>;
  /** Adds an object and resolves to its id. */
  addObject(object: HearthObject): Promise<number>;
  /** Sets properties of an object: all of them or none. */
  changeObject(id: number, properties: Partial<HearthObject>): Promise<void>;
  removeObject(id: number): Promise<void>;
  stats(): Promise<HearthStats | null>;
  restore(...ids: (ParameterId | 'objects')[]): Promise<void>;
  exportConfig(): Promise<HearthConfig>;
  importConfig(config: HearthConfig | string): Promise<void>;
  toBlob(type?: string | HearthPicture, quality?: number): Promise<Blob>;
  stir(x: number, y: number, u: number, v: number): Promise<void>;
  sparks(x: number, y: number, count?: number): Promise<void>;
  /** Where the solids are that forces move. */
  freeSolids(): Promise<HearthFreeSolid[]>;
  /** What a probe at a point measures, the same along the vertical through it, and the flame as a whole. */
  measure(x: number, y: number): Promise<HearthMeasures>;
  ignite(place: number, y?: number): Promise<void>;
  extinguish(place: number, y?: number, radius?: number): Promise<void>;
  /** Resolves to an attribute of the element. A value sets it; null removes it, and so does false, except for `autoplay`. */
  option(name: FrameOption, value?: string | number | boolean | null): Promise<string | null>;
  /** Calls a method by its name. */
  call(method: string, ...args: unknown[]): Promise<unknown>;
  /** Closes the connection; the fire keeps burning. */
  close(): void;

  addEventListener<Type extends keyof FrameFireEventMap>(
    type: Type,
    listener: (this: FrameFire, event: FrameFireEventMap[Type]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<Type extends keyof FrameFireEventMap>(
    type: Type,
    listener: (this: FrameFire, event: FrameFireEventMap[Type]) => unknown,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}

/** Connects to the fire in an iframe, which may still be loading. */
export function connectFire(iframe: HTMLIFrameElement): FrameFire;
