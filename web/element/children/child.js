/**
 * A child of a fire with its object: what its attributes say, and the calls that they cause.
 *
 * @typedef {import('../../generated/properties.js').Domain} Domain
 * @typedef {{[property: string]: unknown}} Values
 */

import { PROPERTIES } from '../../generated/properties.js';
import { NO_MASK, PLACED, boxOf, inMetres, solidOf, sourceOf, targetOf } from './child-box.js';
import { Look } from './child-look.js';

/** The kind of object of each element. @type {{[name: string]: 'source' | 'solid'}} */
export const KINDS = { 'hearth-source': 'source', 'hearth-solid': 'solid' };

/** The origin of the changes in events. */
export const ORIGIN = 'child';

/** The attribute that names the element whose box an object has. */
const OF = 'of';

/** The attribute with which the glyphs of that element count. */
const OF_TEXT = 'of-text';

/** The property that names the solid that a source is on, and that which names the solid that another hangs from. */
const REFERENCES = { source: 'solid', solid: 'hangs_from' };

/** The maximum length of an id in words. */
const MAX_SHOWN = 40;

/** The maximum length of a value, and of one that draws an outline; wasm would keep the memory of longer ones. */
const MAX_VALUE = 1000;
const MAX_OUTLINE = 66_000;
const OUTLINES = ['points', 'mask'];

/** The attribute of a property. */
export const attributeOf = (/** @type {string} */ property) => property.replaceAll('_', '-');

/** The property of an attribute. */
const propertyOf = (/** @type {string} */ attribute) => attribute.replaceAll('-', '_');

/** The attributes of a kind. */
export const attributesOf = (/** @type {string} */ kind) => [OF, ...(kind === 'solid' ? [OF_TEXT] : []), ...Object.keys(PROPERTIES[kind]).map(attributeOf)];

/** A child of one fire. */
export class Child {
  #owner;
  /** The id of its object; undefined while it is not known which source the settings describe. @type {number | undefined} */
  id;
  /** Whether its object is the source that the settings describe. */
  adopts = false;
  /** Whether the fire has its object, as the engine reported last, and that object. */
  live = false;
  /** @type {Values} */
  last = {};
  /** Whether its object is added again, because settings replaced all objects, and the values that it keeps. */
  lost = false;
  /** @type {Values} */
  kept = {};
  /** Whether a call found its object removed, and it is added again. */
  gone = false;
  /** Whether there is no room for its object. */
  refused = false;
  /** Whether another object has its id. */
  taken = false;
  /** Whether the engine has stopped before it answered. */
  dropped = false;
  /** The values of the unanswered calls. @type {Set<Values>} */
  #sent = new Set();
  /** Whether its object is being added, and the properties whose attributes changed meanwhile. */
  #adding = false;
  /** @type {Set<string>} */
  #stale = new Set();
  /** The id of the target, the element whose box it has; empty without one. */
  of = '';
  /** Whether the target has no box, and whether the console has told so. */
  hidden = false;
  #warned = false;
  /** Whether its values wait until it is known how the target looks. */
  #waits = false;
  /** What of the target counts. @type {Look} */
  look;
  /** The id of the solid that was named when the fire was told last, and the name of none that the console has told. */
  #solid = 0;
  #unknown = '';
  /** Whether it has left its fire. */
  left = false;

  /** @param {import('./children.js').Children} owner @param {Element} element */
  constructor(owner, element) {
    this.#owner = owner;
    this.element = element;
    this.kind = KINDS[element.localName];
    this.look = new Look(owner.session, () => `${this.name}: ${OF} = ${this.#shown}`);
  }

  /** The element in words. */
  get name() {
    const { localName, id } = this.element;
    return id ? `<${localName} id="${id.slice(0, MAX_SHOWN)}">` : `<${localName}>`;
  }

