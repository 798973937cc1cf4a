/**
 * Hearth's simulation without a canvas, for Node and browsers: make a fire, step
 * it, read its particles, draw them yourself.
 *
 * The physics is the element's own, in a wasm module of its own, and the same
 * seed and inputs give the same bits in Node, in every browser and natively.
 * Nothing runs by itself: no clock, no frame, no worker. What is handed over is
 * copied first and what is read is a copy, so no code of yours runs inside of it.
 *
 * @typedef {import('./sim.js').SimulationOptions} SimulationOptions
 * @typedef {{[id: string]: unknown}} Values
 */

/** Most steps of one call: minutes of work. More is a mistake. */
const MOST_STEPS = 100_000;
/** Most particles that wasm takes: more are refused before they are copied. */
const MOST_PARTICLES = 400_000;
/** Most fields of an object that is handed over, far more than there are parameters. */
const MOST_FIELDS = 1000;

const OPTIONS = ['model', 'preset', 'seed', 'params', 'wasm'];

/**
 * What a particle is made of, in the order in which wasm takes it, and how many
 * numbers that is each.
 */
const PARTICLE = {
  positions: 2,
  velocities: 2,
  temperatures: 1,
  ages: 1,
  lifetimes: 1,
  fuel: 1,
  oxygen: 1,
  soot: 1,
};
const PARTICLE_NUMBERS = 10;

/** What an ember is made of, in the order in which wasm gives it. */
const EMBER = { positions: 2, velocities: 2, temperatures: 1, sizes: 1, ages: 1, lifetimes: 1 };
const EMBER_NUMBERS = 8;

/**
 * Makes a simulation: a source about to be lit. Values that are refused reject
 * with a `RangeError`; then there is none.
 * @param {SimulationOptions} [options]
 */
export async function createSimulation(options = {}) {
  const { wasm, preset, params, ...own } = optionsOf(options);
  const values = params === undefined ? [] : fields('params', params);
  for (const [id, value] of Object.entries(own)) {
    if (value === undefined) continue;
    if (values.some(([other]) => other === id)) {
      throw new TypeError(`${id} is given twice: as an option and in params`);
    }
    values.push([id, value]);
  }
  if (preset !== undefined) text('preset', preset);
  const { Fire } = await loaded(wasm);
  return new Simulation(() => new Fire(preset, ...columns(values)), [['preset', preset], ...values]);
}

/** A fire, step by step. */
class Simulation {
  /** @type {any} The simulation in wasm; nothing once it is freed or has stopped. */
  #fire;
  #gone = 'this simulation was freed';

