/** The page of equations as printed. What each of them does is tested in `tests/tests/plain.rs`. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { violations } from '../axe.mjs';
import { Browser } from '../driver.mjs';
import { table } from '../site.mjs';

const { PARAMETERS } = await table();
const PHONE = { width: 390, height: 844, touch: true };

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

test('every equation as printed has a pair of fires that differ in it alone, and a number that distinguishes them', async () => {
  const tab = await browser.open('printed.html', PHONE);
  await tab.until('the end', () => document.getElementById('status')?.textContent === '');
  const pairs = await tab.evaluate(() =>
    [...document.querySelectorAll('main section')].map((section) => ({
      flag: section.dataset.flag,
      attributes: [...section.querySelectorAll('hearth-fire')].map((fire) =>
        fire.getAttributeNames().filter((name) => !['alt', 'max-pixels'].includes(name)),
      ),
      numbers: [...section.querySelectorAll('[data-number]')].map((cell) => Number(cell.textContent)),
    })),
  );
  const printed = PARAMETERS.map(({ id }) => id).filter((id) => id.startsWith('printed_'));
  assert.deepEqual(
    pairs.map(({ flag }) => flag),
    printed,
    'the page has all of them',
  );
  for (const { flag = '', attributes, numbers } of pairs) {
    assert.deepEqual(attributes, [['preset'], ['preset', flag.replaceAll('_', '-')]]);
    assert.ok(numbers[1] > numbers[0], `${flag}: ${numbers}`);
  }
  await tab.ready();
  assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), 'it fits a phone');
  assert.deepEqual(await violations(tab), []);
  assert.deepEqual(tab.problems, []);
});
