/** A page in any of the browsers, and what tests do with it. */
import { Picture } from '../picture.mjs';

/** @typedef {{x: number, y: number}} Point */
/** @typedef {import('../picture.mjs').Rectangle} Rectangle */

/** Timeout of every wait [ms]: long, since only a hanging page reaches it. */
export const WAIT_MS = 60_000;

/**
 * Reads a value until it is as `holds` requires, and returns it. The wait ends by its time alone: a number of
 * frames may pass before a worker that gets no processor has drawn one.
 * @template T
 * @param {string} what  Describes the condition in the failure's message.
 * @param {() => T | Promise<T>} read
 * @param {(value: T) => unknown} holds
 * @param {() => unknown} [between]  What happens before the next reading.
 * @param {(value: T) => unknown} [shown]  The value in the failure's message.
 * @returns {Promise<T>}
 */
export async function eventually(what, read, holds, between = () => {}, shown = (value) => value) {
  const end = Date.now() + WAIT_MS;
  for (;;) {
    const value = await read();
    if (holds(value)) return value;
    if (Date.now() > end) throw new Error(`never came true: ${what}; it is ${JSON.stringify(shown(value))}`);
    await between();
  }
}

/** A page and its problems. */
export class Tab {
  /** @param {import('puppeteer-core').Page} page  Puppeteer's page; that of WebKit has some of its methods. */
  constructor(page) {
    this.page = page;
    /** Console errors and warnings, uncaught exceptions, failed requests. @type {string[]} */
    this.problems = [];
    /** Whether WebGL2 draws. */
    this.draws = true;
    /** The options with which `show` opened the page, while other bodies may follow. @type {string | undefined} */
    this.shows = undefined;
  }

  /**
   * Runs `act` in the page and returns its result.
   * @template T
   * @param {string | ((...args: any[]) => T)} act
   * @param {...unknown} args
   * @returns {Promise<Awaited<T>>}
   */
  evaluate(act, ...args) {
    return this.page.evaluate(/** @type {any} */ (act), ...args);
  }

  /**
   * Waits until `holds` returns a truthy value in the page, and returns it.
   * @param {string} what  Describes the condition in the failure's message.
   * @param {Function} holds
   * @param {...unknown} args
   * @returns {Promise<any>}
   */
  async until(what, holds, ...args) {
    try {
      const handle = await this.page.waitForFunction(
        /** @type {any} */ (holds),
        { timeout: WAIT_MS, polling: 50 },
        ...args,
      );
      return await handle.jsonValue();
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      throw new Error(`never came true: ${what} (${why}); problems: ${this.problems.join('; ')}`);
    }
  }

  /**
   * The visible part of the page.
   * @param {Rectangle} [clip]
   */
  async picture(clip) {
    if (!this.draws) throw new Error('this page draws nothing: open it with `draws: true` to look at its picture');
    // A capture beyond the viewport resizes the page for a moment, and a playing fire may be
    // drawn at that size.
    return Picture.decode(await this.page.screenshot({ clip, captureBeyondViewport: false, type: 'png' }));
  }

  /**
   * Runs `act` in the page with the first `<hearth-fire>` as its first argument.
   * @param {(fire: any, ...args: any[]) => any} act
   * @param {...unknown} args
   */
  fire(act, ...args) {
    return this.page.$eval('hearth-fire', act, ...args);
  }

  /** Waits until the first `<hearth-fire>` is ready. */
  ready() {
    return this.fire((fire) => Promise.resolve(fire.ready).then(() => undefined));
  }

  /**
   * Steps the first fire to this age, as fast as the machine computes.
   * @param {number} seconds  Of fire.
   */
  async burnt(seconds) {
    try {
      await this.fire(stepUntil, seconds);
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      throw new Error(`the fire does not burn for ${seconds} s: ${why}; problems: ${this.problems.join('; ')}`);
    }
  }

  /**
   * Waits until the first fire plays to this age.
   * @param {number} seconds  Of fire.
   */
  plays(seconds) {
    return this.until(
      `the fire plays until ${seconds} s`,
      (time) => /** @type {any} */ (document.querySelector('hearth-fire')).stats?.time >= time,
      seconds,
    );
  }

  /** Waits until the page has painted `count` more frames. */
  async frames(count = 2) {
    await this.evaluate(async (left) => {
      for (; left > 0; left -= 1) await new Promise(requestAnimationFrame);
    }, count);
  }

