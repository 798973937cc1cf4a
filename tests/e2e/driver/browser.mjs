/**
 * A browser and the server of the site that it looks at: started once for a
 * test file, with one page at a time.
 */
import { serve } from '../server.mjs';
import { SITE } from '../site.mjs';
import { followWorkers, rememberContexts } from './inside.mjs';
import { chromium, firefox } from './puppeteer.mjs';
import { webkit } from './webkit.mjs';

/** @typedef {import('./programs.mjs').Kind} Kind */
/** @typedef {import('./puppeteer.mjs').PuppeteerTab} PuppeteerTab */
/**
 * How a page is opened, with nothing left open.
 * @typedef {object} Opening
 * @property {number} width
 * @property {number} height
 * @property {number} ratio
 * @property {boolean} touch
 * @property {boolean} reducedMotion
 * @property {string[]} before  Scripts that run in the page before anything of it.
 * @property {string[]} beforeWorker  And in each of its workers.
 */
/**
 * A running browser, as this file needs it.
 * @typedef {object} Engine
 * @property {any} browser  The driver's own handle of it.
 * @property {(opening: Opening) => Promise<any>} open  A tab that has gone nowhere yet.
 * @property {() => Promise<unknown>} close
 */

const START = { chromium, firefox, webkit };

/** Pixels of a fire whose sharpness no test looks at. */
const FEW_PIXELS = 30_000;

/** A running browser and the server of the site that it looks at. */
export class Browser {
  /**
   * @param {Engine} engine
   * @param {import('../server.mjs').Server} server
   * @param {boolean} reducedMotion
   */
  constructor(engine, server, reducedMotion) {
    this.engine = engine;
    this.reducedMotion = reducedMotion;
    this.browser = engine.browser;
    this.server = server;
    /** @type {any} */
    this.tab = undefined;
  }

  /**
   * Starts Chromium with an empty profile of its own, looking at the site, or
   * at other folders.
   * @param {...string} folders
   */
  static launch(...folders) {
    return Browser.start('chromium', { folders });
  }

  /**
   * Starts a browser of that kind.
   * @param {Kind} kind
   * @param {object} [wishes]
   * @param {string[]} [wishes.folders]  What it looks at, if not the site.
   * @param {boolean} [wishes.reducedMotion]  For all its pages: Firefox and WebKit
   *   learn of it when they start.
   */
  static async start(kind, { folders = [], reducedMotion = false } = {}) {
    const server = await serve(...(folders.length > 0 ? folders : [SITE]));
    try {
      return new Browser(await START[kind]({ reducedMotion }, server), server, reducedMotion);
    } catch (error) {
      await server.close();
      throw error;
    }
  }

  /**
   * Opens a page of the site, or one written by the test, and closes the one
   * before: two fires at once would only slow each other down.
   *
   * @param {string} page  A path ("index.html?seed=7"), the HTML of a body
   *   ("<hearth-fire>…"), or a whole document ("<!doctype html>…").
   * @param {object} [options]
   * @param {number} [options.width]  CSS pixels.
   * @param {number} [options.height]
   * @param {number} [options.ratio]  Device pixels for a CSS pixel; not in WebKit.
   * @param {boolean} [options.touch]  A phone: touch, and a phone's viewport; in Chromium.
   * @param {boolean} [options.reducedMotion]
   * @param {() => void} [options.before]  Runs in the page before anything of it.
   * @param {() => void} [options.beforeWorker]  Runs in each of its workers before anything of it.
   * @param {{[name: string]: string}} [options.headers]  Of a page written by the test.
   * @param {{[name: string]: import('../server.mjs').Instead}} [options.files]  What the server
   *   gives instead of files whose path ends so.
   * @param {boolean} [options.remember]  Whether it has what pages before it kept.
   * @param {number} [options.pixels]  How many pixels a fire of one of the site's own pages draws,
   *   few by default: a software renderer computes each of them.
   * @param {string} [options.without]  Requests for files whose path ends so fail, as a
   *   broken network would.
   * @returns {Promise<PuppeteerTab>}
   */
  async open(page, options = {}) {
    const { width = 480, height = 480, ratio = 1, touch = false } = options;
    const { reducedMotion = this.reducedMotion, headers, files = {}, without, remember = false } = options;
    const ofSite = !page.includes('<');
    const { pixels = ofSite ? FEW_PIXELS : Infinity } = options;
    await this.tab?.close();
    this.server.replace(without === undefined ? files : { ...files, [without]: { drop: true } });
    const { origin } = this.server;
    const before = [`(${rememberContexts})();`, `(${followWorkers})(${JSON.stringify(origin)});`];
    if (!remember) before.push(`(${forgetOnce})();`);
    if (pixels < Infinity) before.push(`(${limitPixels})(${pixels});`);
    if (options.before) before.push(`(${options.before})();`);
    const beforeWorker = options.beforeWorker ? [`(${options.beforeWorker})();`] : [];
    this.server.prepend({ workers: beforeWorker });
    const opening = { width, height, ratio, touch, reducedMotion, before, beforeWorker };
    const tab = await this.engine.open(opening);
    this.tab = tab;
    const document = page.startsWith('<!doctype') ? page : documentAround(page);
    await tab.go(ofSite ? new URL(page, `${origin}/`).href : this.server.publish(document, headers));
    return tab;
  }

  async close() {
    await this.engine.close();
    await this.server.close();
  }
}

/** Runs in the page: nothing is kept of the tests before this one. */
function forgetOnce() {
  try {
    // A page that is loaded anew has what it kept itself.
    if (!sessionStorage.getItem('forgotten')) localStorage.clear();
    sessionStorage.setItem('forgotten', 'yes');
  } catch {
    // Then nothing is kept.
  }
}

/**
 * Runs in the page: limits the drawing of each fire in its HTML that has no limit.
 * @param {number} pixels
 */
function limitPixels(pixels) {
  const observer = new MutationObserver(() => {
    for (const fire of document.querySelectorAll('hearth-fire:not([max-pixels])')) {
      fire.setAttribute('max-pixels', String(pixels));
    }
  });
  observer.observe(document, { childList: true, subtree: true });
  addEventListener('DOMContentLoaded', () => observer.disconnect());
}

/** A whole page with `body` in it and the element loaded, black so that fire shows. */
function documentAround(/** @type {string} */ body) {
  return `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>A page with a fire</title>
<link rel="icon" href="data:,">
<style>
  body { margin: 0; background: black; color: white }
  hearth-fire { width: 240px; height: 240px }
</style>
<script type="module" src="/web/hearth-fire.js"></script>
<body>${body}</body>
</html>`;
}
