/**
 * One page in a browser: what a test can do with it and ask of it, whichever
 * browser it is. A browser's own file says how it evaluates, moves a mouse,
 * presses a key and takes a picture; everything else is said here, once.
 */
import { Picture } from '../picture.mjs';

/** @typedef {{x: number, y: number}} Point */
/** @typedef {import('../picture.mjs').Rectangle} Rectangle */

/** Longest wait for anything a page should do soon; slow machines need it, no law does. */
export const PATIENCE = 60_000;

/** One page, with everything it complained about. */
export class Tab {
  constructor() {
    /** Console errors and warnings, uncaught exceptions, failed requests. @type {string[]} */
    this.problems = [];
  }

  /**
   * Runs `act` in the page and gives what it returns.
   * @template T
   * @param {(...args: any[]) => T} act
   * @param {...unknown} args
   * @returns {Promise<Awaited<T>>}
   */
  evaluate(act, ...args) {
    throw new Error(`this tab cannot evaluate ${act.name}(${args})`);
  }

  /**
   * Runs `act` in the page with the first element of `selector` as its first argument.
   * @param {string} selector
   * @param {(element: any, ...args: any[]) => any} act
   * @param {...unknown} args
   * @returns {Promise<any>}
   */
  on(selector, act, ...args) {
    throw new Error(`this tab cannot evaluate ${act.name}(${args}) on ${selector}`);
  }

  /**
   * What stands on the screen, as a PNG.
   * @param {Rectangle} [clip]
   * @returns {Promise<Picture>}
   */
  picture(clip) {
    throw new Error(`this tab takes no picture of ${clip}`);
  }

  /**
   * One thing that a mouse does.
   * @param {'move' | 'down' | 'up'} what @param {Point} at
   * @returns {Promise<unknown>}
   */
  mouse(what, at) {
    throw new Error(`this tab has no mouse to ${what} at ${at.x}, ${at.y}`);
  }

  /**
   * Lays a finger on the page; gives what moves and lifts it.
   * @param {Point} at
   * @returns {Promise<{move: (x: number, y: number) => Promise<void>, end: () => Promise<void>}>}
   */
  finger(at) {
    throw new Error(`this browser cannot be touched at ${at.x}, ${at.y}`);
  }

  /**
   * Presses a key and lets it go.
   * @param {string} key
   * @returns {Promise<void>}
   */
  press(key) {
    throw new Error(`this tab has no key ${key}`);
  }

  /**
   * Waits until `holds` gives something true in the page, and gives that.
   * @param {string} what  What is awaited, in words, for the failure's message.
   * @param {(...args: any[]) => unknown} holds
   * @param {...unknown} args
   * @returns {Promise<any>}
   */
  until(what, holds, ...args) {
    throw new Error(`this tab cannot wait for ${what}: ${holds.name}(${args})`);
  }

  /**
   * Runs `act` in the page with the first `<hearth-fire>` as its first argument.
   * @param {(fire: any, ...args: any[]) => any} act
   * @param {...unknown} args
   */
  fire(act, ...args) {
    return this.on('hearth-fire', act, ...args);
  }

  /** Waits until the first `<hearth-fire>` says that it is ready. */
  ready() {
    return this.fire((fire) => Promise.resolve(fire.ready).then(() => undefined));
  }

  /**
   * Burns the first fire until it is that old, by steps that it is asked for: a second of
   * fire takes as long as its steps take, and not a second.
   * @param {number} seconds  Of the fire's own time.
   */
  burnt(seconds) {
    return this.fire(async (fire, wanted) => {
      await customElements.whenDefined('hearth-fire');
      await fire.ready;
      const told = () => new Promise((resolve) => fire.addEventListener('stats', resolve, { once: true }));
      if (!fire.stats) await told();
      for (let length = 0.002; fire.stats.time < wanted; length = fire.stats.stepLength || length) {
        const steps = Math.ceil((wanted - fire.stats.time) / length);
        // A fire that stands still tells its statistics with its picture.
        const after = fire.paused ? undefined : told();
        await fire.step(Math.min(Math.max(steps, 1), 2000));
        await after;
      }
    }, seconds);
  }

  /**
   * Waits until the first fire is that old, by itself.
   * @param {number} seconds  Of the fire's own time.
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

  /** Everything that the page has complained about by now. */
  async complaints() {
    await this.frames(1);
    return this.problems;
  }

  /**
   * Loses every WebGL2 context, of the page itself and of its workers, as a
   * driver's crash would, and gives them back after a while; without one, never.
   * @param {number} [milliseconds]
   */
  async loseContext(milliseconds) {
    const lost = await this.evaluate(
      (time) => /** @type {any} */ (window).driver.lose(time),
      milliseconds ?? null,
    );
    if (lost === 0) throw new Error('neither the page nor a worker has a context to lose');
  }

  /**
   * How many WebGL2 contexts are alive in page and workers, how many things of the
   * graphics card are made and not deleted in them, how many bytes wasm has, and how
   * many workers there are.
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

  /** What stands on the screen where the first fire is. */
  async firePicture() {
    // The full page's own words stand over its fire, and fade.
    await this.evaluate(() => {
      for (const over of document.querySelectorAll('body > header, #hint, #scenes')) {
        /** @type {HTMLElement} */ (over).style.visibility = 'hidden';
      }
    });
    return this.picture(await this.rectangle('hearth-fire'));
  }

  /**
   * Where an element stands, in CSS pixels of the page.
   * @param {string} selector
   * @returns {Promise<Rectangle>}
   */
  rectangle(selector) {
    return this.on(selector, (element) => {
      const { x, y, width, height } = element.getBoundingClientRect();
      return { x, y, width, height };
    });
  }

  /** @param {string} key */
  async key(key) {
    await this.press(key);
    await this.frames();
  }

  /** @param {Point} at */
  async click(at) {
    for (const what of /** @type {const} */ (['move', 'down', 'up'])) {
      await this.mouse(what, at);
      await this.frames(1);
    }
    await this.frames(1);
  }

  /**
   * Drags with the mouse. A person's drag lasts many frames; a control that is
   * painted frame by frame would not see one that fits into a single frame.
   * @param {Point} from @param {Point} to
   */
  async drag(from, to) {
    await this.mouse('move', from);
    await this.frames(1);
    await this.mouse('down', from);
    await this.frames(1);
    for (const at of between(from, to)) {
      await this.mouse('move', at);
      await this.frames(1);
    }
    await this.mouse('up', to);
    await this.frames();
  }

  /**
   * Drags with one finger.
   * @param {Point} from @param {Point} to
   */
  async touchDrag(from, to) {
    const finger = await this.finger(from);
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
    const part = step / steps;
    yield { x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part };
  }
}
