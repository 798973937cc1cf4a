/** Undo and redo by keys, accessible controls and buttons; `extended/history.test.mjs` has every kind of change. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { Panel, actionOf, along, controlOf } from '../panel.mjs';
import { chord, drag } from '../tools.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

async function openPage(query = 'scene=default&model=classic') {
  const tab = await browser.open(`index.html?${query}&paused`, { width: 760, height: 640 });
  await tab.ready();
  return { tab, panel: await new Panel(tab).mounted() };
}

/** All values and settings, once the panel has nothing under way. */
const look = (tab) => tab.fire(async (fire) => ({ config: await fire.exportConfig(), params: fire.params }));

/** Waits until a button can be pressed, or cannot, by its accessible control. */
const can = (panel, action, able) =>
  panel.until(
    `${action} is ${able ? 'on' : 'off'}`,
    (root, selector, wanted) => root.querySelector(selector).getAttribute('aria-disabled') === String(!wanted),
    actionOf(action),
    able,
  );

test('a key that is held down on an accessible slider is one step, which keys and accessible controls undo and redo', async () => {
  const { tab, panel } = await openPage();
  const first = await look(tab);
  await tab.page.focus(controlOf('buoyancy'));
  for (let repeat = 0; repeat < 5; repeat += 1) await tab.page.keyboard.down('ArrowRight');
  await tab.page.keyboard.up('ArrowRight');
  await can(panel, 'undo', true);
  const second = await look(tab);
  const press = async (...keys) => {
    for (const key of keys) await tab.page.keyboard.down(key);
    for (const key of keys.reverse()) await tab.page.keyboard.up(key);
  };
  for (const [back, forth] of [
    [
      ['Control', 'z'],
      ['Control', 'Shift', 'z'],
    ],
    [
      ['Meta', 'z'],
      ['Control', 'y'],
    ],
  ]) {
    await press(...back);
    await can(panel, 'redo', true);
    assert.deepEqual(await look(tab), first, back.join(' '));
    await press(...forth);
    await can(panel, 'redo', false);
    assert.deepEqual(await look(tab), second, forth.join(' '));
  }
  // A field has an undo of its own.
  await tab.click(along(await panel.rectangleOf('search'), 0.5));
  await tab.page.keyboard.type('x');
  await press('Control', 'z');
  await tab.frames(6);
  assert.deepEqual(await look(tab), second);

  await tab.page.$eval(actionOf('undo'), (button) => /** @type {HTMLElement} */ (button).click());
  await can(panel, 'redo', true);
  assert.deepEqual(await look(tab), first);
});

/** The settings of a fire, and the places of its objects, once it has this preset. */
async function sceneOf(tab, preset) {
  await tab.until(`the scene is ${preset}`, (name) => document.querySelector('hearth-fire').preset === name, preset);
  return tab.fire(async (fire) => [await fire.exportConfig(), fire.objects.map(({ x }) => x)]);
}

for (const [where, width] of Object.entries({ 'with the panel': 900, 'before the panel is loaded': 500 })) {
  const name = `a drag of the base and a scene of the strip are a step each, by keys on its thumbnail, ${where}`;
  test(name, async () => {
    const tab = await browser.open('index.html', { width, height: 640 });
    await tab.ready();
    if (width > 700) await new Panel(tab).mounted();
    const until = (can, value) =>
      tab.until(
        `${can} is ${value}`,
        (name, wanted) => document.querySelector('hearth-fire').history[name] === wanted,
        can,
        value,
      );
    const first = await sceneOf(tab, 'fireside');
    await drag(tab, [0, 0.06], [0.2, 0.06]);
    await until('canUndo', true);
    const dragged = await sceneOf(tab, 'fireside');
    assert.ok(
      dragged[1].every((x, at) => x > first[1][at] + 0.1),
      'all moved',
    );
    await tab.page.click('[data-starts="candle"]');
    const candle = await sceneOf(tab, 'candle');
    assert.deepEqual(candle, [{ hearth: 3, preset: 'candle', values: {} }, candle[1].map(() => 0)]);
    await chord(tab, 'Control', 'z');
    assert.deepEqual(await sceneOf(tab, 'fireside'), dragged);
    await tab.page.focus('[data-opens="about"]');
    await chord(tab, 'Control', 'z');
    await until('canUndo', false);
    assert.deepEqual(await sceneOf(tab, 'fireside'), first);
    for (const key of ['y', 'y']) await chord(tab, 'Control', key);
    assert.deepEqual(await sceneOf(tab, 'candle'), candle);
    assert.deepEqual(tab.problems, []);
  });
}
