/**
 * What an element tells its page: its events, and warnings of what is wrong.
 *
 * @typedef {import('./requests.js').Refusal} Refusal
 */

import { refusal } from './requests.js';

/** The reports of one element. */
export class Reports {
  #fire;

  /** @param {HTMLElement} fire */
  constructor(fire) {
    this.#fire = fire;
  }

  /** @type {(type: string, detail?: object | null) => void} */
  emit(type, detail = null) {
    this.#fire.dispatchEvent(new CustomEvent(type, { detail }));
  }

  /** Something is wrong, and the fire burns on. @type {(kind: string, message: string) => void} */
  warn(kind, message) {
    console.warn(`<hearth-fire>: ${message}`);
    this.emit('error', { kind, message });
  }

  /** Values are refused; the error that says so. @type {(errors: Refusal[]) => Error} */
  refused(errors) {
    for (const { message, ...rest } of errors) {
      console.warn(`<hearth-fire>: ${message}`);
      this.emit('error', { kind: 'bad-parameter', message, ...rest });
    }
    return refusal(errors);
  }

  /** An attribute is refused. @type {(id: string, value: string, allowed: string) => Error} */
  refuse(id, value, allowed) {
    return this.refused([{ id, value, message: `${id} = ${value} is refused: it must be ${allowed}` }]);
  }
}
