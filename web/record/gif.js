/**
 * Animated GIF: one palette of all pictures, and an ordered dither, which does not crawl from picture to picture as
 * diffused errors do. https://www.w3.org/Graphics/GIF/spec-gif89a.txt
 *
 * @typedef {import('./bytes.js').Piece} Piece
 */

import { ascii, joined, little, utf8 } from './bytes.js';
import { ticks } from './pictures.js';

/** Colours of the palette. One more entry is transparent. */
const COLOURS = 255;
/** Alpha from which a pixel is opaque. */
const OPAQUE = 128;
/** Side of the matrix of thresholds, B. E. Bayer, 1973, and the distance of the colours between which it chooses. */
const SIDE = 8;
const SPREAD = 20;
/** Colours of five bits a channel, as which pixels are kept, and the one that is none. */
const CELLS = 32 ** 3;
const CLEAR = CELLS;

/** The threshold of a pixel, from 0 to 1. @type {(x: number, y: number) => number} */
export function threshold(x, y) {
  let sum = 0;
  for (let bit = 0; bit < 3; bit += 1) {
    const [crossed, down] = [((x ^ y) >> bit) & 1, (y >> bit) & 1];
    sum |= (crossed << (5 - 2 * bit)) | (down << (4 - 2 * bit));
  }
  return sum / SIDE ** 2;
}

const OFFSETS = Array.from(
  { length: SIDE ** 2 },
  (_, at) => (threshold(at % SIDE, Math.floor(at / SIDE)) - 0.5) * SPREAD,
);

/** The middle of a cell, by channels. @param {number} cell */
const colourOf = (cell) => [cell >> 10, (cell >> 5) & 31, cell & 31].map((part) => Math.round((part * 255) / 31));

/** Keeps all pictures, since the palette follows from them: two bytes a pixel. */
export class Gif {
  /** @type {Uint16Array[]} */
  #pictures = [];
  #counts = new Float64Array(CELLS + 1);

  /** @param {import('./pictures.js').Header} header */
  constructor(header) {
    this.header = header;
  }

  /** Takes the pixels of a picture, with straight alpha. @type {(rgba: Uint8ClampedArray) => Piece[]} */
  add(rgba) {
    const { width } = this.header;
    const cells = new Uint16Array(rgba.length / 4);
    for (let pixel = 0; pixel < cells.length; pixel += 1) {
      const at = 4 * pixel;
      if (rgba[at + 3] < OPAQUE) {
        cells[pixel] = CLEAR;
        continue;
      }
      const [x, y] = [pixel % width, Math.floor(pixel / width)];
      const offset = OFFSETS[(y % SIDE) * SIDE + (x % SIDE)];
      const part = (/** @type {number} */ value) => (Math.min(255, Math.max(0, value + offset)) * 31 + 127.5) / 255;
      cells[pixel] = (part(rgba[at]) << 10) | (part(rgba[at + 1]) << 5) | part(rgba[at + 2]);
      this.#counts[cells[pixel]] += 1;
    }
    this.#pictures.push(cells);
    return [];
  }

