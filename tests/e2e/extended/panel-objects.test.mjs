/**
 * The objects in the panel of a phone. Its rows and buttons are tested natively in `crates/hearth-panel/tests`, and
 * `history.test.mjs` compares list, rows and accessible controls with the fire after any change.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { Panel, actionOf, along } from '../panel.mjs';
import { objects, objectsUntil as until } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const propertyOf = (/** @type {string} */ name) => `[data-property="${name}"]`;

/** @param {string} query */
async function openPage(query) {
  const options = { width: 390, height: 844, touch: true };
  const tab = await browser.open(`index.html?${query}${query.includes('paused') ? '' : '&paused'}`, options);
  await tab.ready();
  return { tab, panel: await new Panel(tab).mounted() };
}

const titled = (panel, text) =>
  panel.until(
    `the scene is called ${text}`,
    (root, wanted) => root.querySelector('[data-action="scenes"]').textContent === `Scene: ${wanted}`,
    text,
  );

/** Clicks a button of the group with the mouse. */
async function press(panel, tab, action) {
  await tab.click(along(await panel.pointAt(actionOf(action)), 0.5));
}

test('a finger adds a solid, drags its width, undoes and deletes, and a link shows the same fire', async () => {
  const { tab, panel } = await openPage('scene=default');
  const first = await tab.fire((fire) => fire.exportConfig());
  await press(panel, tab, 'add:solid');
  const [source, solid] = await until(tab, 'two', (all) => all.length === 2);
  assert.deepEqual([solid.kind, solid.id], ['solid', 2]);
  const { domain_width: width, domain_height: height } = await tab.fire((fire) => fire.params);
  const apart = Math.hypot(solid.x - source.x, solid.y - source.y);
  assert.ok(apart >= (source.width + solid.width) / 2, `it stands ${apart} from the source`);
  assert.ok(
    Math.abs(solid.x) + solid.width / 2 <= width / 2 && solid.y + solid.width / 2 <= height,
    'it is in the frame',
  );
  await titled(panel, 'Default, changed');

  const rail = await panel.pointAt(propertyOf('solid:width'));
  await tab.drag(along(rail, 0.5), along(rail, 0.7));
  await until(tab, 'wider', ([, moved]) => moved.width > 1.4 * solid.width);

  await panel.press('undo');
  await until(tab, 'as narrow as before', ([, moved]) => moved?.width === solid.width);
  await panel.pointAt(actionOf('redo'));
  await panel.press('redo');
  // The width during the drag may be that of any of its moves; this one is the last.
  const [, dragged] = await until(tab, 'wider again', ([, moved]) => moved.width > 1.4 * solid.width);
  assert.deepEqual({ ...dragged, width: solid.width }, solid, 'only its width is another');
  await panel.pointAt(actionOf('undo'));
  await panel.press('undo');
  await until(tab, 'as narrow as before', ([, moved]) => moved?.width === solid.width);
  await panel.press('undo');
  await until(tab, 'one', (all) => all.length === 1);
  assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), first);
  await titled(panel, 'Default');
  for (let step = 0; step < 2; step += 1) {
    await panel.pointAt(actionOf('redo'));
    await panel.press('redo');
  }
  await until(tab, 'as wide as dragged', ([, moved]) => moved?.width === dragged.width);
  assert.deepEqual(tab.problems, []);

  // A link shows the same fire.
  const query = await tab.until(
    'the address has the width',
    (wanted) => {
      const text = new URLSearchParams(location.search).get('objects');
      return text?.includes(wanted) && location.search;
    },
    `"width":${dragged.width}`,
  );
  const other = await openPage(query.slice(1));
  assert.deepEqual(await objects(other.tab), [source, dragged]);
  await other.panel.pointAt(actionOf('select-object'));
  await other.tab.click(along(await other.panel.rectangleOf('object:2'), 0.5));
  await press(other.panel, other.tab, 'delete');
  await until(other.tab, 'one again', (all) => all.length === 1);
  assert.deepEqual(other.tab.problems, []);
});
