/**
 * The types of `hearth-fire/sim`: the simulation without a canvas, for Node and
 * browsers. Which parameters there are is generated from the table of parameters:
 * see `parameters.d.ts`.
 */

import type { HearthParameters, ModelName, ParameterId, PresetName } from './parameters.js';

export type { HearthParameters, ModelName, ParameterId, PresetName };

declare global {
  /** As newer libraries of TypeScript have it; said here for those that do not. */
  interface SymbolConstructor {
    readonly dispose: unique symbol;
  }
}

/** What a simulation starts with. */
export interface SimulationOptions {
  /** Which equations move the particles; `combustion` where nothing is said. */
  model?: ModelName;
  /** A named set of values to start from. */
  preset?: PresetName;
  /** The seed of its chance: the same seed and calls give the same bits, everywhere. */
  seed?: number;
  /** Values on top of the preset's. */
  params?: Partial<HearthParameters>;
  /**
   * Where the wasm file is, if it is not beside the module: a URL, its bytes, or the
   * compiled module. All simulations share one; the first that loads it decides.
   */
  wasm?: string | URL | BufferSource | WebAssembly.Module;
}

/** Numbers in an array of any kind. */
export type Numbers = ArrayLike<number> & (readonly number[] | ArrayBufferView);

/** Every particle, a property an array, in the order of birth. */
export interface Particles {
  /** Positions [m]: x and y of each; the origin is the middle of the floor, y points up. */
  positions: Float32Array;
  /** Velocities [m/s]: x and y of each. */
  velocities: Float32Array;
  /** Temperatures [K]. */
  temperatures: Float32Array;
  /** Times since birth [s]; those of the combustion model are as old as the fire. */
  ages: Float32Array;
  /** Ages at which they die [s]; infinite in the combustion model. */
  lifetimes: Float32Array;
  /** Fuel, as a share of the gas. */
  fuel: Float32Array;
  /** Oxygen, as a share of that of air. */
  oxygen: Float32Array;
  /** Soot, in the amount that a full share of fuel leaves. */
  soot: Float32Array;
}

/**
 * Particles of your own. All but their positions may be left out, or be one number
 * for all: they are then as in air at rest.
 */
export type OwnParticles = { positions: Numbers } & {
  [Property in Exclude<keyof Particles, 'positions'>]?: Numbers | number;
};

/** The embers that fly. */
export interface Embers {
  count: number;
  /** Positions [m]: x and y of each. */
  positions: Float32Array;
  /** Velocities [m/s]: x and y of each. */
  velocities: Float32Array;
  /** Temperatures [K]. */
  temperatures: Float32Array;
  /** Diameters [m]. */
  sizes: Float32Array;
  /** Times since birth [s]. */
  ages: Float32Array;
  /** Ages at which they die [s]. */
  lifetimes: Float32Array;
}

/** A value that was refused. Every value of the same call is refused with it. */
export interface SimulationRangeError extends RangeError {
  id: string;
  value: unknown;
  min?: number;
  max?: number;
  /** Every refused parameter of the call, this one first. */
  errors?: { id: string; value: unknown; message: string; min?: number; max?: number }[];
}

/**
 * A fire, step by step. Arrays are copies, of all particles, in the order of birth.
 * After `free()` everything but `free()` throws. So it does once a simulation has stopped
 * for good, as where no memory is left; what it had then stays taken.
 */
export interface Simulation {
  /** Simulated time since the start [s]. */
  readonly time: number;
  /** Particles alive. */
  readonly count: number;
  /** Power that the burning gave in the last step [kW/m]; 0 in the classic model. */
  readonly power: number;
  /** Length of a step [s]: in the combustion model, of the last one, which was as long as is stable. */
  readonly stepLength: number;
  /** Every value that it burns with. */
  readonly params: HearthParameters;

  /** Burns on by so many steps, one where nothing is said, at most 100,000 in a call. */
  step(steps?: number): void;
  /** Starts again: time zero, the seed's first bits, the same values. */
  reset(): void;

  /** The value of one parameter; throws a RangeError for an unknown one. */
  get<Id extends ParameterId>(id: Id): HearthParameters[Id];
  /** Sets one parameter; throws a {@link SimulationRangeError}. Another seed or model starts again. */
  set<Id extends ParameterId>(id: Id, value: HearthParameters[Id]): void;
  /** Sets all of these or none, the model first; throws a {@link SimulationRangeError}. */
  set(values: Partial<HearthParameters>): void;
  /** Puts these, or all, back to their defaults; all: the model as well. */
  restore(...ids: ParameterId[]): void;

  /**
   * The number by which each particle is known from step to step, rising. Particles that
   * are put in, or that take over a fire, are numbered from 0 again.
   */
  ids(): Float64Array;
  /** Positions [m]: x and y of each; the origin is the middle of the floor, y points up. */
  positions(): Float32Array;
  /** Velocities [m/s]: x and y of each. */
  velocities(): Float32Array;
  /** Temperatures [K]. */
  temperatures(): Float32Array;
  /** Times since birth [s]; those of the combustion model are as old as the fire. */
  ages(): Float32Array;
  /** Ages at which they die [s]; infinite in the combustion model. */
  lifetimes(): Float32Array;
  /** Densities [kg/m³] as the last step found them. */
  densities(): Float32Array;
  /** Pressures [Pa] as the last step found them. */
  pressures(): Float32Array;
  /** Fuel, as a share of the gas; none in the classic model. */
  fuel(): Float32Array;
  /** Oxygen, as a share of that of air; one in the classic model. */
  oxygen(): Float32Array;
  /** Soot; none in the classic model. */
  soot(): Float32Array;
  /** Fuel burnt in a second [1/s] in the last step; none in the classic model. */
  burnRates(): Float32Array;
  /** Everything that a particle can be put in with: what `setParticles` takes. */
  particles(): Particles;
  /** The embers that fly; none in the classic model. */
  embers(): Embers;

  /**
   * Puts these particles in the place of all that there are; throws, and changes
   * nothing, if one of them cannot be. A RangeError about one has its `index`.
   */
  setParticles(particles: OwnParticles): void;

  /** Gives its memory back. */
  free(): void;
  /** The same, for `using`; only where there is `Symbol.dispose`. */
  [Symbol.dispose](): void;
}

/** Makes a simulation: a source about to be lit. Rejects with what is wrong. */
export function createSimulation(options?: SimulationOptions): Promise<Simulation>;
