/**
 * The accessible controls: native controls for keyboards and screen readers. Each has a name and a range, and Tab
 * leaves them. `history.test.mjs` compares them with the fire and egui after any change.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { BACKWARDS, Browser } from '../driver.mjs';
import { Panel, along, entriesOf, controlOf, sharedPage } from '../panel.mjs';
import { table } from '../site.mjs';

const { PARAMETERS } = await table();

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** @param {{before?: () => void}} [options] */
async function openPage(options) {
  const tab = await browser.open('index.html?scene=default&model=classic', { width: 760, height: 600, ...options });
  await tab.ready();
  return { tab, panel: await new Panel(tab).mounted() };
}

const sharePage = sharedPage(() => browser);

test('every parameter of the model has an accessible control with a name', async () => {
  const { tab, panel } = await sharePage();
  const names = await tab.page.$$eval('[data-parameter]', (found) =>
    found.map((control) => {
      const { labels, ariaLabel, dataset } = /** @type {HTMLInputElement} */ (control);
      return [dataset.parameter, ariaLabel || labels?.[0]?.textContent?.trim()];
    }),
  );
  for (const { id, label } of PARAMETERS) {
    const [, name] = names.find(([of]) => of === id) ?? [];
    assert.ok(name?.includes(label), `${id} is called ${name}`);
  }
  // The model begins the group of the physics.
  const others = PARAMETERS.map(({ id }) => id).filter((id) => id !== 'model');
  const physics = PARAMETERS.filter(({ id }) => id !== 'model').findIndex(({ group }) => group === 'Physics');
  const order = [...others.slice(0, physics), 'model', ...others.slice(physics)];
  for (const values of [
    { model: 'combustion', edges: 'open' },
    { model: 'combustion', edges: 'periodic' },
    { model: 'classic' },
  ]) {
    await tab.fire((fire, values) => fire.set(values), values);
    const used = Object.values(entriesOf(PARAMETERS, values.model, values.edges))
      .filter((entry) => entry.used)
      .map(({ id }) => id)
      .sort((a, b) => order.indexOf(a) - order.indexOf(b));
    assert.deepEqual(await panel.controls(), used);
  }
});

test('accessible sliders have the ranges of the model, also for keys', async () => {
  const { tab, panel } = await sharePage();
  const range = (id) =>
    tab.page.$eval(controlOf(id), (control) => {
      const { min, max, value } = /** @type {HTMLInputElement} */ (control);
      return [min, max, value].map(Number);
    });
  for (const model of ['combustion', 'classic']) {
    const entries = entriesOf(PARAMETERS, model);
    await tab.page.select(controlOf('model'), model);
    await panel.value('model', model, (value) => value === model);
    for (const id of ['source_width', 'max_particles']) {
      const { min, max, default: value } = entries[id];
      assert.deepEqual(await range(id), [min, max, value], `${id} of ${model}`);
    }
    await tab.fire((fire, least) => fire.set('max_particles', least), entries.max_particles.min);
    await tab.page.focus(controlOf('max_particles'));
    await tab.key('ArrowLeft');
    await tab.frames(4);
    assert.equal((await range('max_particles'))[2], entries.max_particles.min);
  }
  assert.deepEqual(tab.problems, []);
});

test('a lost context is reported until it is restored', async () => {
  const { tab, panel } = await openPage({
    // Where the page has the fire's context in reach.
    before: () =>
      customElements.whenDefined('hearth-fire').then((HearthFire) => {
        /** @type {any} */ (HearthFire).engine = 'main';
      }),
  });
  // Above the rows: a line of words there moves what stands below it.
  const rows = () => panel.rectangleOf('group:Basics');
  const top = (await rows()).y;
  await tab.evaluate(() => {
    const own = document.querySelector('#panel canvas');
    const context = /** @type {any} */ (window).contexts.find(({ canvas }) => canvas !== own);
    const extension = context.getExtension('WEBGL_lose_context');
    extension.loseContext();
    /** @type {any} */ (window).giveBack = () => extension.restoreContext();
  });
  await tab.until('the accessible controls report it', () =>
    /context was lost/.test(document.querySelector('.hearth-controls [role="status"]')?.textContent ?? ''),
  );
  await tab.frames(10);
  assert.ok((await rows()).y > top + 5, 'a message is above the rows');
  await tab.evaluate(() => /** @type {any} */ (window).giveBack());
  await tab.until(
    'the accessible control has no reason',
    () => document.querySelector('.hearth-controls [role="status"]')?.textContent === '',
  );
  await tab.frames(10);
  assert.equal((await rows()).y, top);
});

test('the accessible controls are in the order of the screen', async () => {
  const { tab, panel } = await sharePage();
  await panel.reveal('time_scale');
  const boxes = await tab.evaluate(() =>
    [...document.querySelectorAll('.hearth-controls [data-rect]')].map((control) => {
      const [, y, , height] = /** @type {HTMLElement} */ (control).dataset.rect?.split(' ').map(Number) ?? [];
      const { action, parameter, property } = /** @type {HTMLElement} */ (control).dataset;
      return { name: action ?? parameter ?? property, top: y, bottom: y + height };
    }),
  );
  assert.ok(boxes.some(({ name }) => name === 'quality'));
  for (const [at, { name, top }] of boxes.entries())
    for (const next of boxes.slice(at + 1)) assert.ok(next.bottom > top, `${next.name} is above ${name}`);
});

for (const [way, options] of /** @type {[string, object][]} */ ([
  ['forwards', {}],
  ['backwards', BACKWARDS],
]))
  test(`the Tab key leaves the panel ${way}`, options, async () => {
    // Firefox leaves the page with the focus, and no other test finds it there.
    const { tab, panel } = await sharedPage(() => browser)();
    const inPanel = () => tab.evaluate(() => document.activeElement?.closest('#panel') !== null);
    await tab.click(along(await panel.reveal('buoyancy'), 0.5));
    if (way === 'backwards') await tab.page.keyboard.down('Shift');
    let presses = 0;
    do {
      await tab.page.keyboard.press('Tab');
      presses += 1;
    } while (presses < 200 && (await inPanel()));
    if (way === 'backwards') await tab.page.keyboard.up('Shift');
    assert.ok(presses < 200, 'Tab goes round in the panel for ever');
  });
