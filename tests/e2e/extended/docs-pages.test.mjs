/**
 * The pages of the documentation. What the build puts into them is tested in `pages` of `xtask`, the search in
 * `tests/web/docs-search.test.mjs`, what an example may contain in `tests/web/docs-markup.test.mjs`.
 */
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { brotliCompressSync } from 'node:zlib';
import { violations } from '../axe.mjs';
import { Browser } from '../driver.mjs';
import { HOSTILE } from '../../hostile-examples.mjs';
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

/** Runs in the page: the buttons of the examples with this label. @param {string} label */
const press = (label, at = 0) => {
  const buttons = [...document.querySelectorAll('.example button')].filter(({ textContent }) => textContent === label);
  /** @type {HTMLButtonElement} */ (buttons[at]).click();
};
const running = () =>
  [...document.querySelectorAll('.example')].map((example) => example.querySelector('button')?.textContent === 'Stop');

test('one example burns at a time, under the policy of the page', async () => {
  const tab = await browser.open('docs/embedding.html', PHONE);
  await tab.until('the buttons', () => document.querySelector('.example button'));
  await tab.evaluate(press, 'Run');
  await tab.burnt(0.1);
  assert.deepEqual(await tab.fire(({ preset, clientWidth, style }) => [preset, clientWidth > 300, style.height]), [
    'fireside',
    true,
    '480px',
  ]);
  assert.equal(await tab.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false);
  assert.deepEqual(await violations(tab), []);
  // The first of those that do not burn.
  await tab.evaluate(press, 'Run');
  const [first, second, ...others] = await tab.evaluate(running);
  assert.deepEqual([first, second, others.includes(true)], [false, true, false]);
  assert.equal(await tab.evaluate(() => document.querySelectorAll('.burning').length), 1);
  await tab.evaluate(press, 'Stop');
  assert.equal(await tab.evaluate(() => document.querySelectorAll('hearth-fire').length), 0);
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});

test('a reader changes an example: the fire burns on, the address keeps the text, and what is wrong is named', async () => {
  const tab = await browser.open('docs/embedding.html', WIDE);
  await tab.until('the buttons', () => document.querySelector('.example button'));
  await tab.evaluate(press, 'Run');
  await tab.evaluate(press, 'Edit');
  await tab.burnt(0.2);
  const type = async (/** @type {string} */ text) => {
    await tab.page.$eval(
      'textarea',
      (it, value) => {
        it.value = value;
        it.dispatchEvent(new Event('input', { bubbles: true }));
      },
      text,
    );
  };
  const text = await tab.page.$eval('textarea', ({ value }) => value);
  assert.match(text, /^<hearth-fire preset="fireside" warm interactive style=".*"><\/hearth-fire>$/);
  await tab.fire((fire) => void Object.assign(window, { kept: fire }));
  await type(text.replace('warm', 'warm fuel-power="123"').replace('480px', '240px'));
  await tab.until(
    'the value arrives',
    () => /** @type {any} */ (document.querySelector('hearth-fire')).params.fuel_power === 123,
  );
  assert.deepEqual(
    await tab.fire((fire) => [fire === /** @type {any} */ (window).kept, fire.style.width, fire.stats.time >= 0.2]),
    [true, '240px', true],
  );
  await tab.until('the address', () => decodeURIComponent(location.hash).includes('fuel-power="123"'));
  await type(text.replace('warm', 'onclick="f()"'));
  assert.match(await tab.page.$eval('.example [role="status"]', ({ textContent }) => textContent ?? ''), /"onclick"/);
  assert.equal(await tab.fire((fire) => fire === /** @type {any} */ (window).kept), true);
  assert.deepEqual(await violations(tab), []);
  // A reader comes by the address, in which the last text that was typed stands.
  await type(text.replace('fireside', 'candle'));
  await tab.until('the address', () => location.hash.includes('candle'));
  await tab.page.reload();
  await tab.until('the text', () => document.querySelector('textarea')?.value.includes('preset="candle"'));
  assert.equal(
    await tab.evaluate(() => document.querySelectorAll('hearth-fire').length),
    0,
    'no address runs anything',
  );
  await tab.evaluate(press, 'Run');
  await tab.burnt(0.1);
  assert.equal(await tab.fire(({ preset }) => preset), 'candle');
  await tab.evaluate(press, 'Original');
  assert.equal(await tab.evaluate(() => location.hash + document.querySelectorAll('textarea').length), '0');
  await tab.until('the scene', () => /** @type {any} */ (document.querySelector('hearth-fire')).preset === 'fireside');
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});

test('no text of an address runs, leaves the site or makes an element that is not allowed', async () => {
  const tab = await browser.open('docs/embedding.html', WIDE);
  await tab.until('the buttons', () => document.querySelector('.example button'));
  await tab.evaluate(() => performance.clearResourceTimings());
  for (const [text] of HOSTILE) {
    await tab.evaluate((code) => {
      location.hash = `edit-1=${encodeURIComponent(code)}`;
    }, text);
    await tab.until(
      'the text is there',
      (code) => document.querySelector('textarea')?.value === code,
      text.replaceAll('\r', ''),
    );
    const before = await tab.evaluate(() => document.querySelectorAll('*').length);
    await tab.evaluate(press, 'Run');
    const { after, ran, status } = await tab.evaluate(() => ({
      after: document.querySelectorAll('*').length,
      ran: 'ran' in window,
      status: document.querySelector('.example [role="status"]')?.textContent,
    }));
    assert.deepEqual([after, ran], [before, false], text);
    assert.notEqual(status, '', text);
  }
  assert.deepEqual(await tab.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name)), []);
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});

test('an example whose code does not load says so', async () => {
  const tab = await browser.open('docs/embedding.html', { ...WIDE, without: 'hearth-fire.js' });
  await tab.until('the buttons', () => document.querySelector('.example button'));
  await tab.evaluate(press, 'Run');
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
