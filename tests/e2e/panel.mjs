/**
 * The egui panel under test. egui paints into a canvas, so tests find its controls through
 * the accessible controls: focusing one scrolls the panel to its row, and its `data-rect` is
 * the rectangle of the egui control on the page.
 */

import { eventually } from './driver.mjs';
import { domainOf } from './site.mjs';

/** @typedef {import('./driver.mjs').Tab} Tab */
/** @typedef {import('./driver.mjs').Point} Point */
/** @typedef {import('./picture.mjs').Rectangle} Rectangle */

/** The selector of a parameter's accessible control. */
export const controlOf = (/** @type {string} */ id) => `[data-parameter="${id}"]`;

/** The selector of an accessible button: pause, reset, reset-all, scenes, restore:viscosity … */
export const actionOf = (/** @type {string} */ name) => `[data-action="${name}"]`;

/**
 * The parameters by id, with their ranges and defaults in a model, and whether that model
 * uses them with these edges.
 * @param {any[]} PARAMETERS @param {string} model @param {string} [edges]
 */
export function entriesOf(PARAMETERS, model, edges = 'open') {
  return Object.fromEntries(
    PARAMETERS.map((parameter) => [
      parameter.id,
      {
        ...parameter,
        ...domainOf(parameter, model),
        used: parameter.models.includes(model) && (parameter.when?.edges ?? [edges]).includes(edges),
      },
    ]),
  );
}

/** The point of a rectangle at a fraction of its width and half its height. */
export function along(/** @type {Rectangle} */ rectangle, /** @type {number} */ fraction) {
  const { x, y, width, height } = rectangle;
  return { x: x + width * fraction, y: y + height / 2 };
}

/** Runs in the page: the document or shadow root of the panel. */
const ROOT = `((inside) => inside ? document.querySelector('hearth-fire').shadowRoot : document)`;

/** Runs in the page: shows a hidden panel. */
function openPanel() {
  if (document.documentElement.dataset.panel !== 'hidden') return;
  /** @type {HTMLElement} */ (document.getElementById('toggle')).click();
}

/** The panel of the page in a tab, or the one inside of the page's first fire. */
export class Panel {
  /** @param {Tab} tab @param {{inside?: boolean}} [where] */
  constructor(tab, { inside = false } = {}) {
    this.tab = tab;
    this.inside = inside;
  }

  /** The driver's selector of an element of the panel. @param {string} selector */
  find(selector) {
    return this.inside ? `hearth-fire >>> ${selector}` : selector;
  }

