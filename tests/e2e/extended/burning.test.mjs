/**
 * A word that burns by the attributes `burning` and `text` is read. `web/children.test.mjs` has the recipe.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { correlation, hasMask, solidOf } from '../legible.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

/** The words of three scripts, and their widths [m]. */
const WORDS = { Latin: ['FIRE', 1], Arabic: ['نار', 1], Han: ['火', 0.45] };

for (const [script, [word, width]] of Object.entries(WORDS)) {
  test(`a ${script} word that an attribute states is read after ten seconds`, async () => {
    const tab = await browser.open(
      `<style>body { margin: 0; background: black } hearth-fire { width: 504px; height: 420px }</style>
      <hearth-fire preset="burning-word" objects="[]"><hearth-solid text="${word}" width="${width}" burning></hearth-solid></hearth-fire>`,
      { width: 504, height: 420 },
    );
    await tab.ready();
    await tab.until('the word', hasMask);
    await tab.burnt(10);
    const found = correlation(await tab.picture(), await solidOf(tab));
    assert.ok(found >= 0.6, `correlation ${found.toFixed(2)}`);
  });
}
