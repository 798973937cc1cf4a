/**
 * The mask of a picture or of the glyphs of a text on the page. This code is loaded when `of` names
 * such an element.
 *
 * A mask is made when the picture, the text or its size changes, not when the element moves: it is kept with
 * its share of the border box.
 *
 * @typedef {import('./child-box.js').Box} Box
 * @typedef {{left: number, top: number, width: number, height: number}} Rect in pixels of the window
 * @typedef {object} Drawing
 * @property {Rect} outer  The border box of an element.
 * @property {Rect} box  The part of it that is drawn.
 * @property {(context: import('../../mask/opacity.js').Context) => void} draw  Draws that in pixels of the window.
 * @property {string} [key]  Differs where that looks different; undefined where only pixels tell.
 * @property {string[]} [lacks]  What the page draws there besides.
 */

import { contextOf, opacityOf } from '../../mask/opacity.js';
import { imageIn, isComplete } from './picture-of-image.js';
import { isAnimated } from './picture-of-svg.js';
import { glyphsIn, extentOf } from './picture-of-text.js';

/** The most pixels of the longer side of a mask, and those of a CSS pixel. */
const PIXELS = 256;
const DENSITY = 2;

/** Pixels of the drawing across a pixel of the mask: canvases move glyphs to whole pixels. */
const FINENESS = 4;

/** A mask without a transparent pixel. */
const OPAQUE = /^\d+x\d+:[Po-z\d_-]+$/;

/** How long an image or a font may load before its box or another font replaces it [ms]. */
const LOAD_WAIT_MS = 3000;

/** The least time between two masks of an element, and between two looks that find the same picture again [ms]. */
const PAUSE = 100;
const MAX_PAUSE = 1000;

/**
 * Lengths are compared in quarters of a pixel. Layouts have 64ths, and none of them lies where rounding may go both
 * ways.
 */
const GRID = 4;
const OFF_GRID = 0.123;

/** The largest sine of the angle of an element that is not turned. */
const LEVEL = 1e-3;

/** What changes the looks of elements without a mutation. */
const STIRRING = [
  'animationend',
  'change',
  'focusin',
  'focusout',
  'load',
  'pointerout',
  'pointerover',
  'transitionend',
];
const SCHEMES = matchMedia('(prefers-color-scheme: dark)');

