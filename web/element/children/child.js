/**
 * A child of a fire: what its attributes and its target state.
 *
 * @typedef {import('../../generated/properties.js').Domain} Domain
 * @typedef {import('../session/requests.js').Refusal} Refusal
 * @typedef {{[property: string]: unknown}} Values
 */

import { PROPERTIES } from '../../generated/properties.js';
import { cut } from '../../quoted.js';
import { TARGET_PROPERTIES, boxOf, inMetres, solidOf, sourceOf, targetOf } from './child-box.js';
import { Look, isPicture } from './child-look.js';
import { isOn } from '../attributes/attributes.js';

/** The kind of object of each element. @type {{[name: string]: string}} */
export const KINDS = Object.fromEntries(Object.keys(PROPERTIES).map((kind) => [`hearth-${kind}`, kind]));

/** The attribute that names the element whose box an object has. */
const TARGET_ATTRIBUTE = 'of';

/** The attribute with which the glyphs of that element count. */
const TARGET_TEXT_ATTRIBUTE = 'of-text';

/**
 * The property that names the solid that a source is on, and that which names the solid that another hangs from.
 * @type {{[kind: string]: string}}
 */
const REFERENCES = { source: 'solid', solid: 'hangs_from' };

/** Why a name of a solid has no effect. */
const WITHOUT_SOLID = 'no <hearth-solid> of this fire has that id';

/** The maximum length of a value, and of one that draws an outline; wasm would keep the memory of longer ones. */
const MAX_VALUE = 1000;
const MAX_OUTLINE = 66_000;
const OUTLINES = ['points', 'mask'];

/** The attribute of a property. */
export const attributeOf = (/** @type {string} */ property) => property.replaceAll('_', '-');

/** The property of an attribute. */
const propertyOf = (/** @type {string} */ attribute) => attribute.replaceAll('-', '_');

/** The attributes of a solid that burns by a recipe, and of a word that it is; their code is loaded on request. */
const BURNING_ATTRIBUTE = 'burning';
const TEXT_ATTRIBUTE = 'text';
const WORD_ATTRIBUTES = [TEXT_ATTRIBUTE, 'font'];

/** The properties that a word has from its attributes. */
const WORD_PROPERTIES = ['shape', 'x', 'y', 'width', 'height', 'mask'];

/** The attributes of a kind. */
export const attributesOf = (/** @type {string} */ kind) => [
  TARGET_ATTRIBUTE,
  ...(PROPERTIES[kind].mask ? [TARGET_TEXT_ATTRIBUTE, BURNING_ATTRIBUTE, ...WORD_ATTRIBUTES] : []),
  ...Object.keys(PROPERTIES[kind]).map(attributeOf),
];

/** A child of one fire. */
export class Child {
  #owner;
  /** The number by which the engine knows it, and the id of its object. */
  number;
  /**
   * What its target states: nothing without `of`, null if nothing of the target is seen, undefined until that is known.
   * @type {Values | null | undefined}
   */
  #placed;
  /** The properties that it states anew. @type {Set<string>} */
  changed = new Set();
  /** The id of the target, the element whose box its object has; empty without a target. */
  of = '';
  /** The look of the target. @type {Look} */
  look;
  /** The id of the solid that it named last. @type {number | undefined} */
  #solid;
  /** The number of its flame, once it burns, and what that stated last. */
  #flame = 0;
  #flameStated = '';
  /** The warnings and refusals so far that are not repeated. @type {Set<string>} */
  #warned = new Set();

  /**
   * @param {import('./children.js').Children} owner
   * @param {Element} element
   * @param {number} number
   * @param {MutationObserver} names warns about unknown attributes that scripts set
   */
  constructor(owner, element, number, names) {
    this.#owner = owner;
    this.element = element;
    this.number = number;
    this.names = names;
    this.kind = KINDS[element.localName];
    this.look = new Look(owner.session, () => `${this.name}: ${TARGET_ATTRIBUTE} = ${this.#shownTarget}`);
  }

  /** The element as messages name it. */
  get name() {
    const { localName, id } = this.element;
    return id ? `<${localName} id="${cut(id)}">` : `<${localName}>`;
  }

