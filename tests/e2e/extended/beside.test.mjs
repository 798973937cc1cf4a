/**
 * Two fires beside each other on the landing page.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { violations } from '../axe.mjs';
import { Browser } from '../driver.mjs';
import { strip } from '../waits.mjs';

const WIDE = { width: 1280, height: 800 };
const PHONE = { width: 390, height: 844, touch: true };
const BUTTON = '[data-opens="beside"]';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** What is known of both fires, A first. @param {import('../driver.mjs').Tab} tab */
const fires = (tab) =>
  tab.evaluate(() =>
    [...document.querySelectorAll('hearth-fire')].map((element) => {
      const fire = /** @type {any} */ (element);
      const { x, y, width, height } = fire.getBoundingClientRect();
      const { params, preset, zoom } = fire;
      return { x, y, width, height, power: params.fuel_power, preset, zoom };
    }),
  );

/** Acts on B, the fire of the page. @param {import('../driver.mjs').Tab} tab @param {(fire: any) => unknown} act */
const ofPage = (tab, act) => tab.page.$eval('#fire', /** @type {any} */ (act));

/** Waits until all fires pause or play so. @param {import('../driver.mjs').Tab} tab @param {boolean[]} paused */
const wait = (tab, paused) =>
  tab.until(
    `paused: ${paused}`,
    (/** @type {boolean[]} */ wanted) => {
      const all = [...document.querySelectorAll('hearth-fire')].map((fire) => /** @type {any} */ (fire).paused);
      return all.length === wanted.length && all.every((is, at) => is === wanted[at]);
    },
    paused,
  );

/** Waits until both fires burn on. @param {import('../driver.mjs').Tab} tab */
async function burnOn(tab) {
  const before = await tab.evaluate(() =>
    [...document.querySelectorAll('hearth-fire')].map((fire) => /** @type {any} */ (fire).stats?.time ?? 0),
  );
  await tab.until(
    'both burn on',
    (/** @type {number[]} */ times) => {
      const all = [...document.querySelectorAll('hearth-fire')];
      return all.length === 2 && all.every((fire, at) => /** @type {any} */ (fire).stats?.time > times[at]);
    },
    before.length === 2 ? before : [0, 0],
  );
}

test('the present fire stays as A, B goes on beside it, and both pause, enlarge and end together', async () => {
  const tab = await browser.open('index.html?scene=candle&fuel-power=60', WIDE);
  await tab.ready();
  await strip(tab);
  await tab.page.focus(BUTTON);
  await tab.key('Enter');
  await burnOn(tab);
  await ofPage(tab, (fire) => fire.set('fuel_power', 30));
  const [a, b] = await fires(tab);
  assert.deepEqual([a.preset, a.power, b.power], ['candle', 60, 30]);
  assert.ok(
    Math.abs(a.x + a.width - b.x) < 4 && a.y === b.y && Math.abs(a.width - b.width) < 4,
    JSON.stringify({ a, b }),
  );
  assert.deepEqual(await violations(tab), []);
  assert.equal(await tab.page.$eval(BUTTON, (button) => button.getAttribute('aria-pressed')), 'true');

  await tab.page.click('#zoom [data-zooms="in"]');
  await ofPage(tab, (fire) => fire.pause());
  await wait(tab, [true, true]);
  assert.deepEqual(
    (await fires(tab)).map(({ zoom }) => zoom),
    [1.25, 1.25],
  );
  // A preview needs the time of both.
  await ofPage(tab, (fire) => fire.play());
  await burnOn(tab);
  await tab.page.click('[data-opens="embed"]');
  await wait(tab, [true, true, false]);
  await tab.key('Escape');
  await burnOn(tab);

  await tab.page.focus('#kept button');
  await tab.key('Enter');
  const [alone, ...others] = await fires(tab);
  assert.deepEqual([others.length, alone.power], [0, 30]);
  assert.ok(Math.abs(alone.width - a.width - b.width) < 4, 'it has the whole stage');
  assert.deepEqual(
    await tab.evaluate((at) => {
      const button = document.querySelector(at);
      return [button?.getAttribute('aria-pressed'), document.activeElement === button];
    }, BUTTON),
    ['false', true],
  );
  assert.deepEqual(tab.problems, []);
});

test('on a phone A is above B, and the button lets it go', async () => {
  const tab = await browser.open('index.html?scene=candle', PHONE);
  await tab.ready();
  await strip(tab);
  await tab.page.tap(BUTTON);
  await burnOn(tab);
  const [a, b] = await fires(tab);
  assert.ok(a.width === PHONE.width && b.width === PHONE.width, JSON.stringify({ a, b }));
  assert.ok(Math.abs(a.y + a.height - b.y) < 4 && a.height > PHONE.height / 2 - 4, JSON.stringify({ a, b }));
  assert.deepEqual(await violations(tab), []);
  assert.equal(await tab.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false);
  await tab.page.tap(BUTTON);
  await tab.until('B alone', () => document.querySelectorAll('hearth-fire').length === 1);
  assert.deepEqual(tab.problems, []);
});
