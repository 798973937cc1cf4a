/**
 * What the toolbar does to objects. Each call is one step of the history; what the fire refuses becomes a message.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../panel/objects.js').Fields} Fields
 * @typedef {import('./geometry.js').Fields} Drawn
 *
 * @typedef {object} Made  What new solids are.
 * @property {string} material
 * @property {boolean} burns
 */

import { MAX_OBJECTS } from '../generated/scene-objects.js';
import { copyOf, entriesOf, isFull, nameOf, newObject, objectsOf } from '../panel/objects.js';
import { outlineOf, rounded } from './geometry.js';

/** Power of a metre of a surface that burns [kW/m]. */
const POWER = 150;

/** Whether an object is a source that is the surface of a solid. @type {(object: Drawn, id: number) => boolean} */
export function isOn({ kind, shape, solid }, id) {
  return kind === 'source' && shape === 'solid' && solid === id;
}

/** The edits of one fire. */
export class Edits {
  #fire;
  #editing;
  #made;
  #say;

  /**
   * @param {HearthFire} fire
   * @param {import('../panel/editing.js').Editing} editing
   * @param {() => Made} made
   * @param {(text: string) => void} say
   */
  constructor(fire, editing, made, say) {
    this.#fire = fire;
    this.#editing = editing;
    this.#made = made;
    this.#say = say;
  }

  /** Does something that the fire may refuse; a refusal becomes a message. @param {() => unknown} act */
  async attempt(act) {
    try {
      await act();
    } catch (error) {
      this.#say(error instanceof Error ? error.message : String(error));
    }
  }

  /** Adds an object and selects it. @param {Drawn} drawn */
  add(drawn) {
    return this.attempt(async () => {
      const kind = /** @type {'source' | 'solid'} */ (drawn.kind);
      if (isFull(this.#fire, kind)) throw new Error(`A fire has at most ${MAX_OBJECTS} ${kind}s.`);
      const { material, burns } = this.#made();
      const fields = kind === 'source' ? this.#sourceOf(drawn) : { ...drawn, material };
      const isSurface = kind === 'solid' && burns && !isFull(this.#fire, 'source');
      let id = 0;
      await this.#editing.history.objects(async () => {
        id = await this.#fire.addObject(/** @type {any} */ (fields));
        if (isSurface) await this.#fire.addObject(/** @type {any} */ (this.#surfaceOf(id, fields)));
      });
      this.#editing.select(id);
      const object = this.#editing.selected;
      if (object) this.#say(`${nameOf(object)} at ${object.x.toFixed(2)}, ${object.y.toFixed(2)} m.`);
    });
  }

  /** A source as strong by its width as the first one, or as a new one. @param {Drawn} drawn */
  #sourceOf(drawn) {
    const like = /** @type {Drawn} */ (newObject(this.#fire, 'source'));
    const fields = { ...like, ...drawn };
    for (const name of ['power', 'rate']) {
      if (!(name in like)) continue;
      fields[name] = this.#inRange(name, (like[name] * drawn.width) / like.width);
    }
    return { ...fields, shape: 'line', width: this.#inRange('width', drawn.width) };
  }

  /** A source at the surface of a solid. @type {(id: number, solid: Drawn) => Drawn} */
  #surfaceOf(id, solid) {
    const { points, closed } = outlineOf(solid);
    const ends = closed ? [...points, points[0]] : [...points, ...points.slice(0, -1).reverse()];
    const around = ends.reduce((sum, point, at) => sum + (at ? Math.hypot(point.x - ends[at - 1].x, point.y - ends[at - 1].y) : 0), 0);
    return { kind: 'source', shape: 'solid', solid: id, power: this.#inRange('power', POWER * around) };
  }

  /** @type {(name: string, value: number) => number} */
  #inRange(name, value) {
    const { min = value, max = value } = entriesOf('source').find((one) => one.name === name)?.domain(this.#fire.params.model) ?? {};
    return rounded(Math.min(max, Math.max(min, value)));
  }

  duplicate() {
    const { selected } = this.#editing;
    if (selected) this.add({ ...copyOf(this.#fire, selected) });
  }

  remove() {
    const { selected, history } = this.#editing;
    if (!selected) return;
    this.attempt(() => history.objects(() => this.takeAway(selected.id)));
    this.#say(`${nameOf(selected)} is removed.`);
  }

  /** Moves the selected solid before all others, or behind them. @param {boolean} front */
  order(front) {
    const { selected } = this.#editing;
    if (selected?.kind !== 'solid') return;
    this.attempt(() => this.#editing.order([selected.id], front));
    this.#say(`${nameOf(selected)} is ${front ? 'before' : 'behind'} the other solids.`);
  }

  /** Removes an object, and the sources that are its surface: they would burn elsewhere. @param {number} id */
  async takeAway(id) {
    const on = objectsOf(this.#fire).filter((one) => isOn(one, id));
    await Promise.all([...on.map((one) => one.id), id].map((one) => this.#fire.removeObject(one)));
  }
}
