/**
 * The shadow tree of `<hearth-fire>`: canvas, poster, the button that plays or pauses, and the message
 * for a browser that cannot show the fire.
 *
 * The styles are a constructed style sheet where the browser has those, because a content security
 * policy may forbid `<style>`.
 */

import { viewportOf } from './viewport.js';
import { deferred } from './requests.js';
import { motionIsReduced } from './visibility.js';

/** How long the picture before a new fire takes to fade [ms]. */
const FADE_MS = 400;

const STYLES = /* css */ `
:host { display: block; position: relative; overflow: hidden; pointer-events: none; }
:host([hidden]) { display: none; }
/* Gives the element a height where its page gives it none. */
.room { inline-size: 100%; aspect-ratio: 4 / 5; max-block-size: 80vh; }
canvas, .poster, .before { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; }
canvas { display: block; }
.before { pointer-events: none; }
.poster { display: grid; place-items: center; overflow: hidden; }
::slotted([slot='poster']), .poster img { max-inline-size: 100%; max-block-size: 100%; }
.root[data-state='shown'][data-drawn] .poster { display: none; }
.root[data-state='failed'] canvas { visibility: hidden; }
:host([interactive]) { pointer-events: auto; }
:host([interactive]) .root { touch-action: pan-y; }
.message, .play { position: absolute; inset-inline-start: 50%; translate: -50% -50%; }
.message {
  inset-block-end: 6%; translate: -50% 0; box-sizing: border-box; inline-size: max-content; max-inline-size: min(90%, 32rem); margin: 0;
  padding: 0.75em 1em; border-radius: 0.5em; background: rgb(20 16 14 / 0.9); color: #f4ece4;
  font: 0.95rem/1.45 system-ui, sans-serif; text-align: center; pointer-events: auto;
}
.message:empty, .play[hidden] { display: none; }
.play {
  inset-block-start: 50%; display: grid; place-items: center; inline-size: 64px; block-size: 64px; padding: 0; border: 2px solid #fff;
  border-radius: 50%; background: rgb(0 0 0 / 0.6); cursor: pointer; pointer-events: auto;
}
.play[data-does='pause'] { inset-block: auto 8px; inset-inline-start: 32px; inline-size: 44px; block-size: 44px; translate: -50% 0; }
.play:hover { background: rgb(0 0 0 / 0.8); }
.play:focus-visible { outline: 3px solid #ffb454; outline-offset: 3px; }
.play svg { inline-size: 28px; block-size: 28px; fill: #fff; translate: 2px 0; }
.play[data-does='pause'] svg { inline-size: 20px; block-size: 20px; translate: none; }
`;

/** The shapes on the button, and what it is called. */
const BUTTONS = {
  play: ['M5 3v18l16-9z', 'Play the fire'],
  pause: ['M5 3h5v18H5zM14 3h5v18h-5z', 'Pause the fire'],
};

/** The sheet of each document that has had a fire. @type {WeakMap<Document, CSSStyleSheet>} */
const SHEETS = new WeakMap();

/**
 * An element, made node by node: a page may forbid that HTML is made of text.
 * @param {string} name
 * @param {{[attribute: string]: string}} attributes
 * @param {...Node} inside
 */
function make(name, attributes, ...inside) {
  const svg = name === 'svg' || name === 'path';
  const made = svg ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [attribute, value] of Object.entries(attributes)) made.setAttribute(attribute, value);
  made.append(...inside);
  return made;
}

/**
 * What is on a canvas now, as another one.
 * @param {HTMLCanvasElement} canvas
 */
function copy(canvas) {
  const made = document.createElement('canvas');
  made.className = 'before';
  made.ariaHidden = 'true';
  [made.width, made.height] = [canvas.width, canvas.height];
  made.getContext('2d')?.drawImage(canvas, 0, 0);
  return made;
}

