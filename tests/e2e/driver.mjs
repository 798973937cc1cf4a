/**
 * The one way in which tests and benchmarks drive a real browser: serve the
 * site on loopback, start Chromium on software rendering, open a page at a
 * size, press, drag with mouse or finger, ask the page, take its picture, and
 * keep every complaint that it makes.
 *
 * `HEARTH_SITE` names the folder of the built site (else `dist/site`),
 * `HEARTH_CHROMIUM` the browser (else `chromium` from the PATH). A browser that
 * is not there is a failure, never a skipped test.
 */
import { accessSync, constants } from 'node:fs';
import path from 'node:path';
import puppeteer from 'puppeteer-core';
import { Picture } from './picture.mjs';
import { serve } from './server.mjs';
import { SITE } from './site.mjs';

/** @typedef {{x: number, y: number}} Point */
/** @typedef {import('./picture.mjs').Rectangle} Rectangle */

/** Longest wait for anything a page should do soon; slow machines need it, no law does. */
const PATIENCE = 60_000;

const FLAGS = [
  '--no-sandbox',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--no-first-run',
  '--disable-quic',
];

/** The browser's executable: from the environment, else the first on the PATH. */
function chromium() {
  if (process.env.HEARTH_CHROMIUM) return process.env.HEARTH_CHROMIUM;
  const names = ['chromium', 'chromium-browser', 'google-chrome-stable', 'google-chrome'];
  const folders = (process.env.PATH ?? '').split(path.delimiter);
  for (const file of names.flatMap((name) => folders.map((folder) => path.join(folder, name)))) {
    try {
      accessSync(file, constants.X_OK);
      return file;
    } catch {
      // Not here: the next place may have it.
    }
  }
  throw new Error('no Chromium: install Debian\'s "chromium" or name one in HEARTH_CHROMIUM');
}

/** A running Chromium and the server of the site that it looks at. */
export class Browser {
  /**
   * @param {import('puppeteer-core').Browser} browser
   * @param {import('./server.mjs').Server} server
   */
  constructor(browser, server) {
    this.browser = browser;
    this.server = server;
    /** @type {Tab | undefined} */
    this.tab = undefined;
  }

  /**
   * Starts a browser with an empty profile of its own, looking at the site, or
   * at other folders.
   * @param {...string} folders
   */
  static async launch(...folders) {
    const server = await serve(...(folders.length > 0 ? folders : [SITE]));
    const browser = await puppeteer.launch({
      executablePath: chromium(),
      headless: true,
      args: FLAGS,
      protocolTimeout: 4 * PATIENCE,
    });
    return new Browser(browser, server);
  }

  /**
   * Opens a page of the site, or one written by the test, and closes the one
   * before: two fires at once would only slow each other down.
   *
   * @param {string} page  A path ("index.html?seed=7"), or the HTML of a body ("<hearth-fire>…").
   * @param {object} [options]
   * @param {number} [options.width]  CSS pixels.
   * @param {number} [options.height]
   * @param {number} [options.ratio]  Device pixels for a CSS pixel.
   * @param {boolean} [options.touch]  A phone: touch, and a phone's viewport.
   * @param {boolean} [options.reducedMotion]
   * @param {() => void} [options.before]  Runs in the page before anything of it.
   * @param {string} [options.without]  Requests for files of this name fail.
   * @returns {Promise<Tab>}
   */
  async open(page, options = {}) {
    const { width = 480, height = 480, ratio = 1, touch = false, reducedMotion = false } = options;
    await this.tab?.close();
    const tab = new Tab(await this.browser.newPage());
    this.tab = tab;
    await tab.page.setViewport({
      width,
      height,
      deviceScaleFactor: ratio,
      isMobile: touch,
      hasTouch: touch,
    });
    await tab.page.emulateMediaFeatures([
      { name: 'prefers-reduced-motion', value: reducedMotion ? 'reduce' : 'no-preference' },
    ]);
    await tab.page.evaluateOnNewDocument(rememberContexts);
    if (options.before) await tab.page.evaluateOnNewDocument(options.before);
    if (options.without !== undefined) await tab.refuse(options.without);
    const url = page.includes('<')
      ? this.server.publish(documentAround(page))
      : new URL(page, `${this.server.origin}/`).href;
    await tab.page.goto(url, { waitUntil: 'load' });
    return tab;
  }

  async close() {
    await this.browser.close();
    await this.server.close();
  }
}

/** One page in the browser, with everything it complained about. */
export class Tab {
  /** @param {import('puppeteer-core').Page} page */
  constructor(page) {
    this.page = page;
    /** Console errors and warnings, uncaught exceptions, failed requests. @type {string[]} */
    this.problems = [];
    page.on('console', (message) => {
      if (['error', 'warn', 'warning', 'assert'].includes(message.type())) {
        this.problems.push(`console.${message.type()}: ${message.text()}`);
      }
    });
    page.on('pageerror', (error) => {
      this.problems.push(`uncaught: ${error instanceof Error ? error.message : error}`);
    });
    page.on('requestfailed', (request) => {
      this.problems.push(`request failed: ${request.url()} ${request.failure()?.errorText ?? ''}`);
    });
    page.on('response', (response) => {
      if (response.status() >= 400) this.problems.push(`${response.status()}: ${response.url()}`);
    });
  }

