/**
 * A report of a fire for the people who maintain Hearth, to be pasted into an issue: version, browser,
 * settings, measurements and the last errors. It leaves the computer only when the visitor pastes it.
 */

/** The number of errors that are kept, the last ones. */
const KEPT = 10;

/** The errors of one fire since its panel exists. */
export class Report {
  #fire;
  /** @type {string[]} */
  #errors = [];

  /** @param {import('../hearth-fire.js').HearthFire} fire */
  constructor(fire) {
    this.#fire = fire;
    fire.addEventListener('error', this.#keep);
  }

  /** @param {Event} event */
  #keep = (event) => {
    const { kind, message } = /** @type {CustomEvent} */ (event).detail;
    this.#errors = [...this.#errors, `${new Date().toISOString()} ${kind}: ${message}`].slice(-KEPT);
  };

  /** Keeps no more errors. */
  close() {
    this.#fire.removeEventListener('error', this.#keep);
  }

  /**
   * The report as text.
   * @param {string | undefined} link the URL of a page that shows the fire
   * @param {import('../hearth-fire.js').HearthConfig | undefined} config its settings; undefined if it has failed
   */
  text(link, config) {
    const { params, objects, stats, quality } = this.#fire;
    return [
      `Hearth ${/** @type {typeof import('../hearth-fire.js').HearthFire} */ (this.#fire.constructor).version}`,
      `Browser: ${navigator.userAgent}`,
      `Screen: ${screen.width} × ${screen.height}, ${devicePixelRatio} device pixels per pixel; fire: ${this.#fire.clientWidth} × ${this.#fire.clientHeight}`,
      `Processors: ${navigator.hardwareConcurrency}`,
      `Link: ${link ?? 'none'}`,
      `Seed: ${params.seed}`,
      `Quality: ${quality}`,
      `Settings: ${JSON.stringify(config ?? { params, objects })}`,
      `Measurements: ${JSON.stringify(stats)}`,
      'Errors:',
      ...(this.#errors.length > 0 ? this.#errors : ['none']),
    ].join('\n');
  }
}
