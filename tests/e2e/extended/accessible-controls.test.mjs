/**
 * The accessible controls: native controls for keyboards and screen readers. They follow
 * the fire and egui, and egui follows them; each has a name, and Tab leaves them.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser, eventually } from '../driver.mjs';
import { Panel, along, entriesOf, controlOf, sharedPage } from '../panel.mjs';
import { table } from '../site.mjs';

const { PARAMETERS, defaultsOf } = await table();
const DEFAULTS = defaultsOf('classic');

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

/** What the accessible control of a parameter shows. */
function shown(tab, id) {
  return tab.page.$eval(controlOf(id), (control) => {
    const { type, checked, value } = /** @type {HTMLInputElement} */ (control);
    return type === 'checkbox' ? checked : value;
  });
}

const sharePage = sharedPage(() => browser);

test('every parameter of the model has an accessible control with a name', async () => {
  const { tab, panel } = await sharePage();
  const names = await tab.page.$$eval('[data-parameter]', (found) =>
    found.map((control) => {
      const { labels, ariaLabel } = /** @type {HTMLInputElement} */ (control);
      return ariaLabel || labels?.[0]?.textContent?.trim();
    }),
  );
  for (const [at, { id, label }] of PARAMETERS.entries()) {
    assert.ok(names[at]?.includes(label), `${id} is called ${names[at]}`);
  }
  for (const [model, edges] of [
    ['combustion', 'open'],
    ['combustion', 'periodic'],
    ['classic', 'periodic'],
  ]) {
    await tab.fire((fire, values) => fire.set(values), { model, edges });
    const used = Object.values(entriesOf(PARAMETERS, model, edges))
      .filter((entry) => entry.used)
      .map(({ id }) => id);
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

test('an arrow key on an accessible slider changes the value, and egui shows it', async () => {
  const { tab, panel } = await sharePage('classic', true);
  const rectangle = await panel.reveal('buoyancy');
  const picture = await tab.picture(rectangle);
  await tab.page.focus(controlOf('buoyancy'));
  for (let press = 0; press < 10; press += 1) await tab.key('ArrowRight');
  await panel.value('buoyancy', 'more', (value) => value > DEFAULTS.buoyancy);
  await tab.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
  const slider = async () => tab.picture(await panel.reveal('buoyancy'));
  const moved = (after) => after.difference(picture) > 0.5;
  await eventually(
    'egui’s slider moves',
    slider,
    moved,
    () => tab.frames(1),
    () => 'the same picture',
  );
});

test('accessible choices, flags, colours and seeds set the fire', async () => {
  const { tab, panel } = await sharePage();
  for (const [id, value] of [
    ['walls', 'solid'],
    ['printed_kernel', true],
    ['background', '#204060'],
    ['seed', '4711'],
  ]) {
    await tab.page.$eval(
      controlOf(String(id)),
      (control, to) => {
        const input = /** @type {HTMLInputElement} */ (control);
        if (typeof to === 'boolean') input.checked = to;
        else input.value = String(to);
        input.dispatchEvent(new Event('input', { bubbles: true }));
        input.dispatchEvent(new Event('change', { bubbles: true }));
      },
      value,
    );
    await panel.value(String(id), String(value), (now) => String(now) === String(value));
  }
});

test('accessible controls follow attributes of the fire', async () => {
  const { tab } = await sharePage();
  await tab.fire((fire) => {
    fire.setAttribute('walls', 'periodic');
    fire.setAttribute('printed-euler', '');
    fire.setAttribute('seed', '99');
  });
  await tab.until('the accessible controls show them', () => {
    const of = (id) => /** @type {HTMLInputElement} */ (document.querySelector(`[data-parameter="${id}"]`));
    return of('walls').value === 'periodic' && of('printed_euler').checked && of('seed').value === '99';
  });
});

test('accessible controls follow the mouse on egui', async () => {
  const { tab, panel } = await sharePage();
  const before = await shown(tab, 'viscosity');
  await panel.dragSlider('viscosity', 0.1, 0.9);
  await tab.until(
    'the accessible slider has moved',
    (selector, old) => document.querySelector(selector).value !== old,
    controlOf('viscosity'),
    before,
  );
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

test('the panel takes no focus when it loads', async () => {
  const { tab } = await openPage();
  await tab.frames(10);
  assert.equal(await tab.evaluate(() => document.activeElement?.tagName), 'BODY');
});

test('the Tab key goes through the panel in its order on the screen, and leaves it, forwards and backwards', async () => {
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
  const inPanel = () => tab.evaluate(() => document.activeElement?.closest('#panel') !== null);
  for (const backwards of [false, true]) {
    await tab.click(along(await panel.reveal('buoyancy'), 0.5));
    if (backwards) await tab.page.keyboard.down('Shift');
    let presses = 0;
    do {
      await tab.page.keyboard.press('Tab');
      presses += 1;
    } while (presses < 200 && (await inPanel()));
    if (backwards) await tab.page.keyboard.up('Shift');
    assert.ok(presses < 200, 'Tab goes round in the panel for ever');
  }
});

test('the H key hides the panel and shows it again', async () => {
  const { tab } = await sharePage();
  const visible = () => tab.page.$eval('#panel', (panel) => panel.checkVisibility());
  assert.equal(await visible(), true);
  await tab.key('h');
  assert.equal(await visible(), false);
  await tab.key('h');
  assert.equal(await visible(), true);
});
