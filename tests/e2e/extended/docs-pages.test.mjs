/**
 * The pages of the documentation. What the build puts into them is tested in `pages` of `xtask`, the search in
 * `tests/web/docs-search.test.mjs`.
 */
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { brotliCompressSync } from 'node:zlib';
import { violations } from '../axe.mjs';
import { Browser } from '../driver.mjs';
import { SITE } from '../site.mjs';

const WIDE = { width: 1280, height: 800 };
const PHONE = { width: 390, height: 844, touch: true };
const PAGES = readdirSync(path.join(SITE, 'docs')).filter((name) => name.endsWith('.html'));
const ALL = [...PAGES.map((name) => `docs/${name}`), '404.html'];

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

test('a page, its style and its scripts weigh at most 60 KB', () => {
  assert.ok(PAGES.length > 10);
  const weight = (/** @type {string} */ name) => brotliCompressSync(readFileSync(path.join(SITE, name))).length;
  const shared = weight('web/docs/main.css') + weight('web/docs/main.js');
  for (const page of ALL) assert.ok(weight(page) + shared <= 60_000, `${page}: ${weight(page) + shared} bytes`);
});

for (const [device, size] of /** @type {const} */ ([
  ['a wide window', WIDE],
  ['a phone', PHONE],
])) {
  test(`each page fits ${device}, has no violation and no problem, and fetches nothing of the fire`, async () => {
    for (const page of ALL) {
      const tab = await browser.open(page, size);
      await tab.until('the search', () => !document.querySelector('form').hidden);
      const { open, wide, fetched } = await tab.evaluate(() => ({
        open: document.querySelector('details')?.open,
        wide: document.documentElement.scrollWidth - window.innerWidth,
        fetched: performance.getEntriesByType('resource').map(({ name }) => name),
      }));
      assert.equal(open, size === WIDE, page);
      assert.ok(wide <= 0, `${page} is ${wide} pixels too wide`);
      assert.deepEqual(
        fetched.filter((name) => /hearth-|\.wasm|search\.json/.test(name)),
        [],
      );
      assert.deepEqual(await violations(tab), [], page);
      assert.deepEqual(tab.problems, [], page);
    }
  });
}

test('one example burns at a time, under the policy of the page', async () => {
  const tab = await browser.open('docs/embedding.html', PHONE);
  const runs = () => tab.page.$$('.example button:not([hidden])');
  await tab.until('the buttons', () => document.querySelector('.example button:not([hidden])'));
  const [first, second] = await runs();
  await first.click();
  await tab.burnt(0.1);
  assert.deepEqual(await tab.fire(({ preset, clientWidth, style }) => [preset, clientWidth > 300, style.height]), [
    'fireside',
    true,
    '480px',
  ]);
  assert.equal(await tab.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false);
  assert.deepEqual(await violations(tab), []);
  await second.click();
  assert.deepEqual(
    await tab.evaluate(() => [...document.querySelectorAll('.example button')].map(({ textContent }) => textContent)),
    ['Run', 'Stop', ...Array((await runs()).length - 2).fill('Run')],
  );
  assert.equal(await tab.evaluate(() => document.querySelectorAll('.burning').length), 1);
  await second.click();
  assert.equal(await tab.evaluate(() => document.querySelectorAll('hearth-fire').length), 0);
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});

test('an example whose code does not load says so', async () => {
  const tab = await browser.open('docs/embedding.html', { ...WIDE, without: 'hearth-fire.js' });
  await tab.until('the buttons', () => document.querySelector('.example button:not([hidden])'));
  await tab.page.click('.example button');
  await tab.until('the message', () => document.querySelector('.burning')?.textContent?.includes('did not load'));
});

test('the search finds what is typed, and its first result leads there', async () => {
  const tab = await browser.open('docs/index.html', PHONE);
  await tab.until('the search', () => !document.querySelector('form').hidden);
  await tab.page.type('input', 'wind');
  await tab.until('the results', () => document.querySelectorAll('#found li').length > 3);
  const marked = await tab.evaluate(() => [...document.querySelectorAll('#found mark')].map((it) => it.textContent));
  assert.ok(
    marked.every((text) => text?.toLowerCase() === 'wind'),
    `${marked}`,
  );
  assert.deepEqual(await violations(tab), []);
  await tab.page.click('#found a');
  await tab.until('the section', () => location.hash && document.querySelector(location.hash)?.checkVisibility());
  assert.deepEqual(tab.problems, []);
});
