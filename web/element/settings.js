/**
 * Settings from outside, as data or as JSON text. They become plain data here; the engine checks their
 * values.
 */

import { postable } from './requests.js';

/** Longest JSON text, in letters, and longest file, in bytes. */
const LONGEST = 65_536;

/** Deepest nesting of settings and of values: `{objects: [{property: value}]}`. */
export const DEEPEST = 3;

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
 * The settings in the file that `src` names. What fetches it is loaded only here.
 * @param {string} src where it is
 * @returns {Promise<unknown>}
 * @throws {RangeError} it holds no settings
 * @throws {Error} it did not come
 */
export async function settingsOfFile(src) {
  const id = `src = "${src}"`;
  let text;
  try {
    const { textOf } = await import('./settings-file.js');
    text = await textOf(new URL(src, document.baseURI), LONGEST);
  } catch (error) {
    throw new Error(`${id} is refused: ${/** @type {Error} */ (error).message}`);
  }
  if (text === undefined) throw new RangeError(`${id} is refused: it is longer than 64 KiB`);
  return settings(text, id);
}