  /**
   * @param {() => any} make
   * @param {any[][]} values those that it starts with
   */
  constructor(make, values) {
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

  /** Power that the burning gave in the last step [kW/m]; 0 in the classic model. */
  get power() {
    return this.#use((fire) => fire.power);
  }

  /** Length of a step [s]: of the last one where the state decides. */
  get stepLength() {
    return this.#use((fire) => fire.stepLength);
  }

  /** Every value that it burns with, by id. */
  get params() {
    const values = {};
    this.#use((fire) => fire.get(values));
    return values;
  }

  /**
   * Burns on by so many steps.
   * @param {number} [steps]
   */
  step(steps = 1) {
    if (!Number.isInteger(steps) || steps < 0 || steps > MOST_STEPS) {
      const message = `steps = ${words(steps)} is refused: it must be a whole number from 0 to ${MOST_STEPS}`;
      throw refusal([{ id: 'steps', value: steps, min: 0, max: MOST_STEPS, message }]);
    }
    this.#use((fire) => fire.step(steps));
  }

  /** Starts again: time zero, the seed's first bits, the same values. */
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
    const found = {};
    this.#use((fire) => {
      fire.get(found, id);
      // An unknown id cannot be restored either, and that error names it.
      if (!Object.hasOwn(found, id)) fire.set([id]);
    });
    return found[id];
  }

  /**
   * Sets one parameter, or several: all of them or none.
   * @param {string | Values} ids
   * @param {unknown} [value]
   */
  set(ids, value) {
    const values = typeof ids === 'string' ? [[ids, value]] : fields('values', ids);
    this.#use((fire) => fire.set(...columns(values)), values);
  }

  /**
   * Puts these parameters back to their defaults; without ids, all, the model too.
   * @param {...string} ids
   */
  restore(...ids) {
    for (const id of ids) text('id', id);
    this.#use((fire) => fire.set(ids));
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

  /** Fuel, as a share of the gas. */
  fuel() {
    return this.#read('fuel');
  }

  /** Oxygen, as a share of that of air. */
  oxygen() {
    return this.#read('oxygen');
  }

  /** Soot. */
  soot() {
    return this.#read('soot');
  }

  /** Fuel burnt in a second [1/s], in the last step. */
  burnRates() {
    return this.#read('burnRates');
  }

  /** Every property that a particle can be put in with: what `setParticles` takes. */
  particles() {
    return Object.fromEntries(Object.keys(PARTICLE).map((name) => [name, this.#read(name)]));
  }

  /** The embers that fly, an array a property; none in the classic model. */
  embers() {
    const numbers = this.#read('embers');
    const count = numbers.length / EMBER_NUMBERS;
    /** @type {any} */
    const embers = { count };
    let from = 0;
    for (const [name, width] of Object.entries(EMBER)) {
      embers[name] = Float32Array.from(
        { length: count * width },
        (_, at) => numbers[place(at, width, EMBER_NUMBERS) + from],
      );
      from += width;
    }
    return embers;
  }

  /**
   * Puts these particles in the place of all that there are, or refuses all of them.
   * @param {Values} particles
   */
  setParticles(particles) {
    const given = fields('particles', particles);
    for (const [name] of given) known('property of particles', name, Object.keys(PARTICLE));
    const { positions, ...others } = Object.fromEntries(
      given.filter(([, value]) => value !== undefined),
    );
    const count = list('positions', positions).length / 2;
    if (!Number.isInteger(count)) {
      throw new RangeError(`positions has ${2 * count} numbers: it must have two for each particle`);
    }
    if (count > MOST_PARTICLES) {
      throw new RangeError(`the particles are refused: there may be ${MOST_PARTICLES} of them at most`);
    }
    /** @type {Values} */
    const values = {
      positions,
      velocities: 0,
      temperatures: this.get('ambient_temperature'),
      ages: 0,
      lifetimes: Infinity,
      fuel: 0,
      oxygen: 1,
      soot: 0,
      ...others,
    };
    const numbers = new Float32Array(count * PARTICLE_NUMBERS);
    let from = 0;
    for (const [name, width] of Object.entries(PARTICLE)) {
      fill(numbers, from, name, width, values[name]);
      from += width;
    }
    this.#use((fire) => fire.setParticles(numbers));
  }

  /** Gives its memory back. Every later call throws; to free it once more does not. */
  free() {
    this.#fire?.free();
    this.#fire = undefined;
  }

  /** @param {string} name @returns {Float32Array} */
  #read(name) {
    return this.#use((fire) => fire.read(name));
  }

  /**
   * @template T
   * @param {(fire: any) => T} act
   * @param {any[][]} [values] those that it hands over
   * @returns {T}
   */
  #use(act, values) {
    if (!this.#fire) throw new Error(this.#gone);
    return this.#guard(() => act(this.#fire), values);
  }

  /**
   * If wasm traps, only this simulation is half changed. It is abandoned: its memory leaks,
   * because wasm cannot unwind.
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
      throw new Error(`${this.#gone}; there may be no memory left for so many particles`, { cause });
    }
  }
}

if (Symbol.dispose) {
  Object.defineProperty(Simulation.prototype, Symbol.dispose, {
    value: Simulation.prototype.free,
    configurable: true,
    writable: true,
  });
}

/** @type {Promise<any>} The wasm module, once somebody has loaded it; until then nothing. */
let module = Promise.resolve();

/**
 * The wasm module: the one that is loaded already, else from `wasm`, else from
 * beside this script. Who fails leaves it to the next to try again.
 * @param {unknown} wasm
 */
function loaded(wasm) {
  const attempt = module.then((already) => already ?? load(wasm));
  module = attempt.catch(() => undefined);
  return attempt;
}

/** @param {unknown} wasm */
async function load(wasm) {
  /** @type {any} */
  const source = wasm ?? new URL('./wasm/hearth-sim_bg.wasm', import.meta.url);
  const bytes = source instanceof ArrayBuffer || ArrayBuffer.isView(source);
  const compiled = source instanceof WebAssembly.Module;
  if (!bytes && !compiled && typeof source !== 'string' && !(source instanceof URL)) {
    throw new TypeError(`wasm must be a URL, bytes or a WebAssembly.Module, not ${words(source)}`);
  }
  try {
    const glue = await import('./wasm/hearth-sim.js');
    let ready = source;
    if (bytes) ready = await WebAssembly.compile(/** @type {BufferSource} */ (source));
    else if (!compiled) ready = await compiledFrom(source);
    // The glue would keep another module once it has started it.
    if (!WebAssembly.Module.exports(ready).some(({ name }) => name === 'fire_new')) {
      throw new TypeError('this is the wasm of something else');
    }
    await glue.default({ module_or_path: ready });
    return glue;
  } catch (cause) {
    throw new Error(`the simulation's wasm could not be loaded: ${cause}`, { cause });
  }
}

/**
 * The module at a URL. Node fetches no `file:`, and reads it instead.
 * @param {string | URL} url
 */
async function compiledFrom(url) {
  const base = globalThis.document?.baseURI ?? globalThis.location?.href;
  const { href, protocol } = new URL(url, base);
  if (protocol === 'file:' && /** @type {{process?: {versions?: {node?: string}}}} */ (globalThis).process?.versions?.node) {
    // Not by its name in quotes: a bundler for browsers would look for it.
    const files = 'node:fs/promises';
    const { readFile } = await import(/* @vite-ignore */ /* webpackIgnore: true */ files);
    return WebAssembly.compile(await readFile(new URL(href)));
  }
  const response = await fetch(href);
  if (!response.ok) throw new Error(`${href} answers ${response.status}`);
  // As it comes in where its type is right, else when it is there.
  return response.headers.get('content-type') === 'application/wasm'
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}

/**
 * The options, once each; a name that is none of them is refused.
 * @param {unknown} options
 * @returns {any}
 */
function optionsOf(options) {
  const given = fields('options', options);
  for (const [name] of given) known('option', name, OPTIONS);
  return Object.fromEntries(given);
}

/**
 * The fields of a plain object, each read once.
 * @param {string} name  What it is.
 * @param {any} object
 * @returns {[string, any][]}
 */
function fields(name, object) {
  let keys;
  /** @type {any[]} */
  let values = [];
  try {
    keys = isPlain(object) ? Object.keys(object) : undefined;
    values = (keys ?? []).slice(0, MOST_FIELDS).map((key) => object[key]);
  } catch (cause) {
    throw new TypeError(`${name} cannot be read`, { cause });
  }
  if (!keys) throw new TypeError(`${name} must be a plain object, not ${words(object)}`);
  if (keys.length > MOST_FIELDS) {
    throw new RangeError(`${name} has more than ${MOST_FIELDS} fields`);
  }
  return keys.map((key, at) => [key, values[at]]);
}

/** Whether it is an object of no class, of this realm or another. */
function isPlain(/** @type {any} */ object) {
  if (typeof object !== 'object' || object === null || Array.isArray(object)) return false;
  const prototype = Object.getPrototypeOf(object);
  return prototype === null || Object.getPrototypeOf(prototype) === null;
}

/** Ids and values as two arrays, as wasm takes them: an object becomes words for it. */
function columns(/** @type {any[][]} */ values) {
  const plain = (/** @type {any} */ value) => (
    ['string', 'number', 'boolean', 'undefined'].includes(typeof value) ? value : words(value)
  );
  return [values.map(([id]) => id), values.map(([, value]) => plain(value))];
}

/**
 * The error that is thrown for the errors of wasm.
 * @param {any[]} errors
 * @param {any[][]} [values] those that were handed over
 */
function refusal(errors, values) {
  // The value is the one that was sent, not wasm's words for it.
  for (const error of errors) {
    for (const [id, value] of values ?? []) if (id === error.id) error.value = value;
  }
  const [first] = errors;
  return Object.assign(new RangeError(first.message), first, first.id && { errors });
}

/**
 * Refuses a name that is not among these.
 * @param {string} what @param {string} name @param {readonly string[]} names
 */
function known(what, name, names) {
  if (names.includes(name)) return;
  throw new TypeError(`there is no ${what} ${words(name)}; there are ${names.join(', ')}`);
}

/** @param {string} name @param {unknown} value */
function text(name, value) {
  if (typeof value !== 'string') throw new TypeError(`${name} must be a text, not ${words(value)}`);
}

/**
 * The same, if it is an array or a typed array.
 * @param {string} name @param {any} given
 * @returns {any}
 */
function list(name, given) {
  const typed = ArrayBuffer.isView(given) && !(given instanceof DataView);
  if (typed || Array.isArray(given)) return given;
  throw new TypeError(`${name} must be an array of numbers, not ${words(given)}`);
}

/**
 * Copies one property of all particles to its place among their numbers.
 * @param {Float32Array} numbers  All numbers of one particle, then of the next.
 * @param {number} from  Where the property stands among those of a particle.
 * @param {string} name @param {number} width
 * @param {any} given  An array, or one number for all.
 */
function fill(numbers, from, name, width, given) {
  const count = numbers.length / PARTICLE_NUMBERS;
  const all = typeof given === 'number';
  if (!all && list(name, given).length !== count * width) {
    const each = width === 1 ? 'one' : 'two';
    throw new RangeError(
      `${name} has ${given.length} numbers: it must have ${each} for each of ${count} particles`,
    );
  }
  for (let at = 0; at < count * width; at += 1) {
    const number = all ? given : given[at];
    if (typeof number !== 'number') {
      throw new TypeError(`${name}[${at}] must be a number, not ${words(number)}`);
    }
    numbers[place(at, width, PARTICLE_NUMBERS) + from] = number;
  }
}

/** Where the number `at` of a property stands among those of all, its first one at 0. */
function place(/** @type {number} */ at, /** @type {number} */ width, /** @type {number} */ all) {
  return Math.floor(at / width) * all + (at % width);
}

/** A value in a few words, whatever it is; no code of its own runs. */
function words(/** @type {unknown} */ value) {
  switch (typeof value) {
    case 'string':
      return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}…` : value);
    case 'number':
    case 'boolean':
    case 'undefined':
      return String(value);
    case 'object':
      if (value === null) return 'null';
      return Array.isArray(value) ? 'an array' : 'an object';
    case 'bigint':
      return 'a big integer';
    default:
      return `a ${typeof value}`;
  }
}