  /** @returns {Piece[]} */
  end() {
    const { width, height, fps, text } = this.header;
    const { colours, nearest } = paletteOf(this.#counts);
    const sides = [...little(width, 2), ...little(height, 2)];
    const forever = [0x21, 0xff, 11, ...ascii('NETSCAPE2.0'), 3, 1, 0, 0, 0];
    /** @type {Piece[]} */
    const pieces = [{ bytes: joined(ascii('GIF89a'), sides, [0xf7, 0, 0], colours.flat(), forever) }];
    if (text) pieces.push({ bytes: joined([0x21, 0xfe], blocksOf(utf8(text))) });
    for (const [number, cells] of this.#pictures.entries()) {
      const shown = ticks(number + 1, fps, 100) - ticks(number, fps, 100);
      // The background replaces it before the next one.
      const control = [0x21, 0xf9, 4, 0x09, ...little(shown, 2), COLOURS, 0];
      const image = [0x2c, 0, 0, 0, 0, ...sides, 0, 8];
      const indices = Uint8Array.from(cells, (cell) => nearest[cell]);
      pieces.push({ bytes: joined(control, image, compressed(indices)) });
    }
    this.#pictures = [];
    return [...pieces, { bytes: joined([0x3b]) }];
  }
}

/**
 * The colours of a film, and the index of the nearest one for each cell: the median cut of P. Heckbert, 1982, by the
 * variance of the boxes, and the means of what is nearest to each.
 * @param {Float64Array} counts the pixels of each cell
 * @returns {{colours: number[][], nearest: Uint8Array}}
 */
export function paletteOf(counts) {
  const used = Array.from({ length: CELLS }, (_, cell) => cell).filter((cell) => counts[cell] > 0);
  const points = used.map((cell) => ({ cell, colour: colourOf(cell), count: counts[cell] }));
  const boxes = [boxOf(points)];
  while (boxes.length < COLOURS) {
    const most = boxes.reduce((best, box) => (box.spread > best.spread ? box : best), boxes[0]);
    if (!(most.spread > 0)) break;
    const [low, high] = [true, false].map((below) =>
      most.points.filter(({ colour }) => colour[most.channel] <= most.mean[most.channel] === below),
    );
    boxes.splice(boxes.indexOf(most), 1, boxOf(low), boxOf(high));
  }
  let colours = boxes.map(({ mean }) => mean);
  const nearestOf = (/** @type {number[]} */ [r, g, b]) => {
    let [best, least] = [0, Infinity];
    for (let at = 0; at < colours.length; at += 1) {
      const known = colours[at];
      const distance = (known[0] - r) ** 2 + (known[1] - g) ** 2 + (known[2] - b) ** 2;
      if (distance < least) [best, least] = [at, distance];
    }
    return best;
  };
  for (let round = 0; round < 2; round += 1) {
    /** @type {typeof points[]} */
    const groups = colours.map(() => []);
    for (const point of points) groups[nearestOf(point.colour)].push(point);
    colours = groups.map((group, at) => (group.length > 0 ? boxOf(group).mean : colours[at]));
  }
  const nearest = new Uint8Array(CELLS + 1).fill(COLOURS);
  for (const { cell, colour } of points) nearest[cell] = nearestOf(colour);
  const filled = Array.from({ length: COLOURS + 1 }, (_, at) => (colours[at] ?? [0, 0, 0]).map(Math.round));
  return { colours: filled, nearest };
}

/** Colours with their mean, and the channel in which they differ most. @param {{cell: number, colour: number[], count: number}[]} points */
function boxOf(points) {
  let total = 0;
  const [sums, squares] = [
    [0, 0, 0],
    [0, 0, 0],
  ];
  for (const { colour, count } of points) {
    total += count;
    for (let at = 0; at < 3; at += 1) {
      sums[at] += count * colour[at];
      squares[at] += count * colour[at] ** 2;
    }
  }
  const mean = sums.map((sum) => sum / Math.max(total, 1));
  const spreads = points.length < 2 ? [0, 0, 0] : squares.map((square, at) => square - total * mean[at] ** 2);
  const spread = Math.max(...spreads);
  return { points, mean, channel: spreads.indexOf(spread), spread: spread > 1e-6 ? spread : 0 };
}

/** Indices as the blocks of an image (LZW with codes of at most 12 bits). @param {Uint8Array} indices */
export function compressed(indices) {
  const [clear, end, full] = [256, 257, 4096];
  /** The code of a known sequence with one more index; 0: unknown. */
  const known = new Uint16Array(full * 256);
  const out = [];
  let [bits, held, size, next] = [0, 0, 9, end + 1];
  const write = (/** @type {number} */ code) => {
    held |= code << bits;
    for (bits += size; bits >= 8; bits -= 8) {
      out.push(held & 255);
      held >>>= 8;
    }
  };
  write(clear);
  let code = indices[0];
  for (let at = 1; at < indices.length; at += 1) {
    const slot = code * 256 + indices[at];
    if (known[slot] > 0) {
      code = known[slot];
      continue;
    }
    write(code);
    if (next < full) {
      if (next === 1 << size) size += 1;
      known[slot] = next++;
    } else {
      write(clear);
      known.fill(0);
      [size, next] = [9, end + 1];
    }
    code = indices[at];
  }
  write(code);
  if (next === 1 << size && size < 12) size += 1;
  write(end);
  if (bits > 0) out.push(held & 255);
  return blocksOf(out);
}

/** Bytes in blocks, each behind its length, the last one of none. @param {Uint8Array | number[]} bytes */
function blocksOf(bytes) {
  const blocks = [];
  for (let at = 0; at < bytes.length; at += 255) {
    const block = bytes.slice(at, at + 255);
    blocks.push([block.length], block);
  }
  return joined(...blocks, [0]);
}
