/**
 * Hearth's simulation without a canvas, for Node and browsers: make a fire, step it, read its
 * particles, draw them yourself.
 *
 * The physics is that of the element, in a separate wasm module. The same seed and inputs give
 * the same bits in Node, in every browser and natively. Nothing runs by itself: no clock, no
 * frame, no worker. Arguments and results are copies, so no code of a caller runs in a call.
 *
 * @typedef {import('./sim.js').SimulationOptions} SimulationOptions
 * @typedef {{[id: string]: unknown}} Values
 */

import { freeSolidsOf } from './free-solids.js';
import { loaded } from './sim/loading.js';
import { PARTICLE, embersOf, fuelsOf, numbersOf } from './sim/particles.js';
import { between, columns, fields, finite, known, refusal, text, whole, words } from './sim/values.js';

/** Most steps of one call: minutes of work. */
const MAX_STEPS = 100_000;
/** Longest time of one call [s]. */
const MAX_SECONDS = 1000;
/** Largest id of an object. */
const MAX_ID = 1_000_000;

const OPTIONS = ['model', 'preset', 'seed', 'params', 'objects', 'wasm'];

/**
 * Makes a simulation with its sources lit. Rejects with a `RangeError` for values out of range.
 * @param {SimulationOptions} [options]
 */
export async function createSimulation(options = {}) {
  /** @type {[string, any][]} */
  const values = [];
  /** @type {any} */
  let wasm;
  /** @type {any} */
  let preset;
  for (const [name, value] of fields('options', options)) {
    known('option', name, OPTIONS);
    if (value === undefined) continue;
    if (name === 'wasm') wasm = value;
    else if (name === 'preset') preset = value;
    // Of a parameter and an object's property, the later one wins.
    else if (name === 'params') values.push(...fields(name, value));
    else values.push([name, value]);
  }
  const ids = values.map(([id]) => id);
  const twice = ids.find((id, at) => ids.indexOf(id) !== at);
  if (twice !== undefined) throw new TypeError(`${twice} is given twice: as an option and in params`);
  if (preset !== undefined) text('preset', preset);
  const [sent, columnsOfValues] = columns(values);
  const { Fire } = await loaded(wasm);
  return new Simulation(() => new Fire(preset, sent, columnsOfValues), [['preset', preset], ...values], Fire);
}

/** A fire, step by step. */
class Simulation {
  /** @type {any} The simulation in wasm; undefined once it is freed or has trapped. */
  #fire;
  #gone = 'this simulation was freed';
  #wasm;

  /**
   * @param {() => any} make
   * @param {any[][]} values the values of `make`
   * @param {{panic: () => string}} wasm
   */
  constructor(make, values, wasm) {
    this.#wasm = wasm;
    this.#fire = this.#guard(make, values);
  }

  /** Simulated time since the start [s]. */
  get time() {
    return this.#use((fire) => fire.time);
  }

  /** Particles alive. */
  get count() {
    return this.#use((fire) => fire.count);
  }

  /** Power of the combustion in the last step [kW/m]; 0 in the classic model. */
  get power() {
    return this.#use((fire) => fire.power);
  }

  /** Length of a step [s]: of the last one where the state decides. */
  get stepLength() {
    return this.#use((fire) => fire.stepLength);
  }

  /** The value of every parameter, by id. */
  get params() {
    const values = {};
    this.#use((fire) => fire.get(values));
    return values;
  }

  /**
   * The objects: copies, each with its kind, its id and its properties. Setting them replaces
   * all; `null` restores one source.
   */
  get objects() {
    return this.#use((fire) => fire.objects());
  }

  set objects(objects) {
    this.set({ objects });
  }

  /**
   * Makes this number of steps.
   * @param {number} [steps]
   */
  step(steps = 1) {
    whole('steps', steps, 0, MAX_STEPS);
    this.#use((fire) => fire.step(steps));
  }

  /**
   * Makes steps until this number of seconds has passed, exactly: the last two steps are shorter where that is needed.
   * @param {number} seconds
   */
  advance(seconds) {
    between('seconds', seconds, 0, MAX_SECONDS);
    this.#use((fire) => fire.advance(seconds));
  }

  /** Starts again with the same values: time zero, the generator at its seed. */
  reset() {
    this.#use((fire) => fire.reset());
  }

