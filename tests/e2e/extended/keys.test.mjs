/**
 * Keyboard shortcuts of the page: they act wherever the focus is, except in text fields
 * and on controls that use the key.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { Panel, actionOf, along, controlOf } from '../panel.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** @param {() => void} [before] */
async function openPage(before) {
  const tab = await browser.open('index.html?scene=default', { width: 760, height: 600, before });
  await tab.burnt(0.3);
  return { tab, panel: await new Panel(tab).mounted() };
}

const paused = (tab) => tab.fire((fire) => fire.paused);

/**
 * Runs in the page: what is saved counts in `window.saved`; `window.focused` is what has the focus once a dialog has
 * closed, before the next frame.
 */
function countSaved() {
  const page = /** @type {any} */ (window);
  page.saved = 0;
  const { close } = HTMLDialogElement.prototype;
  HTMLDialogElement.prototype.close = function closed() {
    close.call(this);
    queueMicrotask(() => {
      page.focused = document.activeElement?.tagName;
    });
  };
  HTMLAnchorElement.prototype.click = () => {
    page.saved += 1;
  };
}

test('keys act after a press of a button of the page', async () => {
  const { tab } = await openPage();
  await tab.page.click('#speaker');
  await tab.until('the sound is on', () => /** @type {any} */ (document.getElementById('fire')).sound > 0);
  assert.equal(await tab.evaluate(() => document.activeElement?.id), 'speaker');
  await tab.page.keyboard.press('m');
  // The code of the button is loaded on request.
  await tab.until('the sound is off', () => /** @type {any} */ (document.getElementById('fire')).muted);
});

test('space pauses and plays the fire, R restarts it', async () => {
  const { tab, panel } = await openPage();
  // With the focus nowhere, on egui, and on an accessible slider.
  for (const focus of [
    async () => {},
    async () => tab.click(along(await panel.reveal('buoyancy'), 0.5)),
    () => tab.page.focus(controlOf('buoyancy')),
  ]) {
    await focus();
    await tab.key('Space');
    assert.equal(await paused(tab), true);
    await tab.key('Space');
    assert.equal(await paused(tab), false);
  }
  const time = await tab.fire((fire) => fire.stats.time);
  await tab.key('r');
  await tab.until(
    'the fire has restarted',
    (old) => /** @type {any} */ (document.querySelector('hearth-fire')).stats.time < old,
    time,
  );
  assert.deepEqual(tab.problems, []);
});

test('plus and minus enlarge and reduce the picture, Shift and arrow keys move it, 0 shows all of it', async () => {
  const { tab } = await openPage();
  const withShift = async (key) => {
    await tab.page.keyboard.down('Shift');
    await tab.key(key);
    await tab.page.keyboard.up('Shift');
  };
  const camera = () => tab.fire(({ zoom, pan }) => [zoom, ...pan.split(' ').map(Number)]);
  await withShift('ArrowRight');
  assert.deepEqual(await camera(), [1, 0], 'the whole picture does not move');
  await tab.key('+');
  assert.deepEqual(await camera(), [1.25, 0.5, 0.25]);
  for (let press = 0; press < 12; press += 1) await tab.key('+');
  assert.deepEqual(await camera(), [10, 0.5, 0.25]);
  await withShift('ArrowLeft');
  await withShift('ArrowUp');
  const [zoom, x, y] = await camera();
  assert.ok(zoom === 10 && x < 0.5 && x > 0.48 && y > 0.25 && y < 0.27, `${x} ${y}`);
  await tab.key('-');
  assert.equal((await camera())[0], 8);
  await tab.key('0');
  assert.deepEqual(await tab.fire((fire) => [fire.zoom, fire.hasAttribute('zoom'), fire.hasAttribute('pan')]), [
    1,
    false,
    false,
  ]);
  assert.deepEqual(tab.problems, []);
});

