/**
 * The panel under mouse input: every kind of egui control changes the fire's parameters,
 * and visible effects follow.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { isDeepStrictEqual } from 'node:util';
import { Browser } from '../driver.mjs';
import { assertBurns } from '../assertions.mjs';
import { Panel, along, entriesOf, fractionOf, sharedPage } from '../panel.mjs';
import { table } from '../site.mjs';

const { PARAMETERS, defaultsOf } = await table();
const DEFAULTS = defaultsOf('classic');
const entry = entriesOf(PARAMETERS, 'classic');

/** Tolerance of a position on a slider, as a fraction of its length. */
const AIM = 0.06;

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const shared = sharedPage(() => browser);

/** The page with its panel, and a paused fire of that model that has burnt for a second. */
async function openPage(model = 'classic', draws = false) {
  const page = await shared(model, draws);
  await page.tab.burnt(1);
  return page;
}

const stat = (tab, name) => tab.fire((fire, wanted) => fire.stats[wanted], name);

test('each of many choices is selected from a list, by mouse and keys', async () => {
  const { tab, panel } = await openPage();
  const names = entry.display_mode.choices;
  assert.ok(names.length > 4);
  for (const name of [...names].reverse()) {
    await panel.choose('display_mode', name);
    await panel.value('display_mode', name, (value) => value === name);
  }
  // A list that has the focus goes on by the arrows.
  await tab.click(along(await panel.reveal('display_mode'), 0.5));
  await tab.key('ArrowDown');
  await panel.value('display_mode', names[1], (value) => value === names[1]);
  assert.deepEqual(tab.problems, []);
});

test('a flag goes on with one click and off with the next', async () => {
  const { tab, panel } = await openPage();
  for (const on of [true, false]) {
    await tab.click(along(await panel.reveal('printed_kernel'), 0.5));
    await panel.value('printed_kernel', on, (value) => value === on);
  }
});

test('a seed is typed over the number, and the fire restarts from it', async () => {
  const { tab, panel } = await openPage();
  const before = await stat(tab, 'time');
  await tab.click(along(await panel.reveal('seed'), 0.95));
  await tab.page.keyboard.type('4711');
  await tab.key('Enter');
  await panel.value('seed', 4711, (value) => value === 4711);
  await tab.until(
    'the fire has restarted',
    (time) => /** @type {any} */ (document.querySelector('hearth-fire')).stats.time < time,
    before,
  );
});

test('one value, and then all values, return to their defaults', async () => {
  const { tab, panel } = await openPage();
  const changes = { buoyancy: 0.5, viscosity: 0.02, walls: 'solid', printed_euler: true };
  await tab.fire((fire, values) => fire.set(values), changes);
  await panel.restore('buoyancy');
  await panel.value('buoyancy', 'the default', (value) => value === DEFAULTS.buoyancy);
  assert.equal(await tab.fire((fire) => fire.params.viscosity), 0.02);
  await panel.press('reset-all');
  for (const id of Object.keys(changes)) {
    await panel.value(id, 'the default', (value) => value === DEFAULTS[id]);
  }
});

test('reset all resets the active model and leaves the other one unchanged', async () => {
  const { tab, panel } = await openPage();
  await tab.fire((fire) => fire.set({ viscosity: 0.02, wind: 1.5 }));
  await panel.press('reset-all');
  await panel.value('viscosity', 'the default', (value) => value === DEFAULTS.viscosity);
  const { model, wind } = await tab.fire((fire) => fire.params);
  assert.deepEqual({ model, wind }, { model: 'classic', wind: 1.5 });
});

for (const model of ['combustion', 'classic']) {
  // The panel's own tests drag every slider natively.
  test(`every third slider of the ${model} model moves its own value and no other`, async () => {
    const { tab, panel } = await openPage(model);
    const all = Object.values(entriesOf(PARAMETERS, model))
      // The slider of a solid's id spans those of the scene, which has none.
      .filter(({ id, used, kind }) => used && id !== 'source_solid' && (kind === 'number' || kind === 'integer'))
      // Those that are the same in both models are moved in the first.
      .filter(({ domains }) => model === 'combustion' || !isDeepStrictEqual(domains.classic, domains.combustion));
    const sliders = all.filter(({ id }, at) => at % 3 === 0 || id === 'spacing');
    assert.ok(sliders.length > 5, `${sliders.length} sliders`);
    for (const slider of sliders) {
      const before = await tab.fire((fire) => fire.params);
      const from = fractionOf(slider, before[slider.id]);
      const to = from > 0.5 ? 0.3 : 0.7;
      await panel.dragSlider(slider.id, from, to);
      const near = (value) => Math.abs(fractionOf(slider, value) - to) < AIM;
      const value = await panel.value(slider.id, `at ${to} of its slider`, near);
      const now = await tab.fire((fire) => fire.params);
      // The spacing and the number of particles follow each other and the domain.
      const { spacing, particles } = now;
      assert.deepEqual(now, { ...before, spacing, particles, [slider.id]: value });
    }
    assert.deepEqual(tab.problems, []);
  });
}

