/**
 * A golden picture: a fire over black and over white, which shows what absorbs without
 * emitting; opaque fires once. It is half the drawn size with few colours, so that the
 * file stays small.
 */
import { deflateSync } from 'node:zlib';
import { Picture } from '../e2e/picture.mjs';

/** @typedef {import('./painter.mjs').Pixels} Pixels */

/** Steps of a channel from one kept colour to the next. */
const STEP = 4;

/**
 * The sheet of a picture.
 * @param {Pixels} pixels @returns {Picture}
 */
export function sheet({ width, height, rgba }) {
  const [columns, rows] = [width >> 1, height >> 1];
  const panels = rgba.every((value, at) => at % 4 !== 3 || value === 255) ? 1 : 2;
  const rgb = new Uint8Array(columns * panels * rows * 3);
  for (let y = 0; y < rows; y += 1) {
    for (let x = 0; x < columns; x += 1) {
      const sum = [0, 0, 0, 0];
      for (const [dx, dy] of [
        [0, 0],
        [1, 0],
        [0, 1],
        [1, 1],
      ]) {
        const from = ((2 * y + dy) * width + 2 * x + dx) * 4;
        for (let channel = 0; channel < 4; channel += 1) sum[channel] += rgba[from + channel] / 4;
      }
      for (let panel = 0; panel < panels; panel += 1) {
        const behind = panel * (255 - sum[3]);
        const to = ((y * panels + panel) * columns + x) * 3;
        for (let channel = 0; channel < 3; channel += 1) {
          rgb[to + channel] = Math.min(255, Math.round(sum[channel] + behind));
        }
      }
    }
  }
  return new Picture(columns * panels, rows, rgb);
}

/**
 * A picture in few colours. Black stays black, and white white.
 * @param {Picture} picture
 */
export function coarse({ width, height, rgb }) {
  const most = Math.floor(255 / STEP);
  const few = rgb.map((value) => Math.round(Math.round((value / 255) * most) * (255 / most)));
  return new Picture(width, height, few);
}

/**
 * A PNG: 8 bits a channel, each row with the filter that leaves least of it.
 * @param {Picture} picture
 */
export function encode({ width, height, rgb }) {
  const stride = width * 3;
  const rows = [];
  const above = new Uint8Array(stride);
  for (let y = 0; y < height; y += 1) {
    const row = rgb.subarray(y * stride, (y + 1) * stride);
    const filtered = FILTERS.map((guess, filter) => {
      const out = Buffer.alloc(stride + 1);
      out[0] = filter;
      for (let x = 0; x < stride; x += 1) {
        const [left, corner] = x < 3 ? [0, 0] : [row[x - 3], above[x - 3]];
        out[x + 1] = row[x] - guess(left, above[x], corner);
      }
      return out;
    });
    rows.push(filtered.reduce((best, row) => (weight(row) < weight(best) ? row : best)));
    above.set(row);
  }
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 2, 0, 0, 0], 8);
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    chunk('IHDR', header),
    chunk('IDAT', deflateSync(Buffer.concat(rows), { level: 9, memLevel: 9 })),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

/** PNG's guesses of a byte from its neighbours. */
const FILTERS = [
  () => 0,
  (/** @type {number} */ left) => left,
  (/** @type {number} */ _, /** @type {number} */ up) => up,
  (/** @type {number} */ left, /** @type {number} */ up) => (left + up) >> 1,
  (/** @type {number} */ left, /** @type {number} */ up, /** @type {number} */ corner) => {
    const [a, b, c] = [left, up, corner].map((neighbour) => Math.abs(left + up - corner - neighbour));
    if (a <= b && a <= c) return left;
    return b <= c ? up : corner;
  },
];

/** How far from nothing a filtered row is. @param {Buffer} row */
function weight(row) {
  let sum = 0;
  for (let at = 1; at < row.length; at += 1) sum += row[at] < 128 ? row[at] : 256 - row[at];
  return sum;
}

/** @param {string} name @param {Buffer} data */
function chunk(name, data) {
  const body = Buffer.concat([Buffer.from(name, 'latin1'), data]);
  const whole = Buffer.alloc(body.length + 8);
  whole.writeUInt32BE(data.length, 0);
  whole.set(body, 4);
  whole.writeUInt32BE(crc(body), body.length + 4);
  return whole;
}

/** @param {Buffer} bytes */
function crc(bytes) {
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; bit += 1) sum = sum & 1 ? (sum >>> 1) ^ 0xedb88320 : sum >>> 1;
  }
  return (sum ^ 0xffffffff) >>> 0;
}