test('S asks how to save a picture and Enter saves it, F enters and leaves full screen', async () => {
  const { tab } = await openPage(countSaved);
  await tab.key('s');
  const isAsked = () => document.activeElement?.shadowRoot?.activeElement?.matches('[name="save"]');
  await tab.until('the question', isAsked);
  await tab.key('Enter');
  await tab.until('a picture', () => /** @type {any} */ (window).saved === 1);
  assert.equal(await tab.evaluate(() => /** @type {any} */ (window).focused), 'BODY', 'the next key is for the page');
  await tab.key('f');
  await tab.until('all of the screen', () => document.fullscreenElement === document.documentElement);
  await tab.key('f');
  await tab.until('the window', () => document.fullscreenElement === null);
  assert.deepEqual(tab.problems, []);
});

test('with the panel hidden since the visit before, its keys work', async () => {
  const options = { width: 760, height: 600, before: () => localStorage.setItem('hearth-page-panel', 'hidden') };
  for (const [key, done] of /** @type {[string, () => unknown][]} */ ([
    ['+', () => /** @type {any} */ (document.querySelector('hearth-fire')).zoom > 1],
    ['s', () => document.querySelector('.hearth-recorder')?.shadowRoot?.querySelector('dialog')?.open],
    ['?', () => document.querySelector('[data-card="help"]')?.checkVisibility()],
  ])) {
    const tab = await browser.open('index.html?scene=default', options);
    await tab.ready();
    assert.equal(await tab.evaluate(() => document.documentElement.dataset.panel), 'hidden');
    await tab.key(key);
    await tab.until(key, done);
    assert.deepEqual(tab.problems, []);
  }
});

test('the question mark lists every key; it or Escape closes the list', async () => {
  const { tab } = await openPage();
  const listed = () =>
    tab.evaluate(() => [...document.querySelectorAll('[data-card="help"] kbd')].map((key) => key.textContent));
  for (const leave of ['?', 'Escape']) {
    await tab.key('?');
    for (const key of ['Space', 'F', 'Ctrl Z', '/']) assert.ok((await listed()).includes(key), key);
    await tab.key(leave);
    assert.deepEqual(await listed(), []);
  }
  assert.equal(await tab.evaluate(() => document.activeElement?.tagName), 'BODY');
});

test('keys that type or press something do only that', async () => {
  const { tab, panel } = await openPage(countSaved);
  const untouched = async (what) => {
    await tab.frames(6);
    assert.equal(await paused(tab), false, what);
    assert.equal(await tab.evaluate(() => /** @type {any} */ (window).saved), 0, what);
    assert.equal(await tab.page.$('[data-card="help"]'), null, what);
    assert.equal(await tab.page.$eval('#panel', (host) => host.checkVisibility()), true, what);
  };
  await tab.click(along(await panel.rectangleOf('search'), 0.5));
  await tab.page.keyboard.type('s h?');
  await untouched('typed into the search');
  await tab.page.focus(controlOf('background'));
  await tab.page.keyboard.type('s h?');
  await untouched('typed into an accessible field');
  await tab.page.focus(controlOf('model'));
  await tab.key('s');
  await untouched('a choice');
  await tab.page.focus(actionOf('paste'));
  await tab.key('Enter');
  await tab.page.keyboard.type('s h? ');
  assert.equal(await tab.page.$eval('.hearth-card textarea', (field) => /** @type {any} */ (field).value), 's h? ');
  await untouched('typed into a card');
  await tab.key('Escape');
  const at = await tab.fire((fire) => fire.stats.time);
  await tab.page.focus(actionOf('reset'));
  await tab.key('Space');
  await tab.until(
    'the button was pressed',
    (old) => /** @type {any} */ (document.querySelector('hearth-fire')).stats.time < old,
    at,
  );
  await untouched('space on a button');
  // Of the browser's own.
  await tab.page.keyboard.down('Alt');
  await tab.page.keyboard.press('s');
  await tab.page.keyboard.up('Alt');
  await untouched('with another key');
});
