/**
 * The panel under mouse input: a control of each kind reaches the fire and its picture. What every row does is tested
 * natively in `crates/hearth-panel/tests`, and `history.test.mjs` compares the panel with the fire after any change.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
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

test('a row of each kind sets its value, and returns it to its default', async () => {
  const { tab, panel } = await openPage();
  await panel.dragSlider('viscosity', 0.2, 0.8);
  const near = (value) => Math.abs(fractionOf(entry.viscosity, value) - 0.8) < AIM;
  await panel.value('viscosity', 'where the mouse let go', near);
  await panel.choose('walls', 'solid');
  await panel.value('walls', 'solid', (value) => value === 'solid');
  await tab.click(along(await panel.reveal('printed_kernel'), 0.5));
  await panel.value('printed_kernel', true, (value) => value === true);
  const time = await tab.fire((fire) => fire.stats.time);
  await tab.click(along(await panel.reveal('seed'), 0.95));
  await tab.page.keyboard.type('4711');
  await tab.key('Enter');
  await panel.value('seed', 4711, (value) => value === 4711);
  await tab.until(
    'the fire has restarted from its seed',
    (before) => /** @type {any} */ (document.querySelector('hearth-fire')).stats.time < before,
    time,
  );
  await panel.restore('viscosity');
  await panel.value('viscosity', 'the default', (value) => value === DEFAULTS.viscosity);
  await panel.press('reset-all');
  for (const id of ['walls', 'printed_kernel', 'seed'])
    await panel.value(id, 'the default', (value) => value === DEFAULTS[id]);
  assert.deepEqual(tab.problems, []);
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
