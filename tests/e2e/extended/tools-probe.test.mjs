/**
 * The probe: what it reads under a mouse, a finger and the cross, in both models, and that it reads what burns.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { canUndo, chord, openTools, PHONES, pixel, toolStatus, tap, tool, WIDE } from '../tools.mjs';
import { objects } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const PAUSED = 'scene=default&paused&quality=low';

/** What the probe shows, once it shows it at a place [m]; without one, now. */
const read = (tab, x, y) => tab.until(`values at ${x}, ${y} m`, (at) => {
  const rows = [...document.querySelectorAll('.hearth-probe dl > div')].map((row) => [...row.children].map((one) => one.textContent));
  const values = Object.fromEntries(rows);
  const [right, up] = (values.at ?? '').split(',').map(Number.parseFloat);
  const isThere = Number.isFinite(up) && (at === null || (Math.abs(right - at[0]) < 0.02 && Math.abs(up - at[1]) < 0.02));
  return isThere && rows.length > 1 ? values : false;
}, x === undefined ? null : [x, y]);

/** The hottest height above the middle [m], and what the fire measures there. */
const hottest = (tab) => tab.fire(async (fire) => {
  const { profile } = await fire.measure(0, 0);
  // Not behind what is at the edges of the page.
  return profile.filter(({ y }) => y > 0.2 && y < 1.2).reduce((best, one) => ((one.temperature ?? 0) > (best.temperature ?? 0) ? one : best));
});

const kelvin = ({ temperature }) => Number(/^(\d+) K$/.exec(temperature)?.[1]);

for (const size of [WIDE, ...PHONES]) {
  const touch = 'touch' in size;
  describe(`at ${size.width} × ${size.height}`, () => {
    test('a place of the flame is hot and rises, and far air has the temperature of the air', async () => {
      const tab = await openTools(browser, size, PAUSED);
      await tab.burnt(1.5);
      await tool(tab, 'probe');
      assert.match(await toolStatus(tab), /^Probe: Point at a place/);
      // Something is read before a pointer moves.
      await read(tab);
      const flame = await hottest(tab);
      await tap(tab, 0, flame.y, touch);
      const hot = await read(tab, 0, flame.y);
      assert.ok(kelvin(hot) > 1000, hot.temperature);
      assert.ok(Math.abs(kelvin(hot) - flame.temperature) < 100, `${hot.temperature}, and ${flame.temperature} K measured`);
      assert.match(hot.velocity, /^\d+\.\d\d m\/s [↑↗↖] up/);
      assert.deepEqual(Object.keys(hot), ['temperature', 'velocity', 'density', 'oxygen', 'fuel', 'soot', 'at']);
      assert.match(hot.density, /^0\.\d\d kg\/m³$/);
      assert.match(hot.oxygen, /^\d+(\.\d)? %$/);

      // Beside the toolbar at each size.
      await tap(tab, 0.4, 1.4, touch);
      const cold = await read(tab, 0.4, 1.4);
      assert.ok(Math.abs(kelvin(cold) - 293) < 10, cold.temperature);
      assert.equal(cold.oxygen, '100 %');
      assert.equal(cold.soot, '0.00');

      const [list, window] = [await tab.rectangle('.hearth-probe dl'), size];
      assert.ok(list.x >= 0 && list.y >= 0 && list.x + list.width <= window.width && list.y + list.height <= window.height, JSON.stringify(list));
      assert.equal(await canUndo(tab), false);
      assert.equal((await objects(tab)).length, 1);
      await tool(tab, 'stir');
      assert.equal(await tab.evaluate(() => document.querySelector('.hearth-probe')), null);
      assert.deepEqual(tab.problems, []);
    });
  });
}

test('a mouse reads without a press', async () => {
  const tab = await openTools(browser, WIDE, PAUSED);
  await tab.burnt(1);
  await tool(tab, 'probe');
  for (const [x, y] of [[0.1, 0.6], [-0.2, 1]]) {
    await tab.mouse('move', await pixel(tab, x, y));
    const shown = await read(tab, x, y);
    const { place } = await tab.fire((fire, at) => fire.measure(...at), [x, y]);
    assert.ok(Math.abs(kelvin(shown) - place.temperature) < 30, `${shown.temperature}, and ${place.temperature} K measured`);
  }
  assert.deepEqual(tab.problems, []);
});

test('keys read at the cross, and Enter says what is there', async () => {
  const tab = await openTools(browser, WIDE, PAUSED);
  await tab.burnt(1);
  await tab.page.focus('.hearth-overlay');
  await tab.key('p');
  const middle = await read(tab);
  const [x, y] = middle.at.split(',').map(Number.parseFloat);
  await chord(tab, 'Shift', 'ArrowRight');
  await tab.key('ArrowUp');
  const moved = await read(tab, x + 0.1, y + 0.01);
  assert.ok(kelvin(moved) > 200);
  await tab.key('Enter');
  await tab.until('the values as text', () => (
    /^temperature \d+ K, velocity .+, density [\d.]+ kg\/m³, oxygen [\d.]+ %, fuel/.test(document.querySelector('.hearth-status')?.textContent ?? '')
  ));
  assert.equal(await tab.on('[data-tool="probe"]', (button) => button.getAttribute('aria-label')), 'Probe (P)');
  assert.deepEqual(tab.problems, []);
});

test('values follow the fire while it burns', async () => {
  const tab = await openTools(browser, WIDE, 'scene=default&quality=low');
  await tool(tab, 'probe');
  await tap(tab, 0, 0.5);
  const { temperature } = await read(tab, 0, 0.5);
  await tab.until('another temperature', (first) => {
    const now = document.querySelector('.hearth-probe dd')?.textContent;
    return now && now !== first;
  }, temperature);
  assert.deepEqual(tab.problems, []);
});

test('the classic model has neither oxygen nor soot, and no gas around its flame; a solid has none', async () => {
  const tab = await openTools(browser, WIDE, `${PAUSED}&model=classic`);
  await tab.burnt(1);
  await tool(tab, 'probe');
  const flame = await hottest(tab);
  await tap(tab, 0, flame.y);
  const hot = await read(tab, 0, flame.y);
  assert.deepEqual(Object.keys(hot), ['temperature', 'velocity', 'density', 'at']);
  assert.ok(kelvin(hot) > 1000, hot.temperature);
  await tap(tab, 0.4, 1.4);
  assert.deepEqual(Object.keys(await read(tab, 0.4, 1.4)), ['place', 'at']);
  assert.equal((await read(tab, 0.4, 1.4)).place, 'no gas');
  await tab.fire((fire) => fire.addObject({ kind: 'solid', shape: 'box', x: 0.3, y: 1, width: 0.2, height: 0.2 }));
  await tap(tab, 0.3, 1);
  assert.equal((await read(tab, 0.3, 1)).place, 'in a solid');
  assert.deepEqual(tab.problems, []);
});

test('measuring refuses what is no place, and the fire burns on', async () => {
  const tab = await browser.open('<hearth-fire paused></hearth-fire>');
  await tab.burnt(0.2);
  const why = await tab.fire(async (fire) => {
    const all = [];
    for (const place of [[NaN, 0], [0, 2000], ['a', 1], [0]]) all.push(await fire.measure(...place).then(() => 'measured', (error) => `${error.name}: ${error.message}`));
    return all;
  });
  for (const one of why) assert.match(one, /^RangeError: .*\b[xy]\b/);
  const { time, place, power } = await tab.fire((fire) => fire.measure(0, 1));
  assert.ok(time >= 0.2 && power >= 0 && place.temperature > 200);
});
