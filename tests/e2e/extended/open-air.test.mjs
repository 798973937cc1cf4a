/**
 * A fire in open air goes on after a tab that was hidden. Changes of its domain, source and view are tested in
 * `tests/tests/open_changes.rs`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser, TABS } from '../driver.mjs';
import { assertBurns, events, recording } from '../assertions.mjs';
import { becomes } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  // Chromium's headless shell hides no tab.
  browser = await Browser.start();
});
after(() => browser?.close());

const FIRE = '<hearth-fire edges="open" quality="low" style="width: 240px; height: 240px"></hearth-fire>';

/**
 * No gas is at the limit of the speed, and the air around the fire is simulated.
 * @param {import('../driver.mjs').Tab} tab
 */
async function assertCalm(tab) {
  const { atSpeedLimit, asleep, particles } = await tab.fire((fire) => fire.stats);
  assert.equal(atSpeedLimit, 0);
  assert.ok(asleep < 0.2 && particles > 300, `${particles} particles, ${asleep} of the air asleep`);
}

test('a fire burns on without a burst after another tab was in front', TABS, async () => {
  const tab = await browser.show(recording(FIRE));
  await tab.burnt(1.5);
  const other = await browser.browser.newPage();
  await other.bringToFront();
  await tab.evaluate(becomes, /** @type {const} */ ('hidden'));
  const age = await tab.fire((fire) => fire.stats.time);
  await tab.page.bringToFront();
  await tab.evaluate(becomes, /** @type {const} */ ('visible'));
  await other.close();
  await tab.burnt(age + 0.7);
  await assertBurns(tab);
  await assertCalm(tab);
  assert.deepEqual(await events(tab, 'error'), []);
  assert.deepEqual(tab.problems, []);
});
