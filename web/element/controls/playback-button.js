/**
 * The button that plays a fire that is paused for reduced motion, and pauses it again. Its code is
 * loaded for visitors who prefer reduced motion.
 */

import { iconButton } from './icon-button.js';

const STYLES = /* css */ `
.play {
  position: absolute; inset: 50% auto auto 50%; display: grid; place-items: center; inline-size: 64px; block-size: 64px; padding: 0;
  border: 2px solid; border-radius: 50%; background: rgb(0 0 0 / 0.6); color: #fff; translate: -50% -50%; cursor: pointer; pointer-events: auto;
}
.play[hidden] { display: none; }
.play[data-does='pause'], .root[data-tools='row'] > .play {
  inset: auto auto 8px 10px; inline-size: 44px; block-size: 44px; translate: none;
}
.root[data-tools='column'] > .play[data-does='pause'] { left: calc(154px + 2 * max(12px, env(safe-area-inset-left))); }
.play:hover { background: rgb(0 0 0 / 0.8); }
.play:focus-visible { outline: 3px solid #ffb454; outline-offset: 3px; }
.play svg { inline-size: 28px; block-size: 28px; fill: currentcolor; translate: 2px 0; }
.play[data-does='pause'] svg { inline-size: 20px; block-size: 20px; translate: none; }
`;

/** The icon and the label of each action. */
const ACTIONS = {
  play: ['M5 3v18l16-9z', 'Play the fire'],
  pause: ['M5 3h5v18H5zM14 3h5v18h-5z', 'Pause the fire'],
};

/** The views that have the styles of the button. @type {WeakSet<import('../view/view.js').FireView>} */
const STYLED = new WeakSet();

/** The button of one element. */
export class PlaybackButton {
  #button = iconButton('', { class: 'play', part: 'play' });

  /**
   * @param {import('../view/view.js').FireView} view
   * @param {() => void} press what the button does
   */
  constructor(view, press) {
    this.#button.addEventListener('click', press);
    if (!STYLED.has(view)) view.style(STYLES);
    STYLED.add(view);
    view.root.append(this.#button);
  }

  remove() {
    this.#button.remove();
  }

  /** Offers an action, or none. @param {string} action */
  show(action) {
    this.#button.hidden = !action;
    if (action !== 'play' && action !== 'pause') return;
    const [shape, label] = ACTIONS[action];
    this.#button.dataset.does = action;
    this.#button.setAttribute('aria-label', label);
    this.#button.querySelector('path')?.setAttribute('d', shape);
  }
}
