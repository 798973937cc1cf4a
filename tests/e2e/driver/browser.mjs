/**
 * A browser and the server of its pages: started once for each test file, with one page at
 * a time.
 */
import { serve } from '../server.mjs';
import { SITE } from '../site.mjs';
import { drawNothing, followWorkers, rememberContexts } from './page-scripts.mjs';
import { BROWSER } from './programs.mjs';
import { chromium, firefox } from './puppeteer.mjs';

/** @typedef {import('./programs.mjs').Kind} Kind */
/** @typedef {import('./tab.mjs').Tab} Tab */
/**
 * Options of a page, with defaults filled in.
 * @typedef {object} Opening
 * @property {number} width
 * @property {number} height
 * @property {number} ratio
 * @property {boolean} touch
 * @property {Preferences} preferences
 * @property {string[]} before  Scripts that run in the page before its own.
 * @property {string[]} beforeWorker  Scripts that run in each worker before its own.
 */
/**
 * What Firefox or WebKit takes from the system when it starts.
 * @typedef {Pick<Opening, 'preferences' | 'ratio' | 'touch'>} Desktop
 */
/**
 * What a visitor prefers.
 * @typedef {object} Preferences
 * @property {boolean} reducedMotion
 * @property {'light' | 'dark'} scheme
 * @property {boolean} forcedColors
 */
/**
 * A running browser, as its kind implements it.
 * @typedef {object} Engine
 * @property {any} browser  The handle of its driver.
 * @property {() => Promise<string>} version
 * @property {(opening: Opening) => boolean} fits  Whether it opens such a page; else it has to start again for it.
 * @property {(opening: Opening) => Promise<Tab>} open  Opens an empty tab.
 * @property {() => Promise<unknown>} close
 */

/** Starts a browser. What drives WebKit takes long to load. */
const START = {
  chromium,
  firefox,
  webkit: async (options, server) => (await import('./webkit.mjs')).webkit(options, server),
};

/** @type {Desktop} */
const DESKTOP = {
  preferences: { reducedMotion: false, scheme: 'light', forcedColors: false },
  ratio: 1,
  touch: false,
};

/** Pixels of a fire whose sharpness no test asserts. */
const FEW_PIXELS = 30_000;

/** A running browser and the server of its pages. */
export class Browser {
  /**
   * @param {Engine} engine
   * @param {import('../server.mjs').Server} server
   * @param {boolean} draws
   * @param {(desktop: Desktop) => Promise<Engine>} restart
   */
  constructor(engine, server, draws, restart) {
    this.engine = engine;
    this.draws = draws;
    this.server = server;
    this.restart = restart;
    /** How many pages it has opened. */
    this.opened = 0;
    /** @type {any} */
    this.tab = undefined;
  }

  /** The handle of the browser's driver. */
  get browser() {
    return this.engine.browser;
  }

  /**
   * Starts the browser of this run with an empty profile, and a server of the site or of other folders.
   * @param {...string} folders
   */
  static launch(...folders) {
    return Browser.start({ shell: true, folders });
  }

  /**
   * Starts the browser of this run for tests that look at no picture: WebGL2 draws nothing in its pages.
   */
  static launchWithoutDrawing() {
    return Browser.start({ shell: true, draws: false });
  }

  /**
   * Starts a browser.
   * @param {object} [options]
   * @param {Kind} [options.kind]  Without it, the browser of this run.
   * @param {string[]} [options.folders]  Folders to serve instead of the site.
   * @param {boolean} [options.shell]  Chromium's headless shell, which has no window and no clipboard, starts for
   *   Chromium. Its pages share a process and the code that it has compiled.
   * @param {boolean} [options.likeGraphicsCard]  Chromium composes its pages by WebGL's renderer, as with a graphics
   *   card: a benchmark measures how the page draws there.
   * @param {boolean} [options.draws]  Whether WebGL2 draws.
   */
  static async start(options = {}) {
    const { kind = BROWSER, folders = [], draws = true } = options;
    const server = await serve(...(folders.length > 0 ? folders : [SITE]));
    /** @type {Browser['restart']} */
    const start = ({ preferences, ratio, touch }) => START[kind]({ ...options, preferences, ratio, touch }, server);
    try {
      return new Browser(await start(DESKTOP), server, draws, start);
    } catch (error) {
      await server.close();
      throw error;
    }
  }

