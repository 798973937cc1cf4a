/**
 * MP4: H.264, and AAC or Opus. ISO/IEC 14496-12 and 14496-14, 14496-15; https://opus-codec.org/docs/opus_in_isobmff.html
 *
 * @typedef {import('./bytes.js').Piece} Piece
 * @typedef {{size: number, at: number, isKey: boolean, length: number}} Sample
 */

import { ascii, big, joined, room, utf8 } from './bytes.js';

/** A box. @type {(name: string, ...parts: (Uint8Array | number[])[]) => Uint8Array<ArrayBuffer>} */
function box(name, ...parts) {
  const bytes = joined(...parts);
  return joined(big(bytes.length + 8, 4), ascii(name), bytes);
}

/** A box with a version and flags. @type {(name: string, flags: number, ...parts: (Uint8Array | number[])[]) => Uint8Array<ArrayBuffer>} */
const full = (name, flags, ...parts) => box(name, big(flags, 4), ...parts);

/** Numbers of four bytes. @param {...number} values */
const words = (...values) => values.flatMap((value) => big(value, 4));

/** No rotation. */
const MATRIX = words(0x10000, 0, 0, 0, 0x10000, 0, 0, 0, 0x40000000);

/** A descriptor of MPEG-4. @type {(tag: number, ...parts: (Uint8Array | number[])[]) => Uint8Array<ArrayBuffer>} */
function descriptor(tag, ...parts) {
  const bytes = joined(...parts);
  return joined([tag, 0x80, 0x80, 0x80, bytes.length], bytes);
}

/** Samples of sound in a second. */
export const RATE = 48_000;

/** What tells a decoder of the sound what it gets. @param {{codec: 'aac' | 'opus', description: Uint8Array}} sound */
function soundEntry({ codec, description }) {
  const common = [...room(6), 0, 1, ...room(8), 0, 2, 0, 16, ...room(4), ...big(RATE, 2), 0, 0];
  if (codec === 'opus') {
    // From OpusHead, whose numbers have the other order.
    const [channels, gain, family] = [description[9], [description[17], description[16]], description[18]];
    const [skip, rate] = [description.slice(10, 12).reverse(), description.slice(12, 16).reverse()];
    return box('Opus', common, box('dOps', [0, channels], skip, rate, gain, [family]));
  }
  const decoder = descriptor(4, [0x40, 0x15, 0, 0, 0], words(0, 0), descriptor(5, description));
  return box('mp4a', common, full('esds', 0, descriptor(3, [0, 1, 0], decoder, descriptor(6, [2]))));
}

/** A track. @type {(about: {id: number, ms: number, units: number, samples: Sample[], sides: number[]}, entry: Uint8Array) => Uint8Array<ArrayBuffer>} */
function track({ id, ms, units, samples, sides }, entry) {
  const isVideo = sides[0] > 0;
  const length = samples.reduce((sum, sample) => sum + sample.length, 0);
  /** @type {number[][]} */
  const runs = [];
  for (const sample of samples) {
    const last = runs.at(-1);
    if (last && last[1] === sample.length) last[0] += 1;
    else runs.push([1, sample.length]);
  }
  const keys = samples.flatMap(({ isKey }, at) => (isKey ? [at + 1] : []));
  const table = box(
    'stbl',
    full('stsd', 0, words(1), entry),
    full('stts', 0, words(runs.length, ...runs.flat())),
    ...(isVideo ? [full('stss', 0, words(keys.length, ...keys))] : []),
    full('stsc', 0, words(1, 1, 1, 1)),
    full('stsz', 0, words(0, samples.length, ...samples.map(({ size }) => size))),
    full(
      'co64',
      0,
      words(samples.length),
      samples.flatMap(({ at }) => big(at, 8)),
    ),
  );
  const reference = box('dinf', full('dref', 0, words(1), full('url ', 1)));
  const kind = isVideo ? full('vmhd', 1, room(8)) : full('smhd', 0, room(4));
  const handler = full('hdlr', 0, words(0), ascii(isVideo ? 'vide' : 'soun'), room(12), [0]);
  const media = box(
    'mdia',
    full('mdhd', 0, words(0, 0, units, length), [0x55, 0xc4, 0, 0]),
    handler,
    box('minf', kind, reference, table),
  );
  const volume = isVideo ? [0, 0] : [1, 0];
  const shown = words(...sides.map((side) => side * 65_536));
  const head = full('tkhd', 3, words(0, 0, id, 0, ms), room(8), [0, 0, 0, 0], volume, [0, 0], MATRIX, shown);
  return box('trak', head, media);
}

/** A comment, where players look for it. @param {string} text */
function comment(text) {
  const handler = full('hdlr', 0, words(0), ascii('mdirappl'), room(9));
  const data = box('data', words(1, 0), utf8(text));
  return box('udta', full('meta', 0, handler, box('ilst', box('\xa9cmt', data))));
}

/** A film of pictures and sound. */
export class Mp4 {
  #header;
  #at = 0;
  #dataAt = 0;
  /** @type {Sample[][]} */
  #samples = [[], []];

  /** @param {{width: number, height: number, fps: number, count: number, text?: string}} header */
  constructor(header) {
    this.#header = header;
  }

  /** @returns {Piece[]} */
  begin() {
    const type = box('ftyp', ascii('isom'), words(0x200), ascii('isomiso2avc1mp41'));
    this.#dataAt = type.length;
    const bytes = joined(type, words(1), ascii('mdat'), room(8));
    this.#at = bytes.length;
    return [{ bytes }];
  }

  /**
   * Adds what a decoder gets at once; `length` is in ticks of the track: those of the pictures are thousandths of one.
   * @type {(bytes: Uint8Array<ArrayBuffer>, which: 0 | 1, isKey: boolean, length: number) => Piece[]}
   */
  add(bytes, which, isKey, length) {
    this.#samples[which].push({ size: bytes.length, at: this.#at, isKey, length });
    this.#at += bytes.length;
    return [{ bytes }];
  }

  /**
   * @param {Uint8Array} description what a decoder of H.264 needs first
   * @param {{codec: 'aac' | 'opus', description: Uint8Array}} [sound]
   * @returns {Piece[]}
   */
  end(description, sound) {
    const { width, height, fps, count, text } = this.#header;
    const ms = Math.round((count * 1000) / fps);
    const entry = [...room(6), 0, 1, ...room(16), ...big(width, 2), ...big(height, 2), ...words(0x480000, 0x480000, 0)];
    const avc1 = box('avc1', entry, [0, 1], room(32), [0, 24, 0xff, 0xff], box('avcC', description));
    const [pictures, sounds] = this.#samples;
    const units = Math.round(fps * 1000);
    const tracks = [track({ id: 1, ms, units, samples: pictures, sides: [width, height] }, avc1)];
    if (sound) tracks.push(track({ id: 2, ms, units: RATE, samples: sounds, sides: [0, 0] }, soundEntry(sound)));
    const head = full('mvhd', 0, words(0, 0, 1000, ms, 0x10000), [1, 0], room(10), MATRIX, room(24), words(3));
    const size = { bytes: joined(big(this.#at - this.#dataAt, 8)), at: this.#dataAt + 8 };
    return [{ bytes: box('moov', head, ...tracks, ...(text ? [comment(text)] : [])) }, size];
  }
}
