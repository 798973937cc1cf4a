/** The scenes that a visitor saves: they outlive the visit, and what goes wrong is told in words. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from './driver.mjs';
import { Panel } from './panel.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

async function openCard(query = 'scene=candle&paused', options = {}) {
  const tab = await browser.open(`index.html?${query}`, { width: 1000, height: 700, ...options });
  await tab.ready();
  const panel = await new Panel(tab).mounted();
  await panel.openScenes();
  return { tab, panel };
}

const names = (tab) => tab.evaluate(() => [...document.querySelectorAll('.hearth-own input')].map((one) => /** @type {HTMLInputElement} */ (one).value));
const named = (tab, list) => tab.until(`the scenes ${list}`, (wanted) => (
  [...document.querySelectorAll('.hearth-own input')].map((one) => /** @type {HTMLInputElement} */ (one).value).join() === wanted
), list.join());
const alerted = (tab, pattern) => tab.until(`${pattern}`, (source) => (
  new RegExp(source).test(document.querySelector('.hearth-own + [role=alert]')?.textContent ?? '')
), pattern.source);
const press = (tab, label) => tab.page.click(`[aria-label="${label}"]`);
const rename = (tab, from, to) => tab.evaluate(([label, value]) => {
  const input = /** @type {HTMLInputElement} */ (document.querySelector(`[aria-label="Name of ${label}"]`));
  input.value = value;
  input.dispatchEvent(new Event('change'));
}, [from, to]);

test('a saved fire is in the list with its picture, and is shown again after other scenes', async () => {
  const { tab } = await openCard();
  await tab.fire((fire) => fire.set({ wind: 0.7 }));
  const config = await tab.fire((fire) => fire.exportConfig());
  await tab.page.click('[data-card="save"]');
  await named(tab, ['Candle']);
  assert.match(await tab.on('.hearth-own img', (image) => image.src), /^data:image\/jpeg/);
  await tab.page.click('[data-card="save"]');
  await named(tab, ['Candle', 'Candle 2']);
  await rename(tab, 'Candle 2', 'Candle');
  await named(tab, ['Candle', 'Candle 2']);
  await rename(tab, 'Candle 2', '  Draughty  ');
  await named(tab, ['Candle', 'Draughty']);
  await tab.page.click('[data-scene="seed"]');
  await tab.until('another scene', () => /** @type {any} */ (document.querySelector('hearth-fire')).preset === 'seed');
  await press(tab, 'Show Draughty');
  await tab.until('the saved one', () => /** @type {any} */ (document.querySelector('hearth-fire')).params.wind > 0.6);
  assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), config);
  assert.deepEqual(tab.problems, []);
});

test('a list of the visit before is there, and a damaged one is not', async () => {
  for (const [kept, expected] of [
    [JSON.stringify([{ name: 'Mine', config: { hearth: 2, preset: 'torch', values: {} }, picture: 'javascript:alert(1)' }]), ['Mine']],
    ['{"name": 1', []],
    ['[1, null, {"name": 3}, {"name": "x"}]', []],
  ]) {
    const tab = await browser.open('index.html?scene=candle&paused', { width: 1000, height: 700 });
    await tab.evaluate((text) => localStorage.setItem('hearth-scenes', text), kept);
    await tab.ready();
    const panel = await new Panel(tab).mounted();
    await panel.openScenes();
    assert.deepEqual(await names(tab), expected);
    if (expected.length > 0) {
      assert.equal(await tab.on('.hearth-own img', (image) => image.hidden), true);
      await press(tab, 'Show Mine');
      await tab.until('the scene', () => /** @type {any} */ (document.querySelector('hearth-fire')).preset === 'torch');
      assert.equal(await tab.evaluate(() => document.activeElement?.getAttribute('aria-label')), 'Show Mine');
      await press(tab, 'Delete Mine');
      await named(tab, []);
    }
    assert.deepEqual(tab.problems, []);
  }
});

test('storage that is full or forbidden is told, and the list stays', async () => {
  const { tab } = await openCard();
  await tab.page.click('[data-card="save"]');
  await named(tab, ['Candle']);
  for (const [name, pattern] of [['QuotaExceededError', /storage of this site is full/], ['SecurityError', /does not let the page store anything/]]) {
    await tab.evaluate((error) => {
      Storage.prototype.setItem = () => {
        throw new DOMException('', error);
      };
    }, name);
    await tab.page.click('[data-card="save"]');
    await alerted(tab, pattern);
    assert.deepEqual(await names(tab), ['Candle']);
  }
  assert.deepEqual(tab.problems, []);
});
