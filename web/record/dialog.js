/**
 * The dialog that saves a fire: as a film, a loop, a GIF, a sprite sheet or an image. It shows a sample, and what the file takes, before it
 * starts. The panel and the page open it.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../element/types.js').HearthFilm} Options
 */

import { download } from '../editing/download.js';
import { remember, remembered } from '../editing/memory.js';
import { element } from '../element/controls/icon-button.js';
import { FORMATS, RATES, estimate, filmOf, megabytes } from './options.js';
import { loopOf } from './loop.js';
import { STYLES } from './style.js';

/** What the fire is saved as. */
const KINDS = { film: 'Film', loop: 'Loop', gif: 'GIF', sheet: 'Sheet', still: 'Image' };

/** The formats of a film, by name, WebP first, and of a loop. @type {{[format: string]: string}} */
const FILMS = {
  webp: 'WebP: transparent, plays in every browser',
  apng: 'APNG: transparent, exact colours',
  webm: 'WebM: transparent, not in Safari',
  mp4: 'MP4: for players, not transparent',
  stacked: 'MP4 with alpha in its lower half',
  zip: 'PNG pictures in a zip archive',
  wav: 'WAV: the sound alone',
};
const LOOPS = ['webp', 'apng', 'webm', 'zip'];

/** The sizes [pixels]; without one, that on the page. */
const SIZES = ['512 × 512', '256 × 256', '1024 × 1024', '1280 × 720', '1920 × 1080', '1080 × 1920', 'As on the page'];

/** The backgrounds by name. */
const BACKGROUNDS = { scene: 'As on the page', transparent: 'Transparent', '#000000': 'Black', '#ffffff': 'White' };

/** Pictures of a sample, their largest side [pixels], and how long choices rest before one is taken [ms]. */
const SAMPLE = 3;
const SAMPLE_SIDE = 512;
const REST_MS = 500;

/**
 * Opens the dialog.
 * @param {HearthFire} fire
 * @param {(message: string) => void} [saved] is told what was saved
 */
export function openRecorder(fire, saved = () => {}) {
  if (!fire.ownerDocument.querySelector('.hearth-recorder')) new Recorder(fire, saved).open();
}

/** Whether this browser encodes WebP; Safari does not. */
function encodesWebP() {
  const canvas = element('canvas', { width: '1', height: '1' });
  return canvas.toDataURL('image/webp').startsWith('data:image/webp');
}

/** A labelled list of choices. @type {(name: string, label: string, choices: [value: string, text: string][]) => {row: HTMLLabelElement, select: HTMLSelectElement}} */
function choice(name, label, choices) {
  const select = element('select', { name }, ...choices.map(([value, text]) => new Option(text, value)));
  return { row: element('label', {}, element('span', {}, label), select), select };
}

