/**
 * `<hearth-source>` and `<hearth-solid>`: children of a fire that are objects in it. This code is loaded when
 * a fire has such a child.
 *
 * The engine gets the list of the children whole, at most once a frame and before a call of the page, and lays it over
 * the objects.
 *
 * @typedef {import('../../engine/engine.js').Message} Message
 * @typedef {import('../session/requests.js').Refusal} Refusal
 * @typedef {[child: Child, changed: string[]][]} Sent
 */

import { Child, KINDS, attributesOf } from './child.js';

/** The first number of a child, and so the first id of its object. Scenes count theirs from 1. */
const FIRST = 1001;

/** The child that an element is of a fire. @type {WeakMap<Element, Child>} */
const CHILDREN = new WeakMap();

/** The children of one fire that are objects. */
export class Children {
  /** In their order in the document. @type {Child[]} */
  #children = [];
  /** The children of each list that is not answered, with what they state anew. @type {Map<Promise<unknown>, Sent>} */
  sent = new Map();
  #last = FIRST - 1;
  /** Whether the list has changed, and whether it is about to be sent. */
  #isDirty = false;
  #isScheduled = false;
  /** Whether the fire is in sight; undefined before a child has a target. @type {boolean | undefined} */
  #inSight;
  #frame = 0;
  /** @type {Promise<void> | undefined} */
  #loading;
  /** @type {typeof import('./child-burning.js') | undefined} */
  #recipe;
  /** The last list. @type {import('./child-burning.js').Sent[]} */
  #list = [];

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
    this.#children = elements.map(
      (element) => before.find((child) => child.element === element) ?? this.#join(element),
    );
    for (const child of before.filter((old) => !this.#children.includes(old))) {
      child.look.close();
      child.names.disconnect();
      if (CHILDREN.get(child.element) === child) CHILDREN.delete(child.element);
    }
    for (const child of this.#children.filter((joined) => !before.includes(joined))) child.readTarget();
    if (this.#children.some((child, at) => child !== before[at]) || before.length !== this.#children.length)
      this.change();
  }

  /** @param {Element} element */
  #join(element) {
    const names = new MutationObserver((records) => {
      for (const { attributeName: name } of records) if (name && element.hasAttribute(name)) spell(element, name);
      // A child may name a solid by its id.
      if (records.some(({ attributeName }) => attributeName === 'id')) this.change();
    });
    names.observe(element, { attributes: true });
    const child = new Child(this, element, this.nextNumber(), names);
    CHILDREN.set(element, child);
    for (const name of element.getAttributeNames()) spell(element, name);
    return child;
  }

  /** The next number that no object has. */
  nextNumber() {
    do this.#last += 1;
    while (this.session.state.objects.some(({ id }) => id === this.#last));
    return this.#last;
  }

  /** The code of what burns and of words: undefined until it is loaded, which happens with the first such child. */
  recipe() {
    this.#loading ??= this.session.reports.loads(import('./child-burning.js'), 'The code for what burns').then(
      (recipe) => {
        this.#recipe = recipe;
        this.change();
      },
      () => {},
    );
    return this.#recipe;
  }

  /** The list has changed: it is sent with the next frame, or at once where there is none. */
  change() {
    this.#isDirty = true;
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    const send = () => {
      this.#isScheduled = false;
      this.send();
    };
    if (this.session.live && !document.hidden) requestAnimationFrame(send);
    else queueMicrotask(send);
  }

  /** Sends the list, if it has changed. */
  send() {
    if (!this.#isDirty) return;
    this.#isDirty = false;
    /** @type {Sent} */
    const sent = [];
    const list = this.#children.flatMap((child) => {
      const fields = child.take();
      for (const { changed } of fields) sent.push([child, changed]);
      return fields;
    });
    this.#list = list;
    const answer = this.session.call('children', list);
    this.sent.set(answer, sent);
    this.#recipe?.refine(this.session, list);
    answer
      .catch((/** @type {{errors?: Refusal[]}} */ { errors }) => {
        // The engine has stopped before an answer. The next one gets the list.
        if (errors) return;
        this.#isDirty = true;
        for (const [child, changed] of sent) child.restate(changed);
      })
      .finally(() => this.sent.delete(answer));
  }

  /** The child of this kind with an id in the document. @type {(kind: string, id: string) => Child | undefined} */
  childWith(kind, id) {
    return this.#children.find((child) => child.kind === kind && child.element.id === id);
  }

  /**
   * The refusals of a list, which name the element and the attribute; undefined for other calls.
   * @type {(errors: Refusal[], call: Promise<unknown> | undefined) => Refusal[] | undefined}
   */
  named(errors, call) {
    const sent = call && this.sent.get(call);
    if (!sent) return undefined;
    return errors.flatMap((error) => {
      const [, index, property] = /^children\[(\d+)\]\.(.*)$/.exec(error.id) ?? [];
      const child = sent[Number(index)]?.[0];
      return property && child ? (child.refusal(property, error) ?? []) : error;
    });
  }

  /** The fire has begun, or its settings have changed. @param {Message} message */
  report({ type }) {
    if (type === 'ready' && (this.#isDirty || this.#children.some(({ waits }) => waits))) this.change();
    if (this.#children.filter((child) => child.updateReference()).length > 0) this.change();
    this.#follow(type === 'ready');
    this.#recipe?.refine(this.session, this.#list);
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

  /** Reads the targets, unless a list is not answered. */
  #follow(always = false) {
    if (this.sent.size > 0 && !always) return;
    if (this.#children.filter((child) => child.follow()).length === 0) return;
    this.#isDirty = true;
    this.send();
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
        return CHILDREN.get(this)?.object?.id ?? null;
      }

      /** @param {string} attribute */
      attributeChangedCallback(attribute) {
        CHILDREN.get(this)?.attribute(attribute);
      }
    },
  );
}
