/**
 * The undo history of a panel.
 *
 * A step is one gesture: a drag of a slider, a typed value, a press of a button. A page's own script
 * may change values sixty times a second, so its changes are not steps, and undoing one value keeps
 * them. A command that replaces all values, such as a preset or pasted settings, is undone as a
 * whole.
 *
 * The fire answers in order, so a step knows what it changed without another request. A step that
 * changes all values waits for the steps before it, and later steps wait for it.
 */

/** The maximum number of steps. */
const MAX_STEPS = 200;

/** The number of particles and their spacing: the resolution follows the quality until one is set. */
const COUNT = 'max_particles';
const SPACING = 'spacing';
const RESOLUTION = /** @type {const} */ ([COUNT, SPACING]);

const MODEL = 'model';

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../hearth-fire.js').HearthConfig} HearthConfig
 * @typedef {import('../parameters.js').ParameterId} Id
 * @typedef {import('../parameters.js').ModelName} ModelName
 * @typedef {import('../parameters.js').HearthParameters[Id]} Value
 * @typedef {Partial<import('../parameters.js').HearthParameters>} Values
 * @typedef {Pick<HearthFire, 'params' | 'set' | 'restore' | 'exportConfig' | 'importConfig'>} Fire
 *   the part of the element's API that an undo history uses
 *
 * @typedef {object} Step
 * @property {Id} [id]  The parameter of a step that changes one.
 * @property {number} gesture  The number of the press of a key or a button that began it.
 * @property {Side} before
 * @property {Side} after
 *
 * @typedef {object} Side
 * @property {Values} values  The values of the step, or all values.
 * @property {boolean} [named]  Whether the number or the spacing of a step that changes it is set.
 * @property {HearthConfig} [config]  The settings, if all may have changed.
 * @property {Map<ModelName, Values>} [kept]  The last known values of the other models: settings hold those
 *   of one model.
 */

/** The steps of one panel. */
export class UndoHistory {
  #fire;
  #changed;
  #defaultOf;
  #resetTo;
  /** The values of each model when another one replaced it. @type {Map<ModelName, Values>} */
  #kept = new Map();
  /** @type {Step[]} */
  #done = [];
  /** @type {Step[]} */
  #undone = [];
  #gesture = 0;
  /** Values without an answer yet, with the number of calls. @type {Map<Id, {value: Value | undefined, count: number}>} */
  #pending = new Map();
  /** @type {Set<Promise<unknown>>} */
  #running = new Set();
  /** Settles before any other step begins. @type {Promise<unknown> | undefined} */
  #gate;

  /**
   * @param {Fire} fire  The element, or anything with its API.
   * @param {() => void} changed  `canUndo` or `canRedo` may have changed.
   * @param {(id: Id, model: ModelName) => Value | undefined} defaultOf  Undefined if the model does not use the
   *   parameter.
   * @param {(id: Id, model: ModelName) => Value | undefined} [resetTo]  The value that `restore` sets, if it
   *   is not the default.
   */
  constructor(fire, changed, defaultOf, resetTo = defaultOf) {
    this.#fire = fire;
    this.#changed = changed;
    this.#defaultOf = defaultOf;
    this.#resetTo = resetTo;
  }

  /** Whether there is a step to undo. */
  get canUndo() {
    return this.#done.length > 0;
  }

  /** Whether there is a step to redo. */
  get canRedo() {
    return this.#undone.length > 0;
  }

  /** A new gesture begins: the next change is a new step. */
  press() {
    this.#gesture += 1;
  }

  /** @type {(id: Id, value: Value) => Promise<void>} */
  set(id, value) {
    return this.#one({ id, named: true, target: () => value, act: () => this.#fire.set(id, value) });
  }

