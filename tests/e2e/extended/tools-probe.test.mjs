/**
 * The probe: what it reads under a mouse, a finger and the cross, in both models, and that it reads what burns.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { canUndo, chord, openTools, PHONES, pixel, toolStatus, tap, tool, WIDE } from '../tools.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const PAUSED = 'scene=default&paused&quality=low';

/** What the probe shows, once it shows it at a place [m]; without one, now. */
const read = (tab, x, y) =>
  tab.until(
    `values at ${x}, ${y} m`,
    (at) => {
      const rows = [...document.querySelectorAll('.hearth-probe dl > div')].map((row) =>
        [...row.children].map((cell) => cell.textContent),
      );
      const values = Object.fromEntries(rows);
      const [right, up] = (values.at ?? '').split(',').map(Number.parseFloat);
      const isThere =
        Number.isFinite(up) && (at === null || (Math.abs(right - at[0]) < 0.02 && Math.abs(up - at[1]) < 0.02));
      return isThere && rows.length > 1 ? values : false;
    },
    x === undefined ? null : [x, y],
  );

/** The hottest height above the middle [m], and what the fire measures there. */
const hottest = (tab) =>
  tab.fire(async (fire) => {
    const { profile } = await fire.measure(0, 0);
    // Not behind what is at the edges of the page.
    return profile
      .filter(({ y }) => y > 0.2 && y < 1.2)
      .reduce((best, sample) => ((sample.temperature ?? 0) > (best.temperature ?? 0) ? sample : best));
  });

const kelvin = ({ temperature }) => Number(/^-?\d+ °C \((\d+) K\)$/.exec(temperature)?.[1]);

test('a place of the flame is hot and rises, and far air has the temperature of the air, under a finger', async () => {
  const [size] = PHONES;
  const tab = await openTools(browser, size, PAUSED);
  await tab.burnt(1.5);
  await tool(tab, 'probe');
  assert.match(await toolStatus(tab), /^Probe: Point at a place/);
  // Something is read before a pointer moves.
  await read(tab);
  const flame = await hottest(tab);
  await tap(tab, 0, flame.y, true);
  const hot = await read(tab, 0, flame.y);
  assert.ok(kelvin(hot) > 1000, hot.temperature);
  assert.ok(Math.abs(kelvin(hot) - flame.temperature) < 100, `${hot.temperature}, and ${flame.temperature} K measured`);
  assert.match(hot.velocity, /^\d+\.\d\d m\/s [↑↗↖] up/);
  assert.deepEqual(Object.keys(hot), ['temperature', 'velocity', 'density', 'oxygen', 'fuel', 'soot', 'at', 'why']);

  // Beside the toolbar.
  await tap(tab, 0.4, 1.4, true);
  const cold = await read(tab, 0.4, 1.4);
  assert.ok(Math.abs(kelvin(cold) - 293) < 10, cold.temperature);
  assert.equal(cold.oxygen, '21 %');
  assert.equal(cold.soot, '0.00');

  const [list, window] = [await tab.rectangle('.hearth-probe dl'), size];
  assert.ok(
    list.x >= 0 && list.y >= 0 && list.x + list.width <= window.width && list.y + list.height <= window.height,
    JSON.stringify(list),
  );
  assert.equal(await canUndo(tab), false);
  await tool(tab, 'stir');
  assert.equal(await tab.evaluate(() => document.querySelector('.hearth-probe')), null);
  assert.deepEqual(tab.problems, []);
});

test('a mouse reads without a press and keys read at the cross, in both models', async () => {
  const tab = await openTools(browser, WIDE, PAUSED);
  await tab.burnt(1);
  await tool(tab, 'probe');
  for (const [x, y] of [
    [0.1, 0.6],
    [-0.2, 1],
  ]) {
    await tab.move(await pixel(tab, x, y));
    const shown = await read(tab, x, y);
    const { place } = await tab.fire((fire, at) => fire.measure(...at), [x, y]);
    assert.ok(
      Math.abs(kelvin(shown) - place.temperature) < 30,
      `${shown.temperature}, and ${place.temperature} K measured`,
    );
  }
  await tab.page.focus('.hearth-overlay');
  await tab.key('p');
  await chord(tab, 'Shift', 'ArrowRight');
  await tab.key('Enter');
  await tab.until('the values as a message', () =>
    /^temperature \d+ °C \(\d+ K\), velocity .+, density [\d.]+ kg\/m³, oxygen [\d.]+ %, fuel/.test(
      document.querySelector('.hearth-status')?.textContent ?? '',
    ),
  );
  await tab.fire((fire) => fire.set('model', 'classic'));
  await tab.burnt(1);
  const flame = await hottest(tab);
  await tap(tab, 0, flame.y);
  assert.deepEqual(Object.keys(await read(tab, 0, flame.y)), ['temperature', 'velocity', 'density', 'at', 'why']);
  assert.deepEqual(tab.problems, []);
});
