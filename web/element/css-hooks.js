/**
 * What a fire exposes to style sheets: `:state(burning)`, and its brightness and colour as custom
 * properties.
 */

/** The colour of a palette's light: what the pictures of its fires have on average, at full brightness. @type {{[palette: string]: string}} */
const GLOW = {
  blackbody: '#ff7728', gas: '#89adff', copper: '#93ffb9', lithium: '#ff637e', ghost: '#c2f8ff',
};

/** How much of the mean power is another one at the next measurement, of which a second has four. */
const GAIN = 1 / 40;

/** The hooks of one element. */
export class CssHooks {
  #view;
  /** @type {any} */
  #states;
  #mean = 0;

  /**
   * @param {HTMLElement} host
   * @param {import('./view.js').FireView} view
   */
  constructor(host, view) {
    this.#view = view;
    try {
      this.#states = host.attachInternals().states;
    } catch {
      // A browser without it has no `:state()` either.
    }
  }

  /** @param {boolean} burning */
  burning(burning) {
    // Chromium before 125 knows only names that begin so.
    for (const name of ['burning', '--burning']) {
      try {
        this.#states[burning ? 'add' : 'delete'](name);
        return;
      } catch {
        // The other one, then, or none.
      }
    }
  }

  /**
   * How bright it is, against its mean; without power nothing is said.
   * @param {number} [power]
   * @param {import('../parameters.js').HearthParameters} [values]
   */
  light(power, values) {
    if (!power || !values) {
      this.#mean = 0;
      this.#view.tell('');
      return;
    }
    this.#mean += (power - this.#mean) * (this.#mean ? GAIN : 1);
    const light = Math.min(power / this.#mean / 2, 1).toFixed(3);
    this.#view.tell(`--hearth-light: ${light}; --hearth-glow: ${GLOW[values.palette] ?? values.hot_colour}`);
  }
}
