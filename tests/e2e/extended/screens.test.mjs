/**
 * The landing page with its panel on the screens and with the preferences of its visitors: density, the browser's zoom, a
 * finger, reduced motion, colours, and a page from right to left. Everything is in the window, and a slider obeys.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { Panel, along, controlOf } from '../panel.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const WIDE = { width: 1280, height: 800 };

/** A browser that zooms has fewer pixels of the page, each of more pixels of the screen. @param {number} zoom */
const zoomed = (zoom) => ({ width: Math.round(1280 / zoom), height: Math.round(800 / zoom), ratio: zoom });

/** Runs in the page, before its scripts. */
const fromRightToLeft = () =>
  document.addEventListener('DOMContentLoaded', () => (document.documentElement.dir = 'rtl'));

for (const [about, options] of /** @type {[string, any][]} */ ([
  ...[1, 1.5, 3].map((ratio) => [`${ratio} pixels of the screen for each of the page`, { ...WIDE, ratio }]),
  ...[0.67, 2.5].map((zoom) => [`a zoom of ${100 * zoom} %`, zoomed(zoom)]),
  ['a finger', { width: 390, height: 844, ratio: 3, touch: true }],
  ['reduced motion', { ...WIDE, reducedMotion: true }],
  ['a dark scheme', { ...WIDE, scheme: 'dark' }],
  ['forced colours', { ...WIDE, forcedColors: true }],
  ['forced dark colours', { ...WIDE, forcedColors: true, scheme: 'dark' }],
  ['a page from right to left', { ...WIDE, before: fromRightToLeft }],
])) {
  test(`the page is in its window, and a slider obeys, with ${about}`, async () => {
    const tab = await browser.open('index.html?scene=default&paused&quality=low', options);
    await tab.ready();
    const panel = new Panel(tab);
    await moveWind(tab, panel, options);
    await panel.value('wind', 'moved', (value) => value > 0);
    const { across, outside } = await tab.evaluate(() => {
      const root = document.documentElement;
      const outside = ['#panel', '#toggle', '#draw', 'hearth-fire', 'header']
        .map((selector) => document.querySelector(selector))
        .filter((it) => it?.checkVisibility())
        .filter((it) => {
          const { left, right, top, bottom } = /** @type {Element} */ (it).getBoundingClientRect();
          return left < -1 || top < -1 || right > innerWidth + 1 || bottom > innerHeight + 1;
        });
      return { across: root.scrollWidth - root.clientWidth, outside: outside.map((it) => it?.id || it?.tagName) };
    });
    assert.deepEqual({ across, outside }, { across: 0, outside: [] });
    assert.deepEqual(await tab.problemsAfterFrame(), []);
  });
}

/** Moves the slider of the wind: that of the panel, or the plain one that takes its place with forced colours. */
async function moveWind(tab, panel, { forcedColors = false, touch = false }) {
  if (forcedColors) {
    await tab.evaluate(() => {
      const { panel } = document.documentElement.dataset;
      if (panel === 'hidden') /** @type {HTMLElement} */ (document.getElementById('toggle')).click();
    });
    await tab.until('the plain controls', () => document.querySelector('.hearth-controls.alone')?.checkVisibility());
    await tab.page.focus(controlOf('wind'));
    await tab.key('ArrowRight');
    return;
  }
  await panel.mounted();
  const slider = await panel.reveal('wind');
  const [from, to] = [along(slider, 0.5), along(slider, 0.8)];
  await (touch ? tab.touchDrag(from, to) : tab.drag(from, to));
}
