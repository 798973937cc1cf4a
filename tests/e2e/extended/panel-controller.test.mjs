/**
 * The panel controller: defaults are those of the scene, folded groups are remembered,
 * shortcuts act only in the panel, and the panel works in a dialog, scaled, hidden, with
 * few controls and with forced colours.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { Panel, actionOf, along, controlOf } from '../panel.mjs';
import { table } from '../site.mjs';

const { PARAMETERS, PRESETS } = await table();
const CAMPFIRE = PRESETS.find(({ name }) => name === 'campfire').values;

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** @param {string} query @param {object} [options] */
async function openPage(query, options) {
  const tab = await browser.open(`index.html${query}`, { width: 760, height: 600, ...options });
  await tab.ready();
  return { tab, panel: await new Panel(tab).mounted() };
}

/** A page that puts the panel into `#host`, which stands in `body`. @param {string} body @param {string} [parts] */
async function openPanel(body, parts = '') {
  const tab = await browser.open(
    `<hearth-fire id="fire" preset="campfire"></hearth-fire>${body}
    <script type="module">
      import { mountPanel } from '/web/panel.js';
      const [host, fire] = [document.getElementById('host'), document.getElementById('fire')];
      fire.ready.then(() => mountPanel({ host, fire${parts} })).then(() => { window.stands = true; });
    </script>`,
    { width: 700, height: 700 },
  );
  await tab.ready();
  await tab.until('the panel stands', () => /** @type {any} */ (window).stands);
  return { tab, panel: new Panel(tab) };
}

const scene = (panel) => panel.in((root) => root.querySelector('[data-action="scenes"]').textContent);
const paused = (tab) => tab.fire((fire) => fire.paused);

describe('the defaults', () => {
  test('are those of the scene: a reset restores it, and the address names only it', async () => {
    const { tab, panel } = await openPage('?scene=campfire');
    assert.equal(await scene(panel), 'Scene: Campfire');
    await panel.press('reset-all');
    await tab.frames(10);
    assert.equal(await scene(panel), 'Scene: Campfire');
    await panel.dragSlider('fuel_power', 0.5, 0.9);
    await panel.until(
      'it is another fire',
      (root) => root.querySelector('[data-action="scenes"]').textContent === 'Scene: Campfire, changed',
    );
    await panel.restore('fuel_power');
    await panel.value('fuel_power', 'the scene’s', (value) => value === CAMPFIRE.fuel_power);
    assert.equal(await scene(panel), 'Scene: Campfire');
    await tab.fire((fire) => fire.set({ detail: 0.3, source_width: 0.1, bloom: 0.6 }));
    await panel.press('reset-all');
    for (const id of ['detail', 'source_width', 'bloom']) {
      await panel.value(id, 'the scene’s', (value) => value === CAMPFIRE[id]);
    }
    assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), { hearth: 3, preset: 'campfire', values: {} });
    await panel.press('undo');
    await panel.value('detail', 'as it was', (value) => value === 0.3);
    assert.deepEqual(tab.problems, []);
  });
});

describe('the next visit', () => {
  test('finds folds, height and quality as they were', async () => {
    const first = await openPage('', { height: 800 });
    await first.tab.click(along(await first.panel.rectangleOf('group:Basics'), 0.5));
    await first.tab.frames(6);
    await first.tab.page.select(actionOf('quality'), 'low');
    await first.tab.until(
      'the quality',
      () => /** @type {any} */ (document.querySelector('hearth-fire')).quality === 'low',
    );

    const { tab } = await openPage('', { height: 800, remember: true });
    assert.equal(await tab.fire((fire) => fire.quality), 'low');
    const shown = () => tab.evaluate(() => Object.keys(/** @type {any} */ (window).panelRectangles ?? {}));
    await tab.until('the rows', () => /** @type {any} */ (window).panelRectangles?.['group:Basics'] !== undefined);
    assert.ok(!(await shown()).includes('source_width'), 'the group is folded still');
    assert.ok((await shown()).includes('source_height'), 'and the others are not');
    assert.doesNotMatch(await tab.evaluate(() => location.search), /quality/);

    const named = await openPage('?quality=high', { remember: true });
    assert.equal(await named.tab.fire((fire) => fire.quality), 'high', 'what the address names wins');
  });

  test('finds the sheet at the height that mouse or keys gave it', async () => {
    const phone = { width: 390, height: 844, touch: true };
    const { tab, panel } = await openPage('', phone);
    const grip = await tab.rectangle('.hearth-grip');
    await tab.touchDrag(along(grip, 0.5), { x: 195, y: 300 });
    const height = async (of) => (await of.rectangle('#panel')).height;
    const dragged = await height(tab);
    assert.ok(Math.abs(dragged - 544) < 20, `${dragged} high`);
    await panel.in((root) => /** @type {any} */ (root.querySelector('.hearth-grip')).focus());
    await tab.key('ArrowDown');
    await tab.frames(4);
    const lower = await height(tab);
    assert.ok(lower < dragged - 20, `${lower} and not ${dragged}`);
    const again = await openPage('', { ...phone, remember: true });
    assert.ok(Math.abs((await height(again.tab)) - lower) < 2);
  });
});