/** The inside of one element. */
export class FireView {
  #host;
  #shadow;
  #root;
  #path;
  #message;
  #button;
  #poster;
  #alt = '';
  /** @type {ImageBitmapRenderingContext | CanvasRenderingContext2D | null | undefined} */
  #surface;
  /** There is a picture. */
  #drawn = deferred();
  /** Whether the next picture is that of another fire, into which the last one fades. */
  #fades = false;
  /** What it tells its page by custom properties. @type {CSSStyleSheet | undefined} */
  #told;
  /** @type {HTMLCanvasElement | undefined} */
  canvas;
  /** How the world fits the picture, and where it stands in it: 0 to 1 from left, from below. */
  camera = { fit: 'height', x: 0.5, y: 0 };

  /**
   * @param {HTMLElement} host
   * @param {() => void} press what the button does
   */
  constructor(host, press) {
    this.#host = host;
    this.#shadow = host.attachShadow({ mode: 'open' });
    this.#poster = /** @type {HTMLImageElement} */ (make('img', { alt: '', hidden: '' }));
    this.#message = make('p', { class: 'message', part: 'message', role: 'status' });
    this.#path = make('path', {});
    this.#button = /** @type {HTMLButtonElement} */ (make(
      'button',
      { class: 'play', part: 'play', type: 'button', hidden: '' },
      make('svg', { viewBox: '0 0 24 24', 'aria-hidden': 'true' }, this.#path),
    ));
    this.#root = /** @type {HTMLElement} */ (make(
      'div',
      { class: 'root', 'data-state': 'loading' },
      make('div', { class: 'room' }),
      make('div', { class: 'poster' }, make('slot', { name: 'poster' }, this.#poster)),
      this.#message,
      this.#button,
    ));
    this.#shadow.append(this.#root);
    this.#button.addEventListener('click', press);
    this.dress();
  }

  /** Gives it its styles, which are lost with the document that it was in. */
  dress() {
    const owner = this.#host.ownerDocument;
    const Sheet = owner.defaultView?.CSSStyleSheet;
    if (Sheet && 'replaceSync' in Sheet.prototype && 'adoptedStyleSheets' in this.#shadow) {
      let sheet = SHEETS.get(owner);
      if (!sheet) {
        sheet = new Sheet();
        sheet.replaceSync(STYLES);
        SHEETS.set(owner, sheet);
      }
      this.#told = new Sheet();
      this.#shadow.adoptedStyleSheets = [sheet, this.#told];
    } else if (!this.#shadow.querySelector('style')) {
      const style = make('style', {});
      style.textContent = STYLES;
      this.#shadow.prepend(style);
    }
  }

  /**
   * Gives the element custom properties; its page's styles go before them.
   * @param {string} declarations
   */
  tell(declarations) {
    this.#told?.replaceSync(`:host { ${declarations} }`);
  }

  /** Whether a picture of the fire is in sight, and no poster. */
  get shows() {
    return this.#root.matches('[data-state=shown][data-drawn]');
  }

  /** What stands inside. */
  get root() {
    return this.#root;
  }

  /** A new canvas, without the picture of the fire before. */
  newCanvas() {
    this.dropCanvas();
    this.canvas = document.createElement('canvas');
    this.canvas.setAttribute('part', 'canvas');
    this.describe(this.#alt);
    this.#root.querySelector('.poster')?.before(this.canvas);
    return this.canvas;
  }

  /** Takes the canvas away. */
  dropCanvas() {
    this.canvas?.remove();
    this.#fades = false;
    this.canvas = this.#surface = undefined;
    delete this.#root.dataset.drawn;
    this.#drawn.reject(new Error('the fire was taken off the page'));
    this.#drawn = deferred();
  }

  /**
   * Shows a picture: a bitmap, which is taken over, or a canvas, which is copied.
   * @param {import('../engine/engine.js').Drawn} picture
   */
  draw(picture) {
    const { canvas } = this;
    if (!canvas) return;
    if (this.#fades) this.#fade(canvas);
    const bitmap = 'close' in picture ? picture : undefined;
    this.#surface ??= bitmap ? canvas.getContext('bitmaprenderer') : canvas.getContext('2d');
    // Setting a size empties the canvas, so only where it is another one.
    if (canvas.width !== picture.width) canvas.width = picture.width;
    if (canvas.height !== picture.height) canvas.height = picture.height;
    const surface = this.#surface;
    if (surface && 'transferFromImageBitmap' in surface) {
      if (bitmap) surface.transferFromImageBitmap(bitmap);
    } else if (surface) {
      surface.globalCompositeOperation = 'copy';
      surface.drawImage(picture, 0, 0);
    }
    if ('drawn' in this.#root.dataset) return;
    this.#root.dataset.drawn = '';
    this.#drawn.resolve(canvas);
  }

  /** The next picture is that of another fire: what is seen until then fades into it. */
  fade() {
    this.#fades = true;
  }

  /** @param {HTMLCanvasElement} canvas */
  #fade(canvas) {
    this.#fades = false;
    if (motionIsReduced()) return;
    let before = /** @type {HTMLElement | undefined} */ (this.#root.querySelector('.poster'));
    /** @type {Keyframe} */
    const shown = { opacity: 1 };
    if ('drawn' in this.#root.dataset) {
      before = copy(canvas);
      canvas.after(before);
    } else {
      // It is hidden as soon as there is a picture.
      shown.display = 'grid';
    }
    const fading = before?.animate([shown, { ...shown, opacity: 0 }], FADE_MS);
    if (before?.matches('canvas')) fading?.finished.catch(() => {}).then(() => before.remove());
  }

  /**
   * The canvas, when there is a picture on it.
   * @returns {Promise<HTMLCanvasElement>}
   * @throws {Error} there will be none
   */
  drawn() {
    return this.#drawn.promise;
  }

  /**
   * How the picture maps to the fire's world; null without a picture.
   * @param {Pick<import('../parameters.js').HearthParameters, 'domain_width' | 'domain_height'>} params
   */
  place({ domain_width: across, domain_height: up }) {
    const outer = this.#host.getBoundingClientRect();
    const inner = this.canvas?.getBoundingClientRect();
    if (!inner?.height) return null;
    const { scale, left, bottom } = viewportOf(this.camera, across, up, inner.width, inner.height);
    const middle = inner.left - outer.left + left;
    const floor = inner.bottom - outer.top - bottom;
    return {
      toMetres: (/** @type {number} */ x, /** @type {number} */ y) => ({ x: (x - middle) / scale, y: (floor - y) / scale }),
      toPixels: (/** @type {number} */ x, /** @type {number} */ y) => ({ x: middle + x * scale, y: floor - y * scale }),
    };
  }

  /**
   * Shows the poster (`loading`), the fire as soon as there is a picture (`shown`),
   * or the poster with words (`failed`).
   * @param {'loading' | 'shown' | 'failed'} state
   * @param {string} [words]
   */
  show(state, words = '') {
    this.#root.dataset.state = state;
    this.#message.textContent = words;
  }

  /**
   * Offers to play the fire, to pause it, or neither.
   * @param {'play' | 'pause' | ''} what
   */
  offer(what) {
    this.#button.hidden = !what;
    if (!what) return;
    const [shape, words] = BUTTONS[what];
    this.#button.dataset.does = what;
    this.#button.setAttribute('aria-label', words);
    this.#path.setAttribute('d', shape);
  }

  /**
   * The picture that is shown where there is no fire and the page gave none in the slot.
   * @param {string} url
   */
  setPoster(url) {
    this.#poster.hidden = !url;
    if (url) this.#poster.src = url;
    else this.#poster.removeAttribute('src');
  }

  /**
   * What a finger on an interactive fire may do with the page; empty: the usual.
   * @param {string} action
   */
  setTouchAction(action) {
    this.#root.style.touchAction = action;
  }

  /**
   * What a screen reader says of the fire; without words it is decoration.
   * @param {string} alt
   */
  describe(alt) {
    this.#alt = alt;
    if (!this.canvas) return;
    if (alt) {
      this.canvas.setAttribute('role', 'img');
      this.canvas.setAttribute('aria-label', alt);
      this.canvas.removeAttribute('aria-hidden');
    } else {
      this.canvas.removeAttribute('role');
      this.canvas.removeAttribute('aria-label');
      this.canvas.setAttribute('aria-hidden', 'true');
    }
  }
}
