/**
 * A child of a fire and its object: the values of its attributes, and the calls that they cause.
 *
 * @typedef {import('../../generated/properties.js').Domain} Domain
 * @typedef {{[property: string]: unknown}} Values
 */

import { PROPERTIES } from '../../generated/properties.js';
import { NO_MASK, TARGET_PROPERTIES, boxOf, inMetres, solidOf, sourceOf, targetOf } from './child-box.js';
import { Look } from './child-look.js';

/** The kind of object of each element. @type {{[name: string]: string}} */
export const KINDS = Object.fromEntries(Object.keys(PROPERTIES).map((kind) => [`hearth-${kind}`, kind]));

/** The origin of the changes in events. */
export const ORIGIN = 'child';

/** The attribute that names the element whose box an object has. */
const OF = 'of';

/** The attribute with which the glyphs of that element count. */
const OF_TEXT = 'of-text';

/**
 * The property that names the solid that a source is on, and that which names the solid that another hangs from.
 * @type {{[kind: string]: string}}
 */
const REFERENCES = { source: 'solid', solid: 'hangs_from' };

/** The maximum length of an id in a message. */
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
export const attributesOf = (/** @type {string} */ kind) => [
  OF,
  ...(PROPERTIES[kind].mask ? [OF_TEXT] : []),
  ...Object.keys(PROPERTIES[kind]).map(attributeOf),
];

/** A child of one fire. */
export class Child {
  #owner;
  /**
   * The id of its object; undefined while it is not known which source the settings describe.
   * @type {number | undefined}
   */
  id;
  /** Whether its object is the source that the settings describe. */
  isSettingsSource = false;
  /** Whether the fire has its object by the last report of the engine, and the properties in that report. */
  exists = false;
  /** @type {Values} */
  reported = {};
  /**
   * Whether settings have replaced its object, which is to be added again, and values that override its attributes
   * then.
   */
  isReplaced = false;
  /** @type {Values} */
  overrides = {};
  /** Whether a call has found its object removed, which is to be added again. */
  isMissing = false;
  /** Whether the fire has no room for its object. */
  lacksRoom = false;
  /** Whether another object has its id. */
  idIsTaken = false;
  /** Whether the engine has stopped before an answer. */
  isUnanswered = false;
  /** The values of the unanswered calls. @type {Set<Values>} */
  #sent = new Set();
  /** Whether its object is being added, and the properties whose attributes changed meanwhile. */
  #isAdding = false;
  /** @type {Set<string>} */
  #staleProperties = new Set();
  /** The id of the target, the element whose box its object has; empty without a target. */
  of = '';
  /** Whether the target has no box, and whether the console has a warning about that. */
  lacksBox = false;
  #hasWarned = false;
  /** Whether its values wait until the look of the target is known. */
  #awaitsLook = false;
  /** The look of the target. @type {Look} */
  look;
  /** The id of the solid in the last call that names it, and the name in the last warning about an unknown solid. */
  #sentSolidId = 0;
  #unknownSolid = '';
  /** Whether it is no child of its fire any more. */
  isRemoved = false;

  /** @param {import('./children.js').Children} owner @param {Element} element */
  constructor(owner, element) {
    this.#owner = owner;
    this.element = element;
    this.kind = KINDS[element.localName];
    this.look = new Look(owner.session, () => `${this.name}: ${OF} = ${this.#shownTarget}`);
  }

  /** The element as messages name it. */
  get name() {
    const { localName, id } = this.element;
    return id ? `<${localName} id="${id.slice(0, MAX_SHOWN)}">` : `<${localName}>`;
  }

