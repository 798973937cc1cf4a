/**
 * Settings of a fire as they come from outside: data, JSON text, or the file that
 * `src` names. Here they become plain data; whether their values are good, the
 * engine's table says.
 */

import { postable } from './requests.js';

/** Longest JSON text, in letters, and longest file, in bytes. */
const LONGEST = 65_536;

/** Deepest nesting of settings: `{values: {id: value}}`. */
const DEEPEST = 2;

/**
 * Settings as plain data.
 * @param {unknown} config an object of them, or their JSON text
 * @param {string} [id] what they are called
 * @returns {unknown}
 * @throws {RangeError} a text that is too long, or no JSON
 */
export function settings(config, id = 'config') {
  if (typeof config !== 'string') return postable(config, DEEPEST);
  if (config.length > LONGEST) {
    throw new RangeError(`${id} is refused: it has ${config.length} letters; at most ${LONGEST} (64 KiB) are allowed`);
  }
  let parsed;
  try {
    parsed = JSON.parse(config);
  } catch (error) {
    throw new RangeError(`${id} is refused: it is no JSON: ${/** @type {Error} */ (error).message}`);
  }
  return postable(parsed, DEEPEST);
}

/**
 * The settings in a file.
 * @param {string} src where it is
 * @returns {Promise<unknown>}
 * @throws {RangeError} it holds no settings
 * @throws {Error} it did not come
 */
export async function settingsOfFile(src) {
  const id = `src = "${src}"`;
  let text;
  try {
    text = await textOf(new URL(src, document.baseURI));
  } catch (error) {
    throw new Error(`${id} is refused: ${/** @type {Error} */ (error).message}`);
  }
  if (text === undefined) throw new RangeError(`${id} is refused: it is longer than 64 KiB`);
  return settings(text, id);
}

/**
 * The text of a file; undefined where it is too long, which is found out early.
 * @param {URL} url
 */
async function textOf(url) {
  const response = await fetch(url, { credentials: 'same-origin' });
  if (!response.ok) throw new Error(`the server says ${response.status}`);
  const parts = [];
  const reader = response.body?.getReader();
  for (let length = 0; reader; ) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > LONGEST) {
      reader.cancel().catch(() => {});
      return undefined;
    }
    parts.push(value);
  }
  return new Blob(parts).text();
}
