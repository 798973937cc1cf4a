/**
 * How an element behaves on its page: drawing limits, pointer, panel, poster, text alternatives and
 * warnings about unknown attributes.
 */

import { CHOICES, LOUDEST, OBSERVED, isFlag, loudness } from './attributes.js';
import { alignment, panning } from '../view/viewport.js';

const LIMITS = ['fps-limit', 'max-pixels'];

/** Common attributes; the code for the others is loaded with the first of them. */
const COMMON = /^(class|id|style|slot|hidden|title|(data|aria)-.*)$/;

/** Warns about an attribute without an effect. @param {string} name */
function check(name) {
  if (OBSERVED.includes(name) || COMMON.test(name)) return;
  import('./spelling.js').then(
    ({ warnOnce }) => warnOnce(name),
    () => {},
  );
}

/** The page policies of one element. */
export class PagePolicies {
  #fire;
  #view;
  #session;
  #reports;
  /** Whether there is a connection to the engine. */
  #open = false;
  /** The last accepted limits. @type {Map<string, unknown>} */
  #limits = new Map();
  /** Whether the fire burns. */
  #burns = false;
  /** The colour bar, once it is loaded. @type {Promise<import('../view/scale.js').Scale> | undefined} */
  #scale;
  /** The `controls` attribute of the mounted panel. @type {string | null} */
  #controls = null;
  /** Removes the mounted panel. @type {AbortController | undefined} */
  #panel;
  /** Removes the pointer listeners. @type {AbortController | undefined} */
  #pointer;
  /** Observes the attributes that scripts set, and the children with what they contain. */
  #observer = new MutationObserver((records) => {
    for (const { attributeName, target } of records) {
      if (attributeName === null) this.#session.code.loadChildren();
      else if (target === this.#fire && this.#fire.hasAttribute(attributeName)) check(attributeName);
    }
  });

  /** @param {import('../session/session.js').FireSession} session */
  constructor(session) {
    this.#fire = session.fire;
    this.#view = session.view;
    this.#reports = session.reports;
    this.#session = session;
  }

  /** The element is on a page: checks the names of its attributes. */
  checkNames() {
    this.#fire.getAttributeNames().forEach(check);
    this.#observer.observe(this.#fire, { attributes: true, childList: true, subtree: true });
  }

  /** There is a connection to the engine: sends the limits. */
  begin() {
    this.#open = true;
    for (const name of LIMITS) {
      // A limit that was accepted before the element was removed is still valid.
      if (this.#limits.has(name)) this.#send(name, this.#limits.get(name));
      else if (this.#fire.hasAttribute(name)) this.#limit(name);
    }
    this.#listen();
  }

  /** The fire burns. */
  burns() {
    this.#burns = true;
    this.#control();
  }

  /** The element has lost its listeners: those of the panel are new with it. */
  listenAgain() {
    this.#listen();
    this.#controls = null;
    this.#panel?.abort();
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
   * Shows the colour bar, or hides it. Its code is loaded on request.
   * @param {string} [mode] the display mode
   * @param {[number, number] | null} [range] the values of the first and the last colour
   */
  async measure(mode, range) {
    if (range) {
      this.#scale ??= this.#reports
        .loads(import('../view/scale.js'), 'The colour bar')
        .then(({ Scale }) => new Scale(this.#view));
    }
    const scale = await this.#scale?.catch(() => undefined);
    // The next quantity loads it again.
    if (!scale && !range) this.#scale = undefined;
    scale?.show(mode, range);
  }

  /**
   * An attribute has changed.
   * @param {string} name
   * @param {string | null} value
   */
  change(name, value) {
    const choices = hasChoices(name) ? CHOICES[name] : undefined;
    if (choices && value !== null && !choices.some((choice) => choice === value)) {
      this.#reports.refuse(name, value, `one of ${choices.join(', ')}`);
    } else if (name === 'autoplay' && value && value !== 'false' && !isFlag(value)) {
      this.#reports.refuse(name, value, 'true or false');
    } else if (LIMITS.includes(name)) {
      if (this.#open) this.#limit(name);
      else this.#limits.delete(name);
    } else if (name === 'interactive') {
      this.#listen();
    } else if (name === 'fit' || name === 'align') {
      this.#applyFit();
    } else if (name === 'zoom' || name === 'pan') {
      this.#applyZoom();
    } else if (name === 'touch-action') {
      this.#touch(value ?? '');
    } else if (name === 'controls') {
      this.#control();
    } else if (name in LOUDEST) {
      if (value !== null && Number.isNaN(loudness(name, value)))
        this.#reports.refuse(name, value, `a number from 0 to ${LOUDEST[name]}`);
      this.#session.code.sound();
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
    this.#send(name, Number.isNaN(number) ? text : number);
  }

  /** @type {(name: string, value: unknown) => void} */
  #send(name, value) {
    this.#session.call(name.replace('-', '_'), value).then(
      () => this.#limits.set(name, value),
      () => {},
    );
  }

  /** Adds or removes the pointer listeners. */
  #listen() {
    this.#pointer?.abort();
    if (!this.#fire.interactive || !this.#open) return;
    this.#pointer = this.#load(
      import('../pointer/pointer.js'),
      'The code for pointers',
      ({ listenToPointer }, signal) => listenToPointer(this.#session, signal),
    );
  }

  /** Applies `fit` and `align`. */
  #applyFit() {
    const { fit, align } = this.#fire;
    const position = alignment(align || 'center bottom');
    if (!position) {
      this.#reports.refuse('align', align, 'one or two of left, center, right and top, center, bottom');
      return;
    }
    const [x, y] = position;
    Object.assign(this.#view.camera, { fit, x, y });
    this.#session.send('view', fit, x, y);
  }

  /** Applies `zoom` and `pan`. */
  #applyZoom() {
    const { pan } = this.#fire;
    const text = this.#fire.getAttribute('zoom') ?? '1';
    const zoom = text.trim() ? Number(text) : NaN;
    const position = panning(pan || '0.5 0.5');
    const { maxZoom } = this.#view;
    if (!(zoom >= 1 && zoom <= maxZoom)) {
      this.#reports.refuse('zoom', text, `a number from 1 to ${maxZoom}`);
    } else if (!position) {
      this.#reports.refuse('pan', pan, 'two numbers from 0 to 1');
    } else {
      const [panX, panY] = position;
      Object.assign(this.#view.camera, { zoom, panX, panY });
      this.#session.send('zoom', zoom, panX, panY);
    }
  }

  /** @param {string} action */
  #touch(action) {
    if (!action || CSS.supports('touch-action', action)) this.#view.root.style.touchAction = action;
    else this.#reports.refuse('touch-action', action, 'a value of CSS, such as auto, none, pan-y or manipulation');
  }

  /** Mounts or removes the panel. */
  #control() {
    const { controls } = this.#fire;
    const list = !this.#burns || controls === false ? null : controls === true ? '' : String(controls);
    if (list === this.#controls) return;
    this.#controls = list;
    this.#panel?.abort();
    if (list === null) return;
    this.#panel = this.#load(import('../controls/controls.js'), 'The panel', ({ mountControls }, signal) =>
      mountControls(this.#session, list, signal),
    );
  }

  /**
   * Loads code on request and runs it.
   * @template T
   * @param {Promise<T>} code
   * @param {string} what its name in the warning if it does not arrive
   * @param {(code: T, signal: AbortSignal) => unknown} run
   * @returns {AbortController} ends it
   */
  #load(code, what, run) {
    const running = new AbortController();
    const { signal } = running;
    this.#reports.loads(code, what).then(
      (loaded) => signal.aborted || run(loaded, signal),
      () => {},
    );
    return running;
  }
}

/** @type {(name: string) => name is keyof typeof CHOICES} */
function hasChoices(name) {
  return Object.hasOwn(CHOICES, name);
}
