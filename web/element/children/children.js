/**
 * `<hearth-source>` and `<hearth-solid>`: children of a fire that are objects in it. This code is loaded when
 * a fire has such a child.
 *
 * An attribute sets a property of the object. A call that changes the object leaves the attribute alone, and
 * the next change of an attribute wins. Settings that replace the objects of a fire keep those of its children.
 *
 * @typedef {import('../../engine/engine.js').Message} Message
 * @typedef {import('../session/requests.js').Refusal} Refusal
 * @typedef {import('./child.js').Values} Values
 */

import { PROPERTIES } from '../../generated/properties.js';
import { Child, KINDS, ORIGIN, attributeOf, attributesOf } from './child.js';

/** The first id of a child's object. Scenes count theirs from 1. */
const FIRST_ID = 1001;

/** How often, at most, a list of objects waits for the calls of a page that calls without a pause. */
const MAX_TRIES = 100;

/** The child that an element is of a fire. @type {WeakMap<Element, Child>} */
const CHILDREN = new WeakMap();

/** The properties of an object. @param {any} object @returns {Values} */
const propertiesOf = ({ kind, id, ...properties } = {}) => properties;

/** The children of one fire that are objects. */
export class Children {
  /** In their order in the document. @type {Child[]} */
  #children = [];
  /**
   * The child of each call, and whether its object is added again if it is gone.
   * @type {WeakMap<Promise<unknown>, {child: Child, again: boolean}>}
   */
  calls = new WeakMap();
  /**
   * The source that the settings describe before a child replaced it, if that is known, and the properties that
   * children have set since.
   * @type {{values: Values | undefined, changed: Set<string>} | undefined}
   */
  #own;
  #lastId = FIRST_ID - 1;
  /** Whether the objects are being put in order. */
  #sorting = false;
  /** Whether the fire is in sight; undefined before a child has a target. @type {boolean | undefined} */
  #inSight;
  #frame = 0;
  /** Warns about unknown attributes that scripts set. */
  #names = new MutationObserver((records) => {
    for (const { target, attributeName } of records) {
      const element = /** @type {Element} */ (target);
      if (attributeName && element.hasAttribute(attributeName)) spell(element, attributeName);
    }
    // A child may name a solid by its id.
    if (records.some(({ attributeName }) => attributeName === 'id')) this.update();
  });

  /** @param {import('../session/session.js').FireSession} session */
  constructor(session) {
    this.session = session;
  }

  /** The children of the element may have changed. */
  update() {
    const { fire } = this.session;
    // HTML has no self-closing elements, and pages wrap children: descendants count, but those of a fire in this one.
    const elements = [...fire.querySelectorAll(Object.keys(KINDS).join())].filter(
      (element) => element.closest('hearth-fire') === fire,
    );
    const before = this.#children;
    const of = (/** @type {Element} */ element) => before.find((child) => child.element === element);
    this.#children = elements.filter((element) => of(element)).map((element) => /** @type {Child} */ (of(element)));
    const joined = elements.filter((element) => !of(element));
    elements.forEach((element, at) => {
      if (this.#children[at]?.element !== element) this.#join(element, at);
    });
    // A child may name a solid after it.
    for (const child of this.#children.filter(({ element }) => joined.includes(element))) {
      child.readTarget();
      child.synchronise();
    }
    for (const child of before) if (!this.#children.includes(child)) this.#leave(child);
    this.settle();
  }

  /** @type {(element: Element, at: number) => void} */
  #join(element, at) {
    const child = new Child(this, element);
    const first = this.#adoptable();
    if (child.kind === 'source' && first !== null && !this.#children.some(({ kind }) => kind === 'source')) {
      child.isSettingsSource = true;
      child.id = first?.id;
      child.exists = Boolean(first);
      child.reported = propertiesOf(first);
      this.#own ??= { values: first && child.reported, changed: new Set() };
    }
    this.#children.splice(at, 0, child);
    CHILDREN.set(element, child);
    this.#names.observe(element, { attributes: true });
    for (const name of element.getAttributeNames()) spell(element, name);
  }

  /** The first source, if it is no child's; undefined before the fire has begun, null without one. @returns {any} */
  #adoptable(/** @type {any[]} */ objects = this.session.state.objects) {
    if (!this.session.state.started) return undefined;
    const first = objects.find(({ kind }) => kind === 'source');
    return first && !this.#children.some(({ id, isSettingsSource }) => id === first.id && !isSettingsSource)
      ? first
      : null;
  }

  /** A child is no child of this fire any more. @param {Child} child */
  #leave(child) {
    child.isRemoved = true;
    child.look.close();
    if (CHILDREN.get(child.element) === child) CHILDREN.delete(child.element);
    if (!child.busy) this.#depart(child);
  }

  /**
   * Removes the object of a child that has left, or restores the source that the settings describe.
   * @param {Child} child
   */
  #depart(child) {
    const own = this.#own;
    // Another child has replaced it.
    if (this.#children.some(({ id }) => id !== undefined && id === child.id)) return;
    if (own && child.kind === 'source' && !this.#children.some(({ kind }) => kind === 'source')) {
      const names = child.isSettingsSource ? [...own.changed] : Object.keys(own.values ?? {});
      const values = Object.fromEntries(names.map((property) => [property, this.setting(property)]));
      this.#own = undefined;
      if (child.exists) this.set(child, values);
      else if (child.lacksBox) this.session.call('addObject', { kind: 'source', ...own.values, ...values }, ORIGIN);
    } else if (child.exists) {
      this.session.call('removeObject', child.id, ORIGIN);
    }
    // There may be room for one that was refused.
    this.#children.find(({ lacksRoom, kind }) => lacksRoom && kind === child.kind)?.synchronise();
  }

  /** Sets properties of the object of a child. @type {(child: Child, values: Values) => Promise<unknown>} */
  set(child, values) {
    if (Object.keys(values).length === 0) return Promise.resolve();
    if (child.id !== undefined) return this.session.call('changeObject', child.id, values, ORIGIN);
    // A fire that has not begun reports no ids. The parameters are the properties of the source of its settings.
    const parameters = Object.entries(values).flatMap(([property, value]) => {
      const { parameter } = PROPERTIES.source[property];
      return parameter ? [[parameter, value]] : [];
    });
    return this.session.call('set', Object.fromEntries(parameters), ORIGIN);
  }

  /**
   * Notes the properties that a child sets of the source of the settings.
   * @type {(child: Child, values: Values) => void}
   */
  note(child, values) {
    for (const property in values) if (child.isSettingsSource) this.#own?.changed.add(property);
  }

  /** Whether a child has set a property of the source of the settings. @param {string} property */
  changed(property) {
    return Boolean(this.#own?.changed.has(property));
  }

  /**
   * The value of a property of the source of the settings: before a child replaced it, else the attribute of the fire
   * or
   * the default.
   * @param {string} property
   */
  setting(property) {
    const attribute = attributeOf(PROPERTIES.source[property].parameter ?? '');
    return (
      this.#own?.values?.[property] ?? this.session.fire.getAttribute(attribute) ?? this.domain('source', property)[0]
    );
  }

  /**
   * The default and the range of a property in the present model.
   * @type {(kind: string, property: string) => import('./child.js').Domain}
   */
  domain(kind, property) {
    const { every, combustion, classic } = PROPERTIES[kind][property];
    const [own, other] = this.session.state.params.model === 'classic' ? [classic, combustion] : [combustion, classic];
    return every ?? own ?? other ?? [undefined];
  }

  /** The child of this kind with an id in the document. @type {(kind: string, id: string) => Child | undefined} */
  childWith(kind, id) {
    return this.#children.find((child) => child.kind === kind && child.element.id === id);
  }

  /** An id that no object has. */
  freeId() {
    do this.#lastId += 1;
    while (this.session.state.objects.some(({ id }) => id === this.#lastId));
    return this.#lastId;
  }

  /**
   * The refusals of a call of a child, which name its element and its attributes; undefined for other calls.
   * @type {(errors: Refusal[], call: Promise<unknown> | undefined) => Refusal[] | undefined}
   */
  named(errors, call) {
    const asked = call && this.calls.get(call);
    if (!asked) return undefined;
    const { child, again } = asked;
    child.idIsTaken = errors.some(({ id }) => /^objects\[\d+\]\.id$/.test(id));
    child.isMissing = (child.isReplaced || again) && errors.some(({ id }) => id === 'id');
    const sources = Object.entries(PROPERTIES.source);
    return child.idIsTaken || child.isMissing
      ? []
      : errors.map((error) => {
          const property =
            /^objects\[\d+\]\.(.*)$/.exec(error.id)?.[1] ??
            sources.find(([, { parameter }]) => parameter === error.id)?.[0];
          const id = property ? attributeOf(property) : error.id;
          return { ...error, id, message: `${child.name}: ${error.message.replace(error.id, id)}` };
        });
  }

  /** The fire has begun, or its values have changed. @param {Message} message */
  report({ type, replaced, objects, source, values }) {
    const begins = type === 'ready';
    if (this.#own && !begins && 'model' in values) this.#own.values = {};
    if (objects) {
      // These keep the objects of the children.
      const keeps = begins || replaced || source === 'attribute';
      const child =
        this.#children.find(({ isSettingsSource }) => isSettingsSource) ??
        this.#children.find(({ kind }) => kind === 'source');
      const known = objects.some((/** @type {any} */ { id }) => id === child?.id);
      const again = child?.isSettingsSource
        ? replaced || child.id === undefined || !known
        : !known && child?.isExpected && this.#adoptable(objects);
      if (child && keeps && again) this.#adopt(child, objects, replaced);
      for (const other of this.#children) this.#compare(other, objects, keeps);
    }
    this.settle();
    this.#follow();
  }

  /**
   * The settings have another source, which a child replaces.
   * @type {(child: Child, objects: any[], replaced: boolean) => void}
   */
  #adopt(child, objects, replaced) {
    const first = this.#adoptable(objects);
    if (!first) this.#own = undefined;
    else if (!this.#own) this.#own = { values: propertiesOf(first), changed: new Set() };
    else if (replaced || !this.#own.values) this.#own.values = propertiesOf(first);
    // The fire had no id for the source of that name.
    child.isReplaced = !first || child.id !== undefined || 'name' in child.statedValues();
    child.overrides = Object.fromEntries(
      Object.entries(child.lastingValues).filter(([property]) => property in child.statedValues()),
    );
    child.isSettingsSource = Boolean(first);
    child.id = first?.id;
  }

  /** Compares a child with the objects of the fire. @type {(child: Child, objects: any[], keeps: boolean) => void} */
  #compare(child, objects, keeps) {
    const object = objects.find(({ id, kind }) => id === child.id && kind === child.kind);
    if (object) {
      child.reported = propertiesOf(object);
      child.isReplaced &&= child.isSettingsSource;
    } else if (keeps && child.isExpected) {
      child.overrides = child.lastingValues;
      child.isReplaced = true;
    }
    child.exists = Boolean(object);
    if (child.exists && child.isUnanswered) [child.isReplaced, child.overrides] = [true, {}];
  }

  /** Adds lost objects again, and puts the objects in order when no call is unanswered. @param {Child} [answered] */
  settle(answered) {
    if (answered?.isRemoved && !answered.busy) this.#depart(answered);
    for (const child of this.#children) {
      if (child.isReplaced && !child.busy) child.synchronise(child.overrides);
      child.updateReference();
    }
    if (!this.#sorting && this.#children.every(({ busy }) => !busy) && this.#sorted()) this.#sort();
  }

  /** The objects of the fire, those of the children in the order of the children; undefined if they are. */
  #sorted() {
    const { objects } = this.session.state;
    const ids = this.#children.filter(({ exists }) => exists).map(({ id }) => id);
    const owned = objects.filter(({ id }) => ids.includes(id));
    if (owned.every(({ id }, at) => id === ids[at])) return undefined;
    const next = ids.map((nextId) => owned.find(({ id }) => id === nextId));
    return objects.map((object) => (ids.includes(object.id) ? (next.shift() ?? object) : object));
  }

  /** Puts the objects in the order of the children. */
  async #sort() {
    this.#sorting = true;
    let sorted = false;
    try {
      // A list would undo a call of the page that changes an object and is not answered.
      for (let tries = 0; tries === 0 || (tries < MAX_TRIES && !this.session.idle); tries += 1)
        await this.session.call('check', {});
      const objects = this.#sorted();
      if (objects) await this.session.set({ objects }, ORIGIN);
      sorted = true;
    } catch {
      // The next answer tries again.
    }
    this.#sorting = false;
    if (sorted) this.settle();
  }

  /** Follows the targets from now on, in each frame while the fire is in sight. */
  watch() {
    if (this.#inSight === undefined) {
      this.#inSight = false;
      new IntersectionObserver((entries) => {
        this.#inSight = entries[entries.length - 1].isIntersecting;
        this.#await();
      }).observe(this.session.fire);
    }
    this.#await();
  }

  #await() {
    cancelAnimationFrame(this.#frame);
    if (!this.#inSight || !this.#children.some(({ of }) => of)) return;
    this.#frame = requestAnimationFrame(() => {
      this.#follow();
      this.#await();
    });
  }

  #follow() {
    const { view, state, fire } = this.session;
    // Without a picture, boxes have no position in the domain.
    if (!state.started || !this.#children.some(({ of }) => of) || !fire.isConnected || !view.viewport(state.params))
      return;
    for (const child of this.#children) child.followTarget();
  }
}

/** Warns about an attribute without an effect. @type {(element: Element, name: string) => void} */
function spell({ localName }, name) {
  const known = attributesOf(KINDS[localName]);
  if (!known.includes(name))
    import('../attributes/spelling.js').then(
      ({ warnOnce }) => warnOnce(name, localName, known),
      () => {},
    );
}

for (const [name, kind] of Object.entries(globalThis.customElements ? KINDS : {})) {
  if (customElements.get(name)) continue;
  customElements.define(
    name,
    class extends HTMLElement {
      static observedAttributes = attributesOf(kind);

      /** The id of its object; null while the fire has none. */
      get objectId() {
        const child = CHILDREN.get(this);
        return child?.exists ? child.id : null;
      }

      /** @param {string} attribute */
      attributeChangedCallback(attribute) {
        CHILDREN.get(this)?.attribute(attribute);
      }
    },
  );
}
