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

const dialog = (name) => async (tab) => {
  await tab.page.click(`[data-opens="${name}"]`);
  await tab.until('the dialog', () => document.querySelector('dialog[open]') !== null);
};
const leave = (tab) => tab.key('Escape');
const openPanel = async (tab) => void (await new Panel(tab).mounted());

for (const [
  about,
  size,
  states,
] of /** @type {[string, typeof WIDE, [string, (tab: any) => Promise<unknown>][]][]} */ ([
  [
    'on a screen',
    WIDE,
    [
      ['with its panel', openPanel],
      [
        'with the scenes of the panel',
        async (tab) => {
          await new Panel(tab).openScenes();
        },
      ],
      [
        'with what Hearth is',
        async (tab) => {
          await tab.page.click('[data-card="close"]');
          await dialog('about')(tab);
        },
      ],
      [
        'with the code to embed it',
        async (tab) => {
          await leave(tab);
          await dialog('embed')(tab);
        },
      ],
      [
        'with its tools',
        async (tab) => {
          await leave(tab);
          await tools(tab);
        },
      ],
    ],
  ],
  [
    'on a phone',
    PHONE,
    [
      ['as it is', async () => {}],
      [
        'whose links have stepped back',
        (tab) => tab.until('the links step back', () => document.documentElement.dataset.chrome === 'back'),
      ],
      ['with the sheet', openPanel],
    ],
  ],
  ['on a phone, with its tools', PHONE, [['', tools]]],
  ['on a phone that lies', LYING, [['as it is', async () => {}]]],
])) {
  test(`the page ${about}`, async () => {
    const tab = await browser.open('index.html?paused', size);
    await tab.ready();
    await strip(tab);
    for (const [state, act] of states) {
      await act(tab);
      assert.deepEqual(await violations(tab), [], state);
    }
  });
}

test('the page whose fire cannot burn', async () => {
  const tab = await browser.open('index.html', { ...WIDE, without: 'hearth-engine_bg.wasm' });
  await tab.until('words', () =>
    /\S/.test(document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.message')?.textContent ?? ''),
  );
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
    await tab.until(
      'its first picture',
      () =>
        document.querySelector('hearth-fire')?.shadowRoot?.querySelector('[data-drawn]') ??
        !document.querySelector('hearth-fire'),
    );
    assert.deepEqual(await violations(tab), []);
  });
}
