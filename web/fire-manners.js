/**
 * What of an element has to do with the page around it: how much it may draw, a
 * pointer that stirs it, its panel, its poster and its words.
 *
 * @typedef {import('./engine.js').Call} Call
 * @typedef {object} Ways what the element does for its parts
 * @property {any} fire the element
 * @property {(...call: Call) => Promise<void>} ask calls the engine
 * @property {(...call: Call) => void} send calls the engine, whose answer nobody waits for
 * @property {(id: string, value: string, allowed: string) => unknown} refuse
 * @property {(kind: string, message: string) => void} complain
 * @property {(colour: string, fire: Element) => string} hexOf
 * @property {() => boolean} isCalm whether it moves less, since its visitor wants that
 */

import { CHOICES, ID_OF_ATTRIBUTE, OBSERVED } from './fire-attributes.js';
import { alignment } from './fire-place.js';

const LIMITS = ['fps-limit', 'max-pixels'];

/** Attributes that need no look at what others there may be. */
const USUAL = /^(class|id|style|slot|hidden|title|(data|aria)-.*)$/;

/** What is written on the fires of the page. */
const names = globalThis.MutationObserver && new MutationObserver((records) => {
  for (const { target, attributeName } of records) {
    if (/** @type {Element} */ (target).hasAttribute(attributeName ?? '')) spell(attributeName ?? '');
  }
});

/** Says that an attribute does nothing, where it does nothing. @param {string} name */
function spell(name) {
  if (OBSERVED.includes(name) || USUAL.test(name)) return;
  import('./fire-spelling.js').then(({ tell }) => tell(name), () => {});
}

/** The manners of one element. */
export class FireManners {
  #fire;
  #view;
  #ways;
  /** Whether there is a link to the engine, and whether the fire burns. */
  #open = false;
  /** The last good limits. @type {Map<string, unknown>} */
  #limits = new Map();
  #burns = false;
  /** The bar of colours, where there was one. @type {Promise<any> | undefined} */
  #scale;
  /** The attribute of the panel that is there. @type {string | null} */
  #controls = null;
  /** Takes the panel away, where there is one. @type {(() => void) | undefined} */
  #hidePanel;
  /** Stops listening to pointers, where it listens. @type {(() => void) | undefined} */
  #ignorePointer;

  /**
   * @param {Ways} ways
   * @param {import('./fire-view.js').FireView} view
   */
  constructor(ways, view) {
    this.#fire = ways.fire;
    this.#view = view;
    this.#ways = ways;
  }

