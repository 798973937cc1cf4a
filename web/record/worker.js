/**
 * The worker in which films are encoded. It answers each message with pieces of the file, or why there are none.
 *
 * @typedef {import('./bytes.js').Piece} Piece
 * @typedef {import('./options.js').Film} Film
 * @typedef {{pieces?: Piece[], format?: string, start?: number, why?: string}} Answer
 * @typedef {object} Asked
 * @property {Film} [open] begins a film
 * @property {ImageBitmap} [search] a small picture, in which the beginning of a loop is looked for
 * @property {boolean} [found] asks where that is
 * @property {ImageBitmap} [keep] a picture before the beginning of a loop, which is mixed into its end
 * @property {ImageBitmap} [picture]
 * @property {number} [number] that of the picture
 * @property {number} [share] that of the oldest kept picture
 * @property {boolean} [end]
 * @property {Float32Array[]} [samples] the sound
 */

import { Gif } from './gif.js';
import { mix, startOf } from './loop.js';
import { Apng, Still, WebP, Zip } from './pictures.js';
import { Sheet } from './sheet.js';
import { wav } from './wav.js';

/** Quality of the colours of WebP. */
const QUALITY = 0.9;

/** @type {Film} */
let film;
/** @type {OffscreenCanvas} */
let canvas;
/** @type {WebP | Apng | Zip | Still | Gif | Sheet | import('./video.js').Video | undefined} */
let file;
/** @type {Uint8ClampedArray[]} */
const searched = [];
/** @type {Uint8ClampedArray[]} */
const kept = [];

/**
 * Draws a picture on the canvas, over a colour, and returns its pixels with straight alpha, as they are read.
 * @type {(bitmap: ImageBitmap, over?: string) => {readonly data: Uint8ClampedArray<ArrayBuffer>}}
 */
function drawn(bitmap, over) {
  const { width, height } = bitmap;
  if (canvas?.width !== width || canvas.height !== height) canvas = new OffscreenCanvas(width, height);
  const context = context2d();
  context.globalCompositeOperation = 'copy';
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  if (over) {
    context.globalCompositeOperation = 'destination-over';
    context.fillStyle = over;
    context.fillRect(0, 0, width, height);
  }
  return {
    get data() {
      return /** @type {Uint8ClampedArray<ArrayBuffer>} */ (context.getImageData(0, 0, width, height).data);
    },
  };
}

function context2d() {
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('this browser has no memory for a picture of that size');
  return context;
}

/** The picture as a file. @param {string} type */
async function encoded(type) {
  const blob = await canvas.convertToBlob({ type, quality: QUALITY });
  if (blob.type !== type) throw new Error(`this browser cannot encode ${type}: try format "apng"`);
  return new Uint8Array(await blob.arrayBuffer());
}

/** Begins a film, as APNG if no format is stated and the browser encodes no WebP. @param {Film} opened @returns {Promise<Answer>} */
async function open(opened) {
  film = opened;
  if (globalThis.OffscreenCanvas === undefined)
    throw new Error('this browser cannot encode pictures outside of the thread of the page');
  if (film.format === 'auto') {
    canvas = new OffscreenCanvas(1, 1);
    context2d();
    const { type } = await canvas.convertToBlob({ type: 'image/webp' });
    film.format = type === 'image/webp' ? 'webp' : 'apng';
  }
  const { format } = film;
  if (format === 'webp') file = new WebP(film);
  else if (format === 'apng') file = new Apng(film);
  else if (format === 'zip') file = new Zip(film);
  else if (format === 'png') file = new Still(film);
  else if (format === 'gif') file = new Gif(film);
  else if (format === 'sheet') file = new Sheet(film);
  else if (format !== 'wav') file = await (await import('./video.js')).Video.open(film);
  return { format };
}

/** @type {(asked: Asked) => Promise<Answer>} */
async function answer({ open: opened, search, found, keep, picture, number = 0, share, end, samples }) {
  if (opened) return open(opened);
  if (search) searched.push(drawn(search, 'black').data);
  if (keep) kept.push(drawn(keep).data);
  if (found) return { start: startOf(searched.splice(0), film.count, film.fps) };
  if (picture) return { pieces: await add(picture, number, share) };
  if (!end) return {};
  if (!file) return { pieces: [{ bytes: wav(/** @type {Float32Array[]} */ (samples)) }] };
  return { pieces: await file.end(samples) };
}

/** @type {(picture: ImageBitmap, number: number, share?: number) => Promise<Piece[]>} */
async function add(picture, number, share) {
  const pixels = drawn(picture);
  const earlier = share ? kept.shift() : undefined;
  if (earlier) {
    const { data } = pixels;
    mix(data, earlier, share ?? 0);
    context2d().putImageData(new ImageData(data, film.width, film.height), 0, 0);
  }
  if (file instanceof Gif || file instanceof Sheet) return file.add(pixels.data, number);
  if (file instanceof WebP) return file.add(await encoded('image/webp'), number);
  if (file instanceof Apng || file instanceof Zip || file instanceof Still)
    return file.add(await encoded('image/png'), number);
  return /** @type {import('./video.js').Video} */ (file).add(canvas, () => pixels.data, number);
}

let before = Promise.resolve();
addEventListener('message', (/** @type {MessageEvent<Asked>} */ { data }) => {
  const answered = before.then(async () => {
    /** @type {Answer} */
    let given;
    try {
      given = await answer(data);
    } catch (error) {
      given = { why: error instanceof Error ? error.message : String(error) };
    }
    const buffers = new Set(given.pieces?.map(({ bytes }) => bytes.buffer));
    /** @type {any} */ (globalThis).postMessage(given, [...buffers]);
  });
  // An answer that cannot be posted ends the film: the page hears of an error alone.
  before = answered.catch((error) => {
    setTimeout(() => {
      throw error;
    });
  });
});
