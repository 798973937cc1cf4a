/**
 * WebM: VP9 with an alpha of its own stream, and Opus. https://www.webmproject.org/docs/container/
 *
 * @typedef {import('./bytes.js').Piece} Piece
 * @typedef {{bytes: Uint8Array<ArrayBuffer>, isKey: boolean, ms: number}} Block
 */

import { ascii, big, joined, utf8 } from './bytes.js';

/** Names of elements. */
const ID = {
  EBML: 0x1a45dfa3,
  VERSION: 0x4286,
  READ_VERSION: 0x42f7,
  ID_LENGTH: 0x42f2,
  SIZE_LENGTH: 0x42f3,
  DOC_TYPE: 0x4282,
  DOC_VERSION: 0x4287,
  DOC_READ_VERSION: 0x4285,
  SEGMENT: 0x18538067,
  SEEK_HEAD: 0x114d9b74,
  SEEK: 0x4dbb,
  SEEK_ID: 0x53ab,
  SEEK_POSITION: 0x53ac,
  INFO: 0x1549a966,
  SCALE: 0x2ad7b1,
  DURATION: 0x4489,
  MUXER: 0x4d80,
  WRITER: 0x5741,
  TRACKS: 0x1654ae6b,
  TRACK: 0xae,
  NUMBER: 0xd7,
  UID: 0x73c5,
  TYPE: 0x83,
  CODEC: 0x86,
  PRIVATE: 0x63a2,
  CODEC_DELAY: 0x56aa,
  SEEK_PRE_ROLL: 0x56bb,
  FRAME_NS: 0x23e383,
  ADDITION: 0x55ee,
  VIDEO: 0xe0,
  WIDTH: 0xb0,
  HEIGHT: 0xba,
  ALPHA: 0x53c0,
  AUDIO: 0xe1,
  RATE: 0xb5,
  CHANNELS: 0x9f,
  CLUSTER: 0x1f43b675,
  TIME: 0xe7,
  SIMPLE: 0xa3,
  GROUP: 0xa0,
  BLOCK: 0xa1,
  REFERENCE: 0xfb,
  ADDITIONS: 0x75a1,
  MORE: 0xa6,
  ADD_ID: 0xee,
  ADDITIONAL: 0xa5,
  TAGS: 0x1254c367,
  TAG: 0x7373,
  TARGETS: 0x63c0,
  SIMPLE_TAG: 0x67c8,
  TAG_NAME: 0x45a3,
  TAG_STRING: 0x4487,
  CUES: 0x1c53bb6b,
  POINT: 0xbb,
  POINT_TIME: 0xb3,
  POINT_TRACK: 0xb7,
  TRACK_OF_POINT: 0xf7,
  CLUSTER_OF_POINT: 0xf1,
};

/** An id, of which the first byte tells the length. @param {number} id */
const idOf = (id) => big(id, id > 0xffffff ? 4 : id > 0xffff ? 3 : id > 0xff ? 2 : 1);

/** A size in eight bytes, which may be replaced. @param {number} size */
const sizeOf = (size) => [0x01, ...big(size, 7)];

/** An element. @type {(id: number, ...parts: (Uint8Array | number[])[]) => Uint8Array<ArrayBuffer>} */
function element(id, ...parts) {
  const bytes = joined(...parts);
  return joined(idOf(id), sizeOf(bytes.length), bytes);
}

/** A number as an element. @type {(id: number, value: number, bytes?: number) => Uint8Array<ArrayBuffer>} */
const number = (id, value, bytes = 4) => element(id, big(value, bytes));

/** A fraction as an element. @type {(id: number, value: number) => Uint8Array<ArrayBuffer>} */
function fraction(id, value) {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, value);
  return element(id, bytes);
}

/** A text as an element. @type {(id: number, text: string) => Uint8Array<ArrayBuffer>} */
const text = (id, value) => element(id, ascii(value));

/** Where the positions of information, tracks and cues are told, from the start of the segment's contents. */
const seek = (/** @type {number} */ id, /** @type {number} */ at) =>
  element(ID.SEEK, element(ID.SEEK_ID, idOf(id)), number(ID.SEEK_POSITION, at, 8));

/** The maximum time from the start of a cluster to a block of it [ms]. */
const MAX_CLUSTER = 5000;

/** A film of one stream of pictures, with its alpha, and one of sound. */
export class WebM {
  #header;
  /** Where the next byte is, and where the contents of the segment begin. */
  #at = 0;
  #segment = 0;
  /** @type {{ms: number, at: number}[]} */
  #clusters = [];
  /** @type {{start: number, blocks: Uint8Array[]} | undefined} */
  #cluster;
  #seekAt = 0;

  /**
   * @param {object} header
   * @param {number} header.width
   * @param {number} header.height
   * @param {number} header.fps
   * @param {number} header.count
   * @param {boolean} header.alpha
   * @param {Uint8Array | undefined} [header.opus] what an Opus decoder needs first
   * @param {string} [header.text]
   */
  constructor(header) {
    this.#header = header;
  }

