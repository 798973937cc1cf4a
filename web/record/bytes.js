/**
 * Bytes of files.
 *
 * @typedef {{bytes: Uint8Array<ArrayBuffer>, at?: number}} Piece  Bytes that follow the others or, with `at`, replace those from there on.
 */

/** @param {number} length */
export const room = (length) => new Uint8Array(length);

/** Letters as bytes. @param {string} letters */
export function ascii(letters) {
  return Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
}

/** A text as bytes. @param {string} text */
export const utf8 = (text) => new TextEncoder().encode(text);

/**
 * Bytes one after another.
 * @param {...(Uint8Array | number[])} parts
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function joined(...parts) {
  const all = room(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** A whole number in so many bytes, the most significant first. @type {(value: number, bytes: number) => number[]} */
export function big(value, bytes) {
  return Array.from({ length: bytes }, (_, at) => Math.floor(value / 256 ** (bytes - 1 - at)) % 256);
}

/** A whole number in so many bytes, the least significant first. @type {(value: number, bytes: number) => number[]} */
export function little(value, bytes) {
  return big(value, bytes).reverse();
}

/** @type {Uint32Array | undefined} */
let table;

/** The checksum of PNG and zip. @type {(bytes: Uint8Array) => number} */
export function crc32(bytes) {
  table ??= Uint32Array.from({ length: 256 }, (_, value) => {
    for (let bit = 0; bit < 8; bit += 1) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
    return value;
  });
  let sum = 0xffffffff;
  for (let at = 0; at < bytes.length; at += 1) sum = (sum >>> 8) ^ table[(sum ^ bytes[at]) & 255];
  return (sum ^ 0xffffffff) >>> 0;
}

/**
 * The chunks of a PNG or a RIFF file after `from`: their names and contents.
 * @type {(file: Uint8Array<ArrayBuffer>, form: 'png' | 'riff') => {name: string, bytes: Uint8Array<ArrayBuffer>}[]}
 */
export function chunksOf(file, form) {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const isPng = form === 'png';
  const found = [];
  for (let at = isPng ? 8 : 12; at + 8 <= file.length; ) {
    const length = isPng ? view.getUint32(at) : view.getUint32(at + 4, true);
    const named = isPng ? at + 4 : at;
    const name = String.fromCharCode(...file.subarray(named, named + 4));
    found.push({ name, bytes: file.subarray(at + 8, at + 8 + length) });
    // A chunk of PNG ends with a checksum, one of RIFF at an even place.
    at += 8 + length + (isPng ? 4 : length % 2);
  }
  return found;
}
