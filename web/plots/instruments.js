/**
 * The probe and the plots of one fire. While either is shown, the fire is measured once a frame, at the probe or above
 * the first source.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {{x: number, y: number}} Point
 *
 * @typedef {object} Options
 * @property {HTMLElement} host  The parent of the probe and the plots.
 * @property {HearthFire} fire
 * @property {(text: string) => void} showStatus  Shows a message.
 * @property {(shown: boolean) => void} plotsShown  Runs when the plots appear or disappear.
 */

import { addStyle } from '../editing/style.js';
import { Card } from './card.js';
import { Field } from './field.js';
import { Readout, valuesOf } from './readout.js';
import { Record } from './record.js';

/** How often values and charts change [ms]: faster ones cannot be read. */
const READ_MS = 120;
const DRAW_MS = 250;

/** Events after which a fire that is paused, or that could not be measured, is measured again. */
const NEWS = ['stats', 'ready', 'restored', 'params-change', 'objects-change', 'play'];

/** The probe and the plots of one fire. */
export class Instruments {
  #options;
  #readout = new Readout();
  #record = new Record();
  /** What is drawn over the fire, which stays without the card. */
  #field;
  /** @type {Card | undefined} */
  #card;
  /** Where the probe is. @type {Point | undefined} */
  #at;
  /** Whether the status gets the next values. */
  #announces = false;
  #runs = false;
  #news = true;
  #ended = new AbortController();
  #readAt = 0;
  #drawnAt = 0;
  #style;

  /** @param {Options} options */
  constructor(options) {
    this.#options = options;
    this.#style = addStyle(options.host, new URL('./plots.css', import.meta.url).href);
    this.#field = new Field(options.fire, options.host);
    const news = () => (this.#news = true);
    for (const name of NEWS) options.fire.addEventListener(name, news, { signal: this.#ended.signal });
    const mark = (/** @type {import('../element/types.js').HearthFireEvents['params-change']} */ { detail }) =>
      this.#record.mark(detail.id, detail.value);
    options.fire.addEventListener('params-change', mark, { signal: this.#ended.signal });
  }

  /**
   * Measures at a point, or hides the probe.
   * @type {(at: Point | undefined, options?: {announce?: boolean}) => void}
   */
  probe(at, { announce = false } = {}) {
    const { host } = this.#options;
    if (at && !this.#at) host.append(this.#readout.element);
    if (!at) this.#readout.element.remove();
    this.#at = at && { x: at.x, y: at.y };
    this.#announces = at !== undefined && (announce || this.#announces);
    this.#readAt = 0;
    this.#move();
    this.#run();
  }

  /** Shows or hides the plots. */
  plot() {
    if (this.close()) return;
    this.#card = new Card(this.#record, this.#field, () => this.close());
    this.#options.host.append(this.#card.element);
    this.#options.plotsShown(true);
    this.#drawnAt = 0;
    this.#card.show();
    this.#run();
  }

  /** Hides the plots, if they are shown. */
  close() {
    const card = this.#card;
    if (!card) return false;
    this.#card = undefined;
    const focused = card.element.matches(':focus-within');
    card.element.remove();
    this.#options.plotsShown(false);
    if (focused) /** @type {HTMLElement | null} */ (this.#options.host.querySelector('[data-tool="plots"]'))?.focus();
    return true;
  }

  remove() {
    this.close();
    this.probe(undefined);
    this.#field.remove();
    this.#ended.abort();
    this.#style.removeStyle();
  }

  /** Measures until nothing is shown. */
  async #run() {
    this.#news = true;
    if (this.#runs) return;
    this.#runs = true;
    const { fire } = this.#options;
    while (this.#at || this.#card) {
      const now = await nextFrame();
      if (fire.paused && !this.#news) continue;
      this.#news = false;
      await this.#measure(now);
    }
    this.#runs = false;
  }

  /** @param {number} now */
  async #measure(now) {
    const { fire, showStatus } = this.#options;
    const at = this.#at;
    const { x, y } = at ?? { x: sourceOf(fire), y: 0 };
    try {
      const measures = await fire.measure(x, y);
      this.#record.add(measures, fire.stats, x);
      if (at && this.#at) this.#read(measures.place, at, now);
    } catch (error) {
      if (this.#ended.signal.aborted) return;
      showStatus(error instanceof Error ? error.message : String(error));
      // Without a change, each frame would repeat the message.
      while (!this.#news && (this.#at || this.#card)) await nextFrame();
    }
    if (this.#card && (fire.paused || now - this.#drawnAt >= DRAW_MS)) {
      this.#drawnAt = now;
      this.#card.show();
    }
  }

  /** Moves the values to the pixel of the probe. */
  #move() {
    const { fire, host } = this.#options;
    const pixel = this.#at && fire.toPixels(this.#at.x, this.#at.y);
    if (!pixel) return;
    const [inner, outer] = [fire.getBoundingClientRect(), host.getBoundingClientRect()];
    this.#readout.move(
      { x: pixel.x + inner.left - outer.left, y: pixel.y + inner.top - outer.top },
      this.#card !== undefined,
    );
  }

  /** Shows the values of the probe. @type {(place: import('./readout.js').Place, at: Point, now: number) => void} */
  #read(place, at, now) {
    const { fire, showStatus } = this.#options;
    if (fire.paused || now - this.#readAt >= READ_MS) {
      this.#readAt = now;
      this.#readout.show(place, at);
    }
    this.#move();
    if (!this.#announces || at !== this.#at) return;
    this.#announces = false;
    const phrases = Object.entries(valuesOf(place)).map(([name, value]) =>
      name === 'place' ? value : `${name} ${value.replace(/[^\d\w\s./³%°()-]/g, '')}`,
    );
    showStatus(`${phrases.join(', ')}.`);
  }
}

/** The x of the first source [m]. @param {HearthFire} fire */
function sourceOf(fire) {
  return fire.objects.find(({ kind }) => kind === 'source')?.x ?? 0;
}

/** The next frame's time [ms]. @returns {Promise<number>} */
function nextFrame() {
  return new Promise((resolve) => {
    requestAnimationFrame(resolve);
  });
}
