/**
 * The page on a phone: a finger drags a slider while the page does not scroll and the fire
 * stays visible.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { Panel, along, fractionOf } from '../panel.mjs';
import { table } from '../site.mjs';

const { entry } = await table();
const PHONE = { width: 360, height: 640, ratio: 3, touch: true };

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

test('one finger drags a slider while the fire stays in sight', async () => {
  const tab = await browser.open('index.html', PHONE);
  await tab.burnt(1);
  const panel = await new Panel(tab).mounted();
  const sheet = await tab.rectangle('#panel');
  assert.ok(sheet.height <= 0.45 * PHONE.height, `the sheet is ${sheet.height} high`);
  assert.ok(sheet.y >= 0.55 * PHONE.height - 1, `the sheet begins at ${sheet.y}`);

  const rectangle = await panel.reveal('buoyancy');
  assert.ok(rectangle.y >= sheet.y && rectangle.y + rectangle.height <= PHONE.height);
  await tab.touchDrag(along(rectangle, 0.2), along(rectangle, 0.8));

  const near = (value) => Math.abs(fractionOf(entry.buoyancy, value) - 0.8) < 0.08;
  await panel.value('buoyancy', 'where the finger let go', near);
  const scrolled = await tab.evaluate(() => window.scrollY + (visualViewport?.pageTop ?? 0));
  assert.equal(scrolled, 0, 'the page stays where it is');
  // A fire that was just lit may be between two puffs.
  await tab.burnt((await tab.fire((fire) => fire.stats.time)) + 1.5);
  const above = await tab.picture({ x: 0, y: 0, width: PHONE.width, height: sheet.y });
  assert.ok(above.glowing() > 0.01, `${above.glowing()} of what is above the sheet glows`);
  assert.deepEqual(tab.problems, []);
});
