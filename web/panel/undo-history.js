/**
 * The undo history of a panel.
 *
 * A step is one gesture: a drag of a slider, a typed value, a press of a button. A page's own script
 * may change values sixty times a second, so its changes are not steps, and undoing one value keeps
 * them. A command that replaces all values, such as a preset or pasted settings, is undone as a
 * whole. A step that adds, removes or reorders objects restores which there
 * are and their order; those that stay keep their values.
 *
 * The fire answers in order, so a step needs no request to find what it changed. A step that
 * changes all values waits for the steps before it, and later steps wait for it.
 */

import { objectsOf } from './objects.js';

/** The maximum number of steps. */
const MAX_STEPS = 200;

const MODEL = 'model';

/** The number of particles and their spacing: the resolution follows the quality until one is set. */
const RESOLUTION = /** @type {const} */ (['particles', 'spacing']);

/** Whether the resolution follows the quality until this parameter is set. @type {(id: Id) => boolean} */
function ofResolution(id) {
  return RESOLUTION.some((known) => known === id);
}

/** The key of steps of a pointer on the fire. */
const POINTER = 'pointer';

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../hearth-fire.js').HearthConfig} HearthConfig
 * @typedef {import('../parameters.js').ParameterId} Id
 * @typedef {import('../parameters.js').ModelName} ModelName
 * @typedef {import('../parameters.js').HearthParameters[Id]} Value
 * @typedef {Partial<import('../parameters.js').HearthParameters>} Values
 * @typedef {import('./objects.js').Fields} Fields
 * @typedef {{[name: string]: any}} Properties  Those of an object that change.
 * @typedef {Map<number, Properties>} Changes  By the ids of the objects.
 * @typedef {Pick<HearthFire, 'params' | 'objects' | 'set' | 'restore' | 'changeObject' | 'exportConfig' |
 *   'importConfig'>} Fire
 *   the part of the element's API that an undo history uses
 *
 * @typedef {object} Step
 * @property {string} [key]  What a step that changes one value changes: a parameter, or properties of an object.
 * @property {number} gesture  The number of the press of a key or a button that began it.
 * @property {Side} before
 * @property {Side} after
 *
 * @typedef {object} Side
 * @property {Value | Values | [number, Properties][]} [value]  The value of a step that changes one, or the properties
 *   of objects.
 * @property {Values} [values]  The value with the model.
 * @property {[number, Properties][]} [changed]  The properties of a step that changes objects.
 * @property {Fields[]} [objects]  All objects, if a step adds, removes or reorders some.
 * @property {boolean} [named]  Whether the number or the spacing of a step that changes it is set.
 * @property {HearthConfig} [config]  The settings, if all may have changed.
 * @property {unknown} [compared]  Which of two states is shown, if all values may have changed.
 */

