/**
 * What the toolbar does to objects. Each call is one step of the history; what the fire refuses becomes a message.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../editing/objects.js').Fields} Fields
 * @typedef {import('./geometry.js').Fields} Drawn
 *
 * @typedef {object} NewSolidStyle
 * @property {string} material
 * @property {boolean} burns
 */

import { MAX_OBJECTS } from '../generated/scene-objects.js';
import { copyOf, inRange, isBody, isFull, nameOf, newObject } from '../editing/objects.js';
import { aligned, moved, outlineOf, rounded } from './geometry.js';
import { placed } from './gestures.js';

/** Power of a metre of a surface that burns [kW/m]. */
const POWER = 150;

/** The edits of one fire. */
export class Edits {
  #fire;
  #editing;
  #newSolidStyle;
  #showStatus;
  #objects;

  /**
   * @param {HearthFire} fire
   * @param {import('../editing/editing.js').Editing} editing
   * @param {() => NewSolidStyle} newSolidStyle
   * @param {(text: string) => void} showStatus
   * @param {() => Fields[]} objects  Where they are now.
   */
  constructor(fire, editing, newSolidStyle, showStatus, objects) {
    this.#objects = objects;
    this.#fire = fire;
    this.#editing = editing;
    this.#newSolidStyle = newSolidStyle;
    this.#showStatus = showStatus;
  }

  /** Does something that the fire may refuse; a refusal becomes a message. @param {() => unknown} act */
  async attempt(act) {
    try {
      await act();
    } catch (error) {
      this.#showStatus(error instanceof Error ? error.message : String(error));
    }
  }

  /**
   * Adds an object and selects it.
   * @param {Drawn} drawn
   * @param {NewSolidStyle} [style]
   */
  add(drawn, style = this.#newSolidStyle()) {
    return this.attempt(async () => {
      const kind = /** @type {'source' | 'solid'} */ (drawn.kind);
      if (isFull(this.#fire, kind)) throw new Error(`A fire has at most ${MAX_OBJECTS} ${kind}s.`);
      const { material, burns } = style;
      const fields = kind === 'source' ? this.#sourceOf(drawn) : { ...drawn, material };
      const isSurface = isBody(drawn) && burns && !isFull(this.#fire, 'source');
      const step = this.#editing.group();
      const id = await step(() => this.#fire.addObject(/** @type {any} */ (fields)));
      if (isSurface) await step(() => this.#fire.addObject(/** @type {any} */ (this.#surfaceOf(id, fields))));
      this.#editing.select(id);
      const object = this.#editing.selected;
      if (object) this.#showStatus(`${nameOf(object)} at ${object.x.toFixed(2)}, ${object.y.toFixed(2)} m.`);
    });
  }

  /** A source as strong by its width as the first one, or as a new one. @param {Drawn} drawn */
  #sourceOf(drawn) {
    const like = /** @type {Drawn} */ (newObject(this.#fire, 'source'));
    const fields = { ...like, ...drawn };
    for (const name of ['power', 'rate']) {
      if (!(name in like)) continue;
      fields[name] = rounded(inRange(this.#fire, 'source', name, (like[name] * drawn.width) / like.width));
    }
    return { ...fields, shape: 'line', width: inRange(this.#fire, 'source', 'width', drawn.width) };
  }

  /** A source at the surface of a solid. @type {(id: number, solid: Drawn) => Drawn} */
  #surfaceOf(id, solid) {
    const { points, closed } = outlineOf(solid);
    const ends = closed ? [...points, points[0]] : [...points, ...points.slice(0, -1).reverse()];
    const around = ends.reduce(
      (sum, point, at) => sum + (at ? Math.hypot(point.x - ends[at - 1].x, point.y - ends[at - 1].y) : 0),
      0,
    );
    return {
      kind: 'source',
      shape: 'solid',
      solid: id,
      power: rounded(inRange(this.#fire, 'source', 'power', POWER * around)),
    };
  }

  /** Adds an object like each selected one, and selects the new ones. */
  duplicate() {
    return this.attempt(async () => {
      /** @type {number[]} */
      const ids = [];
      const step = this.#editing.group();
      for (const object of this.#editing.all) {
        if (isFull(this.#fire, object.kind)) throw new Error(`A fire has at most ${MAX_OBJECTS} ${object.kind}s.`);
        ids.push(await step(() => this.#fire.addObject(/** @type {any} */ (copyOf(this.#fire, object)))));
      }
      this.#editing.select(...ids);
      this.#showStatus(`${this.#named} ${ids.length > 1 ? 'are' : 'is'} new.`);
    });
  }

  /** Removes the selected objects. */
  remove() {
    const { all } = this.#editing;
    if (all.length === 0) return;
    this.#showStatus(`${this.#named} ${all.length > 1 ? 'are' : 'is'} removed.`);
    this.attempt(() => this.#editing.remove(...all.map(({ id }) => id)));
  }

  /** Moves the selected solids before all others, or behind them. @param {boolean} front */
  order(front) {
    const solids = this.#editing.all.filter(isBody);
    if (solids.length === 0) return;
    this.#showStatus(
      `${this.#named} ${solids.length > 1 ? 'are' : 'is'} ${front ? 'before' : 'behind'} the other solids.`,
    );
    this.attempt(() =>
      this.#editing.order(
        solids.map(({ id }) => id),
        front,
      ),
    );
  }

  /** Aligns the selected objects. @param {import('./geometry.js').Alignment} to */
  align(to) {
    const { all } = this.#editing;
    const objects = placed(this.#objects()).filter(({ id }) => all.some((chosen) => chosen.id === id));
    const by = aligned(objects, to);
    this.change(
      objects.map((object, at) => moved(object, { x: 0, y: 0 }, by[at])),
      objects,
    );
    this.#showStatus(`${this.#named} are aligned: ${to}.`);
  }

  /** Changes objects. @type {(fields: Drawn[], objects: Fields[]) => void} */
  change(fields, objects) {
    this.attempt(() => this.#editing.change(this.changes(objects, fields)));
  }

  /**
   * Changes of objects, within the ranges of the properties: one that is refused would leave the others. A free
   * solid gets its whole pose, and one that a pointer drags does not fall.
   * @type {(objects: Fields[], fields: Drawn[], held?: boolean) => Map<number, Drawn>}
   */
  changes(objects, fields, held = false) {
    return new Map(
      objects.map(({ id, kind, motion, x, y, angle }, at) => {
        const all = { ...(motion === 'free' && { x, y, angle, motion: held ? 'still' : motion }), ...fields[at] };
        return [
          id,
          Object.fromEntries(
            Object.entries(all).map(([name, value]) => [
              name,
              typeof value === 'number' ? inRange(this.#fire, kind, name, value) : value,
            ]),
          ),
        ];
      }),
    );
  }

  /** Adds an object to the selection, or takes it out. @param {number} id */
  toggle(id) {
    this.#editing.toggle(id);
    const { length } = this.#editing.all;
    this.#showStatus(length === 1 ? `${this.#named} is selected.` : `${length} objects are selected.`);
  }

  /** A phrase that names the selected objects. */
  get #named() {
    const { all } = this.#editing;
    return all.length === 1 ? nameOf(all[0]) : `${all.length} objects`;
  }
}
