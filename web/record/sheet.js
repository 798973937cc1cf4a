/**
 * A sprite sheet: the pictures of a film as tiles of one PNG file, and where they are, as TexturePacker's JSON of the form
 * "hash", as `hearth sprites` writes both.
 *
 * @typedef {import('./bytes.js').Piece} Piece
 * @typedef {import('./pictures.js').Header & {premultiplied: boolean}} Header
 */

import { bleed } from './alpha.js';
import { big, joined, utf8 } from './bytes.js';
import { Zip, chunk, png, withText } from './pictures.js';

/** Most tiles in a row, and transparent pixels around each. */
const COLUMNS = 8;
const GUTTER = 1;

/** Names of the picture, the description and the animation. */
const NAME = 'hearth';

/** Where the tiles of a sheet are. @param {{width: number, height: number, count: number}} header */
export function gridOf({ width, height, count }) {
  const [across, up] = [width, height].map((side) => side + 2 * GUTTER);
  const columns = Math.min(COLUMNS, count);
  const corner = (/** @type {number} */ number) => ({
    x: (number % columns) * across + GUTTER,
    y: Math.floor(number / columns) * up + GUTTER,
  });
  return { width: columns * across, height: Math.ceil(count / columns) * up, corner };
}

/** The description of a sheet. @param {Header} header */
export function atlasOf(header) {
  const { width: w, height: h, count, fps, premultiplied } = header;
  const grid = gridOf(header);
  const names = Array.from({ length: count }, (_, number) => `${NAME}-${String(number).padStart(4, '0')}`);
  const frames = names.map((name, number) => {
    const frame = { ...grid.corner(number), w, h };
    const source = { spriteSourceSize: { x: 0, y: 0, w, h }, sourceSize: { w, h } };
    return [name, { frame, rotated: false, trimmed: false, ...source, duration: Math.round(1000 / fps) }];
  });
  const image = { image: `${NAME}.png`, format: 'RGBA8888', size: { w: grid.width, h: grid.height }, scale: '1' };
  const meta = { app: 'hearth', ...image, frameRate: fps, premultiplied };
  return { frames: Object.fromEntries(frames), animations: { [NAME]: names }, meta };
}

/** A sheet and its description in a zip archive. */
export class Sheet {
  #header;
  #grid;
  #rgba;

  /** @param {Header} header */
  constructor(header) {
    this.#header = header;
    this.#grid = gridOf(header);
    this.#rgba = new Uint8ClampedArray(4 * this.#grid.width * this.#grid.height);
  }

  /** Takes the pixels of a picture, with straight alpha. @type {(rgba: Uint8ClampedArray, number: number) => Piece[]} */
  add(rgba, number) {
    const { width, height, premultiplied } = this.#header;
    if (premultiplied) {
      for (let at = 0; at < rgba.length; at += 1) if (at % 4 < 3) rgba[at] = (rgba[at] * rgba[at | 3]) / 255;
    } else bleed(rgba, width);
    const { x, y } = this.#grid.corner(number);
    for (let row = 0; row < height; row += 1) {
      const from = 4 * row * width;
      this.#rgba.set(rgba.subarray(from, from + 4 * width), 4 * ((y + row) * this.#grid.width + x));
    }
    return [];
  }

  /** @returns {Promise<Piece[]>} */
  async end() {
    const zip = new Zip();
    const picture = withText(await pngOf(this.#rgba, this.#grid), this.#header.text);
    const text = utf8(`${JSON.stringify(atlasOf(this.#header), null, 2)}\n`);
    return [...zip.put(picture, `${NAME}.png`), ...zip.put(text, `${NAME}.json`), ...zip.end()];
  }
}

/**
 * Pixels as PNG. A canvas would lose the colours of transparent ones. Each row has the differences from the one above.
 * @type {(rgba: Uint8ClampedArray, size: {width: number, height: number}) => Promise<Uint8Array<ArrayBuffer>>}
 */
async function pngOf(rgba, { width, height }) {
  const length = 4 * width;
  const rows = new Uint8Array((length + 1) * height);
  for (let row = 0; row < height; row += 1) {
    const [to, from] = [row * (length + 1), row * length];
    rows[to] = 2;
    for (let at = 0; at < length; at += 1)
      rows[to + 1 + at] = rgba[from + at] - (row > 0 ? rgba[from + at - length] : 0);
  }
  const stream = new Blob([rows]).stream().pipeThrough(new CompressionStream('deflate'));
  const data = new Uint8Array(await new Response(stream).arrayBuffer());
  const head = joined(big(width, 4), big(height, 4), [8, 6, 0, 0, 0]);
  return png(chunk('IHDR', head), chunk('sRGB', [0]), chunk('IDAT', data));
}
