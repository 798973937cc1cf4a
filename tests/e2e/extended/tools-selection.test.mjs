/**
 * The tools that select and erase: objects move, turn, snap, align and change their order, with a real mouse, a finger
 * and keys.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { chord, close, drag, openTools, PHONES, pixel, toolStatus, tap, tool, WIDE } from '../tools.mjs';
import { objectsUntil as until } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

for (const size of [WIDE, ...PHONES]) {
  const touch = 'touch' in size;
  describe(`at ${size.width} × ${size.height}`, () => {
    test('select moves, turns and sizes; erase removes', async () => {
      const tab = await openTools(browser, size);
      await tool(tab, 'box');
      await drag(tab, [-0.15, 1.2], [0.15, 1], touch);
      await until(tab, 'two', (all) => all.length === 2);
      await tool(tab, 'select');
      await drag(tab, [0, 1.1], [0.1, 0.9], touch);
      await until(tab, 'moved', ([, box]) => close(box.x, 0.1) && close(box.y, 0.9));
      await drag(tab, [0.25, 0.8], [0.3, 0.75], touch);
      await until(tab, 'larger', ([, box]) => close(box.width, 0.4) && close(box.height, 0.3));
      const handle = await tab.evaluate(() => {
        const { x, y, width, height } = /** @type {Element} */ (document.querySelector('.hearth-overlay .turn')).getBoundingClientRect();
        return { x: x + width / 2, y: y + height / 2 };
      });
      const right = await pixel(tab, 0.4, 0.9);
      await (touch ? tab.touchDrag(handle, right) : tab.drag(handle, right));
      await until(tab, 'turned', ([, box]) => close(box.angle, -90, 4));
      for (const step of ['angle', 'width', 'x']) {
        await tool(tab, 'undo');
        await until(tab, `${step} before`, ([, box]) => close(box[step], { angle: 0, width: 0.3, x: 0 }[step]));
      }
      await tool(tab, 'erase');
      await drag(tab, [-0.3, 1.1], [0.05, 1.1], touch);
      await until(tab, 'erased', (all) => all.length === 1);
      await tool(tab, 'undo');
      await until(tab, 'back', (all) => all.length === 2);
      assert.deepEqual(tab.problems, []);
    });

    test('several objects are selected, moved, aligned and removed together, each as one step', async () => {
      const tab = await openTools(browser, size);
      for (const [from, to] of [[[-0.25, 1.25], [-0.15, 1.15]], [[0.1, 1.1], [0.2, 0.95]]]) {
        await tool(tab, 'box');
        await drag(tab, from, to, touch);
        await tab.frames();
      }
      const [, one, other] = await until(tab, 'three', (all) => all.length === 3);
      const aligns = () => tab.on('.hearth-align', (bar) => bar.checkVisibility());
      await tool(tab, 'select');
      await tap(tab, -0.2, 1.2, touch);
      assert.equal(await aligns(), false);
      if (touch) await tool(tab, 'several');
      else await tab.page.keyboard.down('Shift');
      await tap(tab, 0.15, 1.02, touch);
      if (touch) await tool(tab, 'several');
      else await tab.page.keyboard.up('Shift');
      assert.equal(await toolStatus(tab), '2 objects are selected.');
      assert.equal(await aligns(), true);

      await drag(tab, [-0.2, 1.2], [-0.1, 0.9], touch);
      await until(tab, 'moved', ([, a, b]) => close(a.x - one.x, 0.1) && close(a.y - one.y, -0.3)
        && close(b.x - other.x, a.x - one.x, 2e-3) && close(b.y - other.y, a.y - one.y, 2e-3));
      await tool(tab, 'align-left');
      await until(tab, 'aligned at the left', ([, a, b]) => close(a.x - a.width / 2, b.x - b.width / 2, 2e-3));
      await tool(tab, 'align-middle');
      await until(tab, 'aligned in the middle', ([, a, b]) => close(a.y, b.y, 2e-3));
      await tab.page.focus('.hearth-overlay');
      await tab.key('Delete');
      await until(tab, 'one', (all) => all.length === 1);
      for (const [what, holds] of [
        ['back', ([, a, b]) => a && close(a.y, b.y, 2e-3)],
        ['not in the middle', ([, a, b]) => a.y !== b.y && close(a.x - a.width / 2, b.x - b.width / 2, 2e-3)],
        ['not at the left', ([, a, b]) => close(b.x - other.x, a.x - one.x, 2e-3)],
        ['where they were', ([, a, b]) => a.x === one.x && a.y === one.y && b.x === other.x && b.y === other.y],
      ]) {
        await tool(tab, 'undo');
        await until(tab, what, holds);
      }
      assert.deepEqual(tab.problems, []);
    });

    test('the selected solid goes to the front and to the back, each as one step', async () => {
      const tab = await openTools(browser, size);
      for (const [from, to] of [[[-0.15, 1.2], [0.05, 1]], [[-0.05, 1.15], [0.15, 0.95]]]) {
        await tool(tab, 'box');
        await drag(tab, from, to, touch);
        await tab.frames();
      }
      const order = (ids) => until(tab, `in the order ${ids}`, (all) => all.map(({ id }) => id).join() === ids);
      const first = await order('1,2,3');
      await tool(tab, 'back');
      const behind = await order('3,1,2');
      assert.deepEqual(behind, [first[2], first[0], first[1]]);
      // A press finds what is drawn before the other.
      await tool(tab, 'select');
      await tap(tab, 0, 1.08, touch);
      assert.equal(await tab.on('[aria-label="Selected object"]', (list) => list.value), '2');
      await tool(tab, 'back');
      await order('2,3,1');
      await tool(tab, 'front');
      await order('3,1,2');
      for (const before of ['2,3,1', '3,1,2', '1,2,3']) {
        await tool(tab, 'undo');
        await order(before);
      }
      await tool(tab, 'redo');
      await order('3,1,2');
      await tab.page.select('.hearth-toolbar select[aria-label="Selected object"]', '1');
      const disabled = (name) => tab.on(`[data-tool="${name}"]`, (button) => button.getAttribute('aria-disabled'));
      assert.deepEqual([await disabled('front'), await disabled('back')], ['true', 'true'], 'a source has no place in front');
      assert.deepEqual(tab.problems, []);
    });
  });
}

