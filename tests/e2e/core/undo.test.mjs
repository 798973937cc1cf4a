/** Undo and redo by keys, accessible controls and buttons; `extended/history.test.mjs` has every kind of change. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { Panel, actionOf, along, controlOf } from '../panel.mjs';

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

test('a drag of a campfire is one step, which brings back the fire and its logs', async () => {
  const tab = await browser.open('index.html', { width: 900, height: 640 });
  await tab.ready();
  const panel = await new Panel(tab).mounted();
  const places = () =>
    tab.fire(async (fire) => {
      await fire.exportConfig();
      return fire.objects.map(({ x }) => x);
    });
  const before = await places();
  const [from, to] = await tab.fire((fire) => {
    const { left, top } = fire.getBoundingClientRect();
    return [0, 0.2].map((x) => {
      const at = fire.toPixels(x, 0.06);
      return { x: left + at.x, y: top + at.y };
    });
  });
  await tab.drag(from, to);
  await can(panel, 'undo', true);
  assert.ok(
    (await places()).every((x, at) => x > before[at] + 0.1),
    'all moved',
  );
  await panel.press('undo');
  await can(panel, 'undo', false);
  assert.deepEqual(await places(), before);
  await panel.press('redo');
  await can(panel, 'redo', false);
  assert.ok(
    (await places()).every((x, at) => x > before[at] + 0.1),
    'all moved again',
  );
});