  /** The value of `of` as messages show it. */
  get #shownTarget() {
    return `#${this.of.slice(0, MAX_SHOWN)}`;
  }

  /** Whether a call is unanswered. */
  get busy() {
    return this.#sent.size > 0;
  }

  /** Whether the fire has its object, or will have it after the answers to calls. */
  get isExpected() {
    return !this.lacksBox && (this.exists || this.busy || this.isUnanswered);
  }

  /** The reported values of its object, without those that a call sets. @returns {Values} */
  get lastingValues() {
    const sent = Object.assign({}, ...this.#sent);
    return Object.fromEntries(Object.entries(this.reported).filter(([property]) => !(property in sent)));
  }

  /** An attribute has changed. @param {string} attribute */
  attribute(attribute) {
    const property = propertyOf(attribute);
    if (attribute === OF || attribute === OF_TEXT) {
      if (this.readTarget()) this.synchronise();
    } else if (this.#isAdding) {
      this.#staleProperties.add(property);
    } else if (this.lacksBox || (this.of && TARGET_PROPERTIES[this.kind]?.includes(property))) {
      // The target sets it.
    } else if (this.exists || (this.isSettingsSource && this.id === undefined)) {
      this.#write({ [property]: this.#valueOf(property) }, true);
    } else {
      // The fire had no room, or a call has removed the object.
      this.synchronise();
    }
  }

  /** Reads `of`. Returns whether it is valid. */
  readTarget() {
    const text = this.element.getAttribute(OF);
    const id = text === null ? '' : /^\s*#(\S+)\s*$/.exec(text)?.[1];
    if (id === undefined) {
      const message = `${this.name}: ${OF} = ${String(text).slice(0, MAX_SHOWN)} is refused: it must be # and the id of an element`;
      this.#owner.session.reports.refused([{ id: OF, value: text, message }]);
      return false;
    }
    this.of = id;
    this.lacksBox = this.#hasWarned = false;
    this.look.close();
    if (id) this.#owner.watch();
    return true;
  }

  /**
   * Adds its object to the fire or, if the fire has it, sets the values of its attributes.
   * @param {Values} [overrides] values that override those of the attributes
   */
  synchronise(overrides = {}) {
    if (this.#isAdding || this.isRemoved) return;
    const placed = this.#targetValues();
    this.isReplaced = this.isUnanswered = false;
    this.#awaitsLook = placed === undefined;
    this.lacksBox = !placed && !(this.#awaitsLook && this.exists);
    if (!placed) {
      if (this.exists && !this.#awaitsLook) this.#hide();
    } else if (this.exists || (this.isSettingsSource && this.id === undefined)) {
      // Those of the source of the settings change only if a child has set them.
      const names = Object.keys(PROPERTIES[this.kind]).filter((property) =>
        this.isSettingsSource ? this.#sets(property) || this.#owner.changed(property) : property in this.reported,
      );
      this.#write({
        ...Object.fromEntries(names.map((property) => [property, this.#valueOf(property)])),
        ...overrides,
        ...placed,
      });
    } else {
      this.#add({ ...this.statedValues(), ...overrides, ...placed });
    }
  }

  /** The values that the attributes state. @returns {Values} */
  statedValues() {
    const names = Object.keys(PROPERTIES[this.kind]).filter((property) => this.#sets(property));
    return Object.fromEntries(names.map((property) => [property, this.#valueOf(property)]));
  }

  /**
   * Whether an attribute states a property. A body with the box of an element is invisible, because that element is
   * seen.
   */
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
    return this.isSettingsSource ? this.#owner.setting(property) : this.#owner.domain(this.kind, property)[0];
  }

  /** The property that names a solid. */
  get #reference() {
    return REFERENCES[this.kind] ?? '';
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

  /** Sends the id of the solid that it names, when that appears or changes. */
  updateReference() {
    const name = this.#solidName;
    if (!name) return;
    const id = this.#solidOf(name);
    if (id === 0 && name !== this.#unknownSolid && document.readyState !== 'loading') {
      this.#unknownSolid = name;
      console.warn(
        `<hearth-fire>: ${this.name}: ${attributeOf(this.#reference)} = #${name.slice(0, MAX_SHOWN)} has no effect now: no <hearth-solid> of this fire has that id.`,
      );
    }
    if (id !== this.#sentSolidId && this.exists && !this.busy) this.#write({ [this.#reference]: id });
  }

  /** @param {Values} values */
  async #add(values) {
    const { session } = this.#owner;
    this.#isAdding = true;
    this.id ??= this.#owner.freeId();
    const added = await this.#call(values, (accepted) =>
      session.call('addObject', { kind: this.kind, id: this.id, ...accepted }, ORIGIN),
    );
    this.lacksRoom = !added && !this.isUnanswered;
    const stale = [...this.#staleProperties];
    this.#staleProperties.clear();
    if (added && !this.isRemoved && stale.length > 0) {
      this.#write(Object.fromEntries(stale.map((property) => [property, this.#valueOf(property)])));
    }
  }

  /** Sets properties of its object; adds it `again` if a call has removed it. @param {Values} values */
  #write(values, again = false) {
    this.#owner.note(this, values);
    return this.#call(values, (accepted) => this.#owner.set(this, accepted), again);
  }

  /** Removes its object, because its target has no box. */
  #hide() {
    this.lacksBox = true;
    this.#call({}, () => this.#owner.session.call('removeObject', this.id, ORIGIN));
  }

  /**
   * Calls the engine without the values that it refuses. Resolves to whether it accepted a call.
   * @type {(values: Values, send: (values: Values) => Promise<unknown>, again?: boolean) => Promise<boolean>}
   */
  async #call(values, send, again = false) {
    this.#sent.add(values);
    if (this.#solidName && this.#reference in values) this.#sentSolidId = this.#solidOf(this.#solidName);
    let accepted = false;
    for (let remaining = values; !accepted; ) {
      const answer = send(remaining);
      this.#owner.calls.set(answer, { child: this, again });
      try {
        await answer;
        accepted = true;
      } catch (error) {
        const { errors } = /** @type {{errors?: {id: string}[]}} */ (error);
        const refused = errors?.map(({ id }) => propertyOf(id)) ?? [];
        const valid = Object.entries(remaining).filter(([property]) => !refused.includes(property));
        this.isUnanswered ||= !errors;
        if (this.idIsTaken) {
          // Settings may hold the object of this child.
          this.idIsTaken = false;
          accepted = this.exists;
          this.id = accepted ? this.id : this.#owner.freeId();
        } else if (refused.includes('mask') && this.of && remaining.mask !== NO_MASK) {
          // There is no room for its pixels.
          if (this.look.picture) this.look.picture.opacity = 'box';
          remaining = { ...remaining, ...this.#targetValues(), mask: NO_MASK };
        } else if (valid.length < Object.keys(remaining).length) {
          remaining = Object.fromEntries(valid);
        } else {
          if (!this.isReplaced) this.overrides = {};
          this.isReplaced = this.isMissing;
          this.isMissing = false;
          break;
        }
      }
    }
    this.#sent.delete(values);
    this.#isAdding = false;
    // The caller goes on first.
    queueMicrotask(() => this.#owner.settle(this));
    return accepted;
  }

  /** Moves its object to the box of the target, removes it while the target has none, and adds it again. */
  followTarget() {
    if (!this.of || this.busy) return;
    const placed = this.#targetValues();
    if (placed === undefined) return;
    // A mask is long.
    const moved = Object.entries(placed ?? {}).filter(([property, value]) => this.reported[property] !== value);
    if (!placed) this.#loseTarget();
    else if (this.lacksBox || this.#awaitsLook) this.synchronise();
    else if (this.exists && moved.length > 0) this.#write(Object.fromEntries(moved));
  }

  /** The target has no box. */
  #loseTarget() {
    if (this.exists) this.#hide();
    this.lacksBox = true;
    if (this.#hasWarned || document.readyState === 'loading') return;
    this.#hasWarned = true;
    const box =
      this.look.picture?.opacity === null ? 'nothing of that element is opaque' : 'that element has no visible box';
    const why = targetOf(this.element, this.of) ? box : 'no element has that id';
    console.warn(`<hearth-fire>: ${this.name}: ${OF} = ${this.#shownTarget} has no effect now: ${why}.`);
  }

  /**
   * The values that the target sets: none without `of`, null if nothing of it is seen, undefined until that is known.
   * @returns {Values | null | undefined}
   */
  #targetValues() {
    if (!this.of) return {};
    const { fire, view, state } = this.#owner.session;
    const viewport = state.started && view.viewport(state.params);
    const target = viewport && targetOf(this.element, this.of);
    const box = target && boxOf(target);
    if (!box) this.look.close();
    if (!viewport || !box) return null;
    /** @type {ReturnType<Look['of']>} */
    const seen = PROPERTIES[this.kind].mask
      ? this.look.of(target, box, (this.element.getAttribute(OF_TEXT) ?? 'false') !== 'false')
      : box;
    if (!seen) return seen;
    const metres = inMetres(seen, fire.getBoundingClientRect(), viewport);
    if (PROPERTIES[this.kind].mask) return solidOf(metres, state.params.domain_height / 2, seen.mask);
    return sourceOf(metres, (property) => this.#owner.domain('source', property));
  }
}
