/** A card that moves and grows: by its head, which a pointer drags, by arrow keys, and for a projector by a button. */

import { element } from '../element/controls/icon-button.js';

/** How far an arrow key moves it [px]. */
const STEP = 40;

/** @type {{[key: string]: [number, number]}} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class Moves {
  handle = element('button', { type: 'button', title: 'Move: drag the head, or press arrow keys' }, 'Move');
  sizes = element('button', { type: 'button', 'aria-pressed': 'false', title: 'Larger, for a projector' }, 'Large');
  #card;
  #x = 0;
  #y = 0;

  /** @param {HTMLElement} card */
  constructor(card) {
    this.#card = card;
    this.handle.addEventListener('keydown', (event) => {
      const arrow = ARROWS[event.key];
      if (!arrow) return;
      event.preventDefault();
      // Arrow keys move no object meanwhile.
      event.stopPropagation();
      this.#by(STEP * arrow[0], STEP * arrow[1]);
    });
    this.sizes.addEventListener('click', () => {
      const large = card.classList.toggle('large');
      this.sizes.setAttribute('aria-pressed', String(large));
      this.#by(0, 0);
    });
  }

  /** Follows a pointer that drags it. @param {HTMLElement} head */
  follow(head) {
    head.addEventListener('pointerdown', (event) => {
      const { target } = event;
      if (event.button !== 0 || (target instanceof Element && target.closest('button:not(:first-child)'))) return;
      const ended = new AbortController();
      const { signal } = ended;
      let [x, y] = [event.clientX, event.clientY];
      head.setPointerCapture(event.pointerId);
      head.addEventListener(
        'pointermove',
        ({ clientX, clientY }) => {
          this.#by(clientX - x, clientY - y);
          [x, y] = [clientX, clientY];
        },
        { signal },
      );
      for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'])
        head.addEventListener(end, () => ended.abort(), { signal });
    });
  }

  /** Moves it within its parent. @type {(right: number, down: number) => void} */
  #by(right, down) {
    const [outer, inner] = [this.#card.parentElement, this.#card].map((box) => box?.getBoundingClientRect());
    if (!outer || !inner) return;
    this.#x += within(right, outer.left - inner.left, outer.right - inner.right);
    this.#y += within(down, outer.top - inner.top, outer.bottom - inner.bottom);
    this.#card.style.translate = `${this.#x}px ${this.#y}px`;
  }
}

/** @type {(value: number, least: number, most: number) => number} */
const within = (value, least, most) => Math.min(Math.max(value, Math.min(least, most)), Math.max(least, most));
