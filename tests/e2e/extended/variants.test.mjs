/** The panel compares two states of a fire, and sets random values near those of its scene. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { Panel, actionOf } from '../panel.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** @param {object} [options] */
async function openPage(options) {
  const tab = await browser.open('index.html?scene=campfire&paused', { width: 760, height: 640, ...options });
  await tab.ready();
  return { tab, panel: await new Panel(tab).mounted() };
}

const config = (tab) => tab.fire((fire) => fire.exportConfig());
/** The preset, and the solids with all of their values. */
const things = (tab) => tab.fire((fire) => [fire.preset, fire.objects.filter(({ kind }) => kind === 'solid')]);
const shows = (panel, letter) =>
  panel.until(
    `state ${letter} is shown`,
    (root, wanted) => root.querySelector(`[data-action="compare:${wanted}"]`).getAttribute('aria-pressed') === 'true',
    letter,
  );
const compare = async (panel, letter) => {
  await panel.press(`compare:${letter}`);
  await shows(panel, letter);
};

test('each state keeps its values and objects, and undo goes back through both', async () => {
  const { tab, panel } = await openPage();
  await shows(panel, 'A');
  const first = await config(tab);
  await compare(panel, 'B');
  assert.deepEqual(await config(tab), first, 'B begins as a copy of A');
  await panel.dragSlider('fuel_power', 0.5, 0.9);
  await tab.fire((fire) => fire.addObject({ kind: 'solid', x: 0.3, y: 0.4 }));
  const second = await config(tab);
  assert.notDeepEqual(second, first);
  await compare(panel, 'A');
  assert.deepEqual(await config(tab), first);
  await compare(panel, 'B');
  assert.deepEqual(await config(tab), second);
  await panel.press('undo');
  await shows(panel, 'A');
  assert.deepEqual(await config(tab), first);
  await panel.press('undo');
  await shows(panel, 'B');
  assert.deepEqual(await config(tab), second);
  await panel.press('redo');
  await shows(panel, 'A');
  await compare(panel, 'B');
  assert.deepEqual(await config(tab), second, 'undo and redo keep the other state');
  assert.deepEqual(tab.problems, []);
});

test('random values are those of another fire of the same scene: one step of undo', async () => {
  const { tab, panel } = await openPage({ width: 390, height: 844 });
  await panel.pointAt(actionOf('randomise'));
  const [before, all] = [await config(tab), await things(tab)];
  await panel.press('randomise');
  await panel.until(
    'it is another fire',
    (root) => root.querySelector('[data-action="scenes"]').textContent === 'Scene: Campfire, changed',
  );
  assert.deepEqual(await things(tab), all);
  await panel.pointAt(actionOf('undo'));
  await panel.press('undo');
  await panel.until(
    'it is the first one',
    (root) => root.querySelector('[data-action="scenes"]').textContent === 'Scene: Campfire',
  );
  assert.deepEqual(await config(tab), before);
  assert.deepEqual(tab.problems, []);
});
