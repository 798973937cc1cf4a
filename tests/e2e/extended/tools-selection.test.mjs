/**
 * The tool that selects several objects, with keys and a real mouse.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { assertScaleApart, chord, close, openTools, toolStatus, tap, tool } from '../tools.mjs';
import { objectsUntil as until } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

test('keys and clicks add to the selection, move, duplicate, align and order all of it', async () => {
  const tab = await openTools(browser);
  await assertScaleApart(tab);
  await tab.fire((fire) =>
    fire.set({
      objects: [
        { kind: 'source', id: 1 },
        { kind: 'solid', id: 2, x: 0, y: 1, width: 0.1 },
        { kind: 'solid', id: 3, x: 0.3, y: 1.1, width: 0.2 },
      ],
    }),
  );
  await tab.page.select('.hearth-toolbar select[aria-label="Selected object"]', '2');
  await tab.page.focus('.hearth-overlay');
  // Enter shows the cross at the selected object.
  await tab.key('Enter');
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowUp']) await chord(tab, 'Shift', key);
  await chord(tab, 'Shift', 'Enter');
  assert.equal(await toolStatus(tab), '2 objects are selected.');
  await tab.key('Escape');
  await tab.key('ArrowRight');
  await until(tab, 'both to the right', ([, a, b]) => close(a.x, 0.01, 1e-4) && close(b.x, 0.31, 1e-4));
  await chord(tab, 'Control', 'd');
  await until(tab, 'five', (all) => all.length === 5);
  await tab.key('Delete');
  await until(tab, 'three', (all) => all.length === 3);
  await tool(tab, 'undo');
  await tool(tab, 'undo');
  await tool(tab, 'undo');
  await until(tab, 'as they were', ([, a, b]) => a.x === 0 && close(b.x, 0.3, 1e-6));
  // The list adds as well.
  await tool(tab, 'several');
  for (const id of ['2', '3']) await tab.page.select('.hearth-toolbar select[aria-label="Selected object"]', id);
  await tab.page.focus('[data-tool="align-left"]');
  for (const key of ['ArrowRight', 'ArrowRight', 'Enter']) await tab.key(key);
  await until(tab, 'aligned at the right', ([, a, b]) => close(a.x + 0.05, b.x + 0.1, 2e-3));
  const aligns = () => tab.page.$eval('.hearth-align', (bar) => bar.checkVisibility());
  assert.equal(await aligns(), true);
  await tool(tab, 'several');
  await tool(tab, 'select');
  await tap(tab, 0.3, 1.1);
  assert.equal(await aligns(), false);
  assert.equal(await tab.page.$eval('[aria-label="Selected object"]', (list) => list.value), '3');
  await tab.page.keyboard.down('Shift');
  await tap(tab, 0.35, 0.98);
  await tab.page.keyboard.up('Shift');
  assert.equal(await toolStatus(tab), '2 objects are selected.');
  assert.deepEqual(tab.problems, []);
});
