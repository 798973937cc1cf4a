/**
 * The card of plots: by button and by key, at each size; its values follow the fire, and its CSV has the same numbers.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { violations } from '../axe.mjs';
import { Browser, eventually } from '../driver.mjs';
import { assertScaleApart, canUndo, openTools, PHONES, tool, WIDE } from '../tools.mjs';
import { keepSaved } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const PAUSED = 'scene=default&paused&quality=low';
/** Of a paused fire, which has no frames. */
const CHARTS = ['Flame height', 'Power', 'Luminosity', 'Luminosity spectrum', 'Temperature', 'Velocity'];

/** The descriptions of the charts, by their titles; hidden ones are left out. */
const charts = (tab) =>
  tab.evaluate(() =>
    Object.fromEntries(
      [...document.querySelectorAll('.hearth-plots .chart')]
        .filter((element) => element.checkVisibility())
        .map((element) => (element.getAttribute('aria-label') ?? '').split(/: (.*)/s)),
    ),
  );

/** Steps the fire so often, each time for so long [s of fire], which is a row of the record. */
async function burn(tab, rows, seconds = 0.2) {
  for (let row = 0; row < rows; row += 1) {
    await tab.fire(async (fire, length) => {
      await fire.step(Math.max(1, Math.round(length / (fire.stats?.stepLength || 0.003))));
      // The page measures once a frame, and before this.
      await new Promise((resolve) => {
        requestAnimationFrame(() => requestAnimationFrame(resolve));
      });
      await fire.measure(0, 0);
    }, seconds);
  }
  await tab.until('the charts', () =>
    /now/.test(document.querySelector('.hearth-plots .chart:nth-of-type(2)')?.getAttribute('aria-label') ?? ''),
  );
}

/** Opens the plots with the key, and waits until they show something. */
async function openPlots(tab) {
  await tab.key('g');
  await tab.page.waitForSelector('.hearth-plots');
}

/**
 * Presses the button for CSV until it has the present time: the name of the file, and its columns of numbers by their
 * names.
 */
async function csv(tab) {
  const both = async () => ({ file: await saved(tab), time: await tab.fire((fire) => fire.stats.time) });
  const present = (/** @type {any} */ { file, time }) => Math.abs(file.columns['time [s]'].at(-1) - time) < 1e-3;
  const { file } = await eventually('the file has the present time', both, present, () => tab.frames());
  return file;
}

async function saved(tab) {
  await tab.evaluate(keepSaved);
  await tab.page.click('.hearth-plots [title*="CSV"]');
  const { name, type, text } = await tab.until('a file', () => /** @type {any} */ (window).saved);
  const [names, ...lines] = text
    .trimEnd()
    .split('\r\n')
    .map((line) => line.split(','));
  const columns = Object.fromEntries(
    names.map((title, at) => [
      title,
      lines
        .map((line) => line[at])
        .filter((field) => field !== '')
        .map(Number),
    ]),
  );
  return { name, type, columns };
}

/** A button shows the plots beside the tools, accessibly, and Escape hides them. */
async function assertShows(tab, size) {
  await tool(tab, 'plots');
  await tab.page.waitForSelector('.hearth-plots');
  assert.equal(await tab.page.$eval('[data-tool="plots"]', (button) => button.getAttribute('aria-pressed')), 'true');
  await burn(tab, 3);
  const shown = await charts(tab);
  assert.deepEqual(Object.keys(shown), CHARTS);
  assert.match(
    shown['Flame height'],
    /^now \d\.\d\d m; in the last \d+ s from \d\.\d\d m to \d\.\d\d m, mean \d\.\d\d m$/,
  );
  assert.match(shown.Temperature, /^over the height at x = 0\.00 m, on average at most \d+ °C, at \d\.\d\d m$/);
  assert.match(shown['Luminosity spectrum'], /not measured long enough/);
  const [card, bar] = [await tab.rectangle('.hearth-plots'), await tab.rectangle('.hearth-toolbar')];
  assert.ok(
    card.x >= 0 && card.y >= 0 && card.x + card.width <= size.width && card.y + card.height <= size.height,
    JSON.stringify(card),
  );
  const apart =
    card.x >= bar.x + bar.width ||
    card.x + card.width <= bar.x ||
    card.y >= bar.y + bar.height ||
    card.y + card.height <= bar.y;
  assert.ok(apart, `the plots at ${JSON.stringify(card)} cover the tools at ${JSON.stringify(bar)}`);
  assert.deepEqual(await violations(tab), []);
  await tab.page.focus('.hearth-plots header button');
  await tab.key('Escape');
  assert.equal(await tab.evaluate(() => document.querySelector('.hearth-plots')), null);
  assert.equal(await tab.evaluate(() => document.activeElement?.getAttribute('data-tool')), 'plots');
  assert.equal(await tab.page.$eval('[data-tool="plots"]', (button) => button.getAttribute('aria-pressed')), 'false');
}

