/**
 * The egui panel as a hand finds it. egui paints into a canvas, so its
 * controls are found through the mirror of native controls that the panel
 * keeps: focusing a mirror control scrolls the panel to its row, and its
 * `data-rect` tells where the row's control stands on the page.
 */

import { domainOf } from './site.mjs';

/** @typedef {import('./driver.mjs').Tab} Tab */
/** @typedef {import('./driver.mjs').Point} Point */
/** @typedef {import('./picture.mjs').Rectangle} Rectangle */

/** The mirror control of a parameter. */
export const mirrorOf = (/** @type {string} */ id) => `[data-parameter="${id}"]`;

/** The mirror of a button: pause, reset, reset-all, scenes, restore:viscosity … */
export const actionOf = (/** @type {string} */ name) => `[data-action="${name}"]`;

/**
 * The table as one model has it, by id: with its ranges and defaults, and
 * whether it uses the parameter.
 * @param {any[]} PARAMETERS @param {string} model
 */
export function entriesOf(PARAMETERS, model) {
  return Object.fromEntries(PARAMETERS.map((one) => [
    one.id,
    { ...one, ...domainOf(one, model), used: one.models.includes(model) },
  ]));
}

/** The point inside a rectangle at a fraction of its width, half way down. */
export function along(/** @type {Rectangle} */ rectangle, /** @type {number} */ fraction) {
  const { x, y, width, height } = rectangle;
  return { x: x + width * fraction, y: y + height / 2 };
}

/** Runs in the page: what the panel stands in. */
const ROOT = `((inside) => inside ? document.querySelector('hearth-fire').shadowRoot : document)`;

/** Runs in the page: presses the button that shows the panel, where it is hidden. */
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

  /** As the driver finds an element of the panel. @param {string} selector */
  find(selector) {
    return this.inside ? `hearth-fire >>> ${selector}` : selector;
  }

  /**
   * Runs `act` in the page with the document or shadow root that the panel stands in.
   * @param {(root: Document | ShadowRoot, ...args: any[]) => any} act @param {...unknown} args
   */
  in(act, ...args) {
    return this.tab.evaluate(`(${act})(${ROOT}(${this.inside}), ...${JSON.stringify(args)})`);
  }

  /** @param {string} what @param {(root: any, ...args: any[]) => any} holds @param {...unknown} args */
  until(what, holds, ...args) {
    const call = `(${holds})(${ROOT}(${this.inside}), ...${JSON.stringify(args)})`;
    return this.tab.until(what, /** @type {any} */ (call));
  }

  /** Opens the panel of a page, where it is closed, and waits until it has painted its controls. */
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
   * Brings a parameter's row into sight and waits until it stands still.
   * @param {string} id
   * @returns {Promise<Rectangle>}  Where egui shows its control, in CSS pixels of the page.
   */
  async reveal(id) {
    return this.pointAt(mirrorOf(id));
  }

  /**
   * Gives the focus to a mirror control, so that the panel brings its like into sight,
   * and takes it away again.
   * @param {string} selector
   */
  async pointAt(selector) {
    await this.tab.page.focus(this.find(selector));
    const rectangle = await this.standing(selector);
    // A focused mirror control shows itself, and could stand in the mouse's way.
    await this.in((root) => /** @type {HTMLElement} */ (root.activeElement).blur());
    return rectangle;
  }

  /**
   * Where egui shows what a mirror control stands for, once it stands still.
   * @param {string} selector
   * @returns {Promise<Rectangle>}
   */
  async standing(selector) {
    const rectangle = await this.until(`${selector} is in sight`, async (root, wanted) => {
      const mirror = root.querySelector(wanted);
      const first = mirror.dataset.rect;
      for (let frame = 0; frame < 3; frame += 1) await new Promise(requestAnimationFrame);
      return first !== undefined && first === mirror.dataset.rect && first;
    }, selector);
    const [x, y, width, height] = rectangle.split(' ').map(Number);
    return { x, y, width, height };
  }

  /**
   * Where egui shows a part that has no mirror of its own: a name of a choice,
   * a colour's hue.
   * @param {string} name
   * @returns {Promise<Rectangle>}
   */
  part(name) {
    return this.until(`the panel shows ${name}`, (root, wanted) => {
      const found = /** @type {any} */ (window).panelRectangles?.[wanted];
      const canvas = root.querySelector('.hearth-panel canvas')?.getBoundingClientRect();
      if (!found || !canvas) return null;
      const [x, y, width, height] = found;
      return { x: canvas.x + x, y: canvas.y + y, width, height };
    }, name);
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
   * Unfolds what can be shared, where it is folded.
   * @param {string} action  What is needed of it.
   */
  async share(action) {
    await this.pointAt(actionOf(action));
    await this.press(action);
  }

  /** What the mirror says in words. */
  said() {
    return this.in((root) => root.querySelector('.hearth-mirror [role="status"]')?.textContent);
  }

  /**
   * Clicks the button that brings a parameter's default back.
   * @param {string} id
   */
  async restore(id) {
    await this.reveal(id);
    await this.press(`restore:${id}`);
  }

  /**
   * Clicks one of a choice's names, in its list where that is folded.
   * @param {string} id @param {string} name
   */
  async choose(id, name) {
    const rectangle = await this.reveal(id);
    const key = `choice:${id}:${name}`;
    const unfolded = await this.tab.evaluate(
      (wanted) => wanted in (/** @type {any} */ (window).panelRectangles ?? {}),
      key,
    );
    if (!unfolded) {
      await this.tab.click(along(rectangle, 0.5));
    }
    await this.tab.click(along(await this.part(key), 0.5));
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
    return this.tab.page.$$eval(this.find('[data-parameter]'), (controls) => controls
      .filter((control) => control.checkVisibility())
      .map((control) => /** @type {HTMLElement} */ (control).dataset.parameter));
  }

  /**
   * Waits until the fire's parameter satisfies `holds`, and gives its value.
   * @param {string} id @param {string} what @param {(value: any) => boolean} holds
   */
  async value(id, what, holds) {
    for (let patience = 200; patience > 0; patience -= 1) {
      const value = await this.tab.fire((fire, name) => fire.params[name], id);
      if (holds(value)) return value;
      await this.tab.frames();
    }
    const value = await this.tab.fire((fire, name) => fire.params[name], id);
    throw new Error(`${id} should be ${what} and is ${JSON.stringify(value)}`);
  }
}

