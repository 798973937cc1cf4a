/**
 * Whether a fire plays: what its page requests, and the visitor's preference for reduced motion.
 */

import { isOn } from '../attributes/attributes.js';
import { setOrRemove } from '../plain-data.js';
import { motionIsReduced } from '../view/visibility.js';

/** The playback of one element. */
export class Playback {
  #session;
  #fire;
  #changed;
  /** Whether the fire is paused because the visitor prefers reduced motion. */
  #still = false;
  /** Whether the fire plays because the visitor pressed the button, despite that preference. */
  #stoppable = false;
  /**
   * The button, once it is loaded.
   * @type {Promise<import('../controls/playback-button.js').PlaybackButton> | undefined}
   */
  #button;
  paused = false;

  /**
   * @param {import('./session.js').FireSession} session
   * @param {(paused: boolean) => Promise<void>} changed sends it to the engine
   */
  constructor(session, changed) {
    this.#session = session;
    this.#fire = session.fire;
    this.#changed = changed;
  }

  /** @type {(paused: boolean, still?: boolean) => Promise<void>} */
  set(paused, still = false) {
    this.#stoppable = !paused && motionIsReduced() && (this.#still || this.#stoppable);
    this.paused = paused;
    this.#still = still;
    this.showButton();
    // A pause for reduced motion leaves the page's attribute alone.
    if (!still && isOn(this.#fire.getAttribute('paused')) !== paused)
      setOrRemove(this.#fire, 'paused', paused ? '' : null);
    return this.#changed(paused);
  }

  /** Shows the button that plays or pauses, or hides it. Its code is loaded on request. */
  async showButton(action = this.#fire.decorative ? '' : this.#still ? 'play' : this.#stoppable ? 'pause' : '') {
    if (action) {
      const press = () => void (this.#still ? this.set(false) : this.set(true, true));
      this.#button ??= this.#session.reports
        .loads(import('../controls/playback-button.js'), 'The playback button')
        .then(({ PlaybackButton }) => new PlaybackButton(this.#session.view, press));
    }
    // The next action loads it again.
    (await this.#button?.catch(() => (this.#button = undefined)))?.show(action);
  }

  /** The button has lost its listener: another takes its place. */
  listenAgain() {
    this.#button?.then(
      (button) => button.remove(),
      () => {},
    );
    this.#button = undefined;
    this.showButton();
  }

  /** Whether the fire is paused, and moves at once instead of gradually, for reduced motion. */
  prefersStill(reduced = motionIsReduced()) {
    return reduced && this.#fire.reducedMotion !== 'ignore';
  }

  /** Applies a change of the visitor's preference or of the attribute. @param {boolean} [reduced] */
  follow(reduced) {
    const still = this.prefersStill(reduced);
    if (still && !this.paused) this.set(true, true);
    else if (!still && this.#still) this.set(false);
  }

  /**
   * A new fire starts: whether it is paused for reduced motion.
   * @param {boolean} waits whether the page makes it wait for `play()`
   */
  start(waits) {
    const still = this.prefersStill() && (this.#still || !this.paused);
    if (still) {
      this.set(true, true);
    } else {
      if (this.#still) this.set(false);
      if (waits) this.set(true);
    }
    return still;
  }
}
