/**
 * Screenshots as pixels, and figures of them for assertions: the share that glows, the
 * difference from another picture.
 *
 * It decodes the PNGs that browsers write: 8 bits a channel, RGB or RGBA, not interlaced.
 */
import { inflateSync } from 'node:zlib';

/** @typedef {{x: number, y: number, width: number, height: number}} Rectangle */

/** The pixels of a screenshot. */
export class Picture {
  /**
   * @param {number} width
   * @param {number} height
   * @param {Uint8Array} rgb  Three bytes a pixel, row by row from the top.
   */
  constructor(width, height, rgb) {
    this.width = width;
    this.height = height;
    this.rgb = rgb;
  }

  /**
   * @param {Uint8Array} png
   * @param {number[]} [behind]  The colour behind what is transparent; without one, alpha is ignored.
   */
  static decode(png, behind) {
    const bytes = Buffer.from(png);
    const width = bytes.readUInt32BE(16);
    const height = bytes.readUInt32BE(20);
    const [depth, colour, , , interlace] = bytes.subarray(24, 29);
    if (depth !== 8 || (colour !== 2 && colour !== 6) || interlace !== 0) {
      throw new Error(`a PNG of depth ${depth}, colour type ${colour}, interlace ${interlace}`);
    }
    const parts = [];
    for (let at = 8; at < bytes.length; ) {
      const length = bytes.readUInt32BE(at);
      if (bytes.toString('latin1', at + 4, at + 8) === 'IDAT') {
        parts.push(bytes.subarray(at + 8, at + 8 + length));
      }
      at += length + 12;
    }
    const channels = colour === 6 ? 4 : 3;
    const rows = unfilter(inflateSync(Buffer.concat(parts)), width * channels, height, channels);
    const rgb = new Uint8Array(width * height * 3);
    for (let from = 0, to = 0; to < rgb.length; from += channels, to += 3) {
      const alpha = behind && channels === 4 ? rows[from + 3] / 255 : 1;
      for (let k = 0; k < 3; k += 1) rgb[to + k] = rows[from + k] * alpha + (behind?.[k] ?? 0) * (1 - alpha) + 0.5;
    }
    return new Picture(width, height, rgb);
  }

  /**
   * A crop of the picture, in fractions of its width and height.
   * @param {number} left @param {number} top @param {number} right @param {number} bottom
   */
  crop(left, top, right, bottom) {
    const x = Math.round(left * this.width);
    const y = Math.round(top * this.height);
    const width = Math.max(1, Math.round(right * this.width) - x);
    const height = Math.max(1, Math.round(bottom * this.height) - y);
    const rgb = new Uint8Array(width * height * 3);
    for (let row = 0; row < height; row += 1) {
      const start = ((y + row) * this.width + x) * 3;
      rgb.set(this.rgb.subarray(start, start + width * 3), row * width * 3);
    }
    return new Picture(width, height, rgb);
  }

  /** Share of the pixels that are bright with R ≥ G ≥ B, like fire. */
  glowing() {
    return this.share((r, g, b) => r > 70 && r >= g - 2 && g >= b - 2);
  }

  /** Share of the pixels that are nearly black. */
  dark() {
    return this.share((r, g, b) => Math.max(r, g, b) < 24);
  }

  /**
   * Share of the pixels for which `holds`.
   * @param {(r: number, g: number, b: number) => boolean} holds
   */
  share(holds) {
    let count = 0;
    for (let at = 0; at < this.rgb.length; at += 3) {
      if (holds(this.rgb[at], this.rgb[at + 1], this.rgb[at + 2])) count += 1;
    }
    return count / (this.rgb.length / 3);
  }

  /**
   * Mean difference from another picture of the same size, 0–255 a channel.
   * @param {Picture} other
   */
  difference(other) {
    if (other.width !== this.width || other.height !== this.height) {
      throw new Error('two pictures of different sizes have no difference');
    }
    let sum = 0;
    for (let at = 0; at < this.rgb.length; at += 1) sum += Math.abs(this.rgb[at] - other.rgb[at]);
    return sum / this.rgb.length;
  }
}

/**
 * Reverses PNG's five row filters.
 * @param {Uint8Array} data @param {number} stride @param {number} height @param {number} channels
 */
function unfilter(data, stride, height, channels) {
  const rows = new Uint8Array(stride * height);
  for (let y = 0; y < height; y += 1) {
    const filter = data[y * (stride + 1)];
    const from = y * (stride + 1) + 1;
    const to = y * stride;
    for (let x = 0; x < stride; x += 1) {
      const left = x >= channels ? rows[to + x - channels] : 0;
      const up = y > 0 ? rows[to + x - stride] : 0;
      const corner = x >= channels && y > 0 ? rows[to + x - stride - channels] : 0;
      const guess = [0, left, up, (left + up) >> 1, paeth(left, up, corner)][filter];
      rows[to + x] = data[from + x] + guess;
    }
  }
  return rows;
}

/** The neighbour that is nearest to left + up − corner. */
function paeth(left, up, corner) {
  const guess = left + up - corner;
  const [a, b, c] = [left, up, corner].map((neighbour) => Math.abs(guess - neighbour));
  if (a <= b && a <= c) return left;
  return b <= c ? up : corner;
}
