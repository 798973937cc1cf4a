/**
 * The toolbar: everything with keys alone, and the toolbar inside of any element with `controls`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { assertScaleApart, chord, close, drag, openTools, toolStatus, WIDE } from '../tools.mjs';
import { objectsUntil as until } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

test('keys draw, choose, move, turn, scale, duplicate and delete without a pointer', async () => {
  const tab = await openTools(browser);
  await tab.page.focus('.hearth-overlay');
  await tab.key('5');
  await tab.key('Enter');
  for (const key of ['ArrowRight', 'ArrowUp']) await chord(tab, 'Shift', key);
  await tab.key('Enter');
  const [, box] = await until(tab, 'a box', (all) => all.length === 2);
  assert.deepEqual([box.shape, box.width, box.height], ['box', 0.1, 0.1]);
  await tab.key('Escape');
  await tab.key('2');
  await tab.key('ArrowLeft');
  await until(tab, 'to the left', ([, solid]) => close(solid.x, box.x - 0.01, 1e-4));
  await tab.key('[');
  await until(tab, 'turned', ([, solid]) => solid.angle === 5);
  await tab.key('+');
  await until(tab, 'larger', ([, solid]) => close(solid.width, 0.11, 1e-4));
  await chord(tab, 'Control', 'd');
  await until(tab, 'three', (all) => all.length === 3);
  await tab.key('Delete');
  await until(tab, 'two', (all) => all.length === 2);
  assert.match(await toolStatus(tab), /is removed/);
  await tab.page.select('.hearth-toolbar select[aria-label="Selected object"]', '2');
  await tab.page.focus('.hearth-overlay');
  await tab.key('Delete');
  await until(tab, 'one', (all) => all.length === 1);
  assert.deepEqual(tab.problems, []);
});

test('a fire with controls offers the tools inside of it, loaded on request', async () => {
  const tab = await browser.open('<hearth-fire controls style="width: 700px; height: 500px"></hearth-fire>', WIDE);
  await tab.ready();
  const loaded = () =>
    tab.evaluate(() => performance.getEntriesByType('resource').some(({ name }) => name.endsWith('/tools.js')));
  const inside = (selector) =>
    tab.until(
      `${selector} inside`,
      (wanted) => document.querySelector('hearth-fire')?.shadowRoot?.querySelector(wanted) !== null,
      selector,
    );
  await inside('.hearth-draw');
  assert.equal(await loaded(), false);
  await tab.page.click('hearth-fire >>> .hearth-draw');
  await inside('[data-tool="box"]');
  assert.equal(await loaded(), true);
  await tab.page.click('hearth-fire >>> [data-tool="box"]');
  await drag(tab, [-0.1, 1.1], [0.1, 0.9]);
  await until(tab, 'two', (all) => all.length === 2);
  await assertScaleApart(tab);
  await tab.page.click('hearth-fire >>> [data-tool="close"]');
  await tab.until(
    'no toolbar',
    () => !document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.hearth-toolbar'),
  );
  await tab.fire((fire) => fire.removeAttribute('controls'));
  await tab.until('no button', () => !document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.hearth-draw'));
  assert.deepEqual(tab.problems, []);
});
