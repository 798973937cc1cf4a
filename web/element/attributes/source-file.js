/**
 * The file of settings that `src` names.
 *
 * The last request wins: another `src`, and a call that replaces every value, end the download. A fire
 * does not wait long for its file: it begins with its preset and its attributes, and takes the file over
 * when that arrives.
 *
 * @typedef {import('../session/session.js').FireSession} FireSession
 */

import { quiet } from '../promises.js';
import { settingsOfFile } from './settings.js';

/** How long a fire waits for its file before it begins without it [ms]. */
const WAIT_MS = 2000;

/** The file of one element. */
export class SourceFile {
  #session;
  /** The download. @type {AbortController | undefined} */
  #download;
  /** Settles with the last download. @type {Promise<void> | undefined} */
  #loading;
  /** The settings that a fire begins with. @type {unknown} */
  config;

  /** @param {FireSession} session */
  constructor(session) {
    this.#session = session;
  }

  /** `src` has changed. */
  change() {
    // A fire that is not loaded yet loads its file later.
    if (this.#session.begun || this.#loading) this.#load();
  }

  /** The request is cancelled. */
  drop() {
    this.#download?.abort();
    this.#download = undefined;
  }

  /** Loads the file for a new fire; settles when the fire can begin, with the file or without it. */
  async begin() {
    this.#load();
    let patient = true;
    const patience = new Promise((resolve) => setTimeout(resolve, WAIT_MS)).then(() => (patient = false));
    // `src` may change meanwhile.
    while (patient && this.#download) await Promise.race([this.#loading, patience]);
  }

  #load() {
    this.drop();
    const download = new AbortController();
    this.#download = download;
    this.config = undefined;
    this.#loading = quiet(this.#apply(download));
  }

  /** @param {AbortController} download */
  async #apply(download) {
    const session = this.#session;
    const { src } = session.fire;
    const early = !session.begun;
    let config = /** @type {any} */ (await settingsOfFile(src, session.reports, download.signal));
    const late = early && session.begun;
    if (late && config) {
      // The values that the page has set override those of the file, as in a fire that began with it.
      let own = await session.call('export');
      const { settings, params } = session.state;
      const { children = [], values, objects, [params.model]: ofModel } = /** @type {any} */ (settings);
      if (children.length > 0) {
        // The objects of children are not those of the page.
        own = { values: { ...values, ...ofModel }, ...(session.fire.hasAttribute('objects') && { objects }) };
      }
      config = { ...config, ...own, values: { ...config.values, ...own.values }, preset: config.preset };
    }
    if (download !== this.#download) return;
    this.drop();
    if (!session.begun) this.config = config;
    else if (late) config && session.call('import', config, 'src');
    else if (config !== undefined) session.call('import', config, session.history.sourceOfScene('src'));
    else if (!src) session.call('preset', session.fire.preset, session.history.sourceOfScene('src'));
  }
}
