/**
 * The page of the paper's figures. The effects that its text names are tested in `tests/tests/paper.rs` and
 * `models.rs`, its numbers in `tests/web/figures.test.mjs`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { violations } from '../axe.mjs';
import { Browser } from '../driver.mjs';

const PHONE = { width: 390, height: 844, touch: true };

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** @typedef {import('../driver.mjs').Tab} Tab */

/** A fire's figure, by its section and its place. @param {string} id @param {number} at */
const figureAt = (id, at) => `[aria-labelledby="${id}"] .fires > figure:nth-child(${at + 1})`;

/**
 * Scrolls a figure into sight, and waits for its numbers.
 * @param {Tab} tab @param {string} id @param {number} at
 * @returns {Promise<{[name: string]: number}>}
 */
async function numbers(tab, id, at) {
  await tab.page.$eval(figureAt(id, at), (figure) => figure.scrollIntoView({ block: 'center' }));
  return tab.until(
    `the numbers of ${id}, ${at}`,
    (figure) => {
      const cells = [...document.querySelectorAll(`${figure} dd`)].map((cell) => [
        /** @type {HTMLElement} */ (cell).dataset.number,
        Number.parseFloat(cell.textContent ?? ''),
      ]);
      return cells.length > 0 && cells.every(([, number]) => Number.isFinite(number)) && Object.fromEntries(cells);
    },
    figureAt(id, at),
  );
}

test('a slider moves a fire and its numbers by keys; the page fits a phone and has no violation', async () => {
  const tab = await browser.open('figures.html?n=300,600', PHONE);
  const [low, middle, high] = [
    await numbers(tab, 'buoyancy', 0),
    await numbers(tab, 'buoyancy', 1),
    await numbers(tab, 'buoyancy', 2),
  ];
  assert.ok(low.width > middle.width && middle.width > high.width && high.height > 3 * low.height);
  const figure = figureAt('buoyancy', 1);
  await tab.page.focus(`${figure} input`);
  await tab.page.keyboard.press('End');
  assert.deepEqual(
    await tab.page.$eval(figure, (element) => [
      element.querySelector('hearth-fire').getAttribute('buoyancy'),
      element.querySelector('hearth-fire').alt,
      element.querySelector('input').ariaValueText,
    ]),
    ['1', 'Fire: buoyancy 1', '1'],
  );
  assert.deepEqual(await numbers(tab, 'buoyancy', 1), high);
  await tab.page.$eval('#colours', (colours) => colours.scrollIntoView());
  await tab.until('the colours', () => document.querySelectorAll('#scale li').length === 16);
  assert.equal(await tab.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false);
  assert.deepEqual(await violations(tab), []);
  assert.deepEqual(tab.problems, []);
});
