/**
 * The values of the models that do not burn: settings hold those of one model.
 */

/** The number of particles and their spacing: the resolution follows the quality until one is set. */
const COUNT = 'max_particles';
export const SPACING = 'spacing';
export const RESOLUTION = /** @type {const} */ ([COUNT, SPACING]);

const MODEL = 'model';

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../parameters.js').ParameterId} Id
 * @typedef {import('../parameters.js').ModelName} ModelName
 * @typedef {import('../parameters.js').HearthParameters[Id]} Value
 * @typedef {Partial<import('../parameters.js').HearthParameters>} Values
 */

/** @type {(values: Values) => [Id, Value][]} */
export function entries(values) {
  return /** @type {[Id, Value][]} */ (Object.entries(values));
}

/** Whether the resolution follows the quality until this parameter is set. @type {(id: Id) => boolean} */
export function ofResolution(id) {
  return id === COUNT || id === SPACING;
}

/** The values that each model but the burning one has for itself, if they are set or not its defaults. */
export class KeptValues {
  #fire;
  #defaultOf;
  /** @type {Map<ModelName, Values>} */
  #kept = new Map();

  /**
   * @param {Pick<HearthFire, 'params' | 'set' | 'exportConfig'>} fire
   * @param {(id: Id, model: ModelName) => Value | undefined} defaultOf  Undefined if the model does not use the
   *   parameter.
   */
  constructor(fire, defaultOf) {
    this.#fire = fire;
    this.#defaultOf = defaultOf;
  }

  /** A copy of them. */
  get all() {
    return new Map(this.#kept);
  }

  /** The other models have the defaults, or what a scene sets. */
  clear() {
    this.#kept.clear();
  }

  /**
   * Does something that may change the model, and keeps the values of the one that burned.
   * @template T
   * @param {() => Promise<T>} act
   */
  async through(act) {
    const values = this.#fire.params;
    const [{ values: set }, result] = await Promise.all([this.#fire.exportConfig(), act()]);
    const [model, burning] = [values[MODEL], this.#fire.params[MODEL]];
    if (burning === model) return result;
    const own = entries(values).filter(([id, value]) => {
      const standard = this.#defaultOf(id, model);
      // The models share the other values.
      if (id === MODEL || standard === undefined || standard === this.#defaultOf(id, burning)) return false;
      return id in set || (!ofResolution(id) && value !== standard);
    });
    this.#kept.delete(burning);
    if (own.length > 0) this.#kept.set(model, Object.fromEntries(own));
    return result;
  }

  /**
   * Restores the values of the models that do not burn.
   * @type {(kept: Map<ModelName, Values>, burning: ModelName | undefined) => Promise<void>}
   */
  async restore(kept, burning) {
    this.#kept = new Map(kept);
    for (const [model, values] of kept) {
      if (model !== burning) await this.#fire.set({ ...values, [MODEL]: model });
    }
  }
}
