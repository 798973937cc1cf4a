/**
 * The look of the target of `of`: its border box or, of a picture or a text, what is opaque in it. The code
 * that reads pixels is loaded with the first such target.
 *
 * @typedef {import('./child-box.js').Box} Box
 * @typedef {import('./child-picture.js').Picture} Picture
 * @typedef {typeof import('./child-picture.js').Picture} Reader
 */

/** The elements whose pixels count; a `<picture>` has an `<img>`. */
const PICTURES = ['img', 'svg', 'canvas'];

/** Whether the pixels of an element count. @param {Element} element */
export const isPicture = ({ localName }) => PICTURES.includes(localName);

/**
 * The code that reads pixels: undefined until it is loaded, null if it did not arrive.
 * @type {Reader | null | undefined}
 */
let Reader;
let isAsked = false;

/** The look of the target of one child. */
export class Look {
  #session;
  #name;
  /** The pixels of the target, once their code is loaded. @type {Picture | undefined} */
  picture;
  /** The warnings so far: why its box replaces its pixels, and what these lack. */
  #warned = new Set();

  /**
   * @param {import('../session/session.js').FireSession} session
   * @param {() => string} name the child and its target as messages name them
   */
  constructor(session, name) {
    this.#session = session;
    this.#name = name;
  }

  /**
   * The box that counts, with a mask of what is opaque in it; null if nothing is, undefined until that is known.
   * @param {Element} target
   * @param {Box} box its border box in pixels of the window
   * @param {boolean} glyphs whether the glyphs of its text count
   * @returns {Box & {mask?: string} | null | undefined}
   */
  of(target, box, glyphs) {
    if (!(glyphs || isPicture(target)) || Reader === null) {
      this.close();
      return box;
    }
    if (!isAsked) {
      isAsked = true;
      this.#session.reports.loads(import('./child-picture.js'), 'The code for masks').then(
        ({ Picture }) => {
          Reader = Picture;
        },
        () => {
          Reader = null;
        },
      );
    }
    if (!Reader) return undefined;
    let picture = this.picture;
    if (picture?.target !== target || picture.glyphs !== glyphs) {
      picture?.close();
      picture = this.picture = new Reader(target, glyphs, (how) => this.#warn(how));
    }
    return picture.look(box);
  }

  /** @param {string} how */
  #warn(how) {
    if (!this.#warned.has(how)) console.warn(`<hearth-fire>: ${this.#name()} counts ${how}.`);
    this.#warned.add(how);
  }

  /** Forgets the pixels and stops following them. */
  close() {
    this.picture?.close();
    this.picture = undefined;
  }
}
