/**
 * The code of one session that is loaded on request: children that are objects, style hooks, transitions, pictures.
 *
 * @typedef {import('../../engine/engine.js').Call} Call
 * @typedef {import('../../engine/engine.js').Message} Message
 * @typedef {import('./requests.js').Refusal} Refusal
 */

import { postable } from '../plain-data.js';
import { quiet } from '../promises.js';

/** The names of what can fail, in warnings. */
const CHILDREN = 'The code for children';
const HOOKS = 'The code for style hooks';
const SOUND = 'The code for sound';

/** The code of one session. */
export class OnDemandCode {
  #session;
  /** The style hooks, once they are loaded. @type {import('../view/css-hooks.js').CssHooks | undefined} */
  #css;
  /**
   * The children that are objects, once their code is loaded.
   * @type {import('../children/children.js').Children | undefined}
   */
  #children;
  /** The sound, once its code is loaded. @type {import('../../sound/player.js').Player | undefined} */
  #player;
  /** What is loaded or loading, by its name. @type {Map<string, Promise<void>>} */
  #loading = new Map();
  /** The code that has failed, which has warned. @type {Set<string>} */
  #failed = new Set();
  /** The calls since the first transition. @type {import('./transition.js').Calls | undefined} */
  #calls;

  /** @param {import('./session.js').FireSession} session */
  constructor(session) {
    this.#session = session;
  }

  /**
   * Loads code once and does something with it. Without it the fire burns on, and the next call loads it again.
   * @template T
   * @param {string} what its name in the warning if it does not arrive
   * @param {() => Promise<T>} load
   * @param {(code: T) => void} use
   */
  #once(what, load, use) {
    if (this.#loading.has(what)) return;
    this.#loading.set(
      what,
      this.#session.reports.loads(load(), what).then(
        (code) => this.#use(what, () => use(code)),
        () => void this.#loading.delete(what),
      ),
    );
  }

  /** Uses code without which the fire burns: its first failure is a warning. @type {(what: string, act: () => void) => void} */
  #use(what, act) {
    try {
      act();
    } catch (why) {
      if (!this.#failed.has(what)) this.#session.reports.warn('load', `${what} has failed: ${why}`);
      this.#failed.add(what);
    }
  }

  /** Records a call for the transitions. @type {(call: Call, answer: Promise<unknown>) => void} */
  record(call, answer) {
    this.#calls?.push([call, answer]);
  }

  /**
   * Starts a transition. From then on, the calls of the fire are recorded for it.
   * @type {(values: object, how: import('../types.js').HearthTransition | undefined) => Promise<boolean>}
   */
  move(values, how) {
    const session = this.#session;
    this.#calls ??= [];
    const calls = this.#calls;
    const checked = session.call('check', postable(values, 1));
    const source = session.history.source('to');
    const code = session.reports.loads(import('./transition.js'), 'The code for transitions');
    code.catch(() => (this.#calls = undefined));
    return quiet(code.then(({ run }) => run(calls, session, checked, how, source)));
  }

  /** Sets all final values of transitions at once. */
  endTransitions() {
    this.#calls?.end?.();
  }

  /**
   * Calls a function of `capture.js` when the fire is presented.
   * @type {(name: 'toBlob' | 'captureStream' | 'record', ...options: any) => Promise<any>}
   */
  capture(name, ...options) {
    const session = this.#session;
    const loading = session.reports.loads(import('../pictures/capture.js'), 'The code for pictures');
    const code = /** @type {Promise<{[name: string]: Function}>} */ (loading);
    return quiet(Promise.all([code, session.ready]).then(([functions]) => functions[name](session, ...options)));
  }

  /** The element may have other children. The code for those that are objects is loaded with the first one. */
  async loadChildren(begins = this.#session.begun) {
    const { fire } = this.#session;
    if (fire.querySelector(':scope>:not([slot],hearth-source,hearth-solid)')) {
      import('../attributes/spelling.js').then(
        ({ warnOfContent }) => warnOfContent(fire),
        () => {},
      );
    }
    if (begins && fire.querySelector('hearth-source,hearth-solid')) {
      const load = () => import('../children/children.js');
      this.#once(CHILDREN, load, ({ Children }) => (this.#children = new Children(this.#session)));
    }
    await this.#loading.get(CHILDREN);
    this.#use(CHILDREN, () => this.#children?.update());
  }

  /** Whether the code of children is loaded. */
  get hasChildren() {
    return Boolean(this.#children);
  }

  /** Sends the children before a call of the page, if they have changed. */
  sendChildren() {
    this.#use(CHILDREN, () => this.#children?.send());
  }

  /** Passes a report of the engine to the children. @param {Message} message */
  reportToChildren(message) {
    this.#use(CHILDREN, () => this.#children?.report(message));
  }

  /**
   * Refused values, which name the child if a child has sent them.
   * @type {(errors: Refusal[], call: Promise<unknown> | undefined) => Refusal[]}
   */
  named(errors, call) {
    return this.#children?.named(errors, call) ?? errors;
  }

  /** Sets or removes `:state(burning)`. The code is loaded with the first frame. @param {boolean} burning */
  setBurning(burning) {
    const { fire, view } = this.#session;
    if (burning) {
      const load = () => import('../view/css-hooks.js');
      this.#once(HOOKS, load, ({ CssHooks }) => {
        this.#css = new CssHooks(fire, view);
        this.#session.updateBurning();
      });
    }
    this.#use(HOOKS, () => this.#css?.burning(burning));
  }

  /** The sound may be another. Its code is loaded with the first volume above 0. @param {boolean} [renew] */
  sound(renew) {
    const session = this.#session;
    if (session.fire.sound > 0) {
      const load = () => import('../../sound/player.js');
      this.#once(SOUND, load, ({ Player }) => (this.#player = new Player(session)));
    }
    this.#use(SOUND, () => (renew ? this.#player?.renew() : this.#player?.update()));
  }

  /** Passes the samples of a frame to the sound. @param {Message} message */
  playSamples({ samples }) {
    this.#use(SOUND, () => this.#player?.receive(samples));
  }

  /** The sound, if there is any. */
  get player() {
    return this.#player;
  }

  /**
   * Sets the custom properties of light, or removes them.
   * @type {(power?: number, glow?: string) => void}
   */
  setLight(power, glow) {
    this.#use(HOOKS, () => this.#css?.light(power, glow));
  }
}
