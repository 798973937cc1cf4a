/**
 * Films of pictures that the browser encodes one by one: animated WebP, animated PNG, and PNG files in a zip archive. Each
 * has a place for a text.
 *
 * A film takes files of pictures and returns pieces of its own file.
 *
 * @typedef {import('./bytes.js').Piece} Piece
 * @typedef {{width: number, height: number, fps: number, count: number, text?: string}} Header
 */

import { ascii, big, chunksOf, crc32, joined, little, room, utf8 } from './bytes.js';

/** When a picture is shown, in units of which a second has so many. @type {(number: number, fps: number, units: number) => number} */
export function ticks(number, fps, units) {
  return Math.round((number * units) / fps);
}

/** A chunk of RIFF. @type {(name: string, ...parts: (Uint8Array | number[])[]) => Uint8Array<ArrayBuffer>} */
function riff(name, ...parts) {
  const bytes = joined(...parts);
  return joined(ascii(name), little(bytes.length, 4), bytes, room(bytes.length % 2));
}

/** Animated WebP. https://developers.google.com/speed/webp/docs/riff_container */
export class WebP {
  /** @param {Header} header */
  constructor(header) {
    this.header = header;
    this.bytes = 0;
  }

  /** @type {(file: Uint8Array<ArrayBuffer>, number: number) => Piece[]} */
  add(file, number) {
    const { width, height, fps } = this.header;
    const parts = chunksOf(file, 'riff').filter(({ name }) => ['ALPH', 'VP8 ', 'VP8L'].includes(name));
    const shown = ticks(number + 1, fps, 1000) - ticks(number, fps, 1000);
    // It replaces all of the picture before.
    const place = [0, 0, width - 1, height - 1, shown].flatMap((value) => little(value, 3));
    const frame = riff('ANMF', [...place, 2], ...parts.map(({ name, bytes }) => riff(name, bytes)));
    const pieces = number > 0 ? [{ bytes: frame }] : [{ bytes: this.#start() }, { bytes: frame }];
    this.bytes += pieces.reduce((sum, { bytes }) => sum + bytes.length, 0);
    return pieces;
  }

  #start() {
    const { width, height } = this.header;
    const sides = [width - 1, height - 1].flatMap((side) => little(side, 3));
    const [animated, xmp, alpha] = [0x02, this.header.text ? 0x04 : 0, 0x10];
    const chunks = [
      riff('VP8X', [animated | xmp | alpha, 0, 0, 0, ...sides]),
      riff('ANIM', [0, 0, 0, 0], little(0, 2)),
    ];
    return joined(ascii('RIFF'), little(0, 4), ascii('WEBP'), ...chunks);
  }

  /** @returns {Piece[]} */
  end() {
    const { text } = this.header;
    const bytes = text ? riff('XMP ', utf8(xmpOf(text))) : room(0);
    return [{ bytes }, { bytes: joined(little(this.bytes + bytes.length - 8, 4)), at: 4 }];
  }
}

/** A text as XMP. @param {string} text */
function xmpOf(text) {
  const escaped = text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
  const [rdf, dc] = ['http://www.w3.org/1999/02/22-rdf-syntax-ns#', 'http://purl.org/dc/elements/1.1/'];
  const description = `<dc:description>${escaped}</dc:description></rdf:Description></rdf:RDF></x:xmpmeta>`;
  return `<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="${rdf}"><rdf:Description xmlns:dc="${dc}">${description}`;
}

const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];

/** A chunk of PNG. @type {(name: string, ...parts: (Uint8Array | number[])[]) => Uint8Array<ArrayBuffer>} */
export function chunk(name, ...parts) {
  const named = joined(ascii(name), ...parts);
  return joined(big(named.length - 4, 4), named, big(crc32(named), 4));
}

/** A file of PNG. @param {...(Uint8Array | number[])} chunks */
export const png = (...chunks) => joined(SIGNATURE, ...chunks, chunk('IEND'));

/** A text as a chunk, under the keyword `hearth`; nothing without one. @param {string} [text] */
const described = (text) => (text ? chunk('iTXt', ascii('hearth'), [0, 0, 0, 0, 0], utf8(text)) : room(0));

