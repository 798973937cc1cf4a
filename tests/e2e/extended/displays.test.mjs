/**
 * Display modes: the statistics report at once what the colours of each mode mean, for a
 * playing and for a paused fire.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import path from 'node:path';
import { Browser } from '../driver.mjs';
import { SITE, table } from '../site.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

const PAGE = `<script type="module" src="/web/hearth-fire.js"></script>
  <hearth-fire quality="low" style="width: 200px; height: 300px; background: black"></hearth-fire>`;

/**
 * Shows that mode and waits until the statistics follow.
 * @param {import('../driver.mjs').Tab} tab @param {string} mode @param {boolean} measures
 * @returns {Promise<[number, number] | null>}
 */
async function shown(tab, mode, measures) {
  await tab.fire((fire, mode) => fire.set('display_mode', mode), mode);
  const { scale } = await tab.until(
    `the statistics follow to ${mode}`,
    (measures) => {
      const { stats } = /** @type {any} */ (document.querySelector('hearth-fire'));
      return (stats.scale !== null) === measures && { scale: stats.scale };
    },
    measures,
  );
  return scale;
}

test('the statistics report the range of the colours of every display mode', async () => {
  const { entry } = await table();
  const { QUANTITIES } = await import(pathToFileURL(path.join(SITE, 'web/parameters.js')).href);
  const tab = await browser.open(PAGE, { width: 220, height: 320 });
  await tab.ready();
  await tab.burnt(0.5);
  for (const still of [false, true]) {
    if (still) await tab.fire((fire) => fire.pause());
    for (const mode of entry.display_mode.choices) {
      // From the fire, which has none, so that no scale is left over.
      assert.equal(await shown(tab, 'fire', false), null);
      const scale = await shown(tab, mode, mode in QUANTITIES);
      if (scale === null) continue;
      const [least, most] = scale;
      const { signed, whole } = QUANTITIES[mode];
      assert.ok(least < most, `${mode}: ${scale}`);
      assert.equal(least === -most, signed, `${mode}: ${scale}`);
      if (whole) assert.ok(Number.isInteger(least) && Number.isInteger(most), `${mode}: ${scale}`);
      // Decimals of a few digits, as people write them.
      for (const end of scale) assert.ok(String(end).length <= 7, `${mode}: ${end}`);
    }
  }
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});
