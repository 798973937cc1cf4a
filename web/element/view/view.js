/**
 * The shadow tree of `<hearth-fire>`: canvas, poster, and the message for a browser that cannot show
 * the fire. Code that is loaded on request adds elements and their styles.
 */

import { setOrRemove } from '../plain-data.js';
import { deferred } from '../promises.js';
import { viewportOf } from './viewport.js';
import { motionIsReduced } from './visibility.js';

/** How long the last frame of one fire takes to fade into the next fire [ms]. */
const FADE_MS = 400;

const STYLES = /* css */ `
/* Not hidden: a focus would scroll to what of the room is out of its box. It may become as small as a box that scrolls. */
:host {
  display: block; position: relative; min-inline-size: 0; min-block-size: 0; contain: paint; overflow: clip; pointer-events: none;
}
:host([hidden]) { display: none; }
/* Gives the element a size where its page gives it none: all of a block's width, and 300 px where the content decides. */
.room { display: grid; grid-template-columns: minmax(80px, 300px); inline-size: 100%; aspect-ratio: 4 / 5; max-block-size: 80vh; }
/* What lies over the fire is placed in it; the panel takes a part of it. */
.root, .picture, .poster { position: absolute; inset: 0; }
/* A row of tools lies below the fire: it must not hide what burns. */
.root[data-tools='row'] { --hearth-row: calc(62px + max(8px, env(safe-area-inset-bottom))); inset-block-end: var(--hearth-row); }
canvas { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; }
.before { pointer-events: none; }
.poster { display: grid; place-items: center; overflow: hidden; }
::slotted([slot='poster']), .poster img { max-inline-size: 100%; max-block-size: 100%; }
.root[data-state='shown'][data-drawn] .poster { display: none; }
.root[data-state='failed'] canvas { visibility: hidden; }
:host([interactive]) { pointer-events: auto; }
:host([interactive]) .root { touch-action: pan-y; }
.message {
  position: absolute; inset: auto 5% 6%; box-sizing: border-box; inline-size: fit-content; max-inline-size: 32rem; margin: auto;
  padding: 0.75em 1em; border-radius: 0.5em; background: rgb(20 16 14 / 0.9); color: #f4ece4;
  font: 0.9rem/1.4 system-ui, sans-serif; text-align: center; pointer-events: auto; overflow-wrap: anywhere;
}
.message p { margin: 0; }
.message button {
  margin-block-start: 0.5em; padding: 0.25em 1em; border: 1px solid; border-radius: 0.5em; background: none; color: inherit; font: inherit;
}
.root:not([data-state='failed']) .message { display: none; }
`;

/**
 * The constructed style sheets of each document, by their text.
 * @type {WeakMap<Document, Map<string, CSSStyleSheet>>}
 */
const SHEETS = new WeakMap();

/**
 * Makes an element. HTML text is not parsed: a page's policy may forbid it.
 * @param {string} name
 * @param {{[attribute: string]: string}} attributes
 * @param {...(Node | string)} children
 */
function make(name, attributes, ...children) {
  const made = document.createElement(name);
  for (const [attribute, value] of Object.entries(attributes)) made.setAttribute(attribute, value);
  made.append(...children);
  return made;
}

/** A point after a projection. @param {DOMPoint} point */
const flat = ({ x, y, w }) => ({ x: x / w, y: y / w });

