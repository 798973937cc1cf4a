/**
 * The scenes that a visitor saves, whose list `tests/web/own-scenes.test.mjs` tests. Files of settings are opened where
 * they are dropped.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { openTools } from '../tools.mjs';
import { Panel } from '../panel.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

async function openCard(query = 'scene=candle&paused', options = {}) {
  const tab = await browser.open(`index.html?${query}`, { width: 1000, height: 700, ...options });
  await tab.ready();
  const panel = await new Panel(tab).mounted();
  await panel.openScenes();
  return { tab, panel };
}

const named = (tab, list) =>
  tab.until(
    `the scenes ${list}`,
    (wanted) =>
      [...document.querySelectorAll('.hearth-own input')]
        .map((input) => /** @type {HTMLInputElement} */ (input).value)
        .join() === wanted,
    list.join(),
  );
const press = (tab, label) => tab.page.click(`[aria-label="${label}"]`);
const rename = (tab, from, to) =>
  tab.evaluate(
    ([label, value]) => {
      const input = /** @type {HTMLInputElement} */ (document.querySelector(`[aria-label="Name of ${label}"]`));
      input.value = value;
      input.dispatchEvent(new Event('change'));
    },
    [from, to],
  );

test('a saved fire is in the list with its picture, and is shown again after other scenes', async () => {
  const { tab } = await openCard();
  await tab.fire((fire) => fire.set({ wind: 0.7 }));
  const config = await tab.fire((fire) => fire.exportConfig());
  await tab.page.click('[data-card="save"]');
  await named(tab, ['Candle']);
  assert.match(await tab.page.$eval('.hearth-own img', (image) => image.src), /^data:image\/jpeg/);
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

/** Drops a file on an element. */
const drop = (tab, selector, file) =>
  tab.evaluate(
    ([where, { name, type, text }]) => {
      const data = new DataTransfer();
      data.items.add(new File([text], name, { type }));
      const target = /** @type {Element} */ (document.querySelector(where));
      const options = { dataTransfer: data, bubbles: true, composed: true, cancelable: true };
      const over = new DragEvent('dragover', options);
      target.dispatchEvent(over);
      const event = new DragEvent('drop', options);
      target.dispatchEvent(event);
      return [over.defaultPrevented, event.defaultPrevented];
    },
    [selector, file],
  );
const messaged = (tab, pattern) =>
  tab.until(
    `the message ${pattern}`,
    (source) =>
      [...document.querySelectorAll('.hearth-controls :is([role=status], [role=alert])')].some(({ textContent }) =>
        new RegExp(source).test(textContent ?? ''),
      ),
    pattern.source,
  );
const settings = (wind, preset = 'candle') => JSON.stringify({ hearth: 3, preset, values: { wind } });
const blows = (tab, wind) =>
  tab.until(
    `a wind of ${wind}`,
    (wanted) => Math.abs(/** @type {any} */ (document.querySelector('hearth-fire')).params.wind - wanted) < 0.01,
    wind,
  );

test('a file of settings that is dropped anywhere on the page is opened, and any other file is refused with a message', async () => {
  const tab = await browser.open('index.html?scene=candle&paused', { width: 1000, height: 700 });
  await tab.ready();
  await new Panel(tab).mounted();
  let wind = 0.1;
  for (const selector of ['hearth-fire', '.hearth-panel canvas', 'body']) {
    wind += 0.1;
    const file = { name: 'mine.json', type: 'application/json', text: settings(wind) };
    assert.deepEqual(await drop(tab, selector, file), [true, true], selector);
    await blows(tab, wind);
  }
  const config = await tab.fire((fire) => fire.exportConfig());
  for (const [selector, file, words] of [
    ['body', { name: 'notes.txt', type: 'text/plain', text: settings(0) }, /“notes.txt” is no file of settings/],
    ['#panel', { name: 'mine.json', type: '', text: '{"hearth": 3, "values": {"wind": 99}}' }, /wind/],
  ]) {
    assert.deepEqual(await drop(tab, selector, file), [true, true], file.name);
    await messaged(tab, words);
    assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), config);
  }
  // The element warns of settings that it refuses.
  assert.deepEqual(
    tab.problems.filter((problem) => !/ is refused: /.test(problem)),
    [],
  );
});

test('with an open toolbar a dropped file is opened once, and the toolbar keeps its pictures', async () => {
  const tab = await openTools(browser, { width: 1280, height: 800 });
  await new Panel(tab).mounted();
  await drop(tab, '.hearth-overlay', { name: 'mine.json', type: '', text: settings(0.6) });
  await blows(tab, 0.6);
  await tab.page.click('[data-tool="undo"]');
  await blows(tab, 0);
  await tab.until(
    'no other step',
    () => document.querySelector('[data-tool="undo"]')?.getAttribute('aria-disabled') === 'true',
  );
  const disc =
    '<svg xmlns="http://www.w3.org/2000/svg" width="90" height="90"><circle cx="50%" cy="50%" r="40%"/></svg>';
  await drop(tab, '.hearth-overlay', { name: 'disc.svg', type: 'image/svg+xml', text: disc });
  await tab.until('a mask', () =>
    /** @type {any} */ (document.querySelector('hearth-fire')).objects.some(({ shape }) => shape === 'mask'),
  );
  await drop(tab, '.hearth-overlay', { name: 'notes.txt', type: 'text/plain', text: '' });
  await tab.until('the words of the toolbar', () =>
    /“notes.txt” is no image/.test(document.querySelector('.hearth-status')?.textContent ?? ''),
  );
  assert.equal(await tab.evaluate(() => /no file of settings/.test(document.body.textContent ?? '')), false);
  assert.deepEqual(tab.problems, []);
});

test('a fire with controls opens a file that is dropped on it, and leaves other drops to the page', async () => {
  const tab = await browser.open(
    '<p id="other">A page</p><hearth-fire controls paused preset="candle" style="width: 700px; height: 500px"></hearth-fire>',
    { width: 740, height: 600 },
  );
  await tab.ready();
  await new Panel(tab, { inside: true }).mounted();
  assert.deepEqual(await drop(tab, 'hearth-fire', { name: 'mine.json', type: '', text: settings(0.6) }), [true, true]);
  await blows(tab, 0.6);
  assert.deepEqual(await drop(tab, '#other', { name: 'mine.json', type: '', text: settings(0.2) }), [false, false]);
  await tab.frames();
  assert.ok(await tab.fire((fire) => fire.params.wind > 0.5));
  assert.deepEqual(tab.problems, []);
});