/** A file of PNG with a text behind its first chunk. @type {(file: Uint8Array<ArrayBuffer>, text?: string) => Uint8Array<ArrayBuffer>} */
export const withText = (file, text) => joined(file.subarray(0, 33), described(text), file.subarray(33));

/** Animated PNG. https://www.w3.org/TR/png-3/#apng-frame-based-animation */
export class Apng {
  #sequence = 0;
  /** The header of all pictures. */
  #common = '';

  /** @param {Header} header */
  constructor(header) {
    this.header = header;
  }

  /** @type {(file: Uint8Array<ArrayBuffer>, number: number) => Piece[]} */
  add(file, number) {
    const { width, height, fps, count } = this.header;
    const chunks = chunksOf(file, 'png');
    const first = chunks[0].bytes;
    this.#common ||= `${first}`;
    if (`${first}` !== this.#common)
      throw new Error('this browser encodes the pictures of a film as PNG of several kinds');
    const shown = ticks(number + 1, fps, 1000) - ticks(number, fps, 1000);
    // It replaces all of the picture before.
    const sides = [width, height, 0, 0].flatMap((side) => big(side, 4));
    const control = chunk('fcTL', big(this.#sequence++, 4), sides, big(shown, 2), big(1000, 2), [0, 0]);
    const data = chunks.filter(({ name }) => name === 'IDAT').map(({ bytes }) => bytes);
    if (number > 0)
      return [{ bytes: joined(control, ...data.map((part) => chunk('fdAT', big(this.#sequence++, 4), part))) }];
    const start = [
      SIGNATURE,
      chunk('IHDR', first),
      chunk('sRGB', [0]),
      described(this.header.text),
      chunk('acTL', big(count, 4), big(0, 4)),
      control,
    ];
    return [{ bytes: joined(...start, ...data.map((part) => chunk('IDAT', part))) }];
  }

  /** @returns {Piece[]} */
  end() {
    return [{ bytes: chunk('IEND') }];
  }
}

/** The largest file of the format without extensions. */
const MAX_ZIP = 2 ** 32 - 1;
/** The first of January 1980, midnight: entries have no time. */
const NO_TIME = [0, 0, 0x21, 0];

/** Files in a zip archive, which are stored as they are: PNG files of pictures, by their numbers. APPNOTE 6.3.10 */
export class Zip {
  #at = 0;
  /** @type {Uint8Array[]} */
  #directory = [];

  /** @param {{text?: string}} [header] */
  constructor(header) {
    this.text = header?.text;
  }

  /** @type {(file: Uint8Array<ArrayBuffer>, number: number) => Piece[]} */
  add(file, number) {
    return this.put(withText(file, this.text), `${String(number).padStart(5, '0')}.png`);
  }

  /** @type {(file: Uint8Array<ArrayBuffer>, named: string) => Piece[]} */
  put(file, named) {
    const name = ascii(named);
    const size = little(file.length, 4);
    const entry = [...little(0, 4), ...NO_TIME, ...little(crc32(file), 4), ...size, ...size, name.length, 0, 0, 0];
    const local = joined(ascii('PK\x03\x04'), [10, 0], entry, name);
    const rest = [...little(0, 6), ...little(0, 4), ...little(this.#at, 4)];
    this.#directory.push(joined(ascii('PK\x01\x02'), [10, 0, 10, 0], entry, rest, name));
    this.#at += local.length + file.length;
    if (this.#at > MAX_ZIP) throw new Error('a zip archive has at most 4 GB: record a part of the film');
    return [{ bytes: local }, { bytes: file }];
  }

  /** @returns {Piece[]} */
  end() {
    const entries = joined(...this.#directory);
    const count = little(this.#directory.length, 2);
    const end = [...little(0, 4), ...count, ...count, ...little(entries.length, 4), ...little(this.#at, 4), 0, 0];
    return [{ bytes: joined(entries, ascii('PK\x05\x06'), end) }];
  }
}

/** One picture. */
export class Still {
  /** @param {{text?: string}} header */
  constructor({ text }) {
    this.text = text;
  }

  /** @type {(file: Uint8Array<ArrayBuffer>) => Piece[]} */
  add(file) {
    return [{ bytes: withText(file, this.text) }];
  }

  /** @returns {Piece[]} */
  end() {
    return [];
  }
}
