/**
 * The gallery. Its cards, texts and links are tested in `pages` of `xtask`, the files of its scenes in `codegen`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { violations } from '../axe.mjs';
import { Browser } from '../driver.mjs';

const SIZES = /** @type {const} */ ([
  ['a wide window', { width: 1280, height: 800 }],
  ['a phone', { width: 390, height: 844, touch: true }],
]);

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** @typedef {import('../driver.mjs').Tab} Tab */

/** The names of the scenes that burn. @param {Tab} tab */
const burning = (tab) =>
  tab.evaluate(() =>
    [...document.querySelectorAll('hearth-fire')].map((fire) => {
      const { scene, community } = /** @type {HTMLElement} */ (fire.closest('.card')).dataset;
      return scene ?? community;
    }),
  );

/** @param {string} scene */
const picture = (scene) => `[data-scene="${scene}"] .still`;

/** The files of a fire that the page has fetched. @param {Tab} tab */
const fetched = (tab) =>
  tab.evaluate(() =>
    performance
      .getEntriesByType('resource')
      .map(({ name }) => name)
      .filter((name) => /hearth-|\.wasm|community\/.*json/.test(name)),
  );

for (const [device, size] of SIZES) {
  test(`in ${device} the gallery fits, has no violation, and fetches nothing of a fire before a card burns`, async () => {
    const tab = await browser.open('gallery.html', size);
    await tab.until('the search', () => !document.querySelector('[role="search"]').hidden);
    const wide = () => tab.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    assert.ok((await wide()) <= 0);
    assert.deepEqual(await violations(tab), []);
    assert.deepEqual(await fetched(tab), []);
    await tab.page.click(picture('candle'));
    await tab.burnt(0.1);
    assert.deepEqual(await burning(tab), ['candle']);
    assert.ok((await wide()) <= 0);
    assert.deepEqual(await violations(tab), []);
    assert.deepEqual(tab.problems, []);
  });
}

test('one card burns while the pointer or the focus is on it, and goes on after a press', async () => {
  const tab = await browser.open('gallery.html', SIZES[0][1]);
  await tab.page.hover(picture('campfire'));
  await tab.until('the fire', () => document.querySelector('[data-scene="campfire"] hearth-fire'));
  await tab.page.hover(picture('candle'));
  await tab.until('the other fire', () => document.querySelector('[data-scene="candle"] hearth-fire'));
  assert.deepEqual(await burning(tab), ['candle']);
  await tab.page.hover('h1');
  assert.deepEqual(await burning(tab), []);
  await tab.page.click(picture('candle'));
  // At the edge of the window no picture comes under the pointer when focus scrolls the page.
  await tab.page.mouse.move(1, 400);
  assert.deepEqual(await burning(tab), ['candle']);
  assert.equal(await tab.page.$eval(picture('candle'), (it) => it.getAttribute('aria-pressed')), 'true');
  // By keys: the next control after the links of a card is the next picture.
  await tab.page.focus('[data-scene="candle"] .acts a:last-child');
  await tab.page.keyboard.press('Tab');
  const [focused] = await burning(tab);
  assert.ok(focused && focused !== 'candle');
  await tab.page.keyboard.press('Escape');
  assert.deepEqual(await burning(tab), []);
  assert.deepEqual(tab.problems, []);
});

test('under reduced motion a card burns from one press to the next alone', async () => {
  const tab = await browser.open('gallery.html', { ...SIZES[0][1], reducedMotion: true });
  await tab.page.focus(picture('campfire'));
  await tab.page.hover(picture('candle'));
  // A press that follows is later than any fire of the pointer would be.
  await tab.page.click(picture('torch'));
  await tab.burnt(0.1);
  assert.deepEqual(await burning(tab), ['torch']);
  await tab.page.click(picture('torch'));
  assert.deepEqual(await burning(tab), []);
  assert.deepEqual(tab.problems, []);
});

test('a filter shows the cards of its group alone', async () => {
  const tab = await browser.open('gallery.html', SIZES[1][1]);
  const shown = () =>
    tab.evaluate(() =>
      [...document.querySelectorAll('.card')].filter((card) => card.checkVisibility()).map((card) => card.className),
    );
  const all = await shown();
  await tab.page.click('[value="words"]');
  const words = await shown();
  assert.ok(words.length > 2 && words.length < all.length);
  assert.ok(
    words.every((name) => name.split(' ').includes('words')),
    `${words}`,
  );
});

test('a scene of the community burns, copies its HTML, and opens with the panel', async () => {
  const tab = await browser.open('gallery.html', SIZES[0][1]);
  const name = await tab.page.$eval('[data-community]', (card) => card.dataset.community);
  await tab.page.click(`[data-community="${name}"] .still`);
  await tab.burnt(0.1);
  assert.deepEqual(await burning(tab), [name]);
  await tab.page.click('[data-community] [data-act="copy"]');
  await tab.until('the words about the copy', () => document.getElementById('status')?.textContent);
  assert.match(
    await tab.page.$eval('#copy', (field) => field.value),
    /^<script type="module".*\n<hearth-fire\n[\s\S]* objects="/,
  );
  await tab.until('the link', () => document.querySelector('[data-community] .acts a')?.hash);
  const link = await tab.page.$eval('[data-community] .acts a:nth-of-type(2)', (it) => it.href);
  assert.deepEqual(tab.problems, []);
  const { pathname, search, hash } = new URL(link);
  const landing = await browser.open(`${pathname.slice(1)}${search}${hash}`, SIZES[0][1]);
  await landing.ready();
  assert.equal(await landing.evaluate(() => document.documentElement.dataset.panel), 'shown');
  const { objects } = await landing.evaluate(async (file) => (await fetch(file)).json(), `community/${name}.json`);
  await landing.until(
    'the scene',
    (/** @type {string} */ kinds) =>
      document
        .querySelector('hearth-fire')
        .objects.map(({ kind }) => kind)
        .join() === kinds,
    objects.map(({ kind }) => kind).join(),
  );
  assert.deepEqual(landing.problems, []);
});

test('a link to films opens their dialog over the scene', async () => {
  const tab = await browser.open('index.html?scene=candle&open=save', SIZES[0][1]);
  const open = () => document.querySelector('.hearth-recorder')?.shadowRoot?.querySelector('dialog')?.open;
  await tab.until('the dialog', open);
  assert.equal(await tab.fire((fire) => fire.preset), 'candle');
  await tab.until('the address without it', () => !location.search.includes('open'));
  assert.deepEqual(tab.problems, []);
});
