/**
 * Write your word: what burns is what was written. `web/word.test.mjs` has the frame and the links.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { strip } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const SIZES = [
  { width: 1280, height: 800 },
  { width: 390, height: 844, touch: true },
  { width: 844, height: 390, touch: true },
];

/** The mask of the page's fire, if it has one. */
const maskOf = (tab) => tab.fire((fire) => fire.objects.find(({ shape }) => shape === 'mask'));
const isMasked = () => {
  const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
  return fire.preset === 'burning-word' && fire.objects.some(({ shape }) => shape === 'mask');
};

for (const size of SIZES) {
  const touch = 'touch' in size;
  test(`at ${size.width} × ${size.height}, the three actions open, and a word that is typed burns in the fragment alone`, async () => {
    const tab = await browser.open('index.html', size);
    await tab.ready();
    await strip(tab);
    const press = async (name) => {
      const button = `#head [data-opens="${name}"]`;
      await tab.page.waitForSelector(button, { visible: true });
      if (touch) await tab.page.tap(button);
      else await tab.page.click(button);
    };
    await press('scenes');
    await tab.until('a scene has the focus', () => document.activeElement?.matches('#scenes [data-starts]'));
    await press('embed');
    await tab.until('the dialog', () => document.querySelector('#embed[open] [data-code]'));
    await tab.key('Escape');
    await tab.page.focus('#head [data-opens="word"]');
    await tab.key('Enter');
    await tab.until('the form has the focus', () => document.activeElement?.matches('#word input'));
    await tab.until('its word burns', isMasked);
    const first = await maskOf(tab);
    await tab.page.keyboard.type('Ember & Co');
    await tab.until('another word', isOther, first.mask);
    await tab.until('the address has it', () => location.hash.startsWith('#fire='));
    assert.equal(await tab.evaluate(() => location.search), '');
    await tab.key('Escape');
    assert.equal(await tab.page.$eval('#word', (form) => /** @type {HTMLElement} */ (form).hidden), true);
    await tab.fire((fire) => fire.history.undo());
    assert.notEqual(await tab.fire((fire) => fire.preset), 'burning-word', 'typing is one step');
    assert.deepEqual(tab.problems, []);
  });
}

/** Whether the mask is another one. @param {string} before */
function isOther(before) {
  const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
  const mask = fire.objects.find(({ shape }) => shape === 'mask')?.mask;
  return mask && mask !== before;
}

test('a logo is a picture: an SVG runs nothing and fetches nothing, and a file that is none is refused', async () => {
  const tab = await browser.open('index.html', SIZES[0]);
  await tab.ready();
  await tab.page.click('#head [data-opens="word"]');
  await tab.until('the word burns', isMasked);
  const before = await maskOf(tab);
  const drop = (content, type) =>
    tab.evaluate(
      (content, type) => {
        const data = new DataTransfer();
        data.items.add(new File([content], 'logo', { type }));
        document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
      },
      content,
      type,
    );
  await drop(
    `<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100"><script>parent.ran = 1</script>
      <image href="/web/poster.jpg?fetched" width="9" height="9"/><circle cx="50" cy="50" r="40" onload="parent.ran = 1"/></svg>`,
    'image/svg+xml',
  );
  await tab.until('the logo burns', isOther, before.mask);
  const { width, height } = await maskOf(tab);
  assert.ok(Math.abs(width / height - 1) < 0.01);
  const ran = await tab.evaluate(() => [
    /** @type {any} */ (window).ran ?? null,
    performance.getEntriesByType('resource').some(({ name }) => name.includes('fetched')),
  ]);
  assert.deepEqual(ran, [null, false]);
  await drop('no picture', 'image/png');
  await tab.until('why', () => document.getElementById('toast')?.textContent?.includes('cannot be read as an image'));
});
