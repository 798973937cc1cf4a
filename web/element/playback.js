/**
 * Whether a fire plays: what its page asks for, and what a visitor does who wants less motion.
 */

import { motionIsReduced } from './visibility.js';

/** The playback of one element. */
export class Playback {
  #fire;
  #view;
  #changed;
  /** Whether it stands still because the visitor wants less motion. */
  #still = false;
  /** Whether it burns although the visitor wants less motion, who pressed the button. */
  #stoppable = false;
  paused = false;

  /**
   * @param {import('../hearth-fire.js').HearthFire} fire
   * @param {import('./view.js').FireView} view
   * @param {(paused: boolean) => Promise<void>} changed tells the engine
   */
  constructor(fire, view, changed) {
    this.#fire = fire;
    this.#view = view;
    this.#changed = changed;
  }

  /** @type {(paused: boolean, still?: boolean) => Promise<void>} */
  set(paused, still = false) {
    // A visitor who wants less motion and lets it burn can stop it again.
    this.#stoppable = !paused && motionIsReduced() && (this.#still || this.#stoppable);
    this.paused = paused;
    this.#still = still;
    this.offer();
    // The attribute is the page's; standing still for a visitor leaves it alone.
    if (!still && this.#fire.hasAttribute('paused') !== paused) this.#fire.toggleAttribute('paused', paused);
    return this.#changed(paused);
  }

  /** The visitor presses the button in the picture. */
  press() {
    if (this.#still) this.set(false);
    else this.set(true, true);
  }

  /** Shows the button that plays or pauses, where the visitor needs one. */
  offer() {
    this.#view.offer(this.#still ? 'play' : this.#stoppable ? 'pause' : '');
  }

  /** Whether the fire moves less, because its visitor wants that. */
  isCalm(reduced = motionIsReduced()) {
    return reduced && this.#fire.reducedMotion !== 'ignore';
  }

  /** Applies a change of the visitor's preference or of the attribute. @param {boolean} [reduced] */
  follow(reduced) {
    const still = this.isCalm(reduced);
    if (still && !this.paused) this.set(true, true);
    else if (!still && this.#still) this.set(false);
  }

  /**
   * A new fire is about to start; whether it stands still for its visitor.
   * @param {boolean} waits whether its page wants it to wait for `play()`
   */
  start(waits) {
    // One that stood still for its visitor when it was taken off does so again.
    const still = this.isCalm() && (this.#still || !this.paused);
    if (still) {
      this.set(true, true);
    } else {
      if (this.#still) this.set(false);
      if (waits) this.set(true);
    }
    return still;
  }
}
