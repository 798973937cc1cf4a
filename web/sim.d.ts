/**
 * The types of `hearth-fire/sim`: the simulation without a canvas, for Node and
 * browsers. The parameters and the properties of objects are generated from the core's
 * tables: see `parameters.d.ts`.
 */

import type { HearthFreeSolid } from './element/types.js';
import type { HearthObject, HearthParameters, HearthValues, ModelName, ParameterId, PresetName } from './parameters.js';

export type { HearthFreeSolid, HearthObject, HearthParameters, HearthValues, ModelName, ParameterId, PresetName };

declare global {
  /** As in newer libraries of TypeScript. */
  interface SymbolConstructor {
    readonly dispose: unique symbol;
  }
}

/** What a simulation starts with. */
export interface SimulationOptions {
  /** The equations that move the particles; by default `combustion`. */
  model?: ModelName;
  /** A named set of values to start from. */
  preset?: PresetName;
  /** The seed of the random generator: the same seed and calls give the same bits everywhere. */
  seed?: number;
  /** Values on top of the preset's. */
  params?: Omit<HearthValues, 'objects'>;
  /**
   * The objects, in place of the one source that the parameters describe. Of a parameter and a
   * property of the first source, the later one in the options wins.
   */
  objects?: HearthObject[];
  /**
   * The wasm file, if it is not beside the module: a URL, its bytes, or the compiled module.
   * All simulations share one: that of the first call.
   */
  wasm?: string | URL | BufferSource | WebAssembly.Module;
}

/** Numbers in an array of any kind. */
export type Numbers = ArrayLike<number> & (readonly number[] | ArrayBufferView);

/** All particles, an array a property, in the order of birth. */
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
  /** Fuel, as a share of the gas; of the combustion model. */
  fuel?: Float32Array;
  /** Oxygen, as a share of that of air; of the combustion model. */
  oxygen?: Float32Array;
  /** Soot, in the amount that a full share of fuel leaves; of the combustion model. */
  soot?: Float32Array;
}

/**
 * Particles to put in. Each property but the positions may be one number for all particles.
 * A missing property has its value in air at rest.
 */
export type OwnParticles = { positions: Numbers } & {
  [Property in Exclude<keyof Particles, 'positions'>]?: Numbers | number;
};

/** The embers. */
export interface Embers {
  /** How many there are. */
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

/** A solid with fuel; masses in kg per metre of depth. */
export interface BurningSolid {
  id: number;
  /** Whether it burns, has burnt, or went out because it lacked heat or oxygen. */
  state: 'unlit' | 'burning' | 'burnt' | 'out' | 'no-oxygen';
  /** Dry mass at first. */
  first: number;
  /** Fuel that is left. */
  fuel: number;
  /** Water that is left. */
  water: number;
  /** Char and ash that are left. */
  char: number;
  /** Power of the gas that it gives off and of its char [kW/m]. */
  power: number;
  /** Highest temperature [K]. */
  temperature: number;
}

/** A refused value. A call with a refused value changes nothing. */
export interface SimulationRangeError extends RangeError {
  id: string;
  value: unknown;
  min?: number;
  max?: number;
  /** Every refused value of the call, this one first. */
  errors?: { id: string; value: unknown; message: string; min?: number; max?: number }[];
}

/**
 * A fire, step by step. Arrays are copies, of all particles, in the order of birth.
 * After `free()`, every member but `free()` throws. If memory runs out, the simulation stops:
 * its members throw, and its memory leaks.
 */
export interface Simulation {
  /** Simulated time since the start [s]. */
  readonly time: number;
  /** Particles alive. */
  readonly count: number;
  /** Power of the combustion in the last step [kW/m]; 0 in the classic model. */
  readonly power: number;
  /** Length of the last step [s]. */
  readonly stepLength: number;
  /** The value of every parameter. */
  readonly params: HearthParameters;
  /**
   * The objects: copies, each with its kind, its id and its properties. Setting them replaces
   * all; `undefined` restores one source.
   */
  get objects(): Required<HearthObject>[];
  set objects(objects: HearthObject[] | undefined | null);