  /** The problems of the page after one more frame. */
  async problemsAfterFrame() {
    await this.frames(1);
    return this.problems;
  }

  /**
   * Loses every WebGL2 context of the page and its workers, like a crash of the graphics
   * driver.
   * @param {number} [milliseconds]  After which the contexts are restored; without it, never.
   */
  async loseContext(milliseconds) {
    this.shows = undefined;
    const lost = await this.evaluate((time) => /** @type {any} */ (window).driver.lose(time), milliseconds ?? null);
    if (lost === 0) throw new Error('neither the page nor a worker has a context to lose');
  }

  /**
   * Numbers of live WebGL2 contexts, of GPU objects in them, of bytes of wasm memory and of
   * workers.
   * @returns {Promise<{contexts: number, objects: number, memory: number, workers: number}>}
   */
  living() {
    return this.evaluate(async () => {
      const { driver } = /** @type {any} */ (window);
      return {
        contexts: await driver.contexts(),
        objects: await driver.objects(),
        memory: await driver.memory(),
        workers: driver.workers(),
      };
    });
  }

  /** The first fire as it is on the screen. */
  async firePicture() {
    // The landing page has fading text over its fire.
    await this.evaluate(() => {
      for (const over of document.querySelectorAll('body > header, #hint, #scenes')) {
        Object.assign(/** @type {HTMLElement} */ (over).style, { visibility: 'hidden', transition: 'none' });
      }
    });
    return this.picture(await this.rectangle('hearth-fire'));
  }

  /**
   * Waits until the first fire on the screen is as `holds` requires, and returns its picture: an
   * engine in a worker may draw many frames after the page's own.
   * @param {string} what  Describes the condition in the failure's message.
   * @param {(picture: Picture) => boolean} holds
   */
  async pictureUntil(what, holds) {
    return eventually(
      what,
      () => this.firePicture(),
      holds,
      () => this.frames(1),
      () => 'another picture',
    );
  }

  /**
   * The rectangle of an element, in CSS pixels of the page.
   * @param {string} selector
   * @returns {Promise<Rectangle>}
   */
  rectangle(selector) {
    return this.page.$eval(selector, (element) => {
      const { x, y, width, height } = element.getBoundingClientRect();
      return { x, y, width, height };
    });
  }

  /** @param {string} key  Its name, such as `ArrowLeft` or `Space`. */
  async key(key) {
    // Firefox's driver knows the space by its letter alone.
    await this.page.keyboard.press(/** @type {any} */ (key === 'Space' ? ' ' : key));
    await this.frames();
  }

  /** Moves the mouse. @param {Point} at */
  move(at) {
    return this.page.mouse.move(at.x, at.y);
  }

  /** @param {Point} at */
  async click(at) {
    const { mouse } = this.page;
    for (const act of [() => this.move(at), () => mouse.down(), () => mouse.up()]) {
      await act();
      await this.frames(1);
    }
    await this.frames(1);
  }

  /**
   * Drags with the mouse over several frames: egui reads input once a frame.
   * @param {Point} from @param {Point} to
   */
  async drag(from, to) {
    await this.move(from);
    await this.frames(1);
    await this.page.mouse.down();
    await this.frames(1);
    for (const at of between(from, to)) {
      await this.move(at);
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
}

/** The points of a drag, evenly spread, the last one included. */
function* between(/** @type {Point} */ from, /** @type {Point} */ to, steps = 4) {
  for (let step = 1; step <= steps; step += 1) {
    const share = step / steps;
    yield { x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share };
  }
}

/** Runs in the page. @param {any} fire @param {number} seconds  Its age. */
async function stepUntil(fire, seconds) {
  await customElements.whenDefined('hearth-fire');
  await fire.ready;
  const statistics = () => new Promise((resolve) => fire.addEventListener('stats', resolve, { once: true }));
  if (!fire.stats) await statistics();
  for (let length = 0.002; fire.stats.time < seconds; length = fire.stats.stepLength || length) {
    const steps = Math.ceil((seconds - fire.stats.time) / length);
    // A paused fire posts statistics with its picture.
    const next = fire.paused ? undefined : statistics();
    await fire.step(Math.min(Math.max(steps, 1), 2000));
    await next;
  }
}
