/**
 * A page with a fire in an iframe, and what it hears of it. The page is served
 * from one port and the fire from another: two origins.
 */
import { Browser } from './driver.mjs';
import { serve } from './server.mjs';
import { SITE } from './site.mjs';

/** @typedef {import('./driver.mjs').Tab} Tab */
/** @typedef {{[name: string]: string}} Query */

/** A browser, and the two servers that its pages come from. */
export class Around {
  /** @param {Browser} browser @param {import('./server.mjs').Server} elsewhere */
  constructor(browser, elsewhere) {
    this.browser = browser;
    this.elsewhere = elsewhere;
  }

  static async start() {
    return new Around(await Browser.launch(), await serve(SITE));
  }

  async close() {
    await this.browser.close();
    await this.elsewhere.close();
  }

  /** The origin of the page around. */
  get here() {
    return this.browser.server.origin;
  }

  /** The origin of the fire. */
  get there() {
    return this.elsewhere.origin;
  }

  /** The address of a fire. */
  address(/** @type {Query} */ query) {
    return `${this.there}/web/embed.html?${new URLSearchParams(query)}`;
  }

  /**
   * Opens a page with a fire in an iframe. It keeps the messages that it gets, in
   * `window.heard`, and asks with `window.ask`.
   * @param {Query} query  Of the fire's address.
   * @param {object} [look]
   * @param {string} [look.style]  Of the page.
   * @param {string} [look.more]  HTML behind the iframe.
   */
  open(query, { style = '', more = '' } = {}) {
    const address = this.address(query).replaceAll('&', '&amp;');
    return this.browser.open(`<!doctype html>
      <meta charset="utf-8">
      <link rel="icon" href="data:,">
      <style>
        body { margin: 0; background: #000 }
        iframe { display: block; width: 240px; height: 240px; border: 0 }
        ${style}
      </style>
      <script>(${keepMessages})('${this.there}')</script>
      <body><iframe src="${address}"></iframe>${more}</body>`);
  }

  /**
   * The same with a fire that answers the page, when it burns.
   * @param {Query} [query] @param {{style?: string, more?: string}} [look]
   */
  async burning(query = {}, look = {}) {
    const tab = await this.open({ allow: this.here, ...query }, look);
    await heard(tab, 'ready');
    return tab;
  }
}

/** Runs in the page around. */
function keepMessages(/** @type {string} */ there) {
  const page = /** @type {any} */ (window);
  page.heard = [];
  addEventListener('message', ({ data, origin }) => page.heard.push({ ...data, origin }));
  page.posts = (message) => {
    const frame = /** @type {HTMLIFrameElement} */ (document.querySelector('iframe'));
    frame.contentWindow?.postMessage(message, there);
  };
  page.answer = async (id, patience = 30000) => {
    const ends = performance.now() + patience;
    for (;;) {
      const found = page.heard.find((one) => one.id === id && 'ok' in one);
      if (found || performance.now() > ends) return found;
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  };
  let last = 0;
  page.ask = (method, ...args) => {
    last += 1;
    page.posts({ hearth: 1, id: last, method, args });
    return page.answer(last);
  };
}

/**
 * Waits until the page has heard an event from the iframe, and gives it.
 * @param {Tab} tab @param {string} event
 */
export function heard(tab, event) {
  return tab.until(
    `the page hears “${event}”`,
    (wanted) => /** @type {any} */ (window).heard.find((one) => one.event === wanted),
    event,
  );
}

/**
 * Asks the fire as the page around it does, and gives the answer.
 * @param {Tab} tab @param {string} method @param {...unknown} args
 */
export function ask(tab, method, ...args) {
  return tab.evaluate((...all) => /** @type {any} */ (window).ask(...all), method, ...args);
}

/**
 * Sends a message as it is and gives its answer; undefined if there is none in good time.
 * @param {Tab} tab @param {unknown} message @param {unknown} id  Of the answer.
 * @param {number} [patience]  In milliseconds.
 */
export function send(tab, message, id, patience) {
  return tab.evaluate((data, wanted, time) => {
    const page = /** @type {any} */ (window);
    page.posts(data);
    return page.answer(wanted, time);
  }, message, id, patience);
}

/**
 * Runs `act` in the iframe's page with its fire.
 * @param {Tab} tab @param {(fire: any, ...args: any[]) => any} act @param {...unknown} args
 */
export async function inside(tab, act, ...args) {
  const iframe = await tab.page.waitForSelector('iframe');
  const frame = /** @type {import('puppeteer-core').Frame} */ (await iframe?.contentFrame());
  await frame.waitForFunction(() => customElements.get('hearth-fire') !== undefined);
  return frame.$eval('hearth-fire', act, ...args);
}