/** The steps of one panel. */
export class UndoHistory {
  #fire;
  #changed;
  #defaultOf;
  #resetTo;
  #variants;
  /** @type {Step[]} */
  #done = [];
  /** @type {Step[]} */
  #undone = [];
  #gesture = 0;
  /** Values without an answer yet, with the number of calls. @type {Map<string, {value: unknown, count: number}>} */
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
   * @param {{compared?: unknown}} [variants]  Which of two states is shown: steps that may change every value
   *   restore it.
   */
  constructor(fire, changed, defaultOf, resetTo = defaultOf, variants = {}) {
    this.#fire = fire;
    this.#changed = changed;
    this.#defaultOf = defaultOf;
    this.#resetTo = resetTo;
    this.#variants = variants;
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
    return this.#value(
      id,
      true,
      () => value,
      () => this.#fire.set(id, value),
    );
  }

  /**
   * Resets one parameter to its value in the scene.
   * @param {Id} id
   */
  restore(id) {
    const target = () => this.#resetTo(id, this.#fire.params[MODEL]);
    // A restored resolution follows the scene and the quality again.
    const isDefault = () => ofResolution(id) || target() === this.#defaultOf(id, this.#fire.params[MODEL]);
    const act = () => (isDefault() ? this.#fire.restore(id) : this.#fire.set(id, /** @type {Value} */ (target())));
    return this.#value(id, !ofResolution(id), target, act);
  }

  /** Sets properties of an object. @type {(id: number, properties: Properties) => Promise<void>} */
  change(id, properties) {
    return this.changeAll(new Map([[id, properties]]));
  }

  /** Sets properties of several objects: one step. @param {Changes} changes */
  async changeAll(changes) {
    const gesture = this.#gesture;
    while (this.#gate) await this.#gate;
    const find = (/** @type {number} */ id) => objectsOf(this.#fire).find((object) => object.id === id);
    // A step before this one may have removed some.
    const target = [...changes].filter(([id]) => find(id));
    if (target.length === 0) return;
    const latest = (/** @type {number} */ id, /** @type {string} */ name) =>
      this.#latest(`${id}.${name}`, find(id)?.[name]);
    /** @type {[number, Properties][]} */
    const before = target.map(([id, properties]) => [
      id,
      Object.fromEntries(Object.keys(properties).map((name) => [name, latest(id, name)])),
    ]);
    /** @type {Change['sent']} */
    const sent = target.flatMap(([id, properties]) =>
      Object.entries(properties).map(([name, value]) => /** @type {[string, unknown]} */ ([`${id}.${name}`, value])),
    );
    await this.#change({
      key: target.map(([id, properties]) => `${id}.${Object.keys(properties)}`).join(),
      gesture,
      before: { value: before, changed: before },
      after: { value: target, changed: target },
      sent,
      act: () => this.#changeObjects(target),
    });
  }

  /** @param {[number, Properties][]} changes */
  async #changeObjects(changes) {
    await Promise.all(changes.map(([id, properties]) => this.#fire.changeObject(id, properties)));
  }

  /**
   * Records what a pointer on the fire has moved: one step for each press.
   * @param {Fields[]} objects  All objects when it was pressed.
   */
  moved(objects) {
    const last = this.#done.at(-1);
    if (last?.key === POINTER && last.gesture === this.#gesture) this.#done.pop();
    const now = objectsOf(this.#fire);
    const pairs = objects
      .map((old) => [old, now.find(({ id }) => id === old.id) ?? old])
      .filter(([old, moved]) => old.x !== moved.x || old.y !== moved.y);
    const [before, after] = [0, 1].map((side) => {
      const changed = pairs.map(
        (pair) => /** @type {[number, Properties]} */ ([pair[side].id, { x: pair[side].x, y: pair[side].y }]),
      );
      return { value: changed, changed };
    });
    this.#record({ key: POINTER, gesture: this.#gesture, before, after });
  }

  /**
   * Does something that adds, removes or reorders objects.
   * @param {() => unknown} act
   * @returns {Promise<void>}
   */
  objects(act) {
    const gesture = this.#gesture;
    return this.#alone(async () => {
      const before = { objects: objectsOf(this.#fire) };
      await act();
      const after = { objects: objectsOf(this.#fire) };
      const ids = (/** @type {{objects: Fields[]}} */ { objects }) => objects.map(({ id }) => id).join();
      if (ids(before) !== ids(after)) this.#record({ gesture, before, after });
    });
  }

  /**
   * Does something that may change every value.
   * @param {() => unknown} act
   * @returns {Promise<void>}
   */
  all(act) {
    const gesture = this.#gesture;
    return this.#alone(async () => {
      const before = await this.#snapshot();
      await act();
      const after = await this.#snapshot();
      if (JSON.stringify(before) !== JSON.stringify(after)) this.#record({ gesture, before, after });
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
   * @typedef {Omit<Step, 'key'> & {key: string, sent: [name: string, value: unknown][], act: () => unknown}} Change
   *   A step that changes values, with those that it sends.
   */

  /**
   * Changes the value of a parameter.
   * @param {Id} id
   * @param {boolean} named  Whether the value counts as set from then on.
   * @param {() => Value | undefined} target
   * @param {() => unknown} act
   */
  async #value(id, named, target, act) {
    const gesture = this.#gesture;
    const change = async () => {
      const now = this.#fire.params;
      const model = now[MODEL];
      // The answers are in order, so these are the settings before the change.
      const config = ofResolution(id) ? this.#fire.exportConfig() : undefined;
      const value = target();
      const wasNamed = async () => !ofResolution(id) || (await config)?.values[id] !== undefined;
      const side = (/** @type {Value | undefined} */ value) => ({
        value,
        values: { [MODEL]: model, [id]: value },
        named,
      });
      const before = side(this.#latest(id, now[id]));
      return this.#change({ key: id, gesture, before, after: side(value), sent: [[id, value]], act }, wasNamed);
    };
    // Another model has other values.
    if (id === MODEL) return this.#alone(change);
    while (this.#gate) await this.#gate;
    return change();
  }

  /**
   * @param {Change} change
   * @param {() => Promise<boolean>} [wasNamed]  Whether the value counted as set before.
   */
  async #change({ key, gesture, before, after, sent, act }, wasNamed) {
    for (const [name, value] of sent) {
      this.#pending.set(name, { value, count: (this.#pending.get(name)?.count ?? 0) + 1 });
    }
    const answer = this.#started(Promise.resolve(act()));
    try {
      await answer;
      if (wasNamed) before.named = await wasNamed();
      this.#record({ key, gesture, before, after });
    } finally {
      for (const [name] of sent) {
        const left = this.#pending.get(name);
        if (left && left.count > 1) left.count -= 1;
        else this.#pending.delete(name);
      }
    }
  }

  /**
   * A value after the calls without an answer yet.
   * @type {<T>(name: string, now: T) => T}
   */
  #latest(name, now) {
    const pending = this.#pending.get(name);
    return pending ? /** @type {typeof now} */ (pending.value) : now;
  }

  /** @param {Step} step */
  #record(step) {
    const last = this.#done.at(-1);
    const continues =
      last &&
      this.#undone.length === 0 &&
      last.gesture === step.gesture &&
      step.key !== undefined &&
      last.key === step.key;
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
  async #apply({ values, changed, objects, named, config, compared }) {
    const fire = this.#fire;
    if (changed) await this.#changeObjects(changed);
    if (objects) {
      // Objects that are there keep what a page has changed meanwhile.
      const now = objectsOf(fire);
      const list = objects.map(
        (object) => now.find(({ id, kind }) => id === object.id && kind === object.kind) ?? object,
      );
      await fire.set({ objects: /** @type {any[]} */ (list) });
    }
    if (config) {
      await fire.importConfig(config);
      this.#variants.compared = compared;
    }
    if (!values) return;
    const now = fire.params;
    const moved = values[MODEL] !== now[MODEL];
    const changes = /** @type {[Id, Value][]} */ (Object.entries(values)).filter(([id, value]) =>
      ofResolution(id) ? named : moved || value !== now[id],
    );
    if (changes.length > 0) await fire.set(Object.fromEntries(changes));
    for (const id of RESOLUTION) {
      if (!named && id in values) await fire.restore(id);
    }
  }

  /** All settings. @returns {Promise<Side>} */
  async #snapshot() {
    return { config: await this.#fire.exportConfig(), compared: this.#variants.compared };
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
    const gate = done
      .then(
        () => {},
        () => {},
      )
      .then(() => {
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

/** Whether a step that changes one value changes nothing. @param {Step} step */
function isSame({ key, before, after }) {
  return (
    key !== undefined && JSON.stringify(before.value) === JSON.stringify(after.value) && before.named === after.named
  );
}
