/**
 * The cards of lessons, under the policy of their page. That their numbers move as their texts say is tested in
 * `tests/tests/lessons.rs`, what a link and a slider set in `tests/web/lessons.test.mjs`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { violations } from '../axe.mjs';
import { Browser } from '../driver.mjs';

const WIDE = { width: 1280, height: 800 };
const PHONE = { width: 390, height: 844, touch: true };

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** @typedef {import('../driver.mjs').Tab} Tab */

/** The numbers of both fires, once there are two. @param {Tab} tab @returns {Promise<number[]>} */
const numbers = (tab) =>
  tab.until('the numbers', () => {
    const shown = [...document.querySelectorAll('figcaption strong')].map((it) =>
      Number.parseFloat(it.textContent ?? ''),
    );
    return shown.length === 2 && shown.every(Number.isFinite) && shown;
  });

const fires = (/** @type {Tab} */ tab) => tab.evaluate(() => document.querySelectorAll('hearth-fire').length);

/** Opens a card. @param {Tab} tab @param {string} id */
async function light(tab, id) {
  const button = `#${id} ~ .card button`;
  await tab.until('the button', (at) => !document.querySelector(at).hidden, button);
  await tab.page.$eval(button, (found) => found.scrollIntoView({ block: 'center' }));
  await tab.page.click(button);
}

test('a card burns two fires, its slider moves the number of one by keys, and another card ends it', async () => {
  const tab = await browser.open('docs/learn.html', WIDE);
  assert.equal(await fires(tab), 0);
  await light(tab, 'fuel-and-air');
  const [a, b] = await numbers(tab);
  assert.ok(Math.abs(a - b) < 10, `${a} and ${b} cm of the same fire`);
  await tab.page.focus('.card.burns input');
  await tab.page.keyboard.press('End');
  await tab.until(
    'a higher flame',
    (least) => Number.parseFloat(document.querySelectorAll('figcaption strong')[1].textContent ?? '') > least,
    a + 50,
  );
  assert.deepEqual(await violations(tab), []);
  for (const toggle of await tab.page.$$('.card.burns [aria-pressed]')) await toggle.click();
  await tab.until('arrows and isotherms over both', () => document.querySelectorAll('.hearth-field path').length >= 8);
  await light(tab, 'wind');
  await numbers(tab);
  assert.deepEqual(
    await tab.evaluate(() => [...document.querySelectorAll('hearth-fire')].map((fire) => fire.getAttribute('wind'))),
    ['0', '0'],
  );
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});

test('the address of a card opens it with its slider on a phone, which it fits', async () => {
  const tab = await browser.open('docs/learn.html#wind=0.5', PHONE);
  await numbers(tab);
  assert.equal(await tab.evaluate(() => document.querySelectorAll('hearth-fire')[1].getAttribute('wind')), '0.5');
  const box = await tab.rectangle('.card.burns .fires');
  assert.ok(box.x >= 0 && box.x + box.width <= PHONE.width, JSON.stringify(box));
  assert.equal(await tab.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false);
  assert.deepEqual(await violations(tab), []);
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});

test('where motion is reduced nothing burns before a press', async () => {
  const tab = await browser.open('docs/learn.html#wind=0.5', { ...WIDE, reducedMotion: true });
  await tab.until('the buttons', () => document.querySelector('.card button:not([hidden])'));
  await tab.frames();
  assert.equal(await fires(tab), 0);
  await light(tab, 'wind');
  await numbers(tab);
});

test('a printed card has a whole picture, its question, then lines to write on, and no answer', async () => {
  const tab = await browser.open('docs/learn.html', WIDE);
  await light(tab, 'gravity');
  await numbers(tab);
  await tab.page.emulateMediaType('print');
  const cards = await tab.evaluate(() =>
    [...document.querySelectorAll('.card')].map((card) => {
      const image = /** @type {HTMLImageElement} */ (card.querySelector('img'));
      const shown = (/** @type {string} */ at) =>
        [...card.querySelectorAll(at)].filter((it) => it.checkVisibility()).length;
      const [question, lines] = [card.nextElementSibling, card.nextElementSibling?.nextElementSibling];
      const [picture, asked, written] = [card, question, lines].map((part) => part?.getBoundingClientRect());
      return [
        image.complete && image.naturalWidth > 0,
        shown('img'),
        shown('hearth-fire, button'),
        /^Question\./.test(question?.textContent ?? ''),
        lines?.querySelectorAll('.line').length,
        picture &&
          asked &&
          written &&
          picture.bottom <= asked.top &&
          asked.bottom <= written.top &&
          written.height > 100,
      ];
    }),
  );
  assert.deepEqual(cards, Array(6).fill([true, 1, 0, true, 4, true]));
  assert.equal(
    await tab.evaluate(() => [...document.querySelectorAll('details')].some((it) => it.checkVisibility())),
    false,
  );
  assert.deepEqual(tab.problems, []);
});
