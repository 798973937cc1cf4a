/**
 * A page with a fire in an iframe, and the messages that the page receives. Page and fire
 * come from two servers, so they have two origins.
 */
import { Browser } from './driver.mjs';
import { serve } from './server.mjs';
import { SITE } from './site.mjs';

/** @typedef {import('./driver.mjs').Tab} Tab */
/** @typedef {{[name: string]: string}} Query */

/** A browser and both servers. */
export class IframeFixture {
  /** @param {Browser} browser @param {import('./server.mjs').Server} fireServer */
  constructor(browser, fireServer) {
    this.browser = browser;
    this.fireServer = fireServer;
  }

  static async start() {
    return new IframeFixture(await Browser.launchWithoutDrawing(), await serve(SITE));
  }

  async close() {
    await this.browser.close();
    await this.fireServer.close();
  }

  get pageOrigin() {
    return this.browser.server.origin;
  }

  get fireOrigin() {
    return this.fireServer.origin;
  }

  /** The address of a fire. */
  address(/** @type {Query} */ query) {
    return `${this.fireOrigin}/web/embed.html?${new URLSearchParams(query)}`;
  }

  /**
   * Opens a page with a fire in an iframe. The page keeps received messages in
   * `window.received` and calls methods with `window.call`.
   * @param {Query} query  Of the fire's address.
   * @param {object} [look]
   * @param {string} [look.style]  Of the page.
   * @param {string} [look.more]  HTML behind the iframe.
   * @param {() => void} [look.before]  Runs in both pages before their scripts.
   * @param {boolean} [look.draws]  Whether WebGL2 draws; it does not by default.
   */
  open(query, { style = '', more = '', before, draws } = {}) {
    const address = this.address(query).replaceAll('&', '&amp;');
    return this.browser.open(
      `<!doctype html>
      <meta charset="utf-8">
      <link rel="icon" href="data:,">
      <style>
        body { margin: 0; background: #000 }
        iframe { display: block; width: 240px; height: 240px; border: 0 }
        ${style}
      </style>
      <script>(${keepMessages})('${this.fireOrigin}')</script>
      <body><iframe src="${address}"></iframe>${more}</body>`,
      { before, draws },
    );
  }

  /**
   * Opens such a page, whose origin the fire allows, and waits until the fire is ready.
   * @param {Query} [query] @param {{style?: string, more?: string}} [look]
   */
  async burning(query = {}, look = {}) {
    const tab = await this.open({ allow: this.pageOrigin, ...query }, look);
    await received(tab, 'ready');
    return tab;
  }
}

/** Runs in the embedding page. */
function keepMessages(/** @type {string} */ fireOrigin) {
  const page = /** @type {any} */ (window);
  page.received = [];
  addEventListener('message', ({ data, origin }) => page.received.push({ ...data, origin }));
  page.posts = (message) => {
    const iframe = /** @type {HTMLIFrameElement} */ (document.querySelector('iframe'));
    iframe.contentWindow?.postMessage(message, fireOrigin);
  };
  page.answer = async (id, timeout = 30000) => {
    const ends = performance.now() + timeout;
    for (;;) {
      const found = page.received.find((message) => message.id === id && 'ok' in message);
      if (found || performance.now() > ends) return found;
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  };
  let last = 0;
  page.call = (method, ...args) => {
    last += 1;
    page.posts({ hearth: 1, id: last, method, args });
    return page.answer(last);
  };
}

/**
 * Waits until the page receives an event from the iframe, and returns it.
 * @param {Tab} tab @param {string} event
 */
export function received(tab, event) {
  return tab.until(
    `the page receives “${event}”`,
    (wanted) => /** @type {any} */ (window).received.find((message) => message.event === wanted),
    event,
  );
}

/**
 * Calls a method of the fire from the embedding page, and returns the answer.
 * @param {Tab} tab @param {string} method @param {...unknown} args
 */
export function call(tab, method, ...args) {
  return tab.evaluate((...all) => /** @type {any} */ (window).call(...all), method, ...args);
}

/**
 * Sends a message as it is and returns its answer; undefined if none comes within the timeout.
 * @param {Tab} tab @param {unknown} message @param {unknown} id  Of the answer.
 * @param {number} [timeout] [ms]
 */
export function send(tab, message, id, timeout) {
  return tab.evaluate(
    (data, wanted, time) => {
      const page = /** @type {any} */ (window);
      page.posts(data);
      return page.answer(wanted, time);
    },
    message,
    id,
    timeout,
  );
}

/**
 * Runs `act` in the page of the iframe with its fire.
 * @param {Tab} tab @param {(fire: any, ...args: any[]) => any} act @param {...unknown} args
 */
export async function inIframe(tab, act, ...args) {
  const iframe = await tab.page.waitForSelector('iframe');
  const frame = /** @type {import('puppeteer-core').Frame} */ (await iframe?.contentFrame());
  await frame.waitForFunction(() => customElements.get('hearth-fire') !== undefined);
  return frame.$eval('hearth-fire', act, ...args);
}
