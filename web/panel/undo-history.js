/**
 * The undo history of a panel.
 *
 * A step is one gesture: a drag of a slider, a typed value, a press of a button. A page's own script
 * may change values sixty times a second, so its changes are not steps, and undoing one value keeps
 * them. A command that replaces all values, such as a preset or pasted settings, is undone as a
 * whole.
 *
 * The fire answers in order, so a step knows what it changed without a further request. A step that
 * changes all values waits for the steps before it, and the steps after it wait for it.
 */

/** Most steps that are kept. */
const MOST = 200;

/** The number of particles: not set, it follows the quality, and set, it stays. */
const NUMBER = 'max_particles';

const MODEL = 'model';

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../hearth-fire.js').HearthConfig} HearthConfig
 * @typedef {import('../parameters.js').ParameterId} Id
 * @typedef {import('../parameters.js').ModelName} ModelName
 * @typedef {import('../parameters.js').HearthParameters[Id]} Value
 * @typedef {Partial<import('../parameters.js').HearthParameters>} Values
 * @typedef {Pick<HearthFire, 'params' | 'set' | 'restore' | 'exportConfig' | 'importConfig'>} Fire
 *   what an undo history uses of the element
 *
 * @typedef {object} Step
 * @property {Id} [id]  The parameter, where it is one alone.
 * @property {number} gesture  The press of a key or a button that it began with.
 * @property {Side} before
 * @property {Side} after
 *
 * @typedef {object} Side
 * @property {Values} values  The values, or all of them.
 * @property {boolean} [named]  Whether the number of particles is set.
 * @property {HearthConfig} [config]  All settings, where all may have changed.
 * @property {Map<ModelName, Values>} [kept]  And what the other models had, where
 *   that was seen: settings hold the values of one model.
 */

/** The steps of one panel. */
export class UndoHistory {
  #fire;
  #changed;
  #defaultOf;
  #homeOf;
  /** What models had when they were left. @type {Map<ModelName, Values>} */
  #kept = new Map();
  /** @type {Step[]} */
  #done = [];
  /** @type {Step[]} */
  #undone = [];
  #gesture = 0;
  /** Values that were asked for and not answered yet. @type {Map<Id, {value: Value | undefined, count: number}>} */
  #wishes = new Map();
  /** @type {Set<Promise<unknown>>} */
  #open = new Set();
  /** What has to end before anything else begins. @type {Promise<unknown> | undefined} */
  #gate;

  /**
   * @param {Fire} fire  The element, or anything with its API.
   * @param {() => void} changed  Whether there is anything to undo or redo may be another answer now.
   * @param {(id: Id, model: ModelName) => Value | undefined} defaultOf  Nothing, where the model does not
   *   use the parameter.
   * @param {(id: Id, model: ModelName) => Value | undefined} [homeOf]  What a value goes back to, where that
   *   is not its default.
   */
  constructor(fire, changed, defaultOf, homeOf = defaultOf) {
    this.#fire = fire;
    this.#changed = changed;
    this.#defaultOf = defaultOf;
    this.#homeOf = homeOf;
  }

  /** Whether there is a step to undo. */
  get canUndo() {
    return this.#done.length > 0;
  }

  /** Whether there is a step to do again. */
  get canRedo() {
    return this.#undone.length > 0;
  }

  /** A new gesture begins: the next change is another step. */
  press() {
    this.#gesture += 1;
  }

  /** @type {(id: Id, value: Value) => Promise<void>} */
  set(id, value) {
    return this.#one({ id, named: true, target: () => value, act: () => this.#fire.set(id, value) });
  }

