/**
 * What tests use of puppeteer's page, in WebKit: through Selenium, with a mouse and keys that the browser takes for a
 * visitor's. A selector reaches into shadow roots at each `>>>`, as puppeteer's does.
 */
import { setTimeout as sleep } from 'node:timers/promises';
import { Key } from 'selenium-webdriver';
import { SCREEN } from './display.mjs';
import { CHROMIUM_ALONE, LeftOut } from './programs.mjs';
import { WAIT_MS } from './tab.mjs';

/** The least width of its window, whose toolbar needs it [px]. */
const NARROWEST = 290;

/**
 * Where its window stands on the display [px]: no window manager gives it the focus, so that it has the focus while the
 * display's pointer, in the middle of the screen, is over its toolbar.
 */
const PLACE = { x: SCREEN.width / 2 - NARROWEST / 2, y: SCREEN.height / 2 - 8 };

/** Runs in the page: the elements of a selector. @param {string} selector */
function found(selector) {
  const [first, ...others] = selector.split('>>>');
  /** @type {Element[]} */
  let all = [...document.querySelectorAll(first.trim() || '*')];
  for (const inner of others) all = all.flatMap((it) => [...(it.shadowRoot?.querySelectorAll(inner.trim()) ?? [])]);
  return all;
}

/**
 * Runs in the page: shows an element that its window or a list that scrolls cuts off, and where its middle is.
 * @param {Element} element
 */
async function middle(element) {
  const share = await new Promise((resolve) => {
    const observer = new IntersectionObserver(([{ intersectionRatio }]) => {
      observer.disconnect();
      resolve(intersectionRatio);
    });
    observer.observe(element);
  });
  if (share < 1) element.scrollIntoView({ block: 'center', inline: 'center', behavior: 'instant' });
  const { x, y, width, height } = element.getBoundingClientRect();
  return { x: x + width / 2, y: y + height / 2 };
}

/** Runs in the page. @param {Element} element @param {...string} values */
function selectOptions(element, ...values) {
  for (const option of /** @type {HTMLSelectElement} */ (element).options)
    option.selected = values.includes(option.value);
  for (const type of ['input', 'change']) element.dispatchEvent(new Event(type, { bubbles: true }));
}

/** `ArrowLeft` is `Key.ARROW_LEFT`. @param {string} key */
const named = (key) => Key[key.replace(/(?<=[a-z])(?=[A-Z])/g, '_').toUpperCase()] ?? key;

/** How far the wheel of each browser has been turned. @type {WeakMap<any, {x: number, y: number}>} */
const turns = new WeakMap();

/** A page. */
export class WebKitPage {
  #browser;
  #server;
  #problems;
  #viewport;
  #at = { x: 0, y: 0 };