  /**
   * The value of one parameter.
   * @param {string} id
   */
  get(id) {
    text('id', id);
    /** @type {any} */
    const found = Object.create(null);
    this.#use((fire) => {
      fire.get(found, id);
      // The error of a restored unknown id names it.
      if (!(id in found)) fire.set([id], [null]);
    });
    return found[id];
  }

  /**
   * Sets one parameter, or several and `objects`: all of them or none. `null` restores the default. Among several,
   * `undefined` states nothing.
   * @param {string | Values} ids
   * @param {unknown} [value]
   */
  set(ids, value) {
    /** @type {[string, any][]} */
    const values = typeof ids === 'string' ? [[ids, value]] : fields('values', ids);
    const isMissing = typeof ids === 'string' && value === undefined;
    const [sent, columnsOfValues] = columns(isMissing ? [[ids, words(value)]] : values);
    this.#use((fire) => fire.set(sent, columnsOfValues), values);
  }

  /**
   * Adds an object and returns its id.
   * @param {Values} object
   */
  addObject(object) {
    return this.#setObject(undefined, fields('object', object));
  }

  /**
   * Sets properties of an object: all of them or none.
   * @param {number} id
   * @param {Values} properties
   */
  changeObject(id, properties) {
    whole('id', id, 1, MAX_ID);
    this.#setObject(id, fields('properties', properties));
  }

  /**
   * Removes an object. The next source becomes the first, which the parameters describe.
   * @param {number} id
   */
  removeObject(id) {
    whole('id', id, 1, MAX_ID);
    this.#setObject(id);
  }

  /**
   * Restores the defaults of these parameters or of `objects`; without ids, of everything,
   * the model too.
   * @param {...string} ids
   */
  restore(...ids) {
    for (const id of ids) text('id', id);
    const nulls = ids.length > 0 ? ids.map(() => null) : undefined;
    this.#use((fire) => fire.set(ids, nulls));
  }

  /** The number by which each particle is known from step to step. */
  ids() {
    return this.#use((fire) => fire.ids());
  }

  /** Positions [m]: x and y of each particle. */
  positions() {
    return this.#read('positions');
  }

  /** Velocities [m/s]: x and y of each particle. */
  velocities() {
    return this.#read('velocities');
  }

  /** Temperatures [K]. */
  temperatures() {
    return this.#read('temperatures');
  }

  /** Times since birth [s]. */
  ages() {
    return this.#read('ages');
  }

  /** Ages at which they die [s]. */
  lifetimes() {
    return this.#read('lifetimes');
  }

  /** Densities [kg/m³], as the last step found them. */
  densities() {
    return this.#read('densities');
  }

  /** Pressures [Pa], as the last step found them. */
  pressures() {
    return this.#read('pressures');
  }

  /** Fuel, as a share of the gas; undefined in the classic model. */
  fuel() {
    return this.#read('fuel');
  }

  /** Oxygen, as a share of that of air; undefined in the classic model. */
  oxygen() {
    return this.#read('oxygen');
  }

  /** Soot; undefined in the classic model. */
  soot() {
    return this.#read('soot');
  }

  /** Fuel burnt in a second [1/s], in the last step; undefined in the classic model. */
  burnRates() {
    return this.#read('burnRates');
  }

  /** The properties of the model that `setParticles` takes. */
  particles() {
    return Object.fromEntries(
      Object.keys(PARTICLE).flatMap((name) => {
        const read = this.#read(name);
        return read ? [[name, read]] : [];
      }),
    );
  }

  /** The embers, an array a property; none in the classic model. */
  embers() {
    return embersOf(this.#read('embers'));
  }

  /** The solids with fuel, in the order of the objects; none in the classic model. */
  fuels() {
    return fuelsOf(this.#read('fuels'));
  }

  /** The solids that forces move, in the order of the objects. */
  freeSolids() {
    return freeSolidsOf(this.#read('freeSolids'));
  }

  /** The numbers of each step since the last call, from which `hearth-fire/sound` computes a sound. */
  series() {
    return this.#use((fire) => fire.series());
  }

  /**
   * Lights a solid with fuel: all of its surface, by its id, or what is within a radius of a point.
   * Dries the sources there and at a solid there too, so that those that water has put out burn again.
   * @param {number} place the id, or metres from the middle of the floor
   * @param {number} [y] metres above the floor
   * @param {number} [radius] in metres
   */
  ignite(place, y, radius = 0.1) {
    this.#light(true, radius, place, y);
  }

  /**
   * Puts out a solid with fuel, by its id, or all that is within a radius of a point.
   * @param {number} place the id, or metres from the middle of the floor
   * @param {number} [y] metres above the floor
   * @param {number} [radius] in metres
   */
  extinguish(place, y, radius = 0.2) {
    this.#light(false, radius, place, y);
  }

  /** @param {boolean} lit @param {number} radius @param {number} place @param {number} [y] */
  #light(lit, radius, place, y) {
    for (const [name, value] of Object.entries({ place, y: y ?? 0, radius })) finite(name, value);
    this.#use((fire) => fire.light(lit, y === undefined ? -1 : radius, place, y ?? 0));
  }

  /**
   * Sprays water from a point within a twentieth of a second.
   * @param {number} x metres from the middle of the floor
   * @param {number} y metres above the floor
   * @param {number} [u] velocity to the right in metres per second, at most 20
   * @param {number} [v] velocity upwards in metres per second, at most 20
   * @param {number} [grams] for each metre of depth, at most 1000
   */
  spray(x, y, u = 0, v = -4, grams = 5) {
    for (const [name, value] of Object.entries({ x, y, u, v, grams })) finite(name, value);
    this.#use((fire) => fire.spray(x, y, u, v, grams));
  }

  /**
   * Replaces all particles, or throws and changes nothing.
   * @param {Values} particles
   */
  setParticles(particles) {
    const numbers = numbersOf(particles, () => this.get('ambient_temperature'));
    this.#use((fire) => fire.setParticles(numbers));
  }

  /** Frees its memory. Every later call but `free` throws. */
  free() {
    this.#fire?.free();
    this.#fire = undefined;
  }

  /** What Node's console prints. */
  [Symbol.for('nodejs.util.inspect.custom')]() {
    if (!this.#fire) return `Simulation (${this.#gone})`;
    const { time, count, power } = this;
    const state = [`${time.toFixed(3)} s`, `${count} particles`, `${power.toFixed()} kW/m`];
    return `Simulation (${[this.get('model'), ...state].join(', ')})`;
  }

  /**
   * Adds, changes or, without fields, removes an object.
   * @param {number | undefined} id
   * @param {[string, any][]} [values]
   * @returns {number}
   */
  #setObject(id, values) {
    const [sent, columnsOfValues] = values ? columns(values) : [];
    return this.#use((fire) => fire.setObject(id, sent, columnsOfValues), values);
  }

  /** A property of all particles; undefined if the model has none. @param {string} name @returns {any} */
  #read(name) {
    return this.#use((fire) => fire.read(name));
  }

  /**
   * @template T
   * @param {(fire: any) => T} act
   * @param {any[][]} [values] the values of the call
   * @returns {T}
   */
  #use(act, values) {
    if (!this.#fire) throw new Error(this.#gone);
    return this.#guard(() => act(this.#fire), values);
  }

  /**
   * If wasm traps, this simulation is abandoned. Its memory leaks, because wasm cannot unwind;
   * the other simulations go on.
   * @template T
   * @param {() => T} act
   * @param {any[][]} [values]
   * @returns {T}
   */
  #guard(act, values) {
    try {
      return act();
    } catch (cause) {
      if (Array.isArray(cause)) throw refusal(cause, values);
      if (!(cause instanceof WebAssembly.RuntimeError)) throw cause;
      this.#fire = undefined;
      this.#gone = 'this simulation has stopped for good';
      // The allocator traps without a panic.
      const why = this.#wasm.panic() || 'there may be no memory left';
      throw new Error(`${this.#gone}; ${why}`, { cause });
    }
  }
}

// The class has a short name where a bundler makes it one.
Object.defineProperty(Simulation.prototype, Symbol.toStringTag, { value: 'Simulation', configurable: true });

if (Symbol.dispose) {
  Object.defineProperty(Simulation.prototype, Symbol.dispose, {
    value: Simulation.prototype.free,
    configurable: true,
    writable: true,
  });
}
