/**
 * What stands inside a `<hearth-fire>`: the canvas, the poster, the play button
 * and the words for a browser that cannot show the fire.
 *
 * The styles are a constructed sheet where the browser has them, because a page's
 * content security policy may forbid `<style>`.
 */

import { deferred } from './requests.js';

const STYLES = `
:host { display: block; position: relative; overflow: hidden; pointer-events: none; }
:host([hidden]) { display: none; }
/* Gives the element a height where its page gives it none. */
.room { inline-size: 100%; aspect-ratio: 4 / 5; max-block-size: 80vh; }
canvas, .poster { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; }
canvas { display: block; }
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
.play:hover { background: rgb(0 0 0 / 0.8); }
.play:focus-visible { outline: 3px solid #ffb454; outline-offset: 3px; }
.play svg { inline-size: 28px; block-size: 28px; fill: #fff; translate: 2px 0; }
`;

const TEMPLATE = `
<div class="root" data-state="loading">
  <div class="room"></div>
  <div class="poster"><slot name="poster"><img alt="" hidden></slot></div>
  <p class="message" part="message" role="status"></p>
  <button class="play" part="play" type="button" aria-label="Play the fire" hidden>
    <svg viewBox="0 0 24 24" aria-hidden="true"><path d="M5 3v18l16-9z"/></svg>
  </button>
</div>`;

/** @type {CSSStyleSheet | undefined} */
let sheet;

/** The inside of one element. */
export class FireView {
  #host;
  #root;
  #message;
  #button;
  #poster;
  #alt = '';
  /** @type {ImageBitmapRenderingContext | CanvasRenderingContext2D | null | undefined} */
  #surface;
  /** There is a picture. */
  #drawn = deferred();
  /** @type {HTMLCanvasElement | undefined} */
  canvas;

  /**
   * @param {HTMLElement} host
   * @param {() => void} play what the play button does
   */
  constructor(host, play) {
    this.#host = host;
    const shadow = host.attachShadow({ mode: 'open' });
    shadow.innerHTML = TEMPLATE;
    if ('adoptedStyleSheets' in shadow && 'replaceSync' in CSSStyleSheet.prototype) {
      if (!sheet) {
        sheet = new CSSStyleSheet();
        sheet.replaceSync(STYLES);
      }
      shadow.adoptedStyleSheets = [sheet];
    } else {
      const style = document.createElement('style');
      style.textContent = STYLES;
      shadow.prepend(style);
    }
    this.#root = /** @type {HTMLElement} */ (shadow.querySelector('.root'));
    this.#message = /** @type {HTMLElement} */ (shadow.querySelector('.message'));
    this.#button = /** @type {HTMLButtonElement} */ (shadow.querySelector('.play'));
    this.#poster = /** @type {HTMLImageElement} */ (shadow.querySelector('.poster img'));
    this.#button.addEventListener('click', play);
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
    this.canvas = this.#surface = undefined;
    delete this.#root.dataset.drawn;
    this.#drawn.reject(new Error('the fire was taken off the page'));
    this.#drawn = deferred();
  }

  /**
   * Shows a picture: a bitmap, which is taken over, or a canvas, which is copied.
   * @param {import('./engine.js').Drawn} picture
   */
  draw(picture) {
    const { canvas } = this;
    if (!canvas) return;
    const bitmap = 'close' in picture ? picture : undefined;
    this.#surface ??= canvas.getContext(bitmap ? 'bitmaprenderer' : '2d');
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

  /**
   * The canvas, when there is a picture on it.
   * @returns {Promise<HTMLCanvasElement>}
   * @throws {Error} there will be none
   */
  drawn() {
    return this.#drawn.promise;
  }

  /**
   * How the picture maps to the fire's world, whose height fits it; null
   * without a picture.
   * @param {number} domainHeight in metres
   */
  place(domainHeight) {
    const outer = this.#host.getBoundingClientRect();
    const inner = this.canvas?.getBoundingClientRect();
    if (!inner?.height) return null;
    const scale = inner.height / domainHeight;
    const middle = inner.left - outer.left + inner.width / 2;
    const floor = inner.bottom - outer.top;
    return {
      toMetres: (x, y) => ({ x: (x - middle) / scale, y: (floor - y) / scale }),
      toPixels: (x, y) => ({ x: middle + x * scale, y: floor - y * scale }),
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
   * Offers the play button, or takes it away.
   * @param {boolean} offered
   */
  offerPlay(offered) {
    this.#button.hidden = !offered;
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