test('the panel follows a model that the page sets', async () => {
  const { tab, panel } = await openPage('classic', true);
  // As many particles as the classic model had: no event reports that they stay.
  await tab.fire((fire) => fire.set({ model: 'combustion', max_particles: 1000 }));
  const own = PARAMETERS.filter(({ models }) => !models.includes('classic')).map(({ id }) => id);
  await panel.until(
    'a row of the other model',
    (_, ids) => ids.some((id) => /** @type {any} */ (window).panelRectangles?.[id]),
    own,
  );
  await panel.dragSlider('fuel_power', 0.4, 0.8);
  const near = (value) => Math.abs(fractionOf(entriesOf(PARAMETERS, 'combustion').fuel_power, value) - 0.8) < AIM;
  await panel.value('fuel_power', 'where the mouse let go', near);
  const rectangle = await panel.reveal('max_particles');
  const least = await tab.picture(rectangle);
  await tab.fire((fire) => fire.set('max_particles', 90_000));
  await tab.frames(4);
  const most = await tab.picture(await panel.reveal('max_particles'));
  assert.ok(least.difference(most) > 0.5, 'the slider stood at its left end');
});

test('a choice takes the clicked name, and even a paused fire is redrawn', async () => {
  const { tab, panel } = await openPage('classic', true);
  await tab.frames(4);
  const fire = await tab.firePicture();
  await panel.choose('display_mode', 'paper');
  await panel.value('display_mode', 'paper', (value) => value === 'paper');
  await tab.pictureUntil("the paper's discs", (picture) => fire.difference(picture) > 1);
  await panel.choose('display_mode', 'fire');
  await panel.value('display_mode', 'fire', (value) => value === 'fire');
  await tab.pictureUntil('the same fire', (picture) => fire.difference(picture) === 0);
});

test('a parameter without effect is dimmed and described, and can still be set', async () => {
  const { tab, panel } = await openPage('classic', true);
  const reported = (id) =>
    tab.page.$eval(
      `[data-parameter="${id}"]`,
      (control) => document.getElementById(control.getAttribute('aria-describedby') ?? '')?.textContent,
    );
  assert.equal(await reported('hot_colour'), 'Only with palette custom');
  const swatch = await panel.reveal('hot_colour');
  const dim = await tab.picture(swatch);
  await panel.choose('palette', 'custom');
  await tab.until(
    'the accessible control has no reason',
    (id) => document.querySelector(`[data-parameter="${id}"]`)?.closest('.idle') === null,
    'hot_colour',
  );
  assert.equal(await reported('hot_colour'), '');
  assert.equal(await reported('background'), '');
  await tab.fire((fire) => fire.set('backdrop', 'bricks'));
  assert.equal(await reported('background'), 'Not with backdrop bricks and display fire');
  await tab.fire((fire) => fire.restore('backdrop'));
  const lit = await tab.picture({ ...(await panel.reveal('hot_colour')), width: swatch.width, height: swatch.height });
  const brightness = (picture) => picture.rgb.reduce((sum, x) => sum + x, 0);
  assert.ok(brightness(lit) > 1.1 * brightness(dim), 'it is brighter than it was');

  await tab.fire((fire) => fire.set('display_mode', 'density'));
  await tab.until(
    'the accessible control has a reason',
    (id) => document.querySelector(`[data-parameter="${id}"]`)?.closest('.idle') !== null,
    'bloom',
  );
  assert.equal(await reported('bloom'), 'Only with display fire');
  assert.equal(await reported('exposure'), 'Only with display fire, paper or sprites');
  await panel.dragSlider('bloom', 0.3, 0.8);
  const near = (value) => Math.abs(fractionOf(entry.bloom, value) - 0.8) < AIM;
  await panel.value('bloom', 'where the mouse let go', near);
});

test('a colour is dragged out of its sliders, and stands behind the fire', async () => {
  const { tab, panel } = await openPage('classic', true);
  await tab.click(along(await panel.reveal('background'), 0.5));
  await panel.reveal('background');
  for (const [slider, to] of [
    ['brightness', 0.8],
    ['saturation', 0.95],
    ['hue', 0.66],
  ]) {
    const rectangle = await panel.rectangleOf(`${slider}:background`);
    await tab.drag(along(rectangle, 0.3), along(rectangle, to));
  }
  const blue = /^#[0-3].[0-7].[a-f].$/;
  await panel.value('background', 'a bright blue', (value) => blue.test(value));
  await tab.pictureUntil(
    'the corner is blue',
    (picture) => picture.crop(0, 0, 0.05, 0.05).share((r, _, b) => b > 150 && b > 2 * r) > 0.9,
  );
});

test('the pause button stops and continues time and picture', async () => {
  const { tab, panel } = await openPage('classic', true);
  await tab.fire((fire) => fire.play());
  await panel.press('pause');
  await tab.until('the fire is paused', () => /** @type {any} */ (document.querySelector('hearth-fire')).stats.paused);
  // A picture may be on its way; this one follows it.
  await tab.fire((fire) => fire.toBlob().then(() => undefined));
  const [time, picture] = [await stat(tab, 'time'), await tab.firePicture()];
  await tab.frames(20);
  assert.equal(await stat(tab, 'time'), time);
  assert.equal((await tab.firePicture()).difference(picture), 0);
  await panel.press('pause');
  await tab.burnt(time + 0.5);
  await assertBurns(tab);
});

test('a finger selects a choice from a list', async () => {
  const phone = await browser.open('index.html?scene=default&model=classic', {
    width: 360,
    height: 640,
    ratio: 3,
    touch: true,
  });
  await phone.burnt(0.3);
  const sheet = await new Panel(phone).mounted();
  await sheet.choose('display_mode', 'sprites');
  await sheet.value('display_mode', 'sprites', (value) => value === 'sprites');
});
