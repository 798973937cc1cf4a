/**
 * The painter's page in headless Chromium with software rendering, whose pictures are the
 * same on every machine.
 */
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { Browser } from '../e2e/driver.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));

/** Snapshots and the pictures of them. */
export const GOLDENS = path.resolve(HERE, '../goldens');

/** The folder of the painter that `cargo xtask` built. */
const PAINTER = process.env.HEARTH_PAINTER;

/** @typedef {{width: number, height: number, rgba: Uint8Array}} Pixels  Premultiplied sRGB. */
/**
 * What a test requests.
 * @typedef {object} PictureRequest
 * @property {string} [kept]  A snapshot.
 * @property {string} [mode]  Its display mode.
 * @property {string} [lit]  Or a preset to light.
 * @property {number} [burnt]  How long it burns [s].
 * @property {{[id: string]: string | number}} [values]  Other parameters.
 * @property {number} [width]
 * @property {number} [height]
 * @property {string} [format]  Format of the targets.
 * @property {string[]} [without]  Extensions that the device lacks.
 * @property {string} [quality]  Which level.
 */

export class Painter {
  /** @param {Browser} browser @param {import('../e2e/driver.mjs').Tab} tab */
  constructor(browser, tab) {
    this.browser = browser;
    this.tab = tab;
  }

  static async open() {
    if (!PAINTER) throw new Error('HEARTH_PAINTER names no painter: `cargo xtask test goldens` makes one');
    const browser = await Browser.launch(PAINTER, path.join(HERE, 'page'), path.join(HERE, 'figures'), GOLDENS);
    try {
      const tab = await browser.open('index.html');
      await tab.until('the painter is there', () => /** @type {any} */ (window).look);
      return new Painter(browser, tab);
    } catch (error) {
      await browser.close();
      throw error;
    }
  }

  /**
   * A fire that stands still.
   * @param {PictureRequest} request
   * @returns {Promise<Pixels>}
   */
  async still(request) {
    const { width = 320, height = 400 } = request;
    return unpacked(await this.ask('still', { ...request, width, height }), width, height);
  }

  /**
   * Calls a function of the page.
   * @param {string} what @param {...unknown} args
   * @returns {Promise<any>}
   */
  ask(what, ...args) {
    return this.tab.evaluate((name, given) => /** @type {any} */ (window).look[name](...given), what, args);
  }

  close() {
    return this.browser.close();
  }
}

/**
 * The names with one of these beginnings; all names without beginnings.
 * @param {string[]} names
 * @param {string[]} begins
 * @param {string} what the names are of
 * @throws {Error} no name has that beginning: a typing error must not look like success
 */
export function named(names, begins, what) {
  for (const begin of begins) {
    if (names.some((name) => name.startsWith(begin))) continue;
    throw new Error(`there is no ${what} "${begin}"; there are ${names.join(', ')}`);
  }
  return names.filter((name) => begins.length === 0 || begins.some((begin) => name.startsWith(begin)));
}

/**
 * @param {string} text @param {number} width @param {number} height
 * @returns {Pixels}
 */
export function unpacked(text, width, height) {
  return { width, height, rgba: Buffer.from(text, 'base64') };
}