for (const size of PHONES) {
  test(`at ${size.width} × ${size.height}, a button shows the plots beside the tools and their message`, async () => {
    const tab = await openTools(browser, size, PAUSED);
    await assertShows(tab, size);
    await assertScaleApart(tab);
    assert.equal(await canUndo(tab), false);
    if (size.width < size.height) return;
    await tool(tab, 'plots');
    await tab.page.waitForSelector('.hearth-plots');
    await tool(tab, 'stir');
    const [message, card] = await tab.until('a message', () => {
      const status = document.querySelector('.hearth-status');
      return (
        status?.textContent &&
        [status, document.querySelector('.hearth-plots')].map((element) => {
          const { left, right, top, bottom } = /** @type {Element} */ (element).getBoundingClientRect();
          return { left, right, top, bottom };
        })
      );
    });
    assert.ok(message.right <= card.left && message.left >= 0, JSON.stringify([message, card]));
    assert.deepEqual(tab.problems, []);
  });
}

test('plots are loaded with their first use, their CSV has the numbers of stats and measures, and they follow the fire', async () => {
  const tab = await openTools(browser, WIDE, PAUSED);
  const loaded = () =>
    tab.evaluate(() =>
      performance
        .getEntriesByType('resource')
        .map(({ name }) => name)
        .filter((name) => name.includes('/plots/')),
    );
  assert.deepEqual(await loaded(), []);
  await assertShows(tab, WIDE);
  assert.ok((await loaded()).some((name) => name.includes('/plots/')));
  await openPlots(tab);
  await burn(tab, 20, 0.05);
  const { name, type, columns } = await csv(tab);
  const [shown, stats, measures] = [
    await charts(tab),
    await tab.fire((fire) => fire.stats),
    await tab.fire((fire) => fire.measure(0, 0)),
  ];
  assert.deepEqual([name, type], ['hearth.csv', 'text/csv']);
  const { 'time [s]': times, 'power [kW/m]': power, 'flame height [m]': heights } = columns;
  assert.ok(times.length >= 15, `${times.length} rows`);
  assert.ok(Math.abs(times.at(-1) - stats.time) < 1e-3, `${times.at(-1)} and ${stats.time} s`);
  assert.ok(times.every((time, at) => at === 0 || time > times[at - 1]));
  assert.ok(Math.abs(power.at(-1) - measures.power) < 0.01);
  assert.ok(shown['Flame height'].startsWith(`now ${heights.at(-1).toFixed(2)} m`), shown['Flame height']);

  assert.equal(columns['temperature [K]'].length, 64);

  const now = async () => Number(/^now (\d+) kW/.exec((await charts(tab)).Power)?.[1]);
  const before = await now();
  await tab.fire((fire) => fire.set('fuel_power', 600));
  await burn(tab, 9);
  const after = await now();
  assert.ok(after > 1.5 * before, `${before}, then ${after} kW/m`);
  assert.match((await charts(tab)).Power, /s ago fuel power 600/);

  const box = () => tab.rectangle('.hearth-plots');
  const at = await box();
  await tab.page.focus('.hearth-plots header button');
  await tab.key('ArrowLeft');
  assert.equal((await box()).x, at.x - 40);
  await tab.drag({ x: at.x + 60, y: at.y + 20 }, { x: at.x - 240, y: at.y + 60 });
  const moved = await box();
  assert.deepEqual([moved.x, moved.y], [at.x - 340, at.y + 40]);
  await tab.page.click('.hearth-plots [title^="Larger"]');
  const large = await box();
  assert.ok(large.width > 1.5 * at.width && large.x >= 0 && large.y + large.height <= WIDE.height);
  await tab.page.click('.hearth-plots [title^="Larger"]');

  // What is over the fire stays without the card.
  for (const toggle of await tab.page.$$('.hearth-plots .fields button')) await toggle.click();
  await tab.until('arrows and isotherms', () =>
    ['.arrow', '.isotherm'].every((name) => document.querySelector(`.hearth-field ${name}`)?.getAttribute('d')),
  );
  assert.deepEqual(await violations(tab), []);

  await tab.key('g');
  assert.equal(await tab.evaluate(() => document.querySelector('.hearth-plots')), null);
  assert.equal(await tab.evaluate(() => document.querySelectorAll('.hearth-field .arrow').length > 0), true);
  assert.deepEqual(tab.problems, []);
});