  /**
   * Resets one parameter to its value in the scene.
   * @param {Id} id
   */
  restore(id) {
    const target = () => this.#resetTo(id, this.#fire.params[MODEL]);
    // The default number of particles follows the quality again, and any spacing of a scene does.
    const isDefault = () => id === SPACING || target() === this.#defaultOf(id, this.#fire.params[MODEL]);
    const act = () => (isDefault() ? this.#fire.restore(id) : this.#fire.set(id, /** @type {Value} */ (target())));
    return this.#one({ id, named: !ofResolution(id) || !isDefault(), target, act });
  }

  /**
   * Does something that may change every value.
   * @param {() => unknown} act
   * @param {{replaces: boolean}} how  Whether the values that it does not name become the defaults.
   * @returns {Promise<void>}
   */
  all(act, { replaces }) {
    const gesture = this.#gesture;
    return this.#alone(async () => {
      const before = await this.#snapshot();
      await act();
      if (replaces) this.#kept.clear();
      const after = await this.#snapshot();
      const same = JSON.stringify([before.values, before.config]);
      if (same !== JSON.stringify([after.values, after.config])) {
        this.#record({ gesture, before, after });
      }
    });
  }

  /** Undoes the last step; false without one. */
  undo() {
    return this.#alone(() => this.#go(this.#done, this.#undone, 'before'));
  }

  /** Redoes the step that was undone last; false without one. */
  redo() {
    return this.#alone(() => this.#go(this.#undone, this.#done, 'after'));
  }

  /**
   * @typedef {object} Change  Of one value.
   * @property {Id} id
   * @property {boolean} named  Whether the value counts as set from then on.
   * @property {() => Value | undefined} target  The new value.
   * @property {() => unknown} act
   */

  /** @type {(change: Change) => Promise<void>} */
  async #one(change) {
    const gesture = this.#gesture;
    // Another model has other values.
    if (change.id === MODEL) return this.#alone(() => this.#change(change, gesture));
    while (this.#gate) await this.#gate;
    return this.#change(change, gesture);
  }

  /** @type {(change: Change, gesture: number) => Promise<void>} */
  async #change({ id, named, target, act }, gesture) {
    const now = this.#fire.params;
    const model = now[MODEL];
    const value = target();
    if (id === MODEL) this.#kept.set(model, now);
    const pending = this.#pending.get(id) ?? { value: now[id], count: 0 };
    const before = { values: { [MODEL]: model, [id]: pending.value } };
    const after = { values: { [MODEL]: model, [id]: value }, named };
    this.#pending.set(id, { value, count: pending.count + 1 });
    // The answers are in order, so these are the settings before the change.
    const config = ofResolution(id) ? this.#fire.exportConfig() : undefined;
    const answer = this.#started(Promise.resolve(act()));
    try {
      await answer;
      const wasNamed = !ofResolution(id) || (await config)?.values[id] !== undefined;
      this.#record({ id, gesture, before: { ...before, named: wasNamed }, after });
    } finally {
      const left = this.#pending.get(id);
      if (left && left.count > 1) left.count -= 1;
      else this.#pending.delete(id);
    }
  }

  /** @param {Step} step */
  #record(step) {
    const last = this.#done.at(-1);
    const continues = last && this.#undone.length === 0 && last.gesture === step.gesture
      && step.id !== undefined && last.id === step.id;
    if (continues) {
      last.after = step.after;
      if (isSame(last)) this.#done.pop();
    } else if (!isSame(step)) {
      this.#done.push(step);
      if (this.#done.length > MAX_STEPS) this.#done.shift();
    } else {
      return;
    }
    this.#undone.length = 0;
    this.#changed();
  }

  /** @type {(from: Step[], to: Step[], side: 'before' | 'after') => Promise<boolean>} */
  async #go(from, to, side) {
    const step = from.pop();
    if (!step) return false;
    try {
      await this.#apply(step[side]);
      to.push(step);
    } finally {
      // The fire would refuse a refused step again, so the step is dropped.
      this.#changed();
    }
    return true;
  }

  /** @param {Side} side */
  async #apply({ values, named, config, kept }) {
    const fire = this.#fire;
    if (config) await fire.importConfig(config);
    if (kept) await this.#applyKept(kept, values[MODEL]);
    const now = fire.params;
    const moved = values[MODEL] !== now[MODEL];
    const changes = { ...values };
    const isNamed = (/** @type {Id} */ id) => (config ? id in config.values : named);
    for (const [id, value] of entries(values)) {
      // Settings restore whether the resolution is set.
      const isRight = ofResolution(id) ? !isNamed(id) || (config && !moved) : !moved && value === now[id];
      if (isRight) delete changes[id];
    }
    if (Object.keys(changes).length > 0) await fire.set(changes);
    for (const id of RESOLUTION) {
      if ((moved || !config) && !isNamed(id) && id in values) await fire.restore(id);
    }
  }

  /**
   * Restores the values of the models that do not burn, unless they were the defaults.
   * @type {(kept: Map<ModelName, Values>, burning: ModelName | undefined) => Promise<void>}
   */
  async #applyKept(kept, burning) {
    this.#kept = new Map(kept);
    for (const [model, values] of kept) {
      const own = entries(values).filter(([id, value]) => {
        const standard = this.#defaultOf(id, model);
        return standard !== undefined && value !== standard;
      });
      if (model !== burning && own.length > 0) {
        await this.#fire.set({ ...Object.fromEntries(own), [MODEL]: model });
      }
    }
  }

  /** All values, with the settings that restore them. @returns {Promise<Side>} */
  async #snapshot() {
    const config = await this.#fire.exportConfig();
    const values = this.#fire.params;
    return { values, config, kept: new Map(this.#kept) };
  }

  /**
   * Waits for the running steps, then does something. Later steps wait for it.
   * @template T
   * @param {() => T | Promise<T>} act
   * @returns {Promise<T>}
   */
  #alone(act) {
    const earlier = [...this.#running, this.#gate];
    const done = Promise.allSettled(earlier).then(act);
    const gate = done.then(() => {}, () => {}).then(() => {
      if (this.#gate === gate) this.#gate = undefined;
    });
    this.#gate = gate;
    return done;
  }

  /**
   * Adds a promise to the running steps.
   * @template T
   * @param {Promise<T>} promise
   */
  #started(promise) {
    this.#running.add(promise);
    const close = () => this.#running.delete(promise);
    promise.then(close, close);
    return promise;
  }
}

/** @type {(values: Values) => [Id, Value][]} */
function entries(values) {
  return /** @type {[Id, Value][]} */ (Object.entries(values));
}

/** Whether the resolution follows the quality until this parameter is set. @type {(id: Id) => boolean} */
function ofResolution(id) {
  return id === COUNT || id === SPACING;
}

/** Whether a step that changes one value changes nothing. @param {Step} step */
function isSame({ id, before, after }) {
  return id !== undefined && Object.is(before.values[id], after.values[id]) && before.named === after.named;
}