/** A picture or a text that is followed. */
export class Picture {
  #warn;
  /**
   * What is opaque, with its sides as shares of the border box; null if nothing is, `box` if the box replaces it,
   * undefined until it is known.
   * @type {{mask: string, left: number, right: number, top: number, bottom: number} | 'box' | null | undefined}
   */
  opacity;
  /** Whether it has changed since the mask was made. */
  #stale = true;
  /** The style and the lengths of the last look. */
  #style = '';
  /** What the mask was made of, whether that moved by itself at the last look, and how long to wait for the next one. */
  #key = '';
  #moved = false;
  #pause = PAUSE;
  #since = performance.now();
  /** When a mask was made last, and how often one was begun. */
  #last = -Infinity;
  #begun = 0;
  #following = new AbortController();
  #observer = new MutationObserver(() => {
    this.#stale = true;
  });

  /**
   * @param {Element} target
   * @param {boolean} glyphs whether it is a text
   * @param {(how: string) => void} warn reports how it counts
   */
  constructor(target, glyphs, warn) {
    this.target = target;
    this.glyphs = glyphs;
    this.#warn = warn;
    const { signal } = this.#following;
    // Styles of the page reach from any element to the parts of any other. A picture of pixels has no parts.
    const hasParts = glyphs || target.localName === 'svg';
    for (const root of hasParts ? new Set([document, target.getRootNode()]) : [target])
      this.#observer.observe(root, { attributes: true, characterData: true, childList: true, subtree: true });
    const stir = () => {
      this.#stale = true;
    };
    const change = () => {
      this.#key = '';
      stir();
    };
    for (const type of ['load', 'error']) target.addEventListener(type, change, { signal });
    document.fonts?.addEventListener('loadingdone', change, { signal });
    if (!hasParts) return;
    for (const type of STIRRING) document.addEventListener(type, stir, { signal, capture: true, passive: true });
    SCHEMES.addEventListener('change', stir, { signal });
  }

  close() {
    this.#begun += 1;
    this.#observer.disconnect();
    this.#following.abort();
  }

  /** See `Look.of`. @param {Box} box @returns {Box & {mask?: string} | null | undefined} */
  look(box) {
    const now = performance.now();
    if (this.#changes(box)) [this.#stale, this.#key] = [true, ''];
    if (now - this.#last >= this.#pause && this.#moves()) this.#stale = true;
    if (this.#stale && now - this.#last >= (this.#key ? this.#pause : PAUSE)) {
      const waits = now - this.#since < LOAD_WAIT_MS;
      const loads = this.glyphs ? document.fonts?.status === 'loading' && waits : !isComplete(this.target);
      if (!loads) {
        this.#stale = false;
        this.#last = now;
        this.#make();
      } else if (!waits && this.opacity === undefined) {
        this.#resort('it has not loaded');
      }
    }
    const opacity = this.opacity;
    if (opacity === 'box') return box;
    if (!opacity) return opacity;
    const [width, height] = [box.right - box.left, box.bottom - box.top];
    return {
      mask: opacity.mask,
      left: box.left + opacity.left * width,
      right: box.left + opacity.right * width,
      top: box.top + opacity.top * height,
      bottom: box.top + opacity.bottom * height,
      radius: 0,
    };
  }

  /** Whether its style or its size has changed. @param {Box} box */
  #changes({ left, right, top, bottom }) {
    const { target } = this;
    const { offsetWidth, offsetHeight } = /** @type {HTMLElement} */ (target);
    const [across, up] = [right - left, bottom - top];
    const [wide, high] = offsetWidth ? [across / offsetWidth, up / offsetHeight] : [1, 1];
    const css = getComputedStyle(target);
    const lengths = [across / wide, up / high, (100 * wide) / high];
    const extent = this.glyphs && extentOf(target);
    if (extent)
      lengths.push((extent.left - left) / wide, (extent.top - top) / high, extent.width / wide, extent.height / high);
    const style = [
      turns(css),
      ...(this.glyphs
        ? [css.font, css.letterSpacing, css.textTransform, css.writingMode]
        : [css.objectFit, css.objectPosition, css.padding, css.borderWidth]),
      ...lengths.map((length) => Math.round(length * GRID + OFF_GRID)),
    ].join();
    const changes = style !== this.#style;
    this.#style = style;
    return changes;
  }

  /** Whether an animation has moved it since the last look. */
  #moves() {
    const { target, glyphs } = this;
    const moves =
      target.getAnimations?.({ subtree: true }).some(({ playState }) => playState === 'running') ||
      (!glyphs && isAnimated(target));
    const moved = this.#moved;
    this.#moved = moves;
    return moves || moved;
  }

  /** Makes the mask, unless there is a newer one to be made. */
  async #make() {
    const begun = ++this.#begun;
    const { target } = this;
    /** @type {Drawing | string | null | undefined} */
    let drawing;
    let mask = '';
    try {
      if (isTurned(target)) drawing = 'it is turned or mirrored';
      else drawing = this.glyphs ? glyphsIn(target) : await imageIn(target, this.#key);
      const key = drawing instanceof Object ? drawing.key : '';
      if (drawing === undefined || (key && key === this.#key)) {
        this.#pause = Math.min(2 * this.#pause, MAX_PAUSE);
        return;
      }
      [this.#pause, this.#key] = [PAUSE, key ?? ''];
      if (drawing instanceof Object) {
        mask = maskOf(drawing);
        for (const what of drawing.lacks ?? []) this.#warn(`without the ${what}`);
      }
    } catch {
      drawing = 'the page may not read its pixels';
    }
    if (begun !== this.#begun) return;
    if (typeof drawing === 'string') {
      this.#resort(drawing);
    } else if (OPAQUE.test(mask)) {
      this.opacity = 'box';
    } else if (drawing && mask) {
      const { box, outer } = drawing;
      const [left, top] = [(box.left - outer.left) / outer.width, (box.top - outer.top) / outer.height];
      this.opacity = {
        mask,
        left,
        top,
        right: left + box.width / outer.width,
        bottom: top + box.height / outer.height,
      };
    } else {
      this.opacity = null;
    }
  }

  /** Its box replaces its pixels for a reason. @param {string} why */
  #resort(why) {
    this.opacity = 'box';
    this.#warn(`as a box: ${why}`);
  }
}

/**
 * The mask of a drawing; empty if nothing is opaque.
 * @param {Drawing} drawing
 * @throws {Error} the page may not read its pixels
 */
function maskOf({ box: { left, top, width, height }, draw }) {
  const scale = Math.min(PIXELS / Math.max(width, height), DENSITY);
  const [columns, rows] = [width, height].map((length) => Math.max(Math.round(length * scale), 1));
  const fine = contextOf(columns * FINENESS, rows * FINENESS, false);
  const [across, up] = [(columns * FINENESS) / width, (rows * FINENESS) / height];
  fine.setTransform(across, 0, 0, up, -left * across, -top * up);
  draw(fine);
  const context = contextOf(columns, rows);
  context.drawImage(fine.canvas, 0, 0, columns, rows);
  return opacityOf(context);
}

/** Whether an element is turned, skewed or mirrored by its style. @param {CSSStyleDeclaration} css */
function turns({ transform, rotate = 'none', scale }) {
  const { a, b, c, d, is2D } = new DOMMatrix(transform);
  return !is2D || Math.abs(b) > LEVEL || Math.abs(c) > LEVEL || a < 0 || d < 0 || rotate !== 'none' || /-/.test(scale);
}

/** Whether an element or one that holds it is turned. @param {Element | null} element */
function isTurned(element) {
  for (let ancestor = element; ancestor; ancestor = ancestor.parentElement)
    if (turns(getComputedStyle(ancestor))) return true;
  return false;
}
