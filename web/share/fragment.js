/**
 * Long settings as the fragment of a URL: JSON, deflated, in base64url. No server receives a fragment. This code is
 * loaded when a fire is too long for a query, or an address has such a fragment.
 *
 * @typedef {object} Config  Settings, as `share.js` has them.
 */

import { BLANKS } from './strangers.js';

/** What the fragment of settings begins with. */
const NAME = '#fire=';

/** The most characters of a fragment that is written: mail and chat programs cut longer addresses. */
export const MAX_FRAGMENT = 32_000;

/** The most bytes of settings: the same in `element/attributes/settings.js`. */
export const MAX_SETTINGS = 400_000;

/**
 * The fragment of settings.
 * @param {Config} config
 * @returns {Promise<string>}
 * @throws {RangeError} it is too long, or the program cannot compress
 */
export async function fragmentOf(config) {
  if (!globalThis.CompressionStream) {
    throw new RangeError('The fire is too long for a link, and this browser cannot compress it.');
  }
  let json;
  try {
    json = JSON.stringify(config);
  } catch (cause) {
    throw new TypeError('config cannot be written as JSON', { cause });
  }
  const bytes = await through(new CompressionStream('deflate'), new TextEncoder().encode(json), (MAX_FRAGMENT * 3) / 4);
  if (!bytes) {
    throw new RangeError(
      `The fire is too long for a link: an address has at most ${MAX_FRAGMENT} characters. Its file has no such limit.`,
    );
  }
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return `${NAME}${btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')}`;
}

/**
 * The settings of a fragment, which nobody has validated; undefined if it has none. What other programs do to an
 * address does not count: they encode it, break it, and add characters and parameters.
 * @param {string} hash
 * @returns {Promise<Config | undefined>}
 * @throws {RangeError} it is damaged or too long
 */
export async function settingsOf(hash) {
  const text = decoded(decoded(hash)).trim();
  if (!text.startsWith(NAME)) return undefined;
  const joined = text.replace(BLANKS, '');
  // After a blank, the address goes on or words of others follow.
  return read(joined).catch((error) => (joined === text ? Promise.reject(error) : read(text)));
}

/** A text without percent-encoding. @param {string} text */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** @param {string} text @returns {Promise<Config>} */
async function read(text) {
  if (!globalThis.DecompressionStream) throw new RangeError('This browser cannot read the settings of the address.');
  let bytes;
  let config;
  try {
    const [letters] = /^[\w-]*/.exec(text.slice(NAME.length)) ?? [''];
    const base64 = letters.replaceAll('-', '+').replaceAll('_', '/');
    bytes = await through(
      new DecompressionStream('deflate'),
      Uint8Array.from(atob(base64), (character) => character.charCodeAt(0)),
      MAX_SETTINGS,
    );
    config = bytes && JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw new RangeError('The settings of the address are damaged: perhaps its end is missing.');
  }
  if (!bytes) throw new RangeError(`The settings of the address have more than ${MAX_SETTINGS / 1000} KB.`);
  return config;
}

/**
 * Bytes after a stream; undefined if they are more than `max`.
 * @param {CompressionStream | DecompressionStream} stream
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {number} max
 */
async function through(stream, bytes, max) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  /** @type {number[]} */
  const all = [];
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return Uint8Array.from(all);
    if (all.length + value.length > max) {
      reader.cancel().catch(() => {});
      return undefined;
    }
    for (const byte of value) all.push(byte);
  }
}
