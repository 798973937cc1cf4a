/**
 * The probe and the plots, whose code is loaded with the first use of either.
 *
 * @typedef {import('../plots/instruments.js').Instruments} LoadedInstruments
 * @typedef {import('./geometry.js').Point} Point
 */

/** The probe and the plots of one toolbar. */
export class Instruments {
  #options;
  #attempt;
  /** @type {Promise<LoadedInstruments> | undefined} */
  #loading;
  /** @type {LoadedInstruments | undefined} */
  #loaded;
  #removed = false;

  /**
   * @param {import('../plots/instruments.js').Options} options
   * @param {(act: () => unknown) => Promise<void>} attempt
   */
  constructor(options, attempt) {
    this.#options = options;
    this.#attempt = attempt;
  }

  /** @param {(loaded: LoadedInstruments) => void} act */
  #use(act) {
    if (this.#loaded) {
      act(this.#loaded);
      return;
    }
    this.#loading ??= import('../plots/instruments.js').then(({ Instruments: Loaded }) => new Loaded(this.#options));
    this.#attempt(async () => {
      try {
        const loaded = await this.#loading;
        if (!loaded || this.#removed) return;
        this.#loaded = loaded;
        act(loaded);
      } catch (error) {
        // The next use tries again.
        this.#loading = undefined;
        throw error;
      }
    });
  }

  /**
   * Shows the values at a point; `announce` writes them into the status, too.
   * @type {(at: Point, options?: {announce?: boolean}) => void}
   */
  probe(at, options) {
    this.#use((loaded) => loaded.probe(at, options));
  }

  /** Hides the probe. */
  hideProbe() {
    if (this.#loading) this.#use((loaded) => loaded.probe(undefined));
  }

  /** Shows or hides the plots. */
  plot() {
    this.#use((loaded) => loaded.plot());
  }

  /** Hides the plots, if they are shown. */
  close() {
    return this.#loaded?.close() ?? false;
  }

  remove() {
    this.#removed = true;
    this.#loaded?.remove();
  }
}
