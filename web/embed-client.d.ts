/**
 * The types of a fire in an iframe: see `embed-client.js`.
 */

import type {
  HearthChangeDetail,
  HearthConfig,
  HearthErrorDetail,
  HearthObject,
  HearthObjectsDetail,
  HearthParameters,
  HearthQualityDetail,
  HearthStats,
  ParameterId,
} from './hearth-fire.js';

/** The element's own attributes that an embedded fire has. */
export type FrameOption =
  | 'alt'
  | 'autoplay'
  | 'controls'
  | 'fps-limit'
  | 'interactive'
  | 'loading'
  | 'max-pixels'
  | 'paused'
  | 'quality'
  | 'reduced-motion'
  | 'touch-action';

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
 * A fire in an iframe. What is asked before it is there is done when it is; what nobody
 * will answer rejects.
 */
export interface FrameFire extends EventTarget {
  /** Resolves when it burns; rejects where it cannot. */
  ready(): Promise<void>;
  play(): Promise<void>;
  pause(): Promise<void>;
  /** Starts again from nothing, with the same values. */
  reset(): Promise<void>;
  step(steps?: number): Promise<void>;
  set<Id extends ParameterId>(id: Id, value: HearthParameters[Id]): Promise<void>;
  /** Sets all of these or none. */
  set(values: Partial<HearthParameters> & { objects?: HearthObject[] }): Promise<void>;
  get<Id extends ParameterId>(id: Id): Promise<HearthParameters[Id]>;
  params(): Promise<HearthParameters>;
  objects(): Promise<Required<HearthObject>[]>;
  /** Adds an object; resolves to its id. */
  addObject(object: HearthObject): Promise<number>;
  /** Sets properties of an object, all or none. */
  changeObject(id: number, properties: Partial<HearthObject>): Promise<void>;
  removeObject(id: number): Promise<void>;
  stats(): Promise<HearthStats | null>;
  restore(...ids: (ParameterId | 'objects')[]): Promise<void>;
  exportConfig(): Promise<HearthConfig>;
  importConfig(config: HearthConfig | string): Promise<void>;
  toBlob(type?: string, quality?: number): Promise<Blob>;
  stir(x: number, y: number, u: number, v: number): Promise<void>;
  sparks(x: number, y: number, count?: number): Promise<void>;
  /** An attribute of the element itself; sets it if there is a value; null takes it away, and `false` too but for `autoplay`. */
  option(name: FrameOption, value?: string | number | boolean | null): Promise<string | null>;
  /** Asks by name, as the messages do. */
  call(method: string, ...args: unknown[]): Promise<unknown>;
  /** Lets the fire go; it burns on, unheard. */
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
