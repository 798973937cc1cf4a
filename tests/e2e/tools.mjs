/**
 * What the tests of the toolbar share: the page with its toolbar, a mouse or a finger at places of the world, and
 * the state of the fire and of the toolbar.
 */
import assert from 'node:assert/strict';

export const WIDE = { width: 1280, height: 800 };
export const PHONES = [
  { width: 390, height: 844, touch: true },
  { width: 844, height: 390, touch: true },
];

export const toolStatus = (tab) => tab.evaluate(() => document.querySelector('.hearth-status')?.textContent ?? '');
export async function tool(tab, name) {
  const button = `[data-tool="${name}"]`;
  // The ends of a row that scrolls lie over what is behind them.
  await tab.page.$eval(button, (found) => found.scrollIntoView({ block: 'nearest', inline: 'center' }));
  await tab.page.click(button);
}

/** The page with its toolbar. */
export async function openTools(browser, size = WIDE, query = 'scene=default&paused') {
  const tab = await browser.open(`index.html?${query}`, size);
  await tab.ready();
  await tab.page.waitForSelector('#draw:not([hidden])');
  await tab.page.click('#draw');
  await tab.page.waitForSelector('.hearth-toolbar [data-tool="erase"]');
  // Each new solid of wood would be two objects.
  await tab.page.$eval('.hearth-toolbar input[type=checkbox]', (box) => {
    /** @type {HTMLInputElement} */ (box).checked = false;
  });
  return tab;
}

/** A point of the window at a place of the world [m]. */
export async function pixel(tab, x, y) {
  const at = await tab.fire(
    (fire, place) => {
      const { left, top } = fire.getBoundingClientRect();
      const point = fire.toPixels(...place);
      return { x: left + point.x, y: top + point.y };
    },
    [x, y],
  );
  return at;
}

/** Taps or clicks a place of the world [m]. */
export async function tap(tab, x, y, touch = false) {
  const at = await pixel(tab, x, y);
  await (touch ? tab.page.touchscreen.tap(at.x, at.y) : tab.click(at));
  await tab.frames();
}

/** Presses a key while another one is down. */
export async function chord(tab, held, key) {
  await tab.page.keyboard.down(held);
  await tab.key(key);
  await tab.page.keyboard.up(held);
}

/** Whether there is a step to undo. */
export const canUndo = (tab) =>
  tab.page.$eval('[data-tool="undo"]', (button) => button.getAttribute('aria-disabled') !== 'true');

/** Drags with the mouse, or with a finger where the page has touch. */
export async function drag(tab, from, to, touch = false) {
  const [start, end] = [await pixel(tab, ...from), await pixel(tab, ...to)];
  await (touch ? tab.touchDrag(start, end) : tab.drag(start, end));
}

export const close = (a, b, off = 0.02) => Math.abs(a - b) <= off;

/** The scale of a quantity lies apart from the toolbar and its status. */
export async function assertScaleApart(tab) {
  await tab.fire((fire) => fire.set('display_mode', 'temperature'));
  const [scale, ...others] = await tab.until('the scale', () => {
    const inside = document.querySelector('hearth-fire')?.shadowRoot;
    const scale = inside?.querySelector('.scale');
    if (!scale?.checkVisibility()) return false;
    const root = inside?.querySelector('.hearth-toolbar') ? inside : document;
    const parts = [...root.querySelectorAll('.hearth-toolbar, .hearth-status')];
    return [scale, ...parts.filter((part) => part.checkVisibility())].map((part) => {
      const { left, right, top, bottom } = part.getBoundingClientRect();
      return { left, right, top, bottom };
    });
  });
  for (const { left, right, top, bottom } of others)
    assert.ok(
      scale.left >= right || scale.right <= left || scale.top >= bottom || scale.bottom <= top,
      JSON.stringify([scale, ...others]),
    );
  await tab.fire((fire) => fire.restore('display_mode'));
}
