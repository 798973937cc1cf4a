/**
 * How an element behaves on its page: drawing limits, pointer, panel, poster, text alternatives and
 * warnings about unknown attributes.
 */

import { CHOICES, ID_OF_ATTRIBUTE, OBSERVED } from './attributes.js';
import { alignment } from './viewport.js';

const LIMITS = ['fps-limit', 'max-pixels'];

/** Common attributes; the code that knows the others is loaded only for those. */
const USUAL = /^(class|id|style|slot|hidden|title|(data|aria)-.*)$/;

/** Reports attributes that are set on fires of the page. */
const names = globalThis.MutationObserver && new MutationObserver((records) => {
  for (const { target, attributeName } of records) {
    if (/** @type {Element} */ (target).hasAttribute(attributeName ?? '')) spell(attributeName ?? '');
  }
});

/** Warns of an attribute that has no effect. @param {string} name */
function spell(name) {
  if (OBSERVED.includes(name) || USUAL.test(name)) return;
  import('./spelling.js').then(({ tell }) => tell(name), () => {});
}

/** The page policies of one element. */
export class PagePolicies {
  #fire;
  #view;
  #session;
  /** Whether there is a connection to the engine. */
  #open = false;
  /** The last accepted limits. @type {Map<string, unknown>} */
  #limits = new Map();
  /** Whether the fire burns. */
  #burns = false;
  /** The colour bar, once it is loaded. @type {Promise<import('./scale.js').Scale | void> | undefined} */
  #scale;
  /** The `controls` attribute of the mounted panel. @type {string | null} */
  #controls = null;
  /** Removes the mounted panel. @type {(() => void) | undefined} */
  #hidePanel;
  /** Removes the pointer listeners. @type {(() => void) | undefined} */
  #ignorePointer;

  /**
   * @param {import('./session.js').FireSession} session
   */
  constructor(session) {
    this.#fire = session.fire;
    this.#view = session.view;
    this.#session = session;
  }

  /** The element is on a page: checks the names of its attributes. */
  watch() {
    this.#fire.getAttributeNames().forEach(spell);
    names?.observe(this.#fire, { attributes: true });
  }

  /** There is a connection to the engine: sends the limits. */
  begin() {
    this.#open = true;
    for (const name of LIMITS) {
      // A limit that was accepted before the element was removed is still valid.
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
   * Shows the colour bar, or hides it. Its code is loaded on demand.
   * @param {string} [mode] the display
   * @param {[number, number] | null} [ends] the values of its first and its last colour
   */
  async measure(mode, ends) {
    if (ends) {
      this.#scale ??= import('./scale.js').then(
        ({ Scale }) => new Scale(this.#view.root),
        (why) => this.#session.reports.warn('load', `The bar of colours could not be loaded: ${why}`),
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
    const choices = hasChoices(name) ? CHOICES[name] : undefined;
    if (choices && value !== null && !choices.some((one) => one === value)) {
      this.#session.reports.refuse(name, value, `one of ${choices.join(', ')}`);
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

  /** Sends a drawing limit; the engine refuses text that is not a number. @param {string} name */
  #limit(name) {
    const text = this.#fire.getAttribute(name) ?? undefined;
    const number = text?.trim() ? Number(text) : NaN;
    this.#ask(name, Number.isNaN(number) ? text : number);
  }

  /** @type {(name: string, value: unknown) => void} */
  #ask(name, value) {
    const asked = this.#session.ask(name.replace('-', '_'), value);
    asked.then(() => this.#limits.set(name, value), () => {});
  }

  /** Adds or removes the pointer listeners. Their code is loaded on demand. */
  #listen() {
    this.#ignorePointer?.();
    this.#ignorePointer = undefined;
    if (!this.#fire.interactive || !this.#open) return;
    const ended = new AbortController();
    this.#ignorePointer = () => ended.abort();
    const ways = {
      send: (/** @type {import('../engine/engine.js').Call} */ ...call) => this.#session.send(...call),
      move: (/** @type {number} */ x) => this.#session.ask('set', { source_x: x }, 'pointer').catch(() => {}),
    };
    import('./pointer.js').then(
      ({ listenToPointer }) => ended.signal.aborted || listenToPointer(this.#fire, this.#view.root, ways, ended.signal),
      (why) => this.#session.reports.warn('load', `What listens to pointers could not be loaded: ${why}`),
    );
  }

  /** Applies `fit` and `align`. */
  #look() {
    const { fit, align } = this.#fire;
    const place = alignment(align || 'center bottom');
    if (!place) {
      this.#session.reports.refuse('align', align, 'one or two of left, center, right and top, center, bottom');
      return;
    }
    const [x, y] = place;
    this.#view.camera = { fit, x, y };
    this.#session.send('view', fit, x, y);
  }

  /** @param {string} action */
  #touch(action) {
    if (!action || CSS.supports('touch-action', action)) this.#view.setTouchAction(action);
    else this.#session.reports.refuse('touch-action', action, 'a value of CSS, as auto, none, pan-y or manipulation');
  }

  #control() {
    const wanted = this.#burns ? this.#fire.getAttribute('controls') : null;
    if (wanted === this.#controls) return;
    this.#controls = wanted;
    this.#hidePanel?.();
    const failed = (/** @type {unknown} */ why) => this.#session.reports.warn('load', `The panel could not be loaded: ${why}`);
    this.#hidePanel = wanted === null ? undefined : showPanel(this.#fire, this.#only(wanted), failed);
  }

  /**
   * The parameters that a list names; undefined means all of them.
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
    const { meant } = await import('./spelling.js').catch(() => ({ meant: () => '' }));
    const ids = [...ID_OF_ATTRIBUTE.values()];
    this.#session.reports.refuse('controls', name, `a list of parameters${meant(name, ids)}`);
  }
}

/** @type {(name: string) => name is keyof typeof CHOICES} */
function hasChoices(name) {
  return Object.hasOwn(CHOICES, name);
}

/** Values of `controls` that mean all parameters. */
const YES = ['true', 'controls'];

/**
 * Mounts the panel inside its fire. Its code is loaded on demand.
 * @param {import('../hearth-fire.js').HearthFire} fire
 * @param {string[] | undefined} only the parameters to show; undefined means all of them
 * @param {(why: unknown) => void} fail
 * @returns {() => void} removes the panel
 */
function showPanel(fire, only, fail) {
  const host = document.createElement('div');
  host.className = 'panel';
  host.setAttribute('part', 'panel');
  fire.shadowRoot?.append(host);
  let ended = false;
  const mounted = import('../panel.js').then(({ mountPanel }) => (ended ? undefined : mountPanel({ host, fire, only })));
  mounted.catch((error) => {
    host.remove();
    if (!ended) fail(error);
  });
  return () => {
    ended = true;
    mounted.then((panel) => panel?.destroy(), () => {});
    host.remove();
  };
}