  /** The value of `of` as messages show it. */
  get #shownTarget() {
    return `#${cut(this.of)}`;
  }

  /** What the engine knows of it. @returns {{state: string} | undefined} */
  get #known() {
    const { children = [] } = this.#owner.session.state.settings;
    return /** @type {any[]} */ (children).find(({ id }) => id === this.number);
  }

  /** Its object by the last report of the engine. @returns {Values | undefined} */
  get object() {
    const { number, kind } = this;
    // Another object may have the id of one that a call has removed.
    if (this.#known?.state === 'removed') return undefined;
    return this.#owner.session.state.objects.find(({ id, ...object }) => id === number && object.kind === kind);
  }

  /** An attribute has changed. @param {string} attribute */
  attribute(attribute) {
    const property = propertyOf(attribute);
    if ([TARGET_ATTRIBUTE, TARGET_TEXT_ATTRIBUTE, BURNING_ATTRIBUTE].includes(attribute)) {
      if (!this.readTarget()) return;
    } else if (this.#isWord && [...WORD_ATTRIBUTES, ...WORD_PROPERTIES].includes(attribute)) {
      this.#stateAll();
      this.#writeWord();
    } else if (WORD_ATTRIBUTES.includes(attribute)) {
      this.readTarget();
    } else if (this.of && TARGET_PROPERTIES[this.kind]?.includes(property)) {
      return;
    } else {
      this.changed.add(property);
    }
    this.#owner.change();
  }

  /** Reads `of`. Returns whether it is valid. */
  readTarget() {
    const text = this.element.getAttribute(TARGET_ATTRIBUTE);
    const id = text === null ? '' : /^\s*#(\S+)\s*$/.exec(text)?.[1];
    if (id === undefined) {
      const message = `${this.name}: ${TARGET_ATTRIBUTE} = ${cut(String(text))} is refused: it must be # and the id of an element`;
      this.#owner.session.reports.refused([{ id: TARGET_ATTRIBUTE, value: text, message }]);
      this.#placed ??= {};
      return false;
    }
    this.of = id;
    this.#warned.delete(TARGET_ATTRIBUTE);
    this.look.close();
    this.#stateAll();
    if (id) this.#owner.watch();
    else this.#placed = this.#isWord ? undefined : {};
    this.#writeWord();
    this.follow();
    return true;
  }

  /** Whether it burns by the recipe. */
  get #burns() {
    return this.kind === 'solid' && isOn(this.element.getAttribute(BURNING_ATTRIBUTE));
  }

  /** Whether it is a word: without `of`, it has a text. */
  get #isWord() {
    return this.kind === 'solid' && !this.of && this.element.hasAttribute(TEXT_ATTRIBUTE);
  }

  /** Whether it is a word that waits for the domain of the fire. */
  get waits() {
    return this.#isWord && this.#placed === undefined;
  }

  /** The code of what burns and of words; undefined before it is loaded, or if it is not needed. */
  get #recipe() {
    return this.#burns || this.#isWord ? this.#owner.recipe() : undefined;
  }

  /** Places its word, once that code is loaded and the fire has a domain. A refused word leaves the last one. */
  #writeWord() {
    const { state, reports } = this.#owner.session;
    if (!this.#isWord || !this.#recipe || !state.started) return;
    try {
      this.#placed = this.#recipe.wordOf(this.element, state.params.domain_width);
    } catch (error) {
      const { id, message } = /** @type {Refusal} */ (error);
      reports.refused([{ id, value: '', message: `${this.name}: ${message}` }]);
      this.#placed ??= null;
    }
  }

  #stateAll() {
    for (const property in PROPERTIES[this.kind]) this.changed.add(property);
  }

  /** Whether an attribute states a property. A body with the box of an element is invisible: that element is seen. */
  #states(/** @type {string} */ property) {
    return (
      this.element.hasAttribute(attributeOf(property)) || (this.of !== '' && property === 'material' && !this.#burns)
    );
  }

  /** What an attribute states. @param {string} property @returns {unknown} */
  #valueOf(property) {
    if (property === this.#reference && this.#solidName) return this.#solid;
    const text = this.element.getAttribute(attributeOf(property)) ?? 'none';
    const longest = OUTLINES.includes(property) ? MAX_OUTLINE : MAX_VALUE;
    return text.length > longest ? `a text of more than ${longest} letters` : text;
  }

  /** The child for the engine, with its flame if it burns; empty until it is known what its target states. */
  take() {
    this.updateReference();
    if (this.waits) this.#writeWord();
    const recipe = this.#recipe;
    if (this.#placed === undefined || (this.#burns && !recipe)) return [];
    const names = Object.keys(PROPERTIES[this.kind]).filter((property) => this.#states(property));
    const stated = Object.fromEntries(names.map((property) => [property, this.#valueOf(property)]));
    const values = this.#placed && { ...(this.#burns && recipe?.SOLID), ...stated, ...this.#placed };
    const solid = { id: this.number, kind: this.kind, values, changed: [...this.changed] };
    this.changed.clear();
    return this.#burns && recipe ? [solid, this.#flameOf(recipe.sourceOn(this.number, values))] : [solid];
  }

  /** The flame for the engine. @param {Values | null} values */
  #flameOf(values) {
    this.#flame ||= this.#owner.nextNumber();
    const text = JSON.stringify(values);
    const changed = text === this.#flameStated ? [] : Object.keys(values ?? {});
    this.#flameStated = text;
    return { id: this.#flame, kind: 'source', values, changed };
  }

  /** The engine has lost what was sent. @param {string[]} changed */
  restate(changed) {
    this.#flameStated = '';
    for (const property of changed) this.changed.add(property);
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

  /** Finds the solid that it names: 0, which no solid has, if there is none. Returns whether that is another one. */
  updateReference() {
    const name = this.#solidName;
    const id = name ? (this.#owner.childWith('solid', name)?.number ?? 0) : undefined;
    if (id === 0 && document.readyState !== 'loading')
      this.#warnOnce(`#${name}`, `${attributeOf(this.#reference)} = #${cut(name ?? '')}`, WITHOUT_SOLID);
    const isOther = id !== undefined && id !== this.#solid;
    if (isOther) this.changed.add(this.#reference);
    this.#solid = id;
    return isOther;
  }

  /** @type {(key: string, what: string, why: string) => void} */
  #warnOnce(key, what, why) {
    if (!this.#warned.has(key)) console.warn(`<hearth-fire>: ${this.name}: ${what} has no effect now: ${why}.`);
    this.#warned.add(key);
  }

  /**
   * The refusal of a property with its attribute; undefined if it is known.
   * @type {(property: string, error: Refusal) => Refusal | undefined}
   */
  refusal(property, error) {
    // There is no room for its pixels.
    if (property === 'mask' && this.of && this.look.picture) this.look.picture.opacity = 'box';
    const isKnown = property === 'objects' && this.#warned.has(property);
    if (property === 'objects') this.#warned.add(property);
    const id = attributeOf(property);
    return isKnown ? undefined : { ...error, id, message: `${this.name}: ${error.message.replace(error.id, id)}` };
  }

  /** Reads what the target states. Returns whether that is something else. */
  follow() {
    if (!this.of) return false;
    const [before, placed, { object }] = [this.#placed, this.#targetValues(), this];
    if (placed === undefined) return false;
    this.#placed = placed;
    if (placed === null) {
      this.#warnOfTarget();
      return before !== null;
    }
    if (!before) this.#stateAll();
    // A call has removed it.
    else if (!object) return false;
    const moved = Object.entries(placed).filter(([property, value]) => object?.[property] !== value);
    for (const [property] of moved) this.changed.add(property);
    return moved.length > 0;
  }

  /** The target has no box. */
  #warnOfTarget() {
    if (document.readyState === 'loading') return;
    const box =
      this.look.picture?.opacity === null ? 'nothing of that element is opaque' : 'that element has no visible box';
    const why = targetOf(this.element, this.of) ? box : 'no element has that id';
    this.#warnOnce(TARGET_ATTRIBUTE, `${TARGET_ATTRIBUTE} = ${this.#shownTarget}`, why);
  }

  /** Whether the glyphs of its target count. */
  get #takesGlyphs() {
    return (this.element.getAttribute(TARGET_TEXT_ATTRIBUTE) ?? 'false') !== 'false';
  }

  /** @returns {Values | null | undefined} */
  #targetValues() {
    const { fire, view, state } = this.#owner.session;
    // Without a picture, boxes have no position in the domain.
    const viewport = state.started && fire.isConnected && view.viewport(state.params);
    if (!viewport) return undefined;
    const target = targetOf(this.element, this.of);
    const box = target && boxOf(target);
    if (!box) {
      this.look.close();
      return null;
    }
    /** @type {ReturnType<Look['of']>} */
    const seen = PROPERTIES[this.kind].mask
      ? this.look.of(target, box, this.#takesGlyphs || (this.#burns && !isPicture(target)))
      : box;
    if (!seen) return seen;
    const metres = inMetres(seen, fire.getBoundingClientRect(), viewport);
    if (PROPERTIES[this.kind].mask) return solidOf(metres, state.params.domain_height / 2, seen.mask);
    return sourceOf(metres, (property) => domain(property, state.params.model));
  }
}

/** The default and the range of a property of a source in a model. @type {(property: string, model: string) => Domain} */
function domain(property, model) {
  const { every, combustion, classic } = PROPERTIES.source[property];
  return every ?? (model === 'classic' ? classic : combustion) ?? [undefined];
}