  /** Makes this number of steps: one by default, at most 100,000 in a call. */
  step(steps?: number): void;
  /**
   * Makes steps until this number of seconds has passed, 1000 at most: `time` is then exactly the time before plus
   * `seconds`, because the last two steps are shorter where that is needed.
   */
  advance(seconds: number): void;
  /** Starts again with the same values: time zero, the generator at its seed. */
  reset(): void;

  /** The value of one parameter; throws a RangeError for an unknown one. */
  get<Id extends ParameterId>(id: Id): HearthParameters[Id];
  /** Sets one parameter; throws a {@link SimulationRangeError}. Another seed or model starts again. */
  set<Id extends ParameterId>(id: Id, value: HearthParameters[Id] | null): void;
  /** Sets all of these or none, the model first; throws a {@link SimulationRangeError}. */
  set(values: HearthValues): void;
  /** Restores the defaults of these or, without ids, of everything, the model too. */
  restore(...ids: (ParameterId | 'objects')[]): void;
  /** Adds an object and returns its id; throws a {@link SimulationRangeError}. */
  addObject(object: HearthObject): number;
  /** Sets properties of an object: all of them or none; throws a {@link SimulationRangeError}. */
  changeObject(id: number, properties: Partial<HearthObject>): void;
  /**
   * Removes an object. The next source becomes the first, which the parameters describe; throws
   * a {@link SimulationRangeError}.
   */
  removeObject(id: number): void;

  /**
   * The id of each particle, rising. It stays the same from step to step. The ids of particles
   * that are put in, or that replace others at a new resolution, start at 0.
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
  /** Fuel, as a share of the gas; undefined in the classic model. */
  fuel(): Float32Array | undefined;
  /** Oxygen, as a share of that of air; undefined in the classic model. */
  oxygen(): Float32Array | undefined;
  /** Soot; undefined in the classic model. */
  soot(): Float32Array | undefined;
  /** Fuel burnt in a second [1/s] in the last step; undefined in the classic model. */
  burnRates(): Float32Array | undefined;
  /** The properties of the model that `setParticles` takes. */
  particles(): Particles;
  /** The embers. The classic model makes none. */
  embers(): Embers;
  /** The solids with fuel, in the order of the objects. No solid burns in the classic model. */
  fuels(): BurningSolid[];
  /** The solids with `motion` "free" as they are now, in the order of the objects, then what has broken off them. */
  freeSolids(): HearthFreeSolid[];
  /**
   * Twelve numbers of each step since the last call, from which `hearth-fire/sound` computes a sound: see
   * [sound.md](docs/sound.md#series). The first call starts to record and returns none.
   */
  series(): Float32Array;
  /**
   * Lights a solid with fuel: all of its surface, by its id, or what is within a radius of a point [m], 0.1 by
   * default. Dries the sources there and at a solid there too, so that those that water has put out burn again. Throws a `RangeError` if there is
   * neither.
   */
  ignite(id: number): void;
  ignite(x: number, y: number, radius?: number): void;
  /** Puts out a solid with fuel, by its id, or all that is within a radius of a point [m], 0.2 by default. */
  extinguish(id: number): void;
  extinguish(x: number, y: number, radius?: number): void;
  /**
   * Sprays water from a point [m] within a twentieth of a second, with a velocity [m/s], 0 and −4 by default,
   * and a mass in grams for each metre of depth, 5 by default. A faster one counts as 20 m/s, a larger one as 1000 g.
   * Throws in the classic model.
   */
  spray(x: number, y: number, u?: number, v?: number, grams?: number): void;

  /**
   * Replaces all particles. Throws and changes nothing if one of them is out of range; the
   * RangeError has its `index`.
   */
  setParticles(particles: OwnParticles): void;

  /** Frees its memory. */
  free(): void;
  /** The same, for `using`, in engines with `Symbol.dispose`. */
  [Symbol.dispose](): void;
}

/** Makes a simulation with its sources lit. Rejects with a {@link SimulationRangeError}. */
export function createSimulation(options?: SimulationOptions): Promise<Simulation>;
