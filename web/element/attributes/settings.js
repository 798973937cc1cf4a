/**
 * Settings from outside, as data or as JSON text. They become plain data here; the engine validates
 * their values.
 */

import { timely } from '../../engine/time-limit.js';
import { cut } from '../../quoted.js';
import { postable } from '../plain-data.js';

/** The maximum length of JSON text in characters, and of a file in bytes: the same in `share/fragment.js`. */
const MAX_LENGTH = 400_000;

/** The nesting of settings and of values: `{children: [{set: {property: value}}]}`. */
export const DEPTH = 4;

/**
 * Settings as plain data.
 * @param {unknown} config an object of them, or their JSON text
 * @param {string} [id] their name in errors
 * @returns {unknown}
 * @throws {RangeError} the text is too long or is not JSON
 */
export function settings(config, id = 'config') {
  if (typeof config === 'string') {
    if (config.length > MAX_LENGTH) {
      throw new RangeError(
        `${id} is refused: it has ${config.length} characters; at most ${MAX_LENGTH} (400 KB) are allowed`,
      );
    }
    try {
      config = JSON.parse(config.replace(/^\ufeff/, ''));
    } catch (error) {
      throw new RangeError(`${id} is refused: it is not JSON: ${/** @type {Error} */ (error).message}`);
    }
  }
  return postable(config, DEPTH);
}

/**
 * Settings as plain data; reports a refusal.
 * @param {unknown} config
 * @param {string} id their name in errors
 * @param {import('../session/reports.js').Reports} reports
 * @throws {Error} they are refused
 */
export function reportedSettings(config, id, reports) {
  try {
    return settings(config, id);
  } catch (error) {
    throw reports.refused([{ id, value: config, message: /** @type {Error} */ (error).message }]);
  }
}

/**
 * The settings in a file; undefined, with a warning, if there are none, and without one if the request
 * is cancelled.
 * @param {string} src its URL
 * @param {import('../session/reports.js').Reports} reports
 * @param {AbortSignal} cancelled
 * @returns {Promise<unknown>}
 */
export async function settingsOfFile(src, reports, cancelled) {
  if (!src) return undefined;
  const id = `src = "${cut(src, 100)}"`;
  try {
    const { textOf } = await timely(import('./settings-file.js'));
    return settings(await textOf(src, MAX_LENGTH, id, cancelled), id);
  } catch (error) {
    const { message } = /** @type {Error} */ (error);
    if (cancelled.aborted) return undefined;
    if (error instanceof RangeError) reports.refused([{ id: 'src', value: src, message }]);
    else reports.warn('load', message);
    return undefined;
  }
}
