/**
 * The probe and the plots, whose code is loaded with the first use of either.
 *
 * @typedef {import('../plots/instruments.js').Instruments} Made
 * @typedef {import('./geometry.js').Point} Point
 */

/** The probe and the plots of one toolbar. */
export class Instruments {
  #parts;
  #attempt;
  /** @type {Promise<Made> | undefined} */
  #loading;
  /** @type {Made | undefined} */
  #made;
  #removed = false;

  /** @param {import('../plots/instruments.js').Parts} parts @param {(act: () => unknown) => Promise<void>} attempt */
  constructor(parts, attempt) {
    this.#parts = parts;
    this.#attempt = attempt;
  }

  /** @param {(made: Made) => void} act */
  #use(act) {
    if (this.#made) {
      act(this.#made);
      return;
    }
    this.#loading ??= import('../plots/instruments.js').then(({ Instruments: Loaded }) => new Loaded(this.#parts));
    this.#attempt(async () => {
      try {
        const made = await this.#loading;
        if (!made || this.#removed) return;
        this.#made = made;
        act(made);
      } catch (error) {
        // The next use tries again.
        this.#loading = undefined;
        throw error;
      }
    });
  }

  /** Puts the probe at a place, and says what is there if it `tells`. @type {(at: Point, tells?: boolean) => void} */
  probe(at, tells) {
    this.#use((made) => made.probe(at, tells));
  }

  /** Takes the probe away. */
  unprobe() {
    if (this.#loading) this.#use((made) => made.probe(undefined));
  }

  /** Shows or hides the plots. */
  plot() {
    this.#use((made) => made.plot());
  }

  /** Hides the plots, if they are shown. */
  close() {
    return this.#made?.close() ?? false;
  }

  remove() {
    this.#removed = true;
    this.#made?.remove();
  }
}