class Recorder {
  #fire;
  #saved;
  #host = element('div', { class: 'hearth-recorder', dir: 'ltr' });
  #dialog = element('dialog', { 'aria-labelledby': 'title' });
  #kinds = element('fieldset', { class: 'kinds' }, element('legend', {}, 'What for'));
  #formats = choice('format', 'Format', Object.entries(FILMS));
  #size = choice(
    'size',
    'Size',
    SIZES.map((size) => [size, size]),
  );
  #seconds = element('input', { name: 'seconds', type: 'number', min: '0.5', max: '600', step: '0.5', value: '4' });
  #length = element('label', {}, element('span', {}, 'Seconds'), this.#seconds);
  #rate = choice('fps', 'Rate', []);
  #background = choice('background', 'Background', Object.entries(BACKGROUNDS));
  #sound = element('input', { name: 'sound', type: 'checkbox' });
  #soundRow = element('label', {}, element('span', {}, 'With sound'), this.#sound);
  #describe = element('input', { name: 'describe', type: 'checkbox' });
  #describeRow = element('label', {}, element('span', {}, 'With its settings'), this.#describe);
  #preview = element('div', { class: 'preview' });
  #about = element('p', { class: 'about', role: 'status' });
  #alert = element('p', { role: 'alert' });
  #progress = element('progress', { 'aria-label': 'Recorded', hidden: '' });
  #save = element('button', { type: 'submit', name: 'save' }, 'Save');
  #cancel = element('button', { type: 'button', name: 'cancel' }, 'Close');
  /** Cancels the film that is recorded. @type {AbortController | undefined} */
  #film;
  /** Cancels the sample. @type {AbortController | undefined} */
  #sample;
  /** Settles when there is no sample under way. */
  #sampled = Promise.resolve();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #rests;
  /** What was measured of a sample: seconds and bytes of a picture. @type {{seconds: number, bytes?: number} | undefined} */
  #measured;
  #shown = '';
  /** Whether a size is chosen; an image is else as on the page. */
  #sized = false;

  /** @param {HearthFire} fire @param {(message: string) => void} saved */
  constructor(fire, saved) {
    this.#fire = fire;
    this.#saved = saved;
    if (!encodesWebP()) this.#formats.select.options[0].remove();
    const kept = /** @type {any} */ (remembered().film ?? {});
    for (const [value, text] of Object.entries(KINDS)) {
      const radio = element('input', { type: 'radio', name: 'kind', value });
      radio.checked = value === (kept.kind ?? 'still');
      this.#kinds.append(element('label', {}, radio, element('span', {}, text)));
    }
    for (const [field, value] of /** @type {[HTMLSelectElement, unknown][]} */ ([
      [this.#formats.select, kept.format],
      [this.#size.select, kept.size],
      [this.#background.select, kept.background],
    ]))
      if ([...field.options].some((option) => option.value === value)) field.value = String(value);
    this.#sized = Boolean(kept.size);
    if (kept.seconds > 0) this.#seconds.value = String(kept.seconds);
    const fields = element(
      'div',
      { class: 'fields' },
      this.#formats.row,
      this.#size.row,
      this.#length,
      this.#rate.row,
      this.#background.row,
      this.#soundRow,
      this.#describeRow,
    );
    const sheets = element(
      'p',
      { class: 'note' },
      'Sheets of motion vectors, light or smoke: the command ',
      element('code', {}, 'hearth sprites'),
      '.',
    );
    const buttons = element('div', { class: 'buttons' }, this.#cancel, this.#save);
    const form = element(
      'form',
      { method: 'dialog' },
      element('h2', { id: 'title' }, 'Save this fire'),
      this.#kinds,
      element('div', { class: 'body' }, this.#preview, fields),
      this.#about,
      this.#progress,
      this.#alert,
      buttons,
      sheets,
    );
    this.#dialog.append(form);
    const root = this.#host.attachShadow({ mode: 'open' });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(STYLES);
    root.adoptedStyleSheets = [sheet];
    root.append(this.#dialog);
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#record();
    });
    form.addEventListener('input', ({ target }) => {
      this.#sized ||= target === this.#size.select;
      this.#change();
    });
    this.#cancel.addEventListener('click', () => (this.#film ? this.#film.abort() : this.#close()));
    // The fire's shortcuts do not work in a dialog.
    this.#dialog.addEventListener('keydown', (event) => event.stopPropagation());
    this.#dialog.addEventListener('close', () => this.#end());
  }

  open() {
    this.#fire.ownerDocument.body.append(this.#host);
    this.#dialog.showModal();
    this.#save.focus();
    this.#change();
  }

  get #kind() {
    const chosen = /** @type {HTMLInputElement | null} */ (this.#kinds.querySelector('input:checked'));
    return /** @type {keyof typeof KINDS} */ (chosen?.value);
  }

  get #format() {
    const kind = this.#kind;
    if (kind === 'gif' || kind === 'sheet') return kind;
    if (kind === 'still') return 'png';
    const { value } = this.#formats.select;
    return /** @type {keyof typeof FORMATS} */ (value === 'stacked' ? 'mp4' : value);
  }

  /** Whether the end goes over into the beginning: game engines play sheets again and again. */
  get #isLoop() {
    return this.#kind === 'loop' || this.#kind === 'sheet';
  }

  /** The size that is chosen [pixels]. */
  get #sides() {
    const sides = this.#size.select.value.split(' × ').map(Number);
    if (sides.length === 2) return sides;
    const { offsetWidth, offsetHeight } = this.#fire;
    return [offsetWidth, offsetHeight].map((side) => Math.min(4096, 2 * Math.round((side * devicePixelRatio) / 2)));
  }

  /** @returns {Options} */
  get #options() {
    const [width, height] = this.#sides;
    const format = this.#format;
    const film = { format, width, height, seconds: this.#seconds.valueAsNumber, fps: Number(this.#rate.select.value) };
    const kind = this.#kind;
    const sound = this.#sound.checked && !this.#soundRow.hidden;
    const stackedAlpha = kind === 'film' && this.#formats.select.value === 'stacked';
    const describe = this.#describe.checked && !this.#describeRow.hidden;
    const background = this.#background.select.value;
    const options = { ...film, loop: this.#isLoop, sound, background, stackedAlpha, describe };
    // What has no alpha is over black.
    if (format === 'mp4' && this.#filmOf(options) === undefined && background !== '#ffffff')
      return { ...options, background: '#000000' };
    return options;
  }

  /** The film of options; undefined if one is refused. @param {Options} options */
  #filmOf(options) {
    try {
      return filmOf(options, { width: 512, height: 512, params: this.#fire.params });
    } catch {
      return undefined;
    }
  }

  /** Shows the fields of the kind, and what the film takes. */
  #change() {
    const kind = this.#kind;
    const still = kind === 'still';
    if (!this.#sized) this.#size.select.value = still ? SIZES[SIZES.length - 1] : SIZES[0];
    for (const option of this.#formats.select.options)
      option.hidden = option.disabled = kind === 'loop' && !LOOPS.includes(option.value);
    if (this.#formats.select.selectedOptions[0]?.disabled)
      this.#formats.select.value = [...this.#formats.select.options].find(({ disabled }) => !disabled)?.value ?? '';
    const format = this.#format;
    const isSound = format === 'wav';
    this.#formats.row.hidden = kind !== 'film' && kind !== 'loop';
    this.#length.hidden = still;
    this.#rate.row.hidden = still || isSound;
    this.#size.row.hidden = this.#background.row.hidden = this.#describeRow.hidden = isSound;
    this.#soundRow.hidden = kind !== 'film' || !['webm', 'mp4'].includes(format);
    this.#seconds.min = this.#isLoop ? '1' : '0.5';
    this.#seconds.max = this.#isLoop ? '10' : '600';
    this.#offerRates(format === 'gif' ? RATES.gif : RATES.others, format === 'gif' ? 25 : 30);
    this.#alert.textContent = '';
    this.#tell();
    const options = this.#options;
    const { format: name, width, height, background } = options;
    const shown = [name, width, height, background].join();
    if (shown === this.#shown) return;
    this.#shown = shown;
    this.#measured = undefined;
    clearTimeout(this.#rests);
    this.#sample?.abort();
    this.#rests = setTimeout(() => (this.#sampled = this.#takeSample(options)), REST_MS);
  }

  /** @type {(rates: number[], usual: number) => void} */
  #offerRates(rates, usual) {
    const { select } = this.#rate;
    if (select.options.length === rates.length && select.options[0].value === String(rates[0])) return;
    select.replaceChildren(
      ...rates.map((rate) => new Option(`${rate % 1 ? '33⅓' : rate} pictures a second`, String(rate))),
    );
    select.value = String(usual);
  }

  /** Shows how large the film will be and how long it takes. */
  #tell() {
    if (this.#film) return;
    const options = this.#options;
    const film = this.#filmOf(options);
    this.#about.textContent = '';
    if (!film) return;
    const { width, height, count, fps } = film;
    if (this.#kind === 'still') {
      this.#about.textContent = `${width} × ${height} pixels`;
      return;
    }
    const { bytes, memory } = estimate(film);
    const measured = this.#measured;
    const size = measured?.bytes ? measured.bytes * count : bytes;
    const made = count + (film.loop ? loopOf(count, fps).searched : 0);
    const seconds = measured ? measured.seconds * made : undefined;
    const time =
      seconds === undefined
        ? ''
        : `, about ${seconds < 90 ? `${Math.ceil(seconds)} s` : `${Math.ceil(seconds / 60)} minutes`} to record`;
    const needs = memory > 200e6 ? `, needs ${megabytes(memory)} of memory` : '';
    const what = this.#format === 'wav' ? `${count / fps} s of sound` : `${count} pictures of ${width} × ${height}`;
    this.#about.textContent = `${what}, about ${megabytes(size)}${needs}${time}.`;
  }

  /** Records some pictures, shows them, and measures what they take. @param {Options} options */
  async #takeSample(options) {
    const { width = 1, height = 1, format } = options;
    if (format === 'wav') {
      this.#preview.replaceChildren();
      return;
    }
    const scale = Math.min(1, SAMPLE_SIDE / Math.max(width, height));
    const [across, up] = [width, height].map((side) => Math.max(16, 2 * Math.round((side * scale) / 2)));
    const isStill = this.#kind === 'still';
    /** @type {Options['format']} */
    const moving = isStill ? 'png' : format === 'gif' || format === 'webp' ? format : 'apng';
    this.#sample = new AbortController();
    const { signal } = this.#sample;
    /** @type {number[]} */
    const times = [];
    const onprogress = () => times.push(performance.now());
    const fps = moving === 'gif' ? 25 : 30;
    try {
      const sample = {
        format: moving,
        width: across,
        height: up,
        background: options.background,
        seconds: SAMPLE / fps,
        fps,
      };
      const file = await this.#fire.record({ ...sample, signal, onprogress });
      if (!file || signal.aborted) return;
      this.#show(file);
      if (isStill) return;
      // The first picture comes with the start of all.
      const seconds = (times[SAMPLE - 1] - times[0]) / (SAMPLE - 1) / 1000 / scale ** 2;
      const isAlike = !['webm', 'mp4'].includes(String(format));
      this.#measured = { seconds, ...(isAlike && { bytes: file.size / SAMPLE / scale ** 2 }) };
      this.#tell();
    } catch (error) {
      if (!signal.aborted) this.#alert.textContent = messageOf(error);
    }
  }

  /** Shows a file in the preview. @param {Blob} file */
  #show(file) {
    const src = URL.createObjectURL(file);
    const isFilm = file.type.startsWith('video');
    const shown = isFilm
      ? element('video', { autoplay: '', loop: '', playsinline: '' })
      : element('img', { alt: 'The fire as it is saved' });
    if (shown instanceof HTMLVideoElement) shown.muted = true;
    for (const type of ['load', 'loadeddata', 'error'])
      shown.addEventListener(type, () => URL.revokeObjectURL(src), { once: true });
    shown.src = src;
    this.#preview.replaceChildren(shown);
  }

  async #record() {
    if (this.#film) return;
    clearTimeout(this.#rests);
    this.#sample?.abort();
    const options = this.#options;
    const kind = this.#kind;
    const { value: size } = this.#size.select;
    const { format, seconds } = options;
    remember({
      film: { kind, format: this.#formats.select.value, size, background: this.#background.select.value, seconds },
    });
    this.#busy(true);
    try {
      this.#film = new AbortController();
      const file = await this.#file(options, this.#film.signal);
      if (!file) return;
      const { ending } = FORMATS[/** @type {keyof typeof FORMATS} */ (format)];
      const name = `hearth.${ending}`;
      download(file, name);
      if (ending !== 'zip' && format !== 'wav') this.#show(file);
      const { width, height } = options;
      this.#about.textContent = `Saved ${name}, ${kind === 'still' ? `${width} pixels wide` : `${width} × ${height} pixels, ${megabytes(file.size)}`}.`;
      this.#saved(this.#about.textContent);
      if (kind === 'still') this.#close();
    } catch (error) {
      if (this.#film?.signal.aborted) this.#about.textContent = 'Cancelled. Nothing is saved.';
      else this.#alert.textContent = messageOf(error);
    } finally {
      this.#film = undefined;
      this.#busy(false);
    }
  }

  /** @type {(options: Options, signal: AbortSignal) => Promise<Blob | undefined>} */
  async #file(options, signal) {
    // One film of a fire is recorded at a time.
    await this.#sampled;
    const { width, background, describe } = options;
    if (this.#kind === 'still' && !describe && this.#size.select.value === SIZES.at(-1))
      return this.#fire.toBlob({ width, background });
    let told = 0;
    return this.#fire.record({
      ...options,
      signal,
      onprogress: ({ frame, frames, bytes }) => {
        this.#progress.value = frame / frames;
        if (frame - told < frames / 10 && frame > 1) return;
        told = frame;
        this.#about.textContent = `Picture ${frame} of ${frames}, ${megabytes(bytes)} so far.`;
      },
    });
  }

  /** @param {boolean} busy */
  #busy(busy) {
    this.#progress.hidden = !busy;
    this.#progress.value = 0;
    this.#alert.textContent = '';
    this.#save.disabled = busy;
    this.#cancel.textContent = busy ? 'Cancel' : 'Close';
    const fields = /** @type {NodeListOf<HTMLInputElement>} */ (this.#dialog.querySelectorAll('select, input'));
    for (const field of fields) field.disabled = busy;
    if (busy) this.#cancel.focus();
  }

  /** Closes the dialog. A hidden one would take the next key: it keeps the focus until the browser draws a frame. */
  #close() {
    this.#dialog.close();
    this.#end();
  }

  #end() {
    clearTimeout(this.#rests);
    this.#sample?.abort();
    this.#film?.abort();
    this.#host.remove();
  }
}

/** @param {unknown} error */
const messageOf = (error) => (error instanceof Error ? error.message : String(error));
