/**
 * The probe and the plots of one fire. While either is shown, the fire is measured once a frame, at the probe or above
 * the first source.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {{x: number, y: number}} Point
 *
 * @typedef {object} Parts
 * @property {HTMLElement} host  Gets them.
 * @property {HearthFire} fire
 * @property {(text: string) => void} say
 * @property {(shown: boolean) => void} plotted  The plots are shown, or hidden.
 */

import { addStyle } from '../panel/style.js';
import { Card } from './card.js';
import { Readout, valuesOf } from './readout.js';
import { Record } from './record.js';

/** How often values and charts change [ms]: faster ones cannot be read. */
const READ_MS = 120;
const DRAW_MS = 250;

/** Events after which a fire that is paused, or that could not be measured, is measured again. */
const NEWS = ['stats', 'ready', 'restored', 'params-change', 'objects-change', 'play'];

/** The probe and the plots of one fire. */
export class Instruments {
  #parts;
  #readout = new Readout();
  #record = new Record();
  /** @type {Card | undefined} */
  #card;
  /** Where the probe is. @type {Point | undefined} */
  #at;
  /** Whether the next values are told. */
  #tells = false;
  #runs = false;
  #news = true;
  #ended = new AbortController();
  #readAt = 0;
  #drawnAt = 0;
  #style;

  /** @param {Parts} parts */
  constructor(parts) {
    this.#parts = parts;
    this.#style = addStyle(parts.host, new URL('./plots.css', import.meta.url).href);
    const news = () => (this.#news = true);
    for (const name of NEWS) parts.fire.addEventListener(name, news, { signal: this.#ended.signal });
  }

  /** Puts the probe at a place, or away. @type {(at: Point | undefined, tells?: boolean) => void} */
  probe(at, tells = false) {
    const { host } = this.#parts;
    if (at && !this.#at) host.append(this.#readout.element);
    if (!at) this.#readout.element.remove();
    this.#at = at && { x: at.x, y: at.y };
    this.#tells = at !== undefined && (tells || this.#tells);
    this.#readAt = 0;
    this.#place();
    this.#run();
  }

  /** Shows or hides the plots. */
  plot() {
    if (this.close()) return;
    this.#card = new Card(this.#record, () => this.close());
    this.#parts.host.append(this.#card.element);
    this.#parts.plotted(true);
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
    this.#parts.plotted(false);
    if (focused) /** @type {HTMLElement | null} */ (this.#parts.host.querySelector('[data-tool="plots"]'))?.focus();
    return true;
  }

  remove() {
    this.close();
    this.probe(undefined);
    this.#ended.abort();
    this.#style.removeStyle();
  }

  /** Measures until nothing is shown. */
  async #run() {
    this.#news = true;
    if (this.#runs) return;
    this.#runs = true;
    const { fire } = this.#parts;
    while (this.#at || this.#card) {
      const now = await frame();
      if (fire.paused && !this.#news) continue;
      this.#news = false;
      await this.#measure(now);
    }
    this.#runs = false;
  }

  /** @param {number} now */
  async #measure(now) {
    const { fire, say } = this.#parts;
    const at = this.#at;
    const { x, y } = at ?? { x: sourceOf(fire), y: 0 };
    try {
      const measures = await fire.measure(x, y);
      this.#record.add(measures, fire.stats, x);
      if (at && this.#at) this.#read(measures.place, at, now);
    } catch (error) {
      if (this.#ended.signal.aborted) return;
      say(error instanceof Error ? error.message : String(error));
      // Each frame would say so.
      while (!this.#news && (this.#at || this.#card)) await frame();
    }
    if (this.#card && (fire.paused || now - this.#drawnAt >= DRAW_MS)) {
      this.#drawnAt = now;
      this.#card.show();
    }
  }

  /** Moves the values to where the probe is seen. */
  #place() {
    const { fire, host } = this.#parts;
    const pixel = this.#at && fire.toPixels(this.#at.x, this.#at.y);
    if (!pixel) return;
    const [inner, outer] = [fire.getBoundingClientRect(), host.getBoundingClientRect()];
    this.#readout.move({ x: pixel.x + inner.left - outer.left, y: pixel.y + inner.top - outer.top }, this.#card !== undefined);
  }

  /** Shows the values of the probe. @type {(place: import('./readout.js').Place, at: Point, now: number) => void} */
  #read(place, at, now) {
    const { fire, say } = this.#parts;
    if (fire.paused || now - this.#readAt >= READ_MS) {
      this.#readAt = now;
      this.#readout.show(place, at);
    }
    this.#place();
    if (!this.#tells || at !== this.#at) return;
    this.#tells = false;
    say(`${Object.entries(valuesOf(place)).map(([name, value]) => (name === 'place' ? value : `${name} ${value.replace(/[^\d\w\s./³%-]/g, '')}`)).join(', ')}.`);
  }
}

/** The x of the first source [m]. @param {HearthFire} fire */
function sourceOf(fire) {
  return fire.objects.find(({ kind }) => kind === 'source')?.x ?? 0;
}

/** The next frame's time [ms]. @returns {Promise<number>} */
function frame() {
  return new Promise((resolve) => {
    requestAnimationFrame(resolve);
  });
}
