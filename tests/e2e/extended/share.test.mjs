/**
 * The panel copies settings as a link, as HTML and as JSON, and imports JSON. Their
 * contents are tested in tests/web/share.test.mjs.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { Panel, actionOf, along } from '../panel.mjs';
import { keepSaved } from '../waits.mjs';

describe('the panel', () => {
  /** @type {Browser} */
  let browser;
  before(async () => {
    // The headless shell has no clipboard.
    browser = await Browser.start({ draws: false });
  });
  after(() => browser?.close());

  const VALUES = { viscosity: 0.02, max_particles: 400, printed_euler: true, background: '#204060' };

  /**
   * The page with a fire that is not the default one, and its panel.
   * @param {{before?: () => void, width?: number, height?: number, touch?: boolean}} [options]
   */
  async function openPage(options = {}) {
    const tab = await browser.open('index.html?scene=classic', {
      width: 760,
      height: 600,
      before: keepCopies,
      ...options,
    });
    await tab.ready();
    await tab.fire((fire, values) => fire.set(values), VALUES);
    const panel = await new Panel(tab).mounted();
    const { config, params } = await tab.fire(async (fire) => ({
      config: await fire.exportConfig(),
      params: fire.params,
    }));
    return { tab, panel, config, params };
  }

  /** Runs in the page: what it copies is in `window.copied` too. */
  function keepCopies() {
    const original = navigator.clipboard.writeText;
    navigator.clipboard.writeText = function writeText(text) {
      /** @type {any} */ (window).copied = text;
      return original.call(this, text);
    };
  }

  /** Presses one of the buttons that copy, and gives what was copied. */
  async function copied(tab, panel, what) {
    await panel.share(`copy:${what}`);
    return tab.until(`the ${what} is copied`, () => /** @type {any} */ (window).copied);
  }

  const paramsOf = (tab) => tab.fire((fire) => fire.params);

  /** Opens the card for settings with the mouse and types into it. */
  async function pasteSettings(tab, panel, text) {
    await panel.share('paste');
    await tab.until('the card is there', () => document.querySelector('[data-card="paste"] textarea'));
    await tab.page.$eval(
      '[data-card="paste"] textarea',
      (field, value) => {
        /** @type {HTMLTextAreaElement} */ (field).value = value;
      },
      text,
    );
    await tab.click(along(await tab.rectangle('[data-card="use"]'), 0.5));
  }

  test('copies a link that opens the same fire, and reports it', async () => {
    const { tab, panel, params } = await openPage();
    const link = await copied(tab, panel, 'link');
    assert.match(await panel.message(), /copied.*link/i);
    assert.deepEqual(Object.keys(Object.fromEntries(new URL(link).searchParams)).sort(), [
      'background',
      'max-particles',
      'printed-euler',
      'scene',
      'viscosity',
    ]);
    const other = await browser.show(link);
    await other.ready();
    assert.deepEqual(await paramsOf(other), params);
    assert.deepEqual(other.problems, []);
  });

  test('copies settings as JSON, imports them, and undoes the import', async () => {
    const { tab, panel, config, params } = await openPage();
    const json = await copied(tab, panel, 'json');
    assert.deepEqual(JSON.parse(json), config);
    await tab.fire((fire) => fire.restore());
    const defaults = await paramsOf(tab);
    assert.notDeepEqual(defaults, params);
    // By the real clipboard.
    await panel.share('paste');
    await tab.until('the card is there', () => document.activeElement?.matches('[data-card="paste"] textarea'));
    await tab.page.keyboard.down('Control');
    await tab.page.keyboard.press('v');
    await tab.page.keyboard.up('Control');
    await tab.click(along(await tab.rectangle('[data-card="use"]'), 0.5));
    await tab.until('the card is gone', () => !document.querySelector('.hearth-card'));
    assert.deepEqual(await paramsOf(tab), params);
    await panel.press('undo');
    await panel.value('viscosity', 'the default', (value) => value === defaults.viscosity);
    assert.deepEqual(await paramsOf(tab), defaults);
  });

  test('rejects bad settings with a message, keeps the pasted text, and changes nothing', async () => {
    const { tab, panel, params } = await openPage();
    const field = '[data-card="paste"] textarea';
    for (const [text, words] of [
      ['', /field is empty/],
      ['{"hearth": 3, "preset": "classic", "values": {"viscosity": 99}}', /viscosity.*99.*0\.1/],
      ['viscosity = 0.02', /JSON/],
    ]) {
      await pasteSettings(tab, panel, text);
      const reason = await tab.until(
        `${text.slice(0, 60)} is refused`,
        () => document.querySelector('.hearth-card [role="alert"]')?.textContent,
      );
      assert.match(reason, /** @type {RegExp} */ (words));
      assert.equal(await tab.page.$eval(field, (input) => /** @type {any} */ (input).value.length), text.length);
      assert.deepEqual(await paramsOf(tab), params);
      await tab.key('Escape');
      await tab.until('the card is gone', () => !document.querySelector('.hearth-card'));
    }
    assert.equal(await tab.page.$eval(actionOf('undo'), (button) => button.getAttribute('aria-disabled')), 'true');
    assert.deepEqual(
      tab.problems.filter((problem) => problem.startsWith('uncaught')),
      [],
    );
  });

  test('shows the text, selected, where the browser does not let it copy', async () => {
    const { tab, panel, config } = await openPage({
      before: () => {
        navigator.clipboard.writeText = () => Promise.reject(new DOMException('no', 'NotAllowedError'));
      },
    });
    await panel.share('copy:json');
    const shown = await tab.until('a card with the text', () => {
      const field = /** @type {any} */ (document.activeElement);
      return (
        field?.matches('[data-card="copy"] textarea') && {
          text: field.value,
          selected: field.selectionEnd - field.selectionStart,
        }
      );
    });
    assert.deepEqual(JSON.parse(shown.text), config);
    assert.equal(shown.selected, shown.text.length);
    const over = await tab.rectangle('.hearth-card');
    const below = await tab.rectangle('#panel');
    assert.ok(over.x >= below.x && over.width <= below.width, 'the card lies over the panel');
    await tab.key('Escape');
    assert.equal(await tab.page.$('.hearth-card'), null);
  });

  test('saves a picture of the fire as a PNG, as wide as on the page, over the background that its dialog has', async () => {
    const { tab, panel } = await openPage({ before: keepSaved });
    await tab.burnt(0.5);
    await panel.press('picture');
    await tab.until('the dialog is there', () => document.querySelector('.hearth-recorder'));
    await tab.page.select('.hearth-recorder >>> [name="background"]', '#000000');
    // As many pixels as the screen has, however few the fire is drawn with.
    await tab.fire((fire) => fire.setAttribute('max-pixels', '20000'));
    const width = await tab.fire((fire) => 2 * Math.round((fire.offsetWidth * devicePixelRatio) / 2));
    await tab.page.click('.hearth-recorder >>> [name="save"]');
    const { name, start, size } = await tab.until('a file', () => /** @type {any} */ (window).saved);
    assert.equal(name, 'hearth.png');
    assert.deepEqual(start, [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
    assert.ok(size > 1000, `${size} bytes`);
    assert.match(await panel.message(), new RegExp(`saved.*${width} pixels`, 'i'));
    assert.equal(await tab.evaluate(() => document.querySelector('.hearth-recorder')), null, 'the dialog is closed');
  });
});
