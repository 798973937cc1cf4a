/**
 * All words of the landing page have a contrast of 4.5:1 or more over pictures of every scene, at three moments each.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { contrasts, hideWords, wordsOf } from '../landing.mjs';
import { table } from '../site.mjs';
import { strip } from '../waits.mjs';

const { PRESETS } = await table();

/** The moments of each scene [s]: it burns from the start. */
const MOMENTS = [0.1, 0.6, 1.2];

const SIZES = [
  { width: 1280, height: 800 },
  { width: 390, height: 844 },
];

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

test('all words are read over all scenes, on a screen and on a phone', async () => {
  const tab = await browser.open('index.html?paused&quality=low', {
    ...SIZES[0],
    pixels: 12_000,
    // The button of pages where the system has a share sheet.
    before: () => Object.defineProperty(navigator, 'share', { value: () => Promise.resolve() }),
  });
  await tab.ready();
  await strip(tab);
  await tab.evaluate(() => {
    const hint = /** @type {HTMLElement} */ (document.getElementById('hint'));
    hint.textContent = 'Move to blow, click for sparks, drag the base';
    const style = new CSSStyleSheet();
    style.replaceSync(`* { transition: none !important }
      #handle { visibility: visible !important; right: 40% !important }`);
    document.adoptedStyleSheets.push(style);
  });
  /** The words at each size. */
  const words = [];
  for (const size of SIZES) {
    await tab.page.setViewport(size);
    await tab.frames();
    words.push(await wordsOf(tab));
    assert.ok(words[0].length >= 9, JSON.stringify(words));
  }
  await hideWords(tab);
  /** @type {string[]} */
  const low = [];
  let least = Infinity;
  for (const { name } of PRESETS) {
    await tab.fire((fire, preset) => fire.importConfig({ hearth: 3, preset, values: {} }), name);
    for (const moment of MOMENTS) {
      await tab.burnt(moment);
      for (const [at, size] of SIZES.entries()) {
        await tab.page.setViewport(size);
        // The words stay while there is input.
        await tab.move({ x: 200 + 9 * moment, y: 400 });
        await tab.frames(3);
        for (const [word, contrast] of contrasts(await tab.picture(), words[at])) {
          least = Math.min(least, contrast);
          if (contrast < 4.5) low.push(`${name} at ${moment} s, ${size.width} wide: ${word} ${contrast.toFixed(2)}`);
        }
      }
    }
  }
  assert.deepEqual(low, []);
  assert.ok(least < 13, `the pictures are not all dark: ${least.toFixed(1)}`);
});