  /** The value of `of` in words. */
  get #shown() {
    return `#${this.of.slice(0, MAX_SHOWN)}`;
  }

  /** Whether a call is unanswered. */
  get busy() {
    return this.#sent.size > 0;
  }

  /** Whether the fire has its object, or is to have it. */
  get present() {
    return !this.hidden && (this.live || this.busy || this.dropped);
  }

  /** The last values of its object, without those that a call sets. @returns {Values} */
  get lasting() {
    const sent = Object.assign({}, ...this.#sent);
    return Object.fromEntries(Object.entries(this.last).filter(([property]) => !(property in sent)));
  }

  /** An attribute has changed. @param {string} attribute */
  attribute(attribute) {
    const property = propertyOf(attribute);
    if (attribute === OF || attribute === OF_TEXT) {
      if (this.target()) this.put();
    } else if (this.#adding) {
      this.#stale.add(property);
    } else if (this.hidden || (this.of && PLACED[this.kind].includes(property))) {
      // The target decides.
    } else if (this.live || (this.adopts && this.id === undefined)) {
      this.#write({ [property]: this.#valueOf(property) }, true);
    } else {
      // It was refused, or a call has removed the object.
      this.put();
    }
  }

  /** Reads `of`. Returns whether it is valid. */
  target() {
    const text = this.element.getAttribute(OF);
    const id = text === null ? '' : /^\s*#(\S+)\s*$/.exec(text)?.[1];
    if (id === undefined) {
      const message = `${this.name}: ${OF} = ${String(text).slice(0, MAX_SHOWN)} is refused: it must be # and the id of an element`;
      this.#owner.session.reports.refused([{ id: OF, value: text, message }]);
      return false;
    }
    this.of = id;
    this.hidden = this.#warned = false;
    this.look.close();
    if (id) this.#owner.watch();
    return true;
  }

  /**
   * Gives the fire its object or, if the fire has it, the values of its attributes.
   * @param {Values} [kept] values that override those of the attributes
   */
  put(kept = {}) {
    if (this.#adding || this.left) return;
    const place = this.#place();
    this.lost = this.dropped = false;
    this.#waits = place === undefined;
    this.hidden = !place && !(this.#waits && this.live);
    if (!place) {
      if (this.live && !this.#waits) this.#hide();
    } else if (this.live || (this.adopts && this.id === undefined)) {
      // Those of the source that the settings describe are left alone unless a child has set them.
      const names = Object.keys(PROPERTIES[this.kind]).filter((property) => (
        this.adopts ? this.#sets(property) || this.#owner.changed(property) : property in this.last
      ));
      this.#write({ ...Object.fromEntries(names.map((property) => [property, this.#valueOf(property)])), ...kept, ...place });
    } else {
      this.#add({ ...this.attributes(), ...kept, ...place });
    }
  }

  /** The values that the attributes state. @returns {Values} */
  attributes() {
    const names = Object.keys(PROPERTIES[this.kind]).filter((property) => this.#sets(property));
    return Object.fromEntries(names.map((property) => [property, this.#valueOf(property)]));
  }

  /** Whether an attribute states a property. A body with the box of an element is invisible, because that element is seen. */
  #sets(/** @type {string} */ property) {
    return this.element.hasAttribute(attributeOf(property)) || (this.of !== '' && property === 'material');
  }

  /** What the attribute states or, without it, what applies. @param {string} property @returns {unknown} */
  #valueOf(property) {
    const text = this.element.getAttribute(attributeOf(property));
    if (property === this.#reference && this.#solidName) return this.#solidOf(this.#solidName);
    const longest = OUTLINES.includes(property) ? MAX_OUTLINE : MAX_VALUE;
    if (text !== null) return text.length > longest ? `a text of more than ${longest} letters` : text;
    if (this.of && property === 'material') return 'none';
    return this.adopts ? this.#owner.setting(property) : this.#owner.domain(this.kind, property)[0];
  }

  /** The property that names a solid. */
  get #reference() {
    return REFERENCES[this.kind];
  }

  /** The id of an element that it names; undefined if it is a number. */
  get #solidName() {
    const text = this.element.getAttribute(attributeOf(this.#reference));
    return /^\s*#(\S+)\s*$/.exec(text ?? '')?.[1];
  }

  /** The id of the object of a child; 0, which no solid has, if there is none. @param {string} name */
  #solidOf(name) {
    const child = this.#owner.childWith('solid', name);
    if (!child) return 0;
    // Known before the fire has the object, so that the reference holds from the first step.
    child.id ??= this.#owner.freeId();
    return child.id;
  }

  /** Follows the solid that it names: tells the fire when its id comes or changes. */
  refer() {
    const name = this.#solidName;
    if (!name) return;
    const id = this.#solidOf(name);
    if (id === 0 && name !== this.#unknown && document.readyState !== 'loading') {
      this.#unknown = name;
      console.warn(`<hearth-fire>: ${this.name}: ${attributeOf(this.#reference)} = #${name.slice(0, MAX_SHOWN)} has no effect now: no <hearth-solid> of this fire has that id.`);
    }
    if (id !== this.#solid && this.live && !this.busy) this.#write({ [this.#reference]: id });
  }

  /** @param {Values} values */
  async #add(values) {
    const { session } = this.#owner;
    this.#adding = true;
    this.id ??= this.#owner.freeId();
    const added = await this.#ask(values, (rest) => session.call('addObject', { kind: this.kind, id: this.id, ...rest }, ORIGIN));
    this.refused = !added && !this.dropped;
    const stale = [...this.#stale];
    this.#stale.clear();
    if (added && !this.left && stale.length > 0) {
      this.#write(Object.fromEntries(stale.map((property) => [property, this.#valueOf(property)])));
    }
  }

  /** Sets properties of its object; adds it `again` if a call has removed it. @param {Values} values */
  #write(values, again = false) {
    this.#owner.note(this, values);
    return this.#ask(values, (rest) => this.#owner.set(this, rest), again);
  }

  /** Removes its object, because its target has no box. */
  #hide() {
    this.hidden = true;
    this.#ask({}, () => this.#owner.session.call('removeObject', this.id, ORIGIN));
  }

  /**
   * Calls the engine without the values that it refuses. Resolves to whether it accepted a call.
   * @type {(values: Values, send: (values: Values) => Promise<unknown>, again?: boolean) => Promise<boolean>}
   */
  async #ask(values, send, again = false) {
    this.#sent.add(values);
    if (this.#solidName && this.#reference in values) this.#solid = this.#solidOf(this.#solidName);
    let accepted = false;
    for (let rest = values; !accepted; ) {
      const answer = send(rest);
      this.#owner.calls.set(answer, { child: this, again });
      try {
        await answer;
        accepted = true;
      } catch (error) {
        const { errors } = /** @type {{errors?: {id: string}[]}} */ (error);
        const refused = errors?.map(({ id }) => propertyOf(id)) ?? [];
        const left = Object.entries(rest).filter(([property]) => !refused.includes(property));
        this.dropped ||= !errors;
        if (this.taken) {
          // Settings may hold the object of this child.
          this.taken = false;
          accepted = this.live;
          this.id = accepted ? this.id : this.#owner.freeId();
        } else if (refused.includes('mask') && this.of && rest.mask !== NO_MASK) {
          // There is no room for its pixels.
          if (this.look.picture) this.look.picture.made = 'box';
          rest = { ...rest, ...this.#place(), mask: NO_MASK };
        } else if (left.length < Object.keys(rest).length) {
          rest = Object.fromEntries(left);
        } else {
          if (!this.lost) this.kept = {};
          this.lost = this.gone;
          this.gone = false;
          break;
        }
      }
    }
    this.#sent.delete(values);
    this.#adding = false;
    // The caller goes on first.
    queueMicrotask(() => this.#owner.settle(this));
    return accepted;
  }

  /** Follows the target: moves the object, removes it while the target has no box, and adds it again. */
  follow() {
    if (!this.of || this.busy) return;
    const place = this.#place();
    if (place === undefined) return;
    // A mask is long.
    const moved = Object.entries(place ?? {}).filter(([property, value]) => this.last[property] !== value);
    if (!place) this.#miss();
    else if (this.hidden || this.#waits) this.put();
    else if (this.live && moved.length > 0) this.#write(Object.fromEntries(moved));
  }

  /** The target has no box. */
  #miss() {
    if (this.live) this.#hide();
    this.hidden = true;
    if (this.#warned || document.readyState === 'loading') return;
    this.#warned = true;
    const box = this.look.picture?.made === null ? 'nothing of that element is opaque' : 'that element has no visible box';
    const why = targetOf(this.element, this.of) ? box : 'no element has that id';
    console.warn(`<hearth-fire>: ${this.name}: ${OF} = ${this.#shown} has no effect now: ${why}.`);
  }

  /** What the target sets: nothing without `of`, null if nothing of it counts, undefined until that is known. @returns {Values | null | undefined} */
  #place() {
    if (!this.of) return {};
    const { fire, view, state } = this.#owner.session;
    const viewport = state.started && view.viewport(state.params);
    const target = viewport && targetOf(this.element, this.of);
    const box = target && boxOf(target);
    if (!box) this.look.close();
    if (!viewport || !box) return null;
    /** @type {ReturnType<Look['of']>} */
    const seen = this.kind === 'solid' ? this.look.of(target, box, (this.element.getAttribute(OF_TEXT) ?? 'false') !== 'false') : box;
    if (!seen) return seen;
    const metres = inMetres(seen, fire.getBoundingClientRect(), viewport);
    if (this.kind === 'solid') return solidOf(metres, state.params.domain_height / 2, seen.mask);
    return sourceOf(metres, (property) => this.#owner.domain('source', property));
  }
}