test('keys add to the selection, move and duplicate all of it, and align it', async () => {
  const tab = await openTools(browser);
  await tab.fire((fire) => fire.set({ objects: [
    { kind: 'source', id: 1 }, { kind: 'solid', id: 2, x: 0, y: 1, width: 0.1 }, { kind: 'solid', id: 3, x: 0.3, y: 1.1, width: 0.2 },
  ] }));
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
  const names = await tab.evaluate(() => [...document.querySelectorAll('.hearth-align button')].map((button) => button.getAttribute('aria-label')));
  assert.deepEqual(names, ['left', 'centre', 'right', 'top', 'middle', 'bottom'].map((to) => `Align: ${to}`));
  assert.deepEqual(tab.problems, []);
});

test('a moved object snaps to the edges and the middle of others with a guide, and with Alt it does not', async () => {
  const tab = await openTools(browser);
  await tab.fire((fire) => fire.set({ objects: [
    { kind: 'source', id: 1 }, { kind: 'solid', id: 2, shape: 'box', x: 0.3, y: 0.6, width: 0.2, height: 0.1 },
    { kind: 'solid', id: 3, shape: 'box', x: -0.2, y: 1.1, width: 0.1, height: 0.1 },
  ] }));
  await tool(tab, 'select');
  const [from, to] = [await pixel(tab, -0.2, 1.1), await pixel(tab, 0.3, 1)];
  const guides = () => tab.on('.hearth-overlay .guide', (path) => path.getAttribute('d'));
  await tab.mouse('move', from);
  await tab.mouse('down', from);
  // Three pixels beside the middle of the other.
  await tab.mouse('move', { x: to.x + 3, y: to.y });
  await until(tab, 'in the middle', ([, , box]) => close(box.x, 0.3, 2e-3));
  assert.notEqual(await guides(), '');
  await tab.page.keyboard.down('Alt');
  await tab.mouse('move', { x: to.x + 4, y: to.y });
  const [, , free] = await until(tab, 'beside it', ([, , box]) => box.x > 0.302);
  await tab.page.keyboard.up('Alt');
  assert.ok(close(free.x, 0.3), `${free.x}`);
  assert.equal(await guides(), '');
  await tab.mouse('move', { x: to.x - 3, y: to.y });
  await until(tab, 'in the middle again', ([, , box]) => close(box.x, 0.3, 2e-3));
  await tab.mouse('up', { x: to.x - 3, y: to.y });
  await tab.frames();
  assert.equal(await guides(), '');
  await tool(tab, 'undo');
  await until(tab, 'back', ([, , box]) => close(box.x, -0.2, 1e-6));
  assert.deepEqual(tab.problems, []);
});