/**
 * Opens the page with its panel for tests that can share one: it is loaded once and set
 * back for each test, since its wasm takes longer to load than most tests take.
 * @param {() => import('./driver.mjs').Browser} browser
 * @returns {(model?: string) => Promise<{tab: Tab, panel: Panel}>}
 */
export function sharedPage(browser) {
  /** @type {{tab: Tab, panel: Panel} | undefined} */
  let page;
  return async (model = 'classic') => {
    if (!page || page.tab !== browser().tab) {
      const tab = await browser().open('index.html?model=classic', { width: 760, height: 600 });
      await tab.ready();
      page = { tab, panel: await new Panel(tab).mounted() };
    }
    const { tab } = page;
    tab.problems.length = 0;
    // No row is hovered, and none has the focus.
    await tab.mouse('move', { x: 5, y: 300 });
    await tab.evaluate(() => /** @type {HTMLElement | null} */ (document.activeElement)?.blur());
    await tab.fire(async (fire, values) => {
      await fire.restore();
      await fire.importConfig({ hearth: 2, values });
      await fire.play();
    }, { model });
    await tab.frames();
    return page;
  };
}

/**
 * The value that stands at a fraction of a slider.
 * @param {{min: number, max: number, scale: string}} entry  From the parameter table.
 * @param {number} fraction
 */
export function valueAt({ min, max, scale }, fraction) {
  return scale === 'log' ? min * (max / min) ** fraction : min + (max - min) * fraction;
}

/**
 * Where a value stands on its slider, as a fraction.
 * @param {{min: number, max: number, scale: string}} entry  From the parameter table.
 * @param {number} value
 */
export function fractionOf({ min, max, scale }, value) {
  return scale === 'log'
    ? Math.log(value / min) / Math.log(max / min)
    : (value - min) / (max - min);
}

/**
 * Runs in the page: keeps what the panel's wasm tells about all its places in
 * `window.panelRectangles`. The page asks it after every painted frame.
 */
async function rememberRectangles() {
  const load = (/** @type {string} */ url) => import(url);
  const { Panel: inWasm } = await load(new URL('web/wasm/hearth-panel.js', document.baseURI).href);
  const original = inWasm.prototype.rectangles;
  inWasm.prototype.rectangles = function rectangles() {
    return (/** @type {any} */ (window).panelRectangles = original.call(this));
  };
}