/** The shadow tree of one element. */
export class FireView {
  #host;
  #shadow;
  #message = make('p', { role: 'status' });
  #retry = /** @type {HTMLButtonElement} */ (make('button', { part: 'retry', type: 'button' }, 'Try again'));
  #poster = /** @type {HTMLImageElement} */ (make('img', { alt: '', hidden: '' }));
  #posterBox = make('div', { class: 'poster' }, make('slot', { name: 'poster' }, this.#poster));
  /** From the upper left one of the picture on, clockwise. */
  #corners = ['0 auto auto 0', '0 0 auto auto', 'auto 0 0 auto', 'auto auto 0 0'].map((inset) => {
    const corner = make('i', {});
    corner.style.cssText = `position:absolute;inset:${inset}`;
    return corner;
  });
  /** The canvas with its corners, so that its points are known wherever the page or the panel moves it. */
  #picture = make('div', { class: 'picture', part: 'canvas' }, ...this.#corners);
  #messageBox = make('div', { class: 'message', part: 'message' }, this.#message);
  #alt = '';
  /** @type {ImageBitmapRenderingContext | CanvasRenderingContext2D | null | undefined} */
  #surface;
  /** Resolves with the first frame. */
  #drawn = deferred();
  /** Whether the next frame is that of another fire, into which the last one fades. */
  #fades = false;
  #styles = [STYLES];
  #declarations = '';
  /** The custom properties of the element. @type {CSSStyleSheet | undefined} */
  #properties;
  /** @type {HTMLCanvasElement | undefined} */
  canvas;
  /** How much the picture is enlarged at most. */
  maxZoom = 10;
  /** @type {import('./viewport.js').Camera} */
  camera = { fit: 'height', x: 0.5, y: 0, zoom: 1, panX: 0.5, panY: 0.5 };
  /** What the shadow tree holds. */
  root = make('div', { class: 'root', 'data-state': 'loading' }, this.#picture, this.#posterBox, this.#messageBox);

  /** @param {HTMLElement} host */
  constructor(host) {
    this.#host = host;
    this.#shadow = host.attachShadow({ mode: 'open' });
    this.#shadow.append(make('div', { class: 'room' }), this.root);
    this.applyStyles();
  }

  /** Adds styles. @param {string} styles */
  style(styles) {
    this.#styles.push(styles);
    this.applyStyles();
  }

  /**
   * Applies the styles, which an element loses when it moves to another document. They are constructed
   * style sheets where the browser has those: a content security policy may forbid `<style>`.
   */
  applyStyles() {
    const owner = this.#host.ownerDocument;
    const Sheet = owner.defaultView?.CSSStyleSheet;
    if (Sheet && 'replaceSync' in Sheet.prototype && 'adoptedStyleSheets' in this.#shadow) {
      const known = SHEETS.get(owner) ?? new Map();
      SHEETS.set(owner, known);
      this.#properties = new Sheet();
      this.#shadow.adoptedStyleSheets = [
        ...this.#styles.map((text) => {
          const sheet = known.get(text) ?? new Sheet();
          if (!known.has(text)) sheet.replaceSync(text);
          known.set(text, sheet);
          return sheet;
        }),
        this.#properties,
      ];
      this.declare(this.#declarations);
    } else {
      this.#shadow.querySelector('style')?.remove();
      this.#shadow.prepend(make('style', {}, new Text(this.#styles.join(''))));
    }
  }

  /**
   * Sets custom properties of the element; its page's styles take precedence.
   * @param {string} declarations
   */
  declare(declarations) {
    this.#declarations = declarations;
    this.#properties?.replaceSync(`:host{${declarations}}`);
  }

  /** Whether a frame of the fire is shown, and no poster. */
  get shows() {
    return this.root.matches('[data-state=shown][data-drawn]');
  }

  /** A new canvas, without the last frame of the fire before. */
  newCanvas() {
    this.dropCanvas();
    return this.replaceCanvas();
  }

  /** Another canvas, which is empty. */
  replaceCanvas() {
    this.canvas?.remove();
    this.#surface = undefined;
    // What waits for a frame waits for one of this canvas.
    if (this.root.hasAttribute('data-drawn')) this.#drawn = deferred();
    const canvas = this.#host.ownerDocument.createElement('canvas');
    this.canvas = canvas;
    this.describe(this.#alt);
    this.#picture.append(canvas);
    return canvas;
  }

  /** Removes the canvas. */
  dropCanvas() {
    this.canvas?.remove();
    this.#fades = false;
    this.canvas = this.#surface = undefined;
    this.root.removeAttribute('data-drawn');
    this.#drawn.reject(new Error('the fire was removed from the page'));
    this.#drawn = deferred();
  }

  /**
   * Shows a frame: a bitmap, which is transferred, or a canvas, which is copied.
   * @param {import('../../engine/engine.js').Drawn} frame
   */
  draw(frame) {
    const { canvas } = this;
    if (!canvas) return;
    if (this.#fades) this.#fade(canvas);
    const bitmap = 'close' in frame ? frame : undefined;
    this.#surface ??= bitmap ? canvas.getContext('bitmaprenderer') : canvas.getContext('2d');
    // Assigning a size clears the canvas.
    if (canvas.width !== frame.width) canvas.width = frame.width;
    if (canvas.height !== frame.height) canvas.height = frame.height;
    const surface = this.#surface;
    if (surface && 'transferFromImageBitmap' in surface) {
      if (bitmap) surface.transferFromImageBitmap(bitmap);
    } else if (surface) {
      surface.globalCompositeOperation = 'copy';
      surface.drawImage(frame, 0, 0);
    }
    if (!this.root.hasAttribute('data-drawn')) this.root.setAttribute('data-drawn', '');
    this.#drawn.resolve(canvas);
  }

  /** The next frame is that of another fire: what is shown until then fades into it. */
  fade() {
    this.#fades = true;
  }

  /** @param {HTMLCanvasElement} canvas */
  #fade(canvas) {
    this.#fades = false;
    if (motionIsReduced()) return;
    if (!this.root.hasAttribute('data-drawn')) {
      // The poster is hidden as soon as there is a frame, unless the animation shows it.
      this.#posterBox.animate(
        [
          { display: 'grid', opacity: 1 },
          { display: 'grid', opacity: 0 },
        ],
        FADE_MS,
      );
      return;
    }
    const copy = /** @type {HTMLCanvasElement} */ (make('canvas', { class: 'before', 'aria-hidden': 'true' }));
    [copy.width, copy.height] = [canvas.width, canvas.height];
    copy.getContext('2d')?.drawImage(canvas, 0, 0);
    canvas.after(copy);
    const remove = () => copy.remove();
    copy.animate([{ opacity: 1 }, { opacity: 0 }], FADE_MS).finished.then(remove, remove);
  }

  /**
   * Resolves to the canvas when it shows a frame.
   * @returns {Promise<HTMLCanvasElement>}
   * @throws {Error} there will be none
   */
  drawn() {
    return this.#drawn.promise;
  }

  /**
   * How shares of the picture, from the left and from above, map to pixels of the window, whatever transforms the
   * element: points without an area are at its corners.
   */
  #projection() {
    const [a, b, c, d] = this.#corners.map((corner) => corner.getBoundingClientRect());
    const [bx, by, dx, dy] = [b.x - c.x, b.y - c.y, d.x - c.x, d.y - c.y];
    const [sx, sy] = [a.x - b.x + c.x - d.x, a.y - b.y + c.y - d.y];
    const area = bx * dy - dx * by;
    const [g, h] = [(sx * dy - dx * sy) / area, (bx * sy - sx * by) / area];
    const [ux, uy] = [b.x - a.x + g * b.x, b.y - a.y + g * b.y];
    const [vx, vy] = [d.x - a.x + h * d.x, d.y - a.y + h * d.y];
    return new DOMMatrix([ux, uy, 0, g, vx, vy, 0, h, 0, 0, 1, 0, a.x, a.y, 0, 1]);
  }

  /**
   * The shares of the picture, from the left and from above, at a point of the window.
   * @type {(clientX: number, clientY: number) => {x: number, y: number}}
   */
  sharesAt(clientX, clientY) {
    return flat(this.#projection().inverse().transformPoint({ x: clientX, y: clientY }));
  }

  /**
   * How the element's pixels map to the domain's metres; null without a picture.
   * @param {Pick<import('../../parameters.js').HearthParameters, 'domain_width' | 'domain_height'>} params
   */
  viewport({ domain_width: across, domain_height: up }) {
    const { canvas } = this;
    if (!canvas?.clientWidth || !canvas.clientHeight) return null;
    // The lengths of a style have fractions, and are those before a transform.
    const css = getComputedStyle(canvas);
    const [width, height] = [css.width, css.height].map(parseFloat);
    const outer = this.#host.getBoundingClientRect();
    const matrix = this.#projection();
    const inverse = matrix.inverse();
    const { scale, left, bottom } = viewportOf(this.camera, across, up, width, height);
    /** @type {(shares: {x: number, y: number}) => {x: number, y: number}} */
    const metresOf = ({ x, y }) => ({ x: (x * width - left) / scale, y: ((1 - y) * height - bottom) / scale });
    return {
      metresOf,
      toMetres: (/** @type {number} */ x, /** @type {number} */ y) =>
        metresOf(flat(inverse.transformPoint({ x: x + outer.left, y: y + outer.top }))),
      toPixels: (/** @type {number} */ x, /** @type {number} */ y) => {
        const shares = { x: (x * scale + left) / width, y: 1 - (y * scale + bottom) / height };
        const at = flat(matrix.transformPoint(shares));
        return { x: at.x - outer.left, y: at.y - outer.top };
      },
    };
  }

  /**
   * Shows the poster (`loading`), the fire from its first frame on (`shown`), or the poster with a
   * message (`failed`).
   * @param {'loading' | 'shown' | 'failed'} state
   * @param {string} [message]
   * @param {(() => void) | false} [retry] what the button under the message does; without it there is none
   */
  show(state, message = '', retry = false) {
    this.root.dataset.state = state;
    this.#message.textContent = message;
    this.#retry.onclick = retry || null;
    if (retry) this.#message.after(this.#retry);
    else this.#retry.remove();
  }

  /**
   * Sets the picture that is shown without a fire if the slot is empty.
   * @param {string} url
   */
  setPoster(url) {
    this.#poster.hidden = !url;
    setOrRemove(this.#poster, 'src', url || null);
  }

  /**
   * Sets the description for screen readers; without one the fire is decoration.
   * @param {string} alt
   */
  describe(alt) {
    this.#alt = alt;
    if (!this.canvas) return;
    setOrRemove(this.canvas, 'role', alt ? 'img' : null);
    setOrRemove(this.canvas, 'aria-label', alt || null);
    setOrRemove(this.canvas, 'aria-hidden', alt ? null : 'true');
  }
}