  /**
   * Opens a page of the site or of the test, and closes the previous one: two pages would
   * slow each other down.
   *
   * @param {string} page  A path ("index.html?seed=7"), the HTML of a body
   *   ("<hearth-fire>…"), or a whole document ("<!doctype html>…").
   * @param {object} [options]
   * @param {number} [options.width]  CSS pixels.
   * @param {number} [options.height]
   * @param {number} [options.ratio]  Device pixels per CSS pixel; a whole number in WebKit.
   * @param {boolean} [options.touch]  A phone's touch and, in Chromium, viewport; not in WebKit.
   * @param {boolean} [options.reducedMotion]  Firefox and WebKit start again for pages with another preference, and
   *   Firefox for those with touch.
   * @param {'light' | 'dark'} [options.scheme]
   * @param {boolean} [options.forcedColors]  Not in WebKit.
   * @param {boolean} [options.draws]  Whether WebGL2 draws.
   * @param {() => void} [options.before]  Runs in the page before its scripts.
   * @param {() => void} [options.beforeWorker]  Runs in each worker before its scripts.
   * @param {{[name: string]: string}} [options.headers]  Of a page of the test.
   * @param {{[name: string]: import('../server.mjs').Instead}} [options.files]  Replacements of files whose
   *   path ends with these names.
   * @param {boolean} [options.remember]  Keeps the storage of previous pages.
   * @param {number} [options.pixels]  The most pixels of each fire in the page's HTML. Pages of
   *   the site have few by default: a software renderer computes each one.
   * @param {string} [options.without]  Requests for files whose path ends so fail, like a
   *   broken network.
   * @returns {Promise<Tab>}
   */
  async open(page, options = {}) {
    const { width = 480, height = 480, ratio = 1, touch = false } = options;
    const { draws = this.draws, headers, files = {}, without, remember = false } = options;
    const { reducedMotion = false, scheme = 'light', forcedColors = false } = options;
    const ofSite = !page.includes('<');
    const { pixels = ofSite ? FEW_PIXELS : Infinity } = options;
    const { tab: last } = this;
    // A page that cannot be opened leaves none.
    this.tab = undefined;
    await last?.page.close();
    this.server.replace(without === undefined ? files : { ...files, [without]: { drop: true } });
    const { origin } = this.server;
    const before = [`(${rememberContexts})();`, `(${followWorkers})(${JSON.stringify(origin)});`];
    this.opened += 1;
    before.push(`(${forgetOnce})(${this.opened}, ${remember});`);
    if (pixels < Infinity) before.push(`(${limitPixels})(${pixels});`);
    if (options.before) before.push(`(${options.before})();`);
    const beforeWorker = options.beforeWorker ? [`(${options.beforeWorker})();`] : [];
    if (!draws) for (const scripts of [before, beforeWorker]) scripts.unshift(`(${drawNothing})();`);
    this.server.prepend({ workers: beforeWorker });
    const preferences = { reducedMotion, scheme, forcedColors };
    const opening = { width, height, ratio, touch, preferences, before, beforeWorker };
    if (!this.engine.fits(opening)) {
      const { engine } = this;
      this.engine = await this.restart(opening);
      await engine.close();
    }
    const tab = await this.engine.open(opening);
    this.tab = tab;
    tab.draws = draws;
    const document = page.startsWith('<!doctype') ? page : documentAround(page);
    await tab.page.goto(ofSite ? new URL(page, `${origin}/`).href : this.server.publish(document, headers));
    return tab;
  }

  /**
   * Shows another body in the page of the last call, whose code is loaded already. Its fires are destroyed first. The
   * first call opens a page, as does one with other options, after `open`, or after a loss of contexts.
   * @param {string} body
   * @param {object} [options]  As of {@link open}.
   * @param {number} [options.width]
   * @param {number} [options.height]
   * @param {boolean} [options.draws]
   * @param {() => void} [options.before]  Runs once, in the page that `show` opens.
   * @param {{[name: string]: import('../server.mjs').Instead}} [options.files]
   * @returns {Promise<Tab>}
   */
  async show(body, { files = {}, ...options } = {}) {
    const wanted = JSON.stringify({ ...options, before: String(options.before) });
    if (!this.tab || this.tab.shows !== wanted) {
      const tab = await this.open(body, { ...options, files });
      tab.shows = wanted;
      return tab;
    }
    const { tab } = this;
    this.server.replace(files);
    await tab.evaluate(replaceBody, body);
    tab.problems.length = 0;
    return tab;
  }

  async close() {
    await this.engine.close();
    await this.server.close();
  }
}

/**
 * Runs in the page: clears the storage of previous pages. All pages of WebKit are in one tab.
 * @param {number} opened  Which page of the browser it is.
 * @param {boolean} remember  Whether the next visit finds what this browser keeps.
 */
function forgetOnce(opened, remember) {
  try {
    // A reloaded page keeps its own storage.
    if (sessionStorage.getItem('opened') === String(opened)) return;
    sessionStorage.clear();
    sessionStorage.setItem('opened', String(opened));
    if (!remember) localStorage.clear();
  } catch {
    // Without access to storage nothing is kept.
  }
}

/**
 * Runs in the page: replaces the body, and waits until its fires are defined and its modules have run.
 * @param {string} body
 */
async function replaceBody(body) {
  const fires = /** @type {any[]} */ ([...document.querySelectorAll('hearth-fire')]);
  document.body.replaceChildren();
  await Promise.all(fires.map((fire) => fire.destroy()));
  localStorage.clear();
  scrollTo(0, 0);
  const fragment = document.createRange().createContextualFragment(body);
  const modules = /** @type {HTMLScriptElement[]} */ ([...fragment.querySelectorAll('script[type="module"]')]);
  const ran = modules.map(
    (script) =>
      new Promise((resolve) => {
        script.onload = resolve;
      }),
  );
  document.body.append(fragment);
  await Promise.all(ran);
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

/** A document with this body, the element's script and a black background. */
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
