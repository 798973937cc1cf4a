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
import { Picture } from '../picture.mjs';
import { display } from './display.mjs';
import { keepProblems } from './page-scripts.mjs';
import { program } from './programs.mjs';
import { PATIENCE, Tab } from './tab.mjs';
import { Session } from './webdriver.mjs';

/** WebDriver's characters for keys without text. */
const KEYS = {
  Tab: '\uE004',
  Enter: '\uE007',
  Escape: '\uE00C',
  Space: ' ',
  Home: '\uE011',
  End: '\uE010',
  ArrowLeft: '\uE012',
  ArrowUp: '\uE013',
  ArrowRight: '\uE014',
  ArrowDown: '\uE015',
};

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
  const end = () => {
    screen.close();
    rmSync(home, { recursive: true, force: true });
  };
  try {
    const session = await Session.start(
      driver,
      // A cached page would keep its fires and contexts.
      { 'webkitgtk:browserOptions': { args: ['--automation', '--enable-page-cache=false'], ...browserFile() } },
      {
        ...process.env,
        DISPLAY: screen.name,
        WAYLAND_DISPLAY: undefined,
        GDK_BACKEND: 'x11',
        XDG_CONFIG_HOME: home,
        NO_AT_BRIDGE: '1',
      },
    );
    await session.post('timeouts', { script: 4 * PATIENCE, pageLoad: 4 * PATIENCE });
    return {
      browser: session,
      async open(opening) {
        const tab = new WebKitTab(session, server);
        await tab.prepare(opening, reducedMotion);
        return tab;
      },
      close: () => session.close().finally(end),
    };
  } catch (error) {
    end();
    throw error;
  }
}

/** Another browser than the driver's own, if one is named. */
function browserFile() {
  const named = process.env.HEARTH_WEBKIT;
  return named ? { binary: named } : {};
}

/** A page of WebKit. */
export class WebKitTab extends Tab {
  #mouse = { x: 0, y: 0 };

  /** @param {Session} session @param {import('../server.mjs').Server} server */
  constructor(session, server) {
    super();
    this.session = session;
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
    const inner = () => this.session.run('arguments[0]([innerWidth, innerHeight])', []);
    let [across, down] = [0, 0];
    const end = Date.now() + PATIENCE;
    while (Date.now() < end) {
      await this.session.post('window/rect', { width: width + across, height: height + down });
      await sleep(50);
      const [w, h] = await inner();
      if (w === width && h === height) return;
      const rect = await this.session.get('window/rect');
      [across, down] = [rect.width - w, rect.height - h];
    }
    throw new Error(`WebKit's window does not become ${width} × ${height}, but ${await inner()}`);
  }

  /** @param {string} url */
  async go(url) {
    await this.session.post('url', { url });
    // The driver does not always wait for modules.
    await this.until('the page is loaded', () => document.readyState === 'complete');
  }

  /** @override */
  evaluate(act, ...args) {
    return this.#run(`(${act})`, args);
  }

  /** @override */
  on(selector, act, ...args) {
    return this.#run(
      `((wanted, ...rest) => {
        const found = document.querySelector(wanted);
        if (!found) throw new Error('no ' + wanted + ' on the page');
        return (${act})(found, ...rest);
      })`,
      [selector, ...args],
    );
  }

  /** @param {string} source @param {unknown[]} args */
  async #run(source, args) {
    const { text, failure, problems } = JSON.parse(
      await this.session.run(
        `const done = arguments[arguments.length - 1];
      const answer = (response) => done(JSON.stringify({
        ...response, problems: (window.keptProblems ?? []).splice(0),
      }));
      Promise.resolve()
        .then(() => ${source}(...JSON.parse(arguments[0])))
        .then(
          (value) => answer({ text: JSON.stringify(value) }),
          (error) => answer({ failure: String(error) }),
        );`,
        [JSON.stringify(args)],
      ),
    );
    this.problems.push(...problems);
    if (failure !== undefined) throw new Error(failure);
    return text === undefined ? undefined : JSON.parse(text);
  }

  /** @override */
  async until(what, holds, ...args) {
    const end = Date.now() + PATIENCE;
    for (;;) {
      const value = await this.evaluate(holds, ...args);
      if (value) return value;
      if (Date.now() > end) {
        throw new Error(`never came true: ${what}; problems: ${this.problems.join('; ')}`);
      }
      await sleep(50);
    }
  }

  /** @override */
  async picture(clip) {
    const whole = Picture.decode(Buffer.from(await this.session.get('screenshot'), 'base64'));
    if (!clip) return whole;
    const { x, y, width, height } = clip;
    return whole.crop(x / whole.width, y / whole.height, (x + width) / whole.width, (y + height) / whole.height);
  }

  /** @override */
  mouse(what, at) {
    // Without a previous move, a pointer is at the corner.
    if (what === 'move') this.#mouse = at;
    const { x, y } = this.#mouse;
    const actions = {
      move: { type: 'pointerMove', x: Math.round(x), y: Math.round(y), duration: 0 },
      down: { type: 'pointerDown', button: 0 },
      up: { type: 'pointerUp', button: 0 },
    };
    return this.session.post('actions', {
      actions: [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions: [actions[what]] }],
    });
  }

  /** @override */
  async press(key) {
    const value = KEYS[key] ?? key;
    await this.session.post('actions', {
      actions: [
        {
          type: 'key',
          id: 'keyboard',
          actions: [
            { type: 'keyDown', value },
            { type: 'keyUp', value },
          ],
        },
      ],
    });
  }

  async close() {
    this.server.refused = undefined;
    await this.go('about:blank');
    this.server.prepend({});
  }
}
