/**
 * axe-core finds no violation on any page, with any dialog open. Contrast of text over a
 * picture, which axe-core cannot compute, is tested elsewhere.
 */
import assert from 'node:assert/strict';
import { readdir } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { violations } from '../axe.mjs';
import { Browser } from '../driver.mjs';
import { Panel } from '../panel.mjs';
import { SITE } from '../site.mjs';
import { strip } from '../waits.mjs';

const WIDE = { width: 1000, height: 640 };
const PHONE = { width: 360, height: 640, touch: true };
const LYING = { width: 740, height: 360, touch: true };

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** Shows the tools, and their form for a word. @param {import('../driver.mjs').Tab} tab */
async function tools(tab) {
  await tab.page.waitForSelector('#draw:not([hidden])');
  await tab.page.click('#draw');
  await tab.page.waitForSelector('[data-tool="text"]');
  await tab.page.click('[data-tool="text"]');
  const stage = await tab.rectangle('#fire');
  await tab.click({ x: stage.x + stage.width / 2, y: stage.y + stage.height / 3 });
  await tab.page.waitForSelector('.hearth-text');
}

for (const [about, size, act] of [
  ['with its panel', WIDE, (tab) => new Panel(tab).mounted()],
  ['with the scenes of the panel', WIDE, async (tab) => (await new Panel(tab).mounted()).openScenes()],
  ['with what Hearth is', WIDE, (tab) => tab.page.click('[data-opens="about"]')],
  ['with the code to embed it', WIDE, (tab) => tab.page.click('[data-opens="embed"]')],
  ['with its tools', WIDE, tools],
  ['on a phone, with its tools', PHONE, tools],
  ['on a phone', PHONE, () => {}],
  ['on a phone, with the sheet', PHONE, (tab) => new Panel(tab).mounted()],
  ['on a phone that lies', LYING, () => {}],
  ['whose links have stepped back', PHONE, (tab) => (
    tab.until('the links step back', () => document.documentElement.dataset.chrome === 'back')
  )],
]) {
  test(`the page ${about}`, async () => {
    const tab = await browser.open('index.html?paused', size);
    await tab.ready();
    await strip(tab);
    await act(tab);
    await tab.until('a dialog that was asked for', (wanted) => (
      !wanted || document.querySelector('dialog[open]') !== null
    ), /what Hearth|the code/.test(about));
    assert.deepEqual(await violations(tab), []);
  });
}

test('the page whose fire cannot burn', async () => {
  const tab = await browser.open('index.html', { ...WIDE, without: 'hearth-engine_bg.wasm' });
  await tab.until('words', () => (
    /\S/.test(document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.message')?.textContent ?? '')
  ));
  assert.deepEqual(await violations(tab), []);
});

test('the page with reduced motion', async () => {
  const tab = await browser.open('index.html', { ...WIDE, reducedMotion: true });
  await tab.ready();
  await strip(tab);
  assert.deepEqual(await violations(tab), []);
});

const examples = (await readdir(path.join(SITE, 'examples'))).filter((name) => name.endsWith('.html'));
for (const page of ['web/embed.html', ...examples.map((name) => `examples/${name}`)]) {
  test(page, async () => {
    const tab = await browser.open(page, WIDE);
    await tab.until('its first picture', () => document.querySelector('hearth-fire')?.shadowRoot
      ?.querySelector('[data-drawn]') ?? !document.querySelector('hearth-fire'));
    assert.deepEqual(await violations(tab), []);
  });
}
