/**
 * The page of the paper's figures: its fires show the effects that its text names, its sliders move them, and its
 * loop has the names that a fire reports. The numbers come from simulated fires, so no machine is too slow for them.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
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

/** @param {Tab} tab @param {string} id @param {number} count */
async function all(tab, id, count) {
  const found = [];
  for (let at = 0; at < count; at += 1) found.push(await numbers(tab, id, at));
  return found;
}

test('figure 1 has lighter colours at higher temperatures', async () => {
  const tab = await browser.open('figures.html?n=300,600', { ...PHONE, draws: true });
  await tab.ready();
  await tab.page.$eval('#colours', (figure) => figure.scrollIntoView());
  await tab.until('the slider of temperatures', () => document.querySelector('#kelvin:enabled'));
  const colours = await tab.evaluate(() =>
    [...document.querySelectorAll('#scale li')].map((entry) => entry.textContent ?? ''),
  );
  assert.equal(colours.length, 16);
  const sums = colours.map((words, at) => {
    const [, kelvin, ...rgb] = /^(\d+) K: #(..)(..)(..)$/.exec(words) ?? [];
    assert.equal(Number(kelvin), 1000 + 100 * at);
    const [red, green, blue] = rgb.map((digits) => Number.parseInt(digits, 16));
    assert.ok(red >= green && green >= blue, words);
    return red + green + blue;
  });
  assert.ok(
    sums.every((sum, at) => at === 0 || sum > sums[at - 1]),
    `${sums}`,
  );
  await tab.page.focus('#kelvin');
  await tab.page.keyboard.press('Home');
  await tab.until('the coolest fire', () => document.querySelector('hearth-fire')?.maximumTemperature === 1000);
  assert.match(await tab.page.$eval('#kelvin', (slider) => slider.ariaValueText), /^1000 K, #/);
});

describe('the figures on a phone', () => {
  /** @type {import('../driver/tab.mjs').Tab} */
  let tab;
  before(async () => {
    tab = await browser.open('figures.html?n=300,600', PHONE);
  });

  test('a fire that was never in sight does not burn', async () => {
    await tab.ready();
    const far = await tab.evaluate(() =>
      [...document.querySelectorAll('[aria-labelledby="buoyancy"] hearth-fire')].map((fire) => fire.stats),
    );
    assert.deepEqual(far, [null, null, null]);
  });

  test('figure 2 names every stage and pass that its fires report, each with its time', async () => {
    for (const at of [0, 1]) {
      await tab.page.$eval(figureAt('figure-2', at), (figure) => figure.scrollIntoView());
      const { names, rows } = await tab.until(
        'the loop',
        (figure) => {
          const fire = /** @type {any} */ (document.querySelector(`${figure} hearth-fire`));
          const items = /** @type {HTMLElement[]} */ ([...document.querySelectorAll(`${figure} li`)]);
          const { stages = {}, passes = {} } = fire.stats ?? {};
          if (items.length === 0 || Object.keys(passes).length === 0) return false;
          return {
            names: [...Object.keys(stages), ...Object.keys(passes)],
            rows: items.map((item) => [
              item.dataset.name,
              [...item.childNodes].map((node) => node.textContent?.trim() ?? ''),
            ]),
          };
        },
        figureAt('figure-2', at),
      );
      assert.deepEqual(
        rows.map(([name]) => name),
        names,
      );
      for (const [name, [code, text, time]] of rows) {
        assert.equal(code, name);
        assert.ok(text.length > 4, `${name} has no text`);
        assert.match(time, /^(< )?[\d.]+ ms$/);
      }
    }
  });

  test('figure 4: a larger smoothing radius clusters the particles', async () => {
    const [low, middle, high] = await all(tab, 'figure-4', 3);
    assert.ok(high.nearest < 0.75 * low.nearest && high.neighbours > 15 * low.neighbours);
    assert.ok(middle.width > low.width && middle.width > high.width);
  });

  test('figure 5: a larger gas constant widens the fire, and the printed kernel bursts it', async () => {
    const [low, middle, high, printed] = await all(tab, 'figure-5', 4);
    assert.ok(low.width < middle.width && middle.width < high.width && high.height > low.height);
    assert.ok(high.width > 1.3 * low.width && high.width < 1.7 * low.width);
    assert.ok(printed.width > 2 * high.width);
  });

  test('figure 6: viscosity widens the fire as printed, and narrows it corrected', async () => {
    const [low, , high, corrected] = await all(tab, 'figure-6', 4);
    assert.ok(high.width > 1.8 * low.width, `${low.width} ${high.width}`);
    assert.ok(corrected.width < low.width, `${corrected.width} ${low.width}`);
  });

  test('a higher buoyancy contracts the fire', async () => {
    const [low, middle, high] = await all(tab, 'buoyancy', 3);
    assert.ok(low.width > middle.width && middle.width > high.width);
    assert.ok(high.width < 0.8 * low.width && high.height > 3 * low.height);
  });

  test('a slider moves the middle fire and its numbers by keys', async () => {
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
    assert.deepEqual(await numbers(tab, 'buoyancy', 1), await numbers(tab, 'buoyancy', 2));
  });

  test('figure 8 burns one fire at a time and shows its pictures a second', async () => {
    for (const [at, count] of [300, 600].entries()) {
      await tab.page.$eval(`${figureAt('figure-8', at)} button`, (button) => button.click());
      const shown = await numbers(tab, 'figure-8', at);
      // On a busy machine it begins with less than one in two seconds.
      await tab.until(
        'pictures a second',
        (figure) => Number.parseFloat(document.querySelector(`${figure} [data-number="fps"]`)?.textContent ?? '') > 0,
        figureAt('figure-8', at),
      );
      assert.ok(Math.abs(shown.particles - count) <= 0.05 * count, `${shown.particles}`);
      assert.equal(await tab.evaluate(() => document.querySelectorAll('#counts hearth-fire').length), 1);
    }
    await tab.page.$eval(`${figureAt('figure-8', 1)} figcaption button`, (button) => button.click());
    assert.equal(await tab.evaluate(() => document.querySelectorAll('#counts hearth-fire').length), 0);
    assert.equal(await tab.evaluate(() => document.activeElement?.textContent), 'Burn 600 particles');
  });

  test('the page has one fire in a row, and no violation', async () => {
    const { wide, rows } = await tab.evaluate(() => ({
      wide: document.documentElement.scrollWidth > window.innerWidth,
      rows: [...document.querySelectorAll('.fires')].map((fires) => {
        const lefts = [...fires.children].map((figure) => figure.getBoundingClientRect().left);
        return new Set(lefts).size;
      }),
    }));
    assert.equal(wide, false, 'it fits a phone');
    assert.deepEqual(new Set(rows), new Set([1]));
    assert.deepEqual(await violations(tab), []);
    assert.deepEqual(tab.problems, []);
  });
});