  /**
   * Runs `act` in the page with the document or shadow root of the panel.
   * @param {(root: Document | ShadowRoot, ...args: any[]) => any} act @param {...unknown} args
   */
  in(act, ...args) {
    return this.tab.evaluate(this.#call(act, args));
  }

  /** @param {string} what @param {(root: any, ...args: any[]) => any} holds @param {...unknown} args */
  until(what, holds, ...args) {
    return this.tab.until(what, this.#call(holds, args));
  }

  /** A function of the page that calls `act` with the root of the panel. @type {(act: Function, args: unknown[]) => any} */
  #call(act, args) {
    return new Function(`return (${act})(${ROOT}(${this.inside}), ...${JSON.stringify(args)})`);
  }

  /** Shows the panel of a page, and waits until its controls are painted. */
  async mounted() {
    if (!this.inside) await this.tab.evaluate(openPanel);
    await this.until(
      'the panel shows its controls',
      (root) => root.querySelector('[data-action="pause"][data-rect]') !== null,
    );
    await this.tab.evaluate(rememberRectangles);
    return this;
  }

  /**
   * Scrolls to a parameter's row and waits until it no longer moves.
   * @param {string} id
   * @returns {Promise<Rectangle>}  Where egui shows its control, in CSS pixels of the page.
   */
  async reveal(id) {
    return this.pointAt(controlOf(id));
  }

  /**
   * Focuses an accessible control, so that the panel scrolls to its egui control, and blurs
   * it.
   * @param {string} selector
   */
  async pointAt(selector) {
    await this.tab.page.focus(this.find(selector));
    const rectangle = await this.standing(selector);
    // A focused accessible control is visible and could cover the egui control.
    await this.in((root) => /** @type {HTMLElement} */ (root.activeElement).blur());
    return rectangle;
  }

  /**
   * The rectangle of the egui control of an accessible control, once it no longer moves.
   * @param {string} selector
   * @returns {Promise<Rectangle>}
   */
  async standing(selector) {
    const rectangle = await this.until(
      `${selector} is in sight`,
      async (root, wanted) => {
        const control = root.querySelector(wanted);
        const first = control.dataset.rect;
        for (let frame = 0; frame < 3; frame += 1) await new Promise(requestAnimationFrame);
        return first !== undefined && first === control.dataset.rect && first;
      },
      selector,
    );
    const [x, y, width, height] = rectangle.split(' ').map(Number);
    return { x, y, width, height };
  }

  /**
   * The rectangle of a control without an accessible one, once it no longer moves: a name of
   * a choice, the hue of a colour.
   * @param {string} name
   * @returns {Promise<Rectangle>}
   */
  rectangleOf(name) {
    return this.until(
      `the panel shows ${name}`,
      async (root, wanted) => {
        const now = () => {
          const found = /** @type {any} */ (window).panelRectangles?.[wanted];
          const canvas = root.querySelector('.hearth-panel canvas')?.getBoundingClientRect();
          if (!found || !canvas) return null;
          const [x, y, width, height] = found;
          return { x: canvas.x + x, y: canvas.y + y, width, height };
        };
        const first = JSON.stringify(now());
        for (let frame = 0; frame < 3; frame += 1) await new Promise(requestAnimationFrame);
        const last = now();
        return first === JSON.stringify(last) && last;
      },
      name,
    );
  }

  /**
   * Drags a parameter's slider with the mouse between two fractions of its length.
   * @param {string} id @param {number} from @param {number} to
   */
  async dragSlider(id, from, to) {
    const rectangle = await this.reveal(id);
    await this.tab.drag(along(rectangle, from), along(rectangle, to));
  }

  /**
   * Clicks a button of the header with the mouse.
   * @param {string} action
   */
  async press(action) {
    await this.tab.click(along(await this.standing(actionOf(action)), 0.5));
  }

  /**
   * Presses a button of the share section, which it unfolds.
   * @param {string} action
   */
  async share(action) {
    await this.pointAt(actionOf(action));
    await this.press(action);
  }

  /** The text of the status line. */
  message() {
    return this.in((root) => root.querySelector('.hearth-controls [role="status"]')?.textContent);
  }

  /**
   * Clicks the button that restores a parameter's default.
   * @param {string} id
   */
  async restore(id) {
    await this.reveal(id);
    await this.press(`restore:${id}`);
  }

  /**
   * Clicks a name of a choice, in its list if that is folded.
   * @param {string} id @param {string} name
   */
  async choose(id, name) {
    const rectangle = await this.reveal(id);
    const key = `choice:${id}:${name}`;
    const unfolded = await this.tab.evaluate(
      (wanted) => /** @type {any} */ (window).panelRectangles?.[wanted] !== undefined,
      key,
    );
    if (!unfolded) {
      await this.tab.click(along(rectangle, 0.5));
    }
    await this.tab.click(along(await this.rectangleOf(key), 0.5));
  }

  /** Clicks the button that opens the scenes, and waits for them. */
  async openScenes() {
    await this.pointAt(actionOf('scenes'));
    await this.press('scenes');
    await this.tab.page.waitForSelector(this.find('[data-scene]'));
  }

  /**
   * Clicks a scene, and closes the scenes.
   * @param {string} name
   */
  async scene(name) {
    await this.openScenes();
    await this.tab.page.click(this.find(`[data-scene="${name}"]`));
    await this.tab.page.click(this.find('[data-card="close"]'));
  }

  /** The ids of the parameters that have a control at present, in their order. */
  controls() {
    return this.tab.page.$$eval(this.find('[data-parameter]'), (controls) =>
      controls
        .filter((control) => control.checkVisibility())
        .map((control) => /** @type {HTMLElement} */ (control).dataset.parameter),
    );
  }

  /**
   * Waits until the fire's parameter satisfies `holds`, and returns its value: the one after all that the panel
   * has set, since the engine answers in order.
   * @param {string} id @param {string} what @param {(value: any) => boolean} holds
   */
  async value(id, what, holds) {
    const read = () => this.tab.fire((fire, name) => fire.set({}).then(() => fire.params[name]), id);
    return eventually(`${id} is ${what}`, read, holds, () => this.tab.frames());
  }
}

/**
 * Opens the page with its panel and a paused fire, for tests that can share a page. It is
 * loaded once and reset for each test: its wasm takes longer to load than most tests take. It is loaded again
 * where one test looks at pictures and the next does not.
 * @param {() => import('./driver.mjs').Browser} browser
 * @returns {(model?: string, draws?: boolean) => Promise<{tab: Tab, panel: Panel}>}
 */
export function sharedPage(browser) {
  /** @type {{tab: Tab, panel: Panel} | undefined} */
  let page;
  return async (model = 'classic', draws = browser().draws) => {
    if (!page || page.tab !== browser().tab || page.tab.draws !== draws) {
      const tab = await browser().open('index.html?scene=default&model=classic', { width: 760, height: 600, draws });
      await tab.ready();
      // A reset would burn the fire warm, and fade into it.
      await tab.fire((fire) => fire.removeAttribute('warm'));
      page = { tab, panel: await new Panel(tab).mounted() };
    }
    const { tab } = page;
    tab.problems.length = 0;
    // No row is hovered or focused.
    await tab.move({ x: 5, y: 300 });
    await tab.evaluate(() => /** @type {HTMLElement | null} */ (document.activeElement)?.blur());
    await tab.fire(
      async (fire, values) => {
        await fire.restore();
        await fire.importConfig({ hearth: 3, values });
        await fire.pause();
        // The answer follows the picture and the statistics of the new fire.
        await fire.step(1);
      },
      { model },
    );
    await page.panel.until(
      `the panel shows ${model}`,
      (root, name) => root.querySelector('[data-parameter="model"]').value === name,
      model,
    );
    await tab.frames();
    return page;
  };
}

/**
 * The value at a fraction of a slider.
 * @param {{min: number, max: number, scale: string}} entry  From the parameter table.
 * @param {number} fraction
 */
export function valueAt({ min, max, scale }, fraction) {
  return scale === 'log' ? min * (max / min) ** fraction : min + (max - min) * fraction;
}

/**
 * The position of a value on its slider, as a fraction.
 * @param {{min: number, max: number, scale: string}} entry  From the parameter table.
 * @param {number} value
 */
export function fractionOf({ min, max, scale }, value) {
  return scale === 'log' ? Math.log(value / min) / Math.log(max / min) : (value - min) / (max - min);
}

/**
 * Runs in the page: keeps the panel's rectangles in `window.panelRectangles`. The page reads
 * them from the wasm after every painted frame.
 */
async function rememberRectangles() {
  const load = (/** @type {string} */ url) => import(url);
  const { Panel: inWasm } = await load(new URL('web/wasm/hearth-panel.js', document.baseURI).href);
  const original = inWasm.prototype.rectangles;
  inWasm.prototype.rectangles = function rectangles() {
    const rectangles = original.call(this);
    /** @type {any} */ (window).panelRectangles = rectangles;
    return rectangles;
  };
}
