/**
 * WebKitGTK's small browser, in a window of a virtual display, driven through WebDriver.
 *
 * Its driver reports no problems of a page and runs no script before it, so the page records
 * its problems and the server inserts the scripts.
 */
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { Capabilities, Key, WebDriver } from 'selenium-webdriver';
import { Executor, HttpClient } from 'selenium-webdriver/http/index.js';
import { DriverService } from 'selenium-webdriver/remote/index.js';
import { Picture } from '../picture.mjs';
import { display } from './display.mjs';
import { keepProblems } from './page-scripts.mjs';
import { program } from './programs.mjs';
import { WAIT_MS, Tab } from './tab.mjs';

/**
 * @param {{reducedMotion?: boolean}} options  A desktop setting for all its pages.
 * @param {import('../server.mjs').Server} server
 * @returns {Promise<import('./browser.mjs').Engine>}
 */
export async function webkit({ reducedMotion = false }, server) {
  const driver = program('HEARTH_WEBKIT_DRIVER', ['WebKitWebDriver'], 'webkit2gtk-driver');
  const home = mkdtempSync(path.join(os.tmpdir(), 'hearth-webkit-'));
  mkdirSync(path.join(home, 'gtk-3.0'));
  writeFileSync(
    path.join(home, 'gtk-3.0', 'settings.ini'),
    `[Settings]\ngtk-enable-animations=${reducedMotion ? 0 : 1}\n`,
  );
  const screen = await display();
  const env = { ...process.env, DISPLAY: screen.name, WAYLAND_DISPLAY: undefined, GDK_BACKEND: 'x11' };
  const service = new DriverService.Builder(driver)
    .setLoopback(true)
    .setEnvironment({ ...env, XDG_CONFIG_HOME: home, NO_AT_BRIDGE: '1' })
    .build();
  const end = async () => {
    await service.kill();
    screen.close();
    rmSync(home, { recursive: true, force: true });
  };
  try {
    const browser = WebDriver.createSession(
      new Executor(service.start().then((address) => new HttpClient(address))),
      new Capabilities({
        // A cached page would keep its fires and contexts.
        'webkitgtk:browserOptions': { args: ['--automation', '--enable-page-cache=false'], ...browserFile() },
      }),
    );
    await browser.manage().setTimeouts({ script: 4 * WAIT_MS, pageLoad: 4 * WAIT_MS });
    return {
      browser,
      async open(opening) {
        const tab = new WebKitTab(browser, server);
        await tab.prepare(opening, reducedMotion);
        return tab;
      },
      close: () => browser.quit().finally(end),
    };
  } catch (error) {
    await end();
    throw error;
  }
}

/** Another browser than the driver's own, if one is named. */
function browserFile() {
  const named = process.env.HEARTH_WEBKIT;
  return named ? { binary: named } : {};
}

/** A page of WebKit. */
class WebKitTab extends Tab {
  /** @param {WebDriver} browser @param {import('../server.mjs').Server} server */
  constructor(browser, server) {
    super(/** @type {any} */ (undefined));
    this.page = /** @type {any} */ (new WebKitPage(browser, server, this.problems));
    this.browser = browser;
    this.server = server;
  }

  /** @param {import('./browser.mjs').Opening} opening @param {boolean} reduced */
  async prepare({ width, height, ratio, touch, reducedMotion, before, beforeWorker }, reduced) {
    if (ratio !== 1) throw new Error(`WebKit draws one pixel a CSS pixel here, not ${ratio}`);
    if (touch) throw new Error('WebKit has no touch here');
    if (reducedMotion && !reduced) throw new Error('WebKit takes reduced motion at start');
    this.server.prepend({ pages: [`(${keepProblems})();`, ...before], workers: beforeWorker });
    this.server.refused = (problem) => this.problems.push(problem);
    // The window is larger than the page by its toolbar, whose size the page reports.
    const inner = () => this.browser.executeScript('return [innerWidth, innerHeight]');
    const window = this.browser.manage().window();
    let [across, down] = [0, 0];
    const end = Date.now() + WAIT_MS;
    while (Date.now() < end) {
      await window.setRect({ width: width + across, height: height + down });
      await sleep(50);
      const [w, h] = await inner();
      if (w === width && h === height) return;
      const rect = await window.getRect();
      [across, down] = [rect.width - w, rect.height - h];
    }
    throw new Error(`WebKit's window does not become ${width} × ${height}, but ${await inner()}`);
  }

  /** @override @param {import('./tab.mjs').Rectangle} [clip] */
  async picture(clip) {
    const whole = Picture.decode(Buffer.from(await this.browser.takeScreenshot(), 'base64'));
    if (!clip) return whole;
    const { x, y, width, height } = clip;
    return whole.crop(x / whole.width, y / whole.height, (x + width) / whole.width, (y + height) / whole.height);
  }
}

/** What tests use of puppeteer's page in every browser. */
class WebKitPage {
  #browser;
  #server;
  #problems;

  /** @param {WebDriver} browser @param {import('../server.mjs').Server} server @param {string[]} problems */
  constructor(browser, server, problems) {
    this.#browser = browser;
    this.#server = server;
    this.#problems = problems;
    const act = () => browser.actions();
    this.mouse = {
      move: (x, y) =>
        act()
          .move({ x: Math.round(x), y: Math.round(y), duration: 0 })
          .perform(),
      down: () => act().press().perform(),
      up: () => act().release().perform(),
    };
    // `ArrowLeft` is `Key.ARROW_LEFT`.
    const named = (key) => Key[key.replace(/(?<=[a-z])(?=[A-Z])/g, '_').toUpperCase()];
    this.keyboard = {
      press: (key) =>
        act()
          .sendKeys(named(key) ?? key)
          .perform(),
    };
  }

  /** @param {string} url */
  async goto(url) {
    await this.#browser.get(url);
    // The driver does not always wait for modules.
    await this.waitForFunction(() => document.readyState === 'complete', { timeout: WAIT_MS });
  }

  async close() {
    this.#server.refused = undefined;
    await this.goto('about:blank');
    this.#server.prepend({});
  }

  async waitForFunction(holds, { timeout }, ...args) {
    const end = Date.now() + timeout;
    for (;;) {
      const value = await this.evaluate(holds, ...args);
      if (value) return { jsonValue: () => value };
      if (Date.now() > end) throw new Error(`waited for ${timeout} ms`);
      await sleep(50);
    }
  }

  $eval(selector, act, ...args) {
    return this.evaluate(
      `(wanted, ...rest) => {
        const found = document.querySelector(wanted);
        if (!found) throw new Error('no ' + wanted + ' on the page');
        return (${act})(found, ...rest);
      }`,
      selector,
      ...args,
    );
  }

  async evaluate(act, ...args) {
    const { text, failure, problems } = JSON.parse(
      await this.#browser.executeAsyncScript(
        `const done = arguments[arguments.length - 1];
      const answer = (response) => done(JSON.stringify({
        ...response, problems: (window.keptProblems ?? []).splice(0),
      }));
      Promise.resolve()
        .then(() => (${act})(...JSON.parse(arguments[0])))
        .then(
          (value) => answer({ text: JSON.stringify(value) }),
          (error) => answer({ failure: String(error) }),
        );`,
        JSON.stringify(args),
      ),
    );
    this.#problems.push(...problems);
    if (failure !== undefined) throw new Error(failure);
    return text === undefined ? undefined : JSON.parse(text);
  }
}
