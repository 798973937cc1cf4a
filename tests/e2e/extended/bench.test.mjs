/**
 * The page of measurements with few particles. Its links, texts and tables are tested in `tests/web/bench.test.mjs`. No
 * test asserts a time.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { violations } from '../axe.mjs';

const PHONE = { width: 390, height: 844, touch: true };

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

test('a measurement of few particles fills the tables with numbers, on a phone and without violations', async () => {
  const tab = await browser.open('bench.html?n=300&sizes=1,30', PHONE);
  await tab.page.click('#measure');
  await tab.until('the end', () => document.getElementById('status')?.textContent?.startsWith('Done.'));
  const [speeds, sizes] = await tab.evaluate(() =>
    ['speeds', 'memory'].map((table) => {
      const [names, ...rows] = [...document.querySelectorAll(`#${table} tr`)].map((row) =>
        [...row.children].map((cell) => cell.textContent ?? ''),
      );
      return rows.map((row) => Object.fromEntries(names.map((name, at) => [name, row[at]])));
    }),
  );
  assert.deepEqual(
    speeds.map(({ model, particles }) => [model, particles]),
    [
      ['classic', '300'],
      ['combustion', '300'],
    ],
  );
  for (const row of speeds)
    for (const name of ['step, ms', 'steps a second', 'alive', 'picture, ms', 'FPS', 'wasm, MB', 'GPU, MB'])
      assert.ok(Number(row[name]) > 0, `${row.model}, ${name}: “${row[name]}”`);
  assert.equal(speeds[0]['mean number'], '300', 'exactly so many particles');
  assert.ok(Math.abs(Number(speeds[1]['mean number']) - 300) <= 15, speeds[1]['mean number']);
  assert.ok(Number(speeds[0]['paper’s loop, ms']) > 0);
  assert.deepEqual(
    sizes.map((row) => row['size, m']),
    ['0.0025', '0.075'],
  );
  for (const row of sizes) assert.ok(Number(row['wasm, MB']) > 0);
  await tab.page.click('[data-copies="csv"]');
  await tab.until('the words about the copy', () => document.getElementById('copied')?.textContent);
  assert.match(await tab.page.$eval('#copy', (field) => field.value), /^particles,model,.*\n300,classic,/);
  assert.ok(
    await tab.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth),
    'only tables scroll sideways',
  );
  assert.deepEqual(await violations(tab), []);
  assert.deepEqual(tab.problems, []);
});
