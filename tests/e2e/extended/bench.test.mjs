/**
 * The page of measurements: its button, its tables, its copies and its link, with few particles. No test asserts a
 * time.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { violations } from '../axe.mjs';

const FEW = '?n=300&sizes=1,30';
const PHONE = { width: 390, height: 844, touch: true };

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

/**
 * Waits until the status begins with one of these words.
 * @param {import('../driver.mjs').Tab} tab @param {string[]} starts
 */
const statusBegins = (tab, ...starts) =>
  tab.until(
    `the status “${starts[0]}”`,
    (words) => words.some((start) => document.getElementById('status')?.textContent?.startsWith(start)),
    starts,
  );

/**
 * Presses the button, and waits for each row and for the end.
 * @param {import('../driver.mjs').Tab} tab @param {string[]} rows
 */
async function measured(tab, ...rows) {
  const all = [...rows.map((row) => `Measuring ${row}`), 'Done.'];
  await tab.page.click('#measure');
  for (const at of all.keys()) await statusBegins(tab, ...all.slice(at));
}

/**
 * The text of each cell of a table, the names of the columns first.
 * @param {import('../driver.mjs').Tab} tab @param {string} id
 * @returns {Promise<string[][]>}
 */
const cells = (tab, id) =>
  tab.evaluate(
    (table) =>
      [...document.querySelectorAll(`#${table} tr`)].map((row) =>
        [...row.children].map((cell) => cell.textContent ?? ''),
      ),
    id,
  );

/**
 * The field with the copied text, after a press of a button.
 * @param {import('../driver.mjs').Tab} tab @param {string} what
 * @returns {Promise<string>}
 */
async function copied(tab, what) {
  await tab.page.click(`[data-copies="${what}"]`);
  await tab.until('the words about the copy', () => document.getElementById('copied')?.textContent);
  return tab.page.$eval('#copy', (field) => field.value);
}

/** The numbers of a row by column. @param {string[]} names @param {string[]} row */
const byName = (names, row) => Object.fromEntries(names.map((name, at) => [name, row[at]]));

describe('a measurement of few particles', () => {
  /** @type {import('../driver/tab.mjs').Tab} */
  let tab;
  before(async () => {
    tab = await browser.open(`bench.html${FEW}`, PHONE);
    await measured(tab, '300 particles, classic', '300 particles, combustion', 'the sizes');
  });

  test('fills the tables with numbers', async () => {
    const [names, ...rows] = await cells(tab, 'speeds');
    assert.equal(rows.length, 2);
    const [classic, combustion] = rows.map((row) => byName(names, row));
    assert.deepEqual([classic.model, combustion.model], ['classic', 'combustion']);
    for (const row of [classic, combustion]) {
      assert.equal(row.particles, '300');
      assert.equal(row['the paper: ms'], '5.46');
      for (const name of ['step, ms', 'steps a second', 'alive', 'picture, ms', 'FPS', 'wasm, MB', 'GPU, MB']) {
        assert.ok(Number(row[name]) > 0, `${row.model}, ${name}: “${row[name]}”`);
      }
    }
    assert.equal(classic['mean number'], '300', 'exactly so many particles');
    assert.ok(Math.abs(Number(classic.alive) - 300) <= 3, `${classic.alive} particles are alive in the picture`);
    assert.ok(Math.abs(Number(combustion['mean number']) - 300) <= 15, combustion['mean number']);
    assert.ok(Number(classic['paper’s loop, ms']) > 0 && Number(classic.ratio) > 0);
    const [sizeNames, ...sizes] = await cells(tab, 'memory');
    assert.deepEqual(
      sizes.map(([size]) => size),
      ['1', '30'],
    );
    assert.deepEqual(
      sizes.map((row) => byName(sizeNames, row)['size, m']),
      ['0.0025', '0.075'],
    );
    for (const row of sizes) assert.ok(Number(byName(sizeNames, row)['wasm, MB']) > 0);
    assert.deepEqual(tab.problems, []);
  });

  test('copies the tables as Markdown, CSV and JSON', async () => {
    const [names] = await cells(tab, 'speeds');
    const markdown = await copied(tab, 'markdown');
    assert.match(markdown, /^Measured with \S+ [\d.]+, \d+ logical processors?, \S.*\.\n/);
    const lines = markdown.split('\n').filter((line) => line.startsWith('|'));
    assert.equal(lines[0], `| ${names.join(' | ')} |`);
    assert.equal(lines.length, 2 + 2 + 2 + 2);
    const csv = await copied(tab, 'csv');
    const [head, first] = csv.split('\n');
    assert.ok(head.startsWith('particles,model,') && first.startsWith('300,classic,'), csv);
    const json = JSON.parse(await copied(tab, 'json'));
    assert.deepEqual(
      json.speeds.map(({ count, model }) => [count, model]),
      [
        [300, 'classic'],
        [300, 'combustion'],
      ],
    );
    assert.equal(json.paper.table1[300].ms, 5.46);
    assert.equal(new URL(await copied(tab, 'link')).search, FEW);
  });

  test('is plotted beside the paper’s', async () => {
    const names = await tab.evaluate(() =>
      [...document.querySelectorAll('#plot figcaption span')].map((span) => span.textContent),
    );
    assert.deepEqual(names, ['classic', 'combustion', 'the paper’s loop, here', 'the paper’s Table 1']);
    assert.ok(await tab.evaluate(() => document.querySelectorAll('#plot circle').length === 1 + 1 + 1 + 10));
  });

  test('fits a phone and has no violation', async () => {
    assert.ok(
      await tab.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth),
      'only tables scroll sideways',
    );
    assert.deepEqual(await violations(tab), []);
  });
});

