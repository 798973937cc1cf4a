/**
 * What an element reports to its page: events, and warnings in the console.
 *
 * @typedef {import('./requests.js').Refusal} Refusal
 */

import { timely } from '../../engine/time-limit.js';
import { VERSION } from '../../generated/version.js';
import { DEFAULTS } from '../attributes/attributes.js';
import { cut } from '../../quoted.js';
import { refusal } from './requests.js';

/** The reports of one element. */
export class Reports {
  #fire;
  /** The code whose absence has been warned of. @type {Set<string>} */
  #absent = new Set();

  /** @param {import('../../hearth-fire.js').HearthFire} fire */
  constructor(fire) {
    this.#fire = fire;
  }

  /** @type {(type: string, detail?: object | null) => void} */
  emit(type, detail = null) {
    this.#fire.dispatchEvent(new CustomEvent(type, { detail }));
  }

  /**
   * Reports an error as a warning in the console and as an event.
   * @type {(kind: string, message: string, more?: object) => void}
   */
  warn(kind, message, more) {
    console.warn(`<hearth-fire>: ${message}`);
    this.failure(kind, message, more);
  }

  /**
   * Reports an error as an event, by default with what shows the same fire to a maintainer.
   * @type {(kind: string, message: string, more?: object) => void}
   */
  failure(kind, message, more = this.#same()) {
    this.emit('error', { kind, message, ...more });
  }

  /** The version, the seed, and the settings as the URL parameters of the page of Hearth. */
  #same() {
    const { params, objects } = this.#fire;
    const values = Object.entries({ scene: 'default', ...params }).filter(
      ([id, value]) => value !== /** @type {{[id: string]: unknown}} */ (DEFAULTS)[id],
    );
    if (objects.length > 1) values.push(['objects', JSON.stringify(objects)]);
    return { version: VERSION, seed: params.seed, settings: `?${new URLSearchParams(/** @type {any} */ (values))}` };
  }

  /** Reports refused values; returns the error that names them. @type {(errors: Refusal[]) => Error} */
  refused(errors) {
    for (const { message, ...more } of errors) this.warn('bad-parameter', message, more);
    return refusal(errors);
  }

  /** Reports a refused attribute. @type {(id: string, value: string, allowed: string) => Error} */
  refuse(id, value, allowed) {
    return this.refused([{ id, value, message: `${id} = ${cut(value)} is refused: it must be ${allowed}` }]);
  }

  /**
   * Warns once if code that is loaded on request does not arrive in time.
   * @template T
   * @param {Promise<T>} loading
   * @param {string} what its name in the warning
   */
  loads(loading, what) {
    const code = timely(loading);
    code.catch((why) => {
      if (!this.#absent.has(what)) this.warn('load', `${what} could not be loaded: ${why}`);
      this.#absent.add(what);
    });
    return code;
  }
}