  /** @param {any} browser @param {import('../server.mjs').Server} server @param {string[]} problems */
  constructor(browser, server, problems) {
    this.#browser = browser;
    this.#server = server;
    this.#problems = problems;
    Object.assign(this, CHROMIUM_ALONE);
    const act = () => browser.actions();
    this.mouse = {
      move: (x, y) => {
        this.#at = { x: Math.round(x), y: Math.round(y) };
        return act()
          .move({ ...this.#at, duration: 0 })
          .perform();
      },
      down: () => act().press().perform(),
      up: () => act().release().perform(),
      click: async (x, y) => {
        await this.mouse.move(x, y);
        await this.mouse.down();
        await this.mouse.up();
      },
      wheel: ({ deltaX = 0, deltaY = 0 }) => {
        // The driver takes the way since the last turn of the wheel for the turn.
        const { x, y } = turns.get(browser) ?? { x: 0, y: 0 };
        const turned = { x: x + Math.round(deltaX), y: y + Math.round(deltaY) };
        turns.set(browser, turned);
        return act().scroll(this.#at.x, this.#at.y, turned.x, turned.y).perform();
      },
    };
    this.keyboard = {
      press: (key) => act().sendKeys(named(key)).perform(),
      down: (key) => act().keyDown(named(key)).perform(),
      up: (key) => act().keyUp(named(key)).perform(),
      type: (text) => act().sendKeys(text).perform(),
    };
  }

  /** @param {string} url */
  async goto(url) {
    await this.#browser.get(url);
    // The driver does not always wait for modules.
    await this.waitForFunction(() => document.readyState === 'complete', { timeout: WAIT_MS });
  }

  async reload() {
    await this.#browser.navigate().refresh();
    await this.waitForFunction(() => document.readyState === 'complete', { timeout: WAIT_MS });
  }

  async close() {
    this.#server.refused = undefined;
    await this.goto('about:blank');
    this.#server.prepend({});
  }

  viewport() {
    return this.#viewport;
  }

  /** @param {{width: number, height: number}} viewport */
  async setViewport(viewport) {
    const { width, height } = viewport;
    if (width < NARROWEST) throw new LeftOut(`WebKitGTK's window is no narrower than ${NARROWEST} pixels`);
    this.#viewport = viewport;
    // The window is larger than the page by its toolbar, whose size the page reports.
    const inner = () => this.#browser.executeScript('return [innerWidth, innerHeight]');
    const window = this.#browser.manage().window();
    let [across, down] = [0, 0];
    const end = Date.now() + WAIT_MS;
    while (Date.now() < end) {
      await window.setRect({ ...PLACE, width: width + across, height: height + down });
      await sleep(50);
      const [w, h] = await inner();
      if (w === width && h === height) return;
      const rect = await window.getRect();
      [across, down] = [rect.width - w, rect.height - h];
    }
    throw new Error(`WebKit's window does not become ${width} × ${height}, but ${await inner()}`);
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

  /** Waits for an element, and returns its handle. @param {string} selector */
  async waitForSelector(selector, { timeout = WAIT_MS } = {}) {
    const wanted = new Function('selector', `return (${found})(selector).length > 0`);
    await this.waitForFunction(wanted, { timeout }, selector);
    return this.#handle(selector, 0);
  }

  async $(selector) {
    const [first] = await this.$$(selector);
    return first ?? null;
  }

  async $$(selector) {
    const count = await this.$$eval(selector, (all) => all.length);
    return Array.from({ length: count }, (_, at) => this.#handle(selector, at));
  }

  /** What tests use of puppeteer's handle of an element. */
  #handle(selector, at) {
    const evaluate = (act, ...args) => this.#run(`(${found})(wanted)[${at}]`, act, selector, args);
    return {
      evaluate,
      click: async () => {
        const { x, y } = await evaluate(middle);
        await this.mouse.click(x, y);
      },
      contentFrame: () => new WebKitFrame(this, this.#browser, at),
    };
  }

  async click(selector) {
    await (await this.waitForSelector(selector)).click();
  }

  async hover(selector) {
    const { x, y } = await this.$eval(selector, middle);
    await this.mouse.move(x, y);
  }

  focus(selector) {
    return this.$eval(selector, (element) => element.focus());
  }

  select(selector, ...values) {
    return this.$eval(selector, selectOptions, ...values);
  }

  async type(selector, text) {
    await this.focus(selector);
    await this.keyboard.type(text);
  }

  $eval(selector, act, ...args) {
    return this.#run(`(${found})(wanted)[0]`, act, selector, args);
  }

  $$eval(selector, act, ...args) {
    return this.#run(`(${found})(wanted)`, act, selector, args);
  }

  /** Runs `act` with what an expression gives of the selector. */
  #run(expression, act, selector, args) {
    return this.#call(
      `(wanted, ...rest) => {
        const chosen = ${expression};
        if (!chosen) throw new Error('no ' + wanted + ' on the page');
        return (${act})(chosen, ...rest);
      }`,
      [selector, ...args],
    );
  }

  /** A function with its arguments, or a script. */
  evaluate(act, ...args) {
    return typeof act === 'string' ? this.#call(`() => {${act}\n}`, []) : this.#call(act, args);
  }

  /** @param {Function | string} act  A function, or its text. @param {unknown[]} args */
  async #call(act, args) {
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

/** What tests use of puppeteer's frame. */
class WebKitFrame {
  #page;
  #browser;
  #at;

  /** @param {WebKitPage} page @param {any} browser @param {number} at  Its place among the frames of the page. */
  constructor(page, browser, at) {
    this.#page = page;
    this.#browser = browser;
    this.#at = at;
  }

  /** Runs a call of the page inside of the frame. @param {() => Promise<any>} call */
  async #inside(call) {
    await this.#browser.switchTo().frame(this.#at);
    try {
      return await call();
    } finally {
      await this.#browser.switchTo().defaultContent();
    }
  }

  evaluate(...all) {
    return this.#inside(() => this.#page.evaluate(.../** @type {[any]} */ (all)));
  }

  $eval(...all) {
    return this.#inside(() => this.#page.$eval(.../** @type {[any, any]} */ (all)));
  }

  waitForFunction(holds, { timeout = WAIT_MS } = {}, ...args) {
    return this.#inside(() => this.#page.waitForFunction(holds, { timeout }, ...args));
  }
}