test('a link chooses rows, and so do the boxes', async () => {
  const tab = await browser.open('bench.html?n=500,1000,7&models=classic&sizes=', { width: 900, height: 700 });
  await tab.page.click('summary');
  const checked = () =>
    tab.evaluate(() => [...document.querySelectorAll('input:checked')].map((box) => /** @type {any} */ (box).value));
  assert.deepEqual(await checked(), ['500', '1000', 'classic']);
  await tab.page.click('#counts input[value="500"]');
  assert.equal(await tab.evaluate(() => location.search), '?n=1000&models=classic&sizes=');
  assert.equal(
    await tab.page.$eval('[data-copies="csv"]', (button) => button.disabled),
    true,
    'nothing is measured yet',
  );
  assert.deepEqual(await violations(tab), []);
});

test('a measurement can be cancelled by its button, which the fire does not cover, and the table fits the window', async () => {
  const tab = await browser.open('bench.html?n=300&models=classic&sizes=', { width: 1280, height: 800 });
  await tab.page.$eval('#stage', (stage) => {
    new MutationObserver(() => {
      stage.querySelector('hearth-fire')?.addEventListener('stats', () => {
        window.scrollTo(0, 600);
        const { left, top } = /** @type {Element} */ (document.getElementById('cancel')).getBoundingClientRect();
        /** @type {HTMLElement} */ (document.elementFromPoint(left + 20, top + 20)).click();
      });
    }).observe(stage, { childList: true });
  });
  await tab.page.click('#measure');
  await statusBegins(tab, 'Cancelled');
  assert.ok(
    await tab.page.$eval('.scroll', ({ scrollWidth, clientWidth }) => scrollWidth === clientWidth),
    'no column is cut',
  );
  assert.equal(await tab.evaluate(() => document.querySelectorAll('hearth-fire, iframe').length), 0);
  assert.equal((await cells(tab, 'speeds')).length, 1, 'a part of a row is not shown');
  assert.deepEqual(tab.problems, []);
});

test('a row during which the tab was hidden is measured again', async () => {
  const tab = await browser.open('bench.html?n=300&models=classic&sizes=', { width: 900, height: 700 });
  await tab.page.$eval('#status', (status) => {
    let hidden = false;
    Object.defineProperty(document, 'hidden', { get: () => hidden });
    const hide = (/** @type {boolean} */ value) => {
      hidden = value;
      document.dispatchEvent(new Event('visibilitychange'));
    };
    const statuses = [];
    /** @type {any} */ (window).statuses = statuses;
    new MutationObserver(() => {
      statuses.push(status.textContent);
      if (statuses.length === 1) hide(true);
      if (/^The tab is hidden/.test(status.textContent)) hide(false);
    }).observe(status, { childList: true });
  });
  const row = '300 particles, classic (row 1 of 1)';
  await measured(tab, `${row}, again: the tab was hidden`);
  const statuses = await tab.evaluate(() =>
    /** @type {any} */ (window).statuses.map((/** @type {string} */ words) => words.slice(0, 22)),
  );
  assert.deepEqual(statuses, ['Measuring 300 particle', 'The tab is hidden: bro', 'Measuring 300 particle', 'Done.']);
  assert.equal((await cells(tab, 'speeds')).length, 2);
  assert.deepEqual(tab.problems, []);
});
