/**
 * The tools that act on the gas: what they blow and throw, with a real mouse and keys.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { chord, drag, openTools, toolStatus, tool, WIDE } from '../tools.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

/** A fire whose particles are all flame. */
const CLASSIC = 'scene=default&model=classic&paused&quality=low';

/** Where the glow of the same fire is, as a share of its width, after each of these. */
async function glowsAfter(tab, acts) {
  const places = [];
  for (const act of acts) {
    await tab.fire((fire) => fire.reset());
    await tab.fire((fire) => fire.step(240));
    for (let round = 0; round < 3; round += 1) {
      await act();
      await tab.fire((fire) => fire.step(20));
    }
    await tab.frames();
    places.push(await glowAt(tab));
  }
  return places;
}

async function glowAt(tab) {
  // The toolbar glows too. Without visibility, it would lose the focus.
  const shows = (how) => tab.page.$eval('.hearth-tools', (host, opacity) => (host.style.opacity = opacity), how);
  await shows('0');
  const picture = await tab.firePicture();
  await shows('');
  const columns = Array.from({ length: 48 }, (_, at) => picture.crop(at / 48, 0, (at + 1) / 48, 1).glowing());
  const all = columns.reduce((sum, column) => sum + column);
  return columns.reduce((sum, column, at) => sum + column * (at + 0.5), 0) / (48 * all);
}

/** Number of embers that the fire reports after a step. */
const embers = async (tab) => {
  await tab.fire((fire) => fire.step(1));
  await tab.frames(3);
  return tab.fire((fire) => fire.stats?.embers ?? 0);
};

test('a drag blows flames its way, and keys blow and throw sparks from the cross; none is a step', async () => {
  const tab = await openTools(browser, WIDE, CLASSIC);
  await tool(tab, 'blow');
  assert.match(await toolStatus(tab), /^Blow: Drag to blow/);
  const blown = (right, left, by) =>
    assert.ok(right > left + 0.01, `blown to the right by ${by}, the flames are at ${right}, to the left at ${left}`);
  blown(
    ...(await glowsAfter(
      tab,
      [1, -1].map((way) => () => drag(tab, [-0.1 * way, 0.3], [0.1 * way, 0.3])),
    )),
    'a drag',
  );
  await tab.page.focus('.hearth-overlay');
  const cross = () => tab.page.$eval('.hearth-overlay .cross', (path) => path.getBoundingClientRect().y);
  await tab.key('Enter');
  const middle = await cross();
  for (let down = 0; down < 4; down += 1) await chord(tab, 'Shift', 'ArrowDown');
  assert.ok((await cross()) > middle, 'with Shift, an arrow moves the cross');
  const at = await cross();
  blown(
    ...(await glowsAfter(
      tab,
      ['ArrowRight', 'ArrowLeft'].map((key) => () => tab.key(key)),
    )),
    'keys',
  );
  assert.equal(await cross(), at, 'an arrow blows and moves nothing');
  await tab.key('k');
  assert.match(await toolStatus(tab), /The classic model has none/);

  await tab.fire((fire) => fire.importConfig({ hearth: 2, values: { ember_rate: 0 } }));
  await tab.page.focus('.hearth-overlay');
  const before = await embers(tab);
  await tab.key('Enter');
  await tab.key('Enter');
  assert.equal((await embers(tab)) - before, 48);
  assert.equal(await tab.fire((fire) => fire.objects.length), 1);
  const names = await tab.evaluate(() =>
    ['blow', 'sparks'].map((name) => document.querySelector(`[data-tool="${name}"]`)?.getAttribute('aria-label')),
  );
  assert.deepEqual(names, ['Blow (B)', 'Sparks (K)']);
  assert.deepEqual(tab.problems, []);
});