  /** It is on a page: what is written on it is looked at. */
  watch() {
    this.#fire.getAttributeNames().forEach(spell);
    names?.observe(this.#fire, { attributes: true });
  }

  /** There is a link to the engine: it is told what it was not told before. */
  begin() {
    this.#open = true;
    for (const name of LIMITS) {
      // One that was good before the element was taken off is good again.
      if (this.#limits.has(name)) this.#ask(name, this.#limits.get(name));
      else if (this.#fire.hasAttribute(name)) this.#limit(name);
    }
    this.#listen();
  }

  /** The fire burns. */
  burns() {
    this.#burns = true;
    this.#control();
  }

  /** The fire is gone. */
  end() {
    this.measure();
    this.#open = this.#burns = false;
    this.#control();
    this.#listen();
  }

  /**
   * Shows which colour is how much, or that none is. Its code is loaded only here.
   * @param {string} [mode] the display
   * @param {[number, number] | null} [ends] what its first and its last colour stand for
   */
  async measure(mode, ends) {
    if (ends) {
      this.#scale ??= import('./scale.js').then(
        ({ Scale }) => new Scale(this.#view.root),
        (why) => this.#ways.complain('load', `The bar of colours could not be loaded: ${why}`),
      );
    }
    (await this.#scale)?.show(mode, ends);
  }

  /**
   * An attribute has changed.
   * @param {string} name
   * @param {string | null} value
   */
  change(name, value) {
    if (Object.hasOwn(CHOICES, name) && value !== null && !CHOICES[name].includes(value)) {
      this.#ways.refuse(name, value, `one of ${CHOICES[name].join(', ')}`);
    } else if (LIMITS.includes(name)) {
      if (this.#open) this.#limit(name);
      else this.#limits.delete(name);
    } else if (name === 'interactive') {
      this.#listen();
    } else if (name === 'fit' || name === 'align') {
      this.#look();
    } else if (name === 'touch-action') {
      this.#touch(value ?? '');
    } else if (name === 'controls') {
      this.#control();
    } else if (name === 'poster') {
      this.#view.setPoster(value ?? '');
    } else if (name === 'alt') {
      this.#view.describe(value ?? '');
    }
  }

  /** How much it may draw; what is no number is the engine's to refuse. @param {string} name */
  #limit(name) {
    const text = this.#fire.getAttribute(name) ?? undefined;
    const number = text?.trim() ? Number(text) : NaN;
    this.#ask(name, Number.isNaN(number) ? text : number);
  }

  /** @type {(name: string, value: unknown) => void} */
  #ask(name, value) {
    const asked = this.#ways.ask(name.replace('-', '_'), value);
    asked.then(() => this.#limits.set(name, value), () => {});
  }

  /** Listens to pointers where it should. The code of that is loaded only then. */
  #listen() {
    this.#ignorePointer?.();
    this.#ignorePointer = undefined;
    if (!this.#fire.interactive || !this.#open) return;
    const ended = new AbortController();
    this.#ignorePointer = () => ended.abort();
    const ways = {
      send: this.#ways.send,
      move: (x) => this.#ways.ask('set', { source_x: x }, 'pointer').catch(() => {}),
    };
    import('./fire-pointer.js').then(
      ({ listenToPointer }) => ended.signal.aborted || listenToPointer(this.#fire, this.#view.root, ways, ended.signal),
      (why) => this.#ways.complain('load', `What listens to pointers could not be loaded: ${why}`),
    );
  }

  /** Which part of its world is seen. */
  #look() {
    const { fit, align } = this.#fire;
    const [x, y] = alignment(align || 'center bottom') ?? [];
    if (y === undefined) {
      this.#ways.refuse('align', align, 'one or two of left, center, right and top, center, bottom');
      return;
    }
    this.#view.camera = { fit, x, y };
    this.#ways.send('view', fit, x, y);
  }

  /** @param {string} action */
  #touch(action) {
    if (!action || CSS.supports('touch-action', action)) this.#view.setTouchAction(action);
    else this.#ways.refuse('touch-action', action, 'a value of CSS, as auto, none, pan-y or manipulation');
  }

  #control() {
    const wanted = this.#burns ? this.#fire.getAttribute('controls') : null;
    if (wanted === this.#controls) return;
    this.#controls = wanted;
    this.#hidePanel?.();
    const failed = (why) => this.#ways.complain('load', `The panel could not be loaded: ${why}`);
    this.#hidePanel = wanted === null ? undefined : showPanel(this.#fire, this.#only(wanted), failed);
  }

  /**
   * The parameters that a list names; undefined: all.
   * @param {string} list
   */
  #only(list) {
    const known = [];
    for (const name of list.split(/[\s,]+/).filter((one) => one && !YES.includes(one))) {
      const id = ID_OF_ATTRIBUTE.get(name.replaceAll('_', '-'));
      if (id) known.push(id);
      else this.#misspelt(name);
    }
    return known.length > 0 ? known : undefined;
  }

  /** @param {string} name */
  async #misspelt(name) {
    const { meant } = await import('./fire-spelling.js').catch(() => ({ meant: () => '' }));
    const ids = [...ID_OF_ATTRIBUTE.values()];
    this.#ways.refuse('controls', name, `a list of parameters${meant(name, ids)}`);
  }
}

/** Ways to say that there is a panel, besides naming the attribute alone. */
const YES = ['true', 'controls'];

/**
 * Shows the panel of a fire inside it. Its code is loaded only here.
 * @param {any} fire
 * @param {string[] | undefined} only the parameters that it shows, if not all
 * @param {(why: unknown) => void} fail
 * @returns {() => void} takes it away
 */
function showPanel(fire, only, fail) {
  const host = document.createElement('div');
  host.className = 'panel';
  host.setAttribute('part', 'panel');
  fire.shadowRoot.append(host);
  let ended = false;
  const mounted = import('./panel.js').then(({ mountPanel }) => !ended && mountPanel({ host, fire, only }));
  mounted.catch((error) => {
    host.remove();
    if (!ended) fail(error);
  });
  return () => {
    ended = true;
    mounted.then((panel) => panel && panel.destroy(), () => {});
    host.remove();
  };
}