describe('keys', () => {
  test('act in the panel alone, can be turned off, and the slash focuses the search', async () => {
    const { tab, panel } = await openPage('');
    await tab.key('/');
    await tab.frames(6);
    await tab.page.keyboard.type('color');
    await tab.until('the palette is the first that is found', () => {
      const { palette, wind } = /** @type {any} */ (window).panelRectangles ?? {};
      return palette && !wind;
    });
    assert.equal(await paused(tab), false);
    await tab.key('Escape');
    await panel.rectangleOf('wind');
    await tab.evaluate(() => /** @type {any} */ (document.activeElement)?.blur());

    await tab.key('?');
    await panel.in((root) => /** @type {any} */ (root.querySelector('[data-card="help"] input')).click());
    await tab.key('Escape');
    await tab.key('Space');
    assert.equal(await paused(tab), false);
    await panel.in((root) => /** @type {any} */ (root.querySelector('[data-action="help"]')).click());
    await panel.in((root) => /** @type {any} */ (root.querySelector('[data-card="help"] input')).click());
    await tab.key('Escape');
    await tab.evaluate(() => /** @type {any} */ (document.activeElement)?.blur());
    await tab.key('Space');
    assert.equal(await paused(tab), true);
    await tab.evaluate(() => {
      document.documentElement.dataset.shortcuts = 'off';
    });
    await tab.key('Space');
    assert.equal(await paused(tab), true);
    await tab.evaluate(() => {
      delete document.documentElement.dataset.shortcuts;
    });

    await tab.evaluate(() => {
      const link = Object.assign(document.createElement('a'), { href: '#there', textContent: 'elsewhere' });
      document.body.append(link);
      link.focus();
    });
    await tab.key('r');
    await tab.key('?');
    await tab.frames(4);
    assert.equal(await tab.page.$('[data-card="help"]'), null);
  });
});

describe('its position', () => {
  test('a dialog around it stays open when Escape is pressed in it', async () => {
    const { tab, panel } = await openPanel(`<dialog id="dialog" style="padding: 0; border: 0">
      <div id="host" style="width: 340px; height: 600px"></div></dialog>
      <script>document.getElementById('dialog').showModal()</script>`);
    await panel.mounted();
    const open = () => tab.evaluate(() => /** @type {any} */ (document.getElementById('dialog')).open);
    await tab.click(along(await panel.reveal('fuel_power'), 0.5));
    await tab.key('Escape');
    await tab.page.focus(controlOf('wind'));
    await tab.key('Escape');
    await tab.frames(4);
    assert.equal(await open(), true);
  });

  test('a scaled panel reacts where it is drawn', async () => {
    const { tab, panel } = await openPanel(`<div id="host"
      style="width: 340px; height: 800px; transform: scale(0.6); transform-origin: 0 0"></div>`);
    await panel.mounted();
    const rectangle = await panel.reveal('fuel_power');
    assert.ok(rectangle.width < 200, `${rectangle.width} wide on the screen`);
    await tab.drag(along(rectangle, 0.2), along(rectangle, 0.8));
    await panel.value('fuel_power', 'about 480', (value) => Math.abs(value - 480) < 40);
    // The tooltip of the row lies beside the panel.
    await tab.move(along(rectangle, 0.5));
    const [tooltip, host] = await tab.until('the tooltip', () => {
      const shown = document.querySelector('.hearth-tooltip');
      if (!shown?.checkVisibility() || !/Attribute fuel-power$/.test(shown.textContent ?? '')) return false;
      return [shown, document.getElementById('host')].map((part) => {
        const { left, right, top, bottom } = /** @type {Element} */ (part).getBoundingClientRect();
        return { left, right, top, bottom };
      });
    });
    assert.ok(tooltip.left >= host.right && tooltip.right <= 700, JSON.stringify([tooltip, host]));
    assert.ok(tooltip.top <= rectangle.y && tooltip.bottom >= rectangle.y, JSON.stringify([tooltip, rectangle]));
    await tab.move({ x: 600, y: 20 });
    await tab.until('no tooltip', () => !document.querySelector('.hearth-tooltip')?.checkVisibility());
  });

  test('with forced colours, the accessible controls replace the panel; they have its groups, and announce each value once', async () => {
    const { tab } = await openPage('');
    const groups = await tab.page.$$eval('.hearth-controls fieldset', (sets) =>
      sets.filter((set) => !(/** @type {any} */ (set).hidden)).map((set) => set.querySelector('legend')?.textContent),
    );
    const used = PARAMETERS.filter(({ models }) => models.includes('combustion')).map(({ group }) => group);
    const [basics, ...others] = new Set(used);
    assert.deepEqual(groups, [basics, 'Objects', ...others]);
    const loud = await tab.page.$$eval('.hearth-controls :is(output, [aria-live], [role=status])', (all) => all.length);
    assert.equal(loud, 1, 'only the line of the error is a live region');
    const client = await tab.page.createCDPSession();
    await client.send('Emulation.setEmulatedMedia', { features: [{ name: 'forced-colors', value: 'active' }] });
    await tab.until(
      'the accessible controls are shown',
      () => document.querySelector('.hearth-controls.alone') && !document.querySelector('.hearth-panel canvas'),
    );
    assert.ok(await tab.page.$eval(controlOf('fuel_power'), (control) => control.getBoundingClientRect().width > 100));
    await client.send('Emulation.setEmulatedMedia', { features: [] });
    await tab.until(
      'the panel is back',
      () => document.querySelector('.hearth-panel canvas') && !document.querySelector('.hearth-controls.alone'),
    );
  });
});
