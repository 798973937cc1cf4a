/**
 * A slow network while a visitor acts: the page answers at once with the code that it has, and what comes late shows the
 * fire as it is by then.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { Panel, actionOf } from '../panel.mjs';
import { drag } from '../tools.mjs';
import { objectsUntil, strip } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** Runs in the page: the wasm of the panel comes when the test calls `arrive`. */
function holdPanel() {
  const page = /** @type {any} */ (window);
  const { fetch } = window;
  const arrival = new Promise((resolve) => (page.arrive = resolve));
  window.fetch = async (...request) => {
    if (String(request[0]).includes('hearth-panel_bg.wasm')) {
      page.isAsked = true;
      await arrival;
    }
    return fetch(...request);
  };
}

test('while the panel is on its way, a visitor plays, draws, undoes and chooses scenes, and it shows the fire of then', async () => {
  const tab = await browser.open('index.html?scene=default', { width: 1000, height: 700, before: holdPanel });
  await tab.ready();
  await strip(tab);
  await tab.until('the panel is asked for', () => /** @type {any} */ (window).isAsked);

  await tab.key('Space');
  await tab.until('it is paused', () => /** @type {any} */ (document.querySelector('hearth-fire')).paused);
  await tab.page.click('[data-starts="candle"]');
  await tab.until('the scene', () => location.search.includes('scene=candle'));
  const count = await tab.fire((fire) => fire.objects.length);
  await tab.page.waitForSelector('#draw:not([hidden])');
  await tab.page.click('#draw');
  await tab.page.waitForSelector('.hearth-toolbar [data-tool="box"]');
  await tab.page.click('[data-tool="box"]');
  // A new solid of wood would be two objects.
  await tab.page.click('.hearth-toolbar input[type=checkbox]');
  await drag(tab, [0.1, 0.5], [0.15, 0.45]);
  await objectsUntil(tab, 'one more', (all) => all.length === count + 1);
  await tab.page.click('[data-tool="undo"]');
  await objectsUntil(tab, 'as before', (all) => all.length === count);
  await tab.page.click('[data-tool="redo"]');
  await objectsUntil(tab, 'one more', (all) => all.length === count + 1);
  await tab.until('the address has the drawing', () => location.search.includes('objects='));
  const config = await tab.fire((fire) => fire.exportConfig());
  await tab.evaluate(() => /** @type {any} */ (document.activeElement)?.blur());
  // A key of the panel waits for it.
  await tab.key('+');

  await tab.evaluate(() => /** @type {any} */ (window).arrive());
  const panel = await new Panel(tab).mounted();
  await tab.until('the picture is larger', () => /** @type {any} */ (document.querySelector('hearth-fire')).zoom > 1);
  const title = await panel.in((root, selector) => root.querySelector(selector).textContent, actionOf('scenes'));
  assert.equal(title, 'Scene: Candle, changed');
  await panel.press('undo');
  await objectsUntil(tab, 'without the drawing', (all) => all.length === count);
  await panel.press('redo');
  await objectsUntil(tab, 'with the drawing', (all) => all.length === count + 1);
  assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), config);
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});
