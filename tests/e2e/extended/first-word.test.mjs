/**
 * A stranger's first minute: a word of their own burns, framed and read, within four presses, by mouse, touch and
 * keyboard. Each test says how long it took, which is no matter of the test: a busy machine changes it.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser, eventually } from '../driver.mjs';
import { correlation, solidOf } from '../legible.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

const WORD = 'EMBER';
const BUTTON = '#head [data-opens="word"]';

/** What opens the form, in presses. @type {{[how: string]: (page: import('puppeteer-core').Page) => Promise<number>}} */
const OPEN = {
  mouse: (page) => page.click(BUTTON).then(() => 1),
  touch: (page) => page.tap(BUTTON).then(() => 1),
  keyboard: async (page) => {
    let presses = 0;
    for (; presses < 3 && !(await page.$(`${BUTTON}:focus`)); presses += 1) await page.keyboard.press('Tab');
    await page.keyboard.press('Enter');
    return presses + 1;
  },
};

for (const [how, width, height, least] of /** @type {[string, number, number, number][]} */ ([
  ['mouse', 1280, 800, 0.6],
  ['keyboard', 1280, 800, 0.6],
  // Letters of 65 pixels: dark grains of the coal are as wide as their strokes.
  ['touch', 390, 844, 0.45],
  ['touch', 844, 390, 0.6],
])) {
  test(`at ${width} × ${height} a stranger’s word burns after four presses or fewer, by ${how}`, async (context) => {
    const arrived = Date.now();
    const tab = await browser.open('index.html', { width, height, touch: how === 'touch', pixels: 340_000 });
    await tab.page.waitForSelector(BUTTON, { visible: true });
    // A press before the script of the page has run would be of no use to anybody.
    await tab.until('the page listens', () => document.documentElement.dataset.chrome);
    let presses = await OPEN[how](tab.page);
    await tab.until('the form has the focus', () => document.activeElement?.matches('#word input'));
    await tab.page.keyboard.type(WORD);
    await tab.page.keyboard.press('Enter');
    presses += 1;
    assert.ok(presses <= 4, `${presses} presses`);
    await tab.until('the word is wider than FIRE', () => {
      const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
      const word = fire.objects.find((/** @type {any} */ { shape }) => shape === 'mask');
      return fire.preset === 'burning-word' && word?.width / word?.height > 4;
    });
    const read = await eventually(
      'the word is read',
      async () => {
        const { x, y, width: wide, height: high } = await tab.rectangle('#fire');
        return correlation(await tab.picture({ x, y, width: wide, height: high }), await solidOf(tab));
      },
      (found) => found >= least,
      () => tab.frames(1),
    );
    context.diagnostic(
      `${((Date.now() - arrived) / 1000).toFixed(1)} s, ${presses} presses, correlation ${read.toFixed(2)}`,
    );
    const [stage, form, word] = [await tab.rectangle('#stage'), await tab.rectangle('#word'), await solidOf(tab)];
    assert.ok(word.left > 0 && word.right < stage.width && word.bottom < stage.height, JSON.stringify(word));
    assert.ok(word.right - word.left > stage.width / 3, 'it is large');
    assert.ok(form.y + form.height < stage.y + word.top, 'the form lies above it');
    assert.deepEqual(tab.problems, []);
  });
}
