/**
 * A word that burns by the attributes `burning` and `text` is read, and a logo burns along its outline. `web/children.test.mjs` has the recipe.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { correlation, hasMask, lightAtOutline, solidOf } from '../legible.mjs';

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
      <hearth-fire preset="burning-word" objects="[]" quality="medium" paused><hearth-solid text="${word}" width="${width}" burning></hearth-solid></hearth-fire>`,
      { width: 504, height: 420 },
    );
    await tab.ready();
    await tab.until('the word', hasMask);
    // The word differs from moment to moment, and a busy machine looks late.
    await tab.fire((fire) => fire.advance(10));
    await tab.frames(5);
    const found = correlation(await tab.picture(), await solidOf(tab));
    assert.ok(found >= 0.6, `correlation ${found.toFixed(2)}`);
  });
}

/** Logos of different build, at a level of quality that does not depend on the machine: strokes, a full shape with a hole, and small parts side by side. */
const LOGOS = {
  'of strokes': '<path d="M50 12 88 84H12Z" fill="none" stroke="#fff" stroke-width="10"/>',
  'that is full': '<path d="M50 5a45 45 0 1 0 .1 0zM50 35a15 15 0 1 1-.1 0z" fill="#fff" fill-rule="evenodd"/>',
  'of parts': [0, 1, 2].map(
    (at) => `<rect x="${4 + 34 * at}" y="${20 + 12 * at}" width="24" height="60" fill="#fff"/>`,
  ),
};

for (const [build, paths] of Object.entries(LOGOS)) {
  test(`a logo ${build} burns along its outline`, async () => {
    const tab = await browser.open(
      `<style>body { margin: 0; background: black } svg { position: absolute; left: 272px; bottom: 60px; width: 96px }
        hearth-fire { position: absolute; inset: 0; width: auto; height: auto }</style>
      <svg id="logo" viewBox="0 0 100 100">${[paths].flat().join('')}</svg>
      <hearth-fire domain-width="2" domain-height="1" ember-rate="0" quality="medium">
        <hearth-solid of="#logo" burning></hearth-solid>
      </hearth-fire>`,
      { width: 640, height: 320 },
    );
    await tab.ready();
    await tab.until('the logo', hasMask);
    const solid = await solidOf(tab);
    const shares = [];
    for (const moment of [3, 4, 5]) {
      await tab.burnt(moment);
      shares.push(lightAtOutline(await tab.picture(), solid));
    }
    const mean = (key) => shares.reduce((sum, it) => sum + it[key], 0) / shares.length;
    const said = JSON.stringify(shares);
    // A flame, not charcoal alone: as much light as 2000 white pixels.
    assert.ok(mean('light') > 2000 * 255, said);
    assert.ok(mean('share') >= 0.7, said);
  });
}