  /**
   * Lets every request for a file of that name fail, as a broken network would.
   * @param {string} name
   */
  async refuse(name) {
    await this.page.setRequestInterception(true);
    this.page.on('request', (request) => (
      request.url().endsWith(name) ? request.abort() : request.continue()
    ));
  }

  /**
   * Runs `act` in the page and gives what it returns.
   * @template T
   * @param {(...args: any[]) => T} act
   * @param {...unknown} args
   * @returns {Promise<Awaited<T>>}
   */
  evaluate(act, ...args) {
    return this.page.evaluate(act, ...args);
  }

  /**
   * Runs `act` in the page with the first `<hearth-fire>` as its first argument.
   * @param {(fire: any, ...args: any[]) => any} act
   * @param {...unknown} args
   */
  fire(act, ...args) {
    return this.page.$eval('hearth-fire', act, ...args);
  }

  /** Waits until the first `<hearth-fire>` says that it is ready. */
  ready() {
    return this.fire((fire) => Promise.resolve(fire.ready).then(() => undefined));
  }

  /**
   * Waits until `holds` gives something true in the page, and gives that.
   * @param {string} what  What is awaited, in words, for the failure's message.
   * @param {(...args: any[]) => unknown} holds
   * @param {...unknown} args
   * @returns {Promise<any>}
   */
  async until(what, holds, ...args) {
    try {
      const handle = await this.page.waitForFunction(
        holds,
        { timeout: PATIENCE, polling: 50 },
        ...args,
      );
      return await handle.jsonValue();
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      throw new Error(`never came true: ${what} (${why}); problems: ${this.problems.join('; ')}`);
    }
  }

  /**
   * Waits until the first fire has burnt for so many seconds of its own time.
   * @param {number} seconds
   */
  burnt(seconds) {
    return this.until(
      `the fire has burnt for ${seconds} s`,
      (time) => /** @type {any} */ (document.querySelector('hearth-fire')).stats?.time >= time,
      seconds,
    );
  }

  /** Waits until the page has painted `count` more frames. */
  async frames(count = 2) {
    await this.page.evaluate(async (left) => {
      for (; left > 0; left -= 1) await new Promise(requestAnimationFrame);
    }, count);
  }

  /**
   * What stands on the screen, all of it or the part inside `clip`.
   * @param {Rectangle} [clip]  CSS pixels.
   */
  async picture(clip) {
    return Picture.decode(await this.page.screenshot({ clip, type: 'png' }));
  }

  /** What stands on the screen where the first fire is. */
  async firePicture() {
    return this.picture(await this.rectangle('hearth-fire'));
  }

  /**
   * Where an element stands, in CSS pixels of the page.
   * @param {string} selector
   * @returns {Promise<Rectangle>}
   */
  rectangle(selector) {
    return this.page.$eval(selector, (element) => {
      const { x, y, width, height } = element.getBoundingClientRect();
      return { x, y, width, height };
    });
  }

  /** @param {import('puppeteer-core').KeyInput} key */
  async key(key) {
    await this.page.keyboard.press(key);
    await this.frames();
  }

  /** @param {Point} at */
  async click(at) {
    await this.page.mouse.move(at.x, at.y);
    await this.frames();
    await this.page.mouse.down();
    await this.frames();
    await this.page.mouse.up();
    await this.frames();
  }

  /**
   * Drags with the mouse. A person's drag lasts many frames; a control that is
   * painted frame by frame would not see one that fits into a single frame.
   * @param {Point} from @param {Point} to
   */
  async drag(from, to) {
    await this.page.mouse.move(from.x, from.y);
    await this.frames();
    await this.page.mouse.down();
    await this.frames();
    for (const at of between(from, to)) {
      await this.page.mouse.move(at.x, at.y);
      await this.frames(1);
    }
    await this.page.mouse.up();
    await this.frames();
  }

  /**
   * Drags with one finger.
   * @param {Point} from @param {Point} to
   */
  async touchDrag(from, to) {
    const finger = await this.page.touchscreen.touchStart(from.x, from.y);
    await this.frames();
    for (const at of between(from, to)) {
      await finger.move(at.x, at.y);
      await this.frames(1);
    }
    await finger.end();
    await this.frames();
  }

  async close() {
    await this.page.close();
  }
}

/** The points of a drag, evenly spread, the last one included. */
function* between(/** @type {Point} */ from, /** @type {Point} */ to, steps = 6) {
  for (let step = 1; step <= steps; step += 1) {
    const part = step / steps;
    yield { x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part };
  }
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

/**
 * Runs in the page: keeps every WebGL2 context and its canvas in
 * `window.contexts`, so that a test can lose one as a driver's crash would and
 * can see a canvas's true pixel size wherever the element hides it.
 */
function rememberContexts() {
  const contexts = (/** @type {any} */ (window).contexts = []);
  for (const type of [HTMLCanvasElement, globalThis.OffscreenCanvas]) {
    if (!type) continue;
    const original = /** @type {any} */ (type.prototype.getContext);
    /** @type {any} */ (type.prototype).getContext = function getContext(...args) {
      const context = original.apply(this, args);
      if (args[0] === 'webgl2' && context && !contexts.includes(context)) contexts.push(context);
      return context;
    };
  }
}
