/**
 * WebKitGTK's small browser, in a window of a virtual display, driven through WebDriver.
 *
 * Its driver reports no problems of a page and runs no script before it, so the page records
 * its problems and the server inserts the scripts.
 */
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { isDeepStrictEqual } from 'node:util';
import { Capabilities, WebDriver } from 'selenium-webdriver';
import { Executor, HttpClient } from 'selenium-webdriver/http/index.js';
import { DriverService } from 'selenium-webdriver/remote/index.js';
import { Picture } from '../picture.mjs';
import { display } from './display.mjs';
import { keepProblems } from './page-scripts.mjs';
import { LeftOut, program } from './programs.mjs';
import { WAIT_MS, Tab } from './tab.mjs';
import { WebKitPage } from './webkit-page.mjs';

/** The least toolbar, so that a window may be as narrow as a phone. */
const NARROW = '* { min-width: 0; min-height: 0; margin: 0; padding: 0; border: 0; font-size: 1px }';

/**
 * @param {import('./browser.mjs').Desktop} options  The desktop's, for all its pages.
 * @param {import('../server.mjs').Server} server
 * @returns {Promise<import('./browser.mjs').Engine>}
 */
export async function webkit({ preferences, ratio }, server) {
  const { reducedMotion, scheme, forcedColors } = preferences;
  if (forcedColors) throw new LeftOut('WebKitGTK has no forced colours');
  if (!Number.isInteger(ratio)) throw new LeftOut('WebKitGTK draws a whole number of pixels for each of a page');
  const driver = program('HEARTH_WEBKIT_DRIVER', ['WebKitWebDriver'], 'webkit2gtk-driver');
  const home = mkdtempSync(path.join(os.tmpdir(), 'hearth-webkit-'));
  mkdirSync(path.join(home, 'gtk-3.0'));
  writeFileSync(path.join(home, 'gtk-3.0', 'gtk.css'), NARROW);
  writeFileSync(
    path.join(home, 'gtk-3.0', 'settings.ini'),
    `[Settings]
gtk-enable-animations=${reducedMotion ? 0 : 1}
gtk-application-prefer-dark-theme=${scheme === 'dark' ? 1 : 0}
`,
  );
  const screen = await display(ratio);
  const env = {
    GDK_SCALE: String(ratio),
    ...process.env,
    DISPLAY: screen.name,
    WAYLAND_DISPLAY: undefined,
    GDK_BACKEND: 'x11',
  };
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
      version: async () => (await browser.getCapabilities()).getBrowserVersion(),
      fits: (opening) => isDeepStrictEqual([opening.preferences, opening.ratio], [preferences, ratio]),
      async open(opening) {
        const tab = new WebKitTab(browser, server);
        await tab.prepare(opening);
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

  /** @param {import('./browser.mjs').Opening} opening */
  async prepare({ width, height, touch, before, beforeWorker }) {
    if (touch) throw new LeftOut("WebKitGTK's driver has no touch");
    this.server.prepend({ pages: [`(${keepProblems})();`, ...before], workers: beforeWorker });
    this.server.refused = (problem) => this.problems.push(problem);
    await this.page.setViewport({ width, height });
  }

  /** @override @param {import('./tab.mjs').Rectangle} [clip] */
  async picture(clip) {
    const whole = Picture.decode(Buffer.from(await this.browser.takeScreenshot(), 'base64'));
    if (!clip) return whole;
    // The picture is of the window, the rectangle of the page.
    const [w, h, left, top] = await this.evaluate(() => [innerWidth, innerHeight, scrollX, scrollY]);
    const [x, y] = [clip.x - left, clip.y - top];
    return whole.crop(x / w, y / h, (x + clip.width) / w, (y + clip.height) / h);
  }
}
