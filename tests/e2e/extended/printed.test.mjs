/** The page of equations as printed: ten fires, and numbers that distinguish each pair as its text states. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { violations } from '../axe.mjs';
import { Browser } from '../driver.mjs';
import { table } from '../site.mjs';

const { PARAMETERS } = await table();
const PHONE = { width: 390, height: 844, touch: true };

/** How many times larger the number as printed is, at least and at most. */
const RATIOS = {
  printed_kernel: [5, 20],
  printed_pressure: [1.1, 1.4],
  printed_viscosity: [3, 8],
  printed_divisor: [5, 6.5],
  printed_euler: [1.2, 2.5],
};

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

test('every equation as printed has a pair of fires that differ in it alone, and a number that distinguishes them', async () => {
  const tab = await browser.open('printed.html', PHONE);
  for (const flag of Object.keys(RATIOS)) {
    await tab.until(
      `the numbers of ${flag}`,
      (id) => document.querySelector(`[data-flag="${id}"] [data-number="printed"]`)?.textContent !== '…',
      flag,
    );
  }
  await tab.until('the end', () => document.getElementById('status')?.textContent === '');
  const pairs = await tab.evaluate(() =>
    [...document.querySelectorAll('section')].map((section) => ({
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
  for (const {
    flag = '',
    attributes,
    numbers: [corrected, asPrinted],
  } of pairs) {
    assert.deepEqual(attributes, [['preset'], ['preset', flag.replaceAll('_', '-')]]);
    const [least, most] = RATIOS[flag];
    const ratio = asPrinted / corrected;
    assert.ok(ratio >= least && ratio <= most, `${flag}: ${corrected} and ${asPrinted}`);
  }
  await tab.ready();
  assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), 'it fits a phone');
  assert.deepEqual(await violations(tab), []);
  assert.deepEqual(tab.problems, []);
});