  /** @param {Uint8Array<ArrayBuffer>} bytes @returns {Piece} */
  #piece(bytes) {
    this.#at += bytes.length;
    return { bytes };
  }

  /** @returns {Piece[]} */
  begin() {
    const { width, height, fps, count, alpha, opus, text: about } = this.#header;
    const size = [number(ID.WIDTH, width), number(ID.HEIGHT, height)];
    const video = element(ID.VIDEO, ...size, ...(alpha ? [number(ID.ALPHA, 1, 1)] : []));
    const pictures = element(
      ID.TRACK,
      number(ID.NUMBER, 1, 1),
      number(ID.UID, 1, 1),
      number(ID.TYPE, 1, 1),
      text(ID.CODEC, 'V_VP9'),
      number(ID.FRAME_NS, Math.round(1e9 / fps)),
      ...(alpha ? [number(ID.ADDITION, 1, 1)] : []),
      video,
    );
    const sound =
      opus &&
      element(
        ID.TRACK,
        number(ID.NUMBER, 2, 1),
        number(ID.UID, 2, 1),
        number(ID.TYPE, 2, 1),
        text(ID.CODEC, 'A_OPUS'),
        element(ID.PRIVATE, opus),
        // The samples that a decoder drops at first, as it says itself, and those before a jump.
        number(ID.CODEC_DELAY, Math.round(((opus[10] | (opus[11] << 8)) * 1e9) / 48_000)),
        number(ID.SEEK_PRE_ROLL, 80_000_000),
        element(ID.AUDIO, fraction(ID.RATE, 48_000), number(ID.CHANNELS, 2, 1)),
      );
    const head = element(
      ID.EBML,
      number(ID.VERSION, 1, 1),
      number(ID.READ_VERSION, 1, 1),
      number(ID.ID_LENGTH, 4, 1),
      number(ID.SIZE_LENGTH, 8, 1),
      text(ID.DOC_TYPE, 'webm'),
      number(ID.DOC_VERSION, 4, 1),
      number(ID.DOC_READ_VERSION, 2, 1),
    );
    const info = element(
      ID.INFO,
      number(ID.SCALE, 1_000_000),
      fraction(ID.DURATION, (count * 1000) / fps),
      text(ID.MUXER, 'hearth'),
      text(ID.WRITER, 'hearth'),
    );
    const tracks = element(ID.TRACKS, pictures, ...(sound ? [sound] : []));
    const comment = [text(ID.TAG_NAME, 'COMMENT'), element(ID.TAG_STRING, utf8(about ?? ''))];
    const tags = element(ID.TAGS, element(ID.TAG, element(ID.TARGETS), element(ID.SIMPLE_TAG, ...comment)));
    const segment = joined(idOf(ID.SEGMENT), sizeOf(0));
    this.#segment = head.length + segment.length;
    const seeks = (/** @type {number} */ cues) => {
      const length = element(ID.SEEK_HEAD, seek(ID.INFO, 0), seek(ID.TRACKS, 0), seek(ID.CUES, 0)).length;
      return element(ID.SEEK_HEAD, seek(ID.INFO, length), seek(ID.TRACKS, length + info.length), seek(ID.CUES, cues));
    };
    this.seeks = seeks;
    this.#seekAt = this.#segment;
    return [this.#piece(joined(head, segment, seeks(0), info, tracks, about ? tags : []))];
  }

  /**
   * Adds blocks in the order of their times.
   * @type {(block: Block, track: 1 | 2, alpha?: Uint8Array) => Piece[]}
   */
  add({ bytes, isKey, ms }, track, alpha) {
    const cluster = this.#cluster;
    const begins = !cluster || ms - cluster.start > MAX_CLUSTER || (track === 1 && isKey && ms > cluster.start);
    const pieces = begins ? this.#close() : [];
    this.#cluster ??= { start: ms, blocks: [] };
    const { start, blocks } = this.#cluster;
    const place = [0x80 | track, ...big((ms - start + 65_536) % 65_536, 2)];
    if (alpha) {
      const more = element(ID.MORE, number(ID.ADD_ID, 1, 1), element(ID.ADDITIONAL, alpha));
      const refers = isKey ? [] : [element(ID.REFERENCE, [0xff])];
      blocks.push(element(ID.GROUP, element(ID.BLOCK, [...place, 0], bytes), element(ID.ADDITIONS, more), ...refers));
    } else {
      blocks.push(element(ID.SIMPLE, [...place, isKey ? 0x80 : 0], bytes));
    }
    return pieces;
  }

  /** @returns {Piece[]} */
  #close() {
    const cluster = this.#cluster;
    this.#cluster = undefined;
    if (!cluster) return [];
    this.#clusters.push({ ms: cluster.start, at: this.#at - this.#segment });
    return [this.#piece(element(ID.CLUSTER, number(ID.TIME, cluster.start), ...cluster.blocks))];
  }

  /** @returns {Piece[]} */
  end() {
    const pieces = this.#close();
    const cues = this.#at - this.#segment;
    const points = this.#clusters.map(({ ms, at }) =>
      element(
        ID.POINT,
        number(ID.POINT_TIME, ms),
        element(ID.POINT_TRACK, number(ID.TRACK_OF_POINT, 1, 1), number(ID.CLUSTER_OF_POINT, at, 8)),
      ),
    );
    pieces.push(this.#piece(element(ID.CUES, ...points)));
    const size = { bytes: joined(sizeOf(this.#at - this.#segment)), at: this.#segment - 8 };
    return [...pieces, size, { bytes: this.seeks?.(cues) ?? joined(), at: this.#seekAt }];
  }

  /** @type {((cues: number) => Uint8Array<ArrayBuffer>) | undefined} */
  seeks;
}
