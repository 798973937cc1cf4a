/**
 * What a fire exposes to style sheets: `:state(burning)`, and its brightness and colour as custom
 * properties.
 */

/** The weight of a new measurement in the mean power. There are about four measurements a second. */
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
      // This browser has no `:state()` either.
    }
  }

  /** @param {boolean} burning */
  burning(burning) {
    // Chromium before 125 requires the two hyphens.
    for (const name of ['burning', '--burning']) {
      try {
        this.#states[burning ? 'add' : 'delete'](name);
        return;
      } catch {
        // Try the other name.
      }
    }
  }

  /**
   * Sets the custom properties from the power against its mean; removes them without power.
   * @param {number} [power]
   * @param {string} [glow]  The colour of the light.
   */
  light(power, glow) {
    if (!power || !glow) {
      this.#mean = 0;
      this.#view.declare('');
      return;
    }
    this.#mean += (power - this.#mean) * (this.#mean ? GAIN : 1);
    const light = Math.min(power / this.#mean / 2, 1).toFixed(3);
    this.#view.declare(`--hearth-light:${light};--hearth-glow:${glow}`);
  }
}