  /**
   * Puts one parameter back to what it has in the scene.
   * @param {Id} id
   */
  restore(id) {
    const target = () => this.#homeOf(id, this.#fire.params[MODEL]);
    // The default number of particles follows the quality again.
    const isUsual = () => target() === this.#defaultOf(id, this.#fire.params[MODEL]);
    const act = () => (isUsual() ? this.#fire.restore(id) : this.#fire.set(id, /** @type {Value} */ (target())));
    return this.#one({ id, named: id !== NUMBER || !isUsual(), target, act });
  }

  /**
   * Does something after which every value may be another one.
   * @param {() => unknown} act
   * @param {{anew: boolean}} how  Whether values that it does not name are the defaults after it.
   * @returns {Promise<void>}
   */
  all(act, { anew }) {
    const gesture = this.#gesture;
    return this.#alone(async () => {
      const before = await this.#look();
      await act();
      if (anew) this.#kept.clear();
      const after = await this.#look();
      const same = JSON.stringify([before.values, before.config]);
      if (same !== JSON.stringify([after.values, after.config])) {
        this.#record({ gesture, before, after });
      }
    });
  }

  /** Takes the last step back; false where there is none. */
  undo() {
    return this.#alone(() => this.#go(this.#done, this.#undone, 'before'));
  }

  /** Does again what was undone last; false where there is nothing. */
  redo() {
    return this.#alone(() => this.#go(this.#undone, this.#done, 'after'));
  }

  /**
   * @typedef {object} Change  Of one value.
   * @property {Id} id
   * @property {boolean} named  Whether it counts as set from then on.
   * @property {() => Value | undefined} target  What it will be.
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
    const wish = this.#wishes.get(id) ?? { value: now[id], count: 0 };
    const before = { values: { [MODEL]: model, [id]: wish.value } };
    const after = { values: { [MODEL]: model, [id]: value }, named };
    this.#wishes.set(id, { value, count: wish.count + 1 });
    // Asked before the change and answered before it.
    const config = id === NUMBER ? this.#fire.exportConfig() : undefined;
    const answer = this.#opened(Promise.resolve(act()));
    try {
      await answer;
      const wasNamed = id !== NUMBER || (await config)?.values[NUMBER] !== undefined;
      this.#record({ id, gesture, before: { ...before, named: wasNamed }, after });
    } finally {
      const left = this.#wishes.get(id);
      if (left && left.count > 1) left.count -= 1;
      else this.#wishes.delete(id);
    }
  }

  /** @param {Step} step */
  #record(step) {
    const last = this.#done.at(-1);
    const goesOn = last && this.#undone.length === 0 && last.gesture === step.gesture
      && step.id !== undefined && last.id === step.id;
    if (goesOn) {
      last.after = step.after;
      if (isSame(last)) this.#done.pop();
    } else if (!isSame(step)) {
      this.#done.push(step);
      if (this.#done.length > MOST) this.#done.shift();
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
      await this.#put(step[side]);
      to.push(step);
    } finally {
      // What the fire refuses now it would refuse for ever: such a step is gone.
      this.#changed();
    }
    return true;
  }

  /** @param {Side} side */
  async #put({ values, named, config, kept }) {
    const fire = this.#fire;
    if (config) await fire.importConfig(config);
    if (kept) await this.#putKept(kept, values[MODEL]);
    const now = fire.params;
    const moved = values[MODEL] !== now[MODEL];
    const wanted = { ...values };
    for (const [id, value] of entries(values)) {
      // The number counts as set or not, whatever it is; the settings have seen to it.
      const isRight = id === NUMBER ? !named || (config && !moved) : !moved && value === now[id];
      if (isRight) delete wanted[id];
    }
    if (Object.keys(wanted).length > 0) await fire.set(wanted);
    if ((moved || !config) && !named && NUMBER in values) await fire.restore(NUMBER);
  }

  /**
   * Gives models that do not burn what they had, where that was not their defaults.
   * @type {(kept: Map<ModelName, Values>, burning: ModelName | undefined) => Promise<void>}
   */
  async #putKept(kept, burning) {
    this.#kept = new Map(kept);
    for (const [model, values] of kept) {
      const own = entries(values).filter(([id, value]) => {
        const usual = this.#defaultOf(id, model);
        return usual !== undefined && value !== usual;
      });
      if (model !== burning && own.length > 0) {
        await this.#fire.set({ ...Object.fromEntries(own), [MODEL]: model });
      }
    }
  }

  /** All values, and the settings that give them. @returns {Promise<Side>} */
  async #look() {
    const config = await this.#fire.exportConfig();
    const values = this.#fire.params;
    return { values, named: NUMBER in config.values, config, kept: new Map(this.#kept) };
  }

  /**
   * Waits for what is under way, then does this, and lets nothing begin meanwhile.
   * @template T
   * @param {() => T | Promise<T>} act
   * @returns {Promise<T>}
   */
  #alone(act) {
    const earlier = [...this.#open, this.#gate];
    const done = Promise.allSettled(earlier).then(act);
    const gate = done.then(() => {}, () => {}).then(() => {
      if (this.#gate === gate) this.#gate = undefined;
    });
    this.#gate = gate;
    return done;
  }

  /**
   * Counts a promise among those that are under way.
   * @template T
   * @param {Promise<T>} promise
   */
  #opened(promise) {
    this.#open.add(promise);
    const close = () => this.#open.delete(promise);
    promise.then(close, close);
    return promise;
  }
}

/** @type {(values: Values) => [Id, Value][]} */
function entries(values) {
  return /** @type {[Id, Value][]} */ (Object.entries(values));
}

/** Whether a step that changes one value changes nothing. @param {Step} step */
function isSame({ id, before, after }) {
  return id !== undefined && Object.is(before.values[id], after.values[id]) && before.named === after.named;
}
