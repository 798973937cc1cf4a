/**
 * The tools that light solids and spray water, with a real mouse and keys. What they do is in `web/tool-effects.test.mjs`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { close, drag, openTools, toolStatus, tap, tool, WIDE } from '../tools.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** A fire that never reaches what stands aside. */
const PAUSED = 'scene=default&paused&quality=low';

/** Adds an object; its id. */
const add = (tab, object) => tab.fire((fire, fields) => fire.addObject(fields), object);

/** The state of the fuels that the fire reports after so many steps. */
async function fuelAfter(tab, steps) {
  await tab.fire((fire, count) => fire.step(count), steps);
  await tab.frames(3);
  return tab.fire((fire) => fire.stats?.fuel ?? '');
}

/** What the tools ask the fire to spray while `act` runs. */
async function sprayed(tab, act) {
  await tab.fire((fire) => {
    window.sprayed = [];
    fire.spray = (...call) => {
      window.sprayed.push(call);
      return Object.getPrototypeOf(fire).spray.apply(fire, call);
    };
  });
  await act();
  return tab.evaluate(() => window.sprayed);
}

test('a press lights wood; a drag and keys spray water', async () => {
  const tab = await openTools(browser, WIDE, PAUSED);
  const id = await add(tab, { kind: 'solid', shape: 'box', x: 0.3, y: 0.6, width: 0.1, height: 0.1, material: 'wood' });
  const fuel = () =>
    tab.until(
      'fuel',
      (solid) => document.querySelector('hearth-fire').objects.find((object) => object.id === solid)?.fuel === 'wood',
      id,
    );
  await tool(tab, 'ignite');
  assert.match(await toolStatus(tab), /^Ignite: Press a solid/);
  await tap(tab, 0.3, 0.6);
  await fuel();
  await tab.fire((fire) => fire.ready);
  assert.equal(await fuelAfter(tab, 40), 'burning');
  await tool(tab, 'water');
  assert.match(await toolStatus(tab), /^Water: Hold to spray/);
  const calls = await sprayed(tab, () => drag(tab, [0.25, 0.8], [0.35, 0.8]));
  assert.ok(calls.length > 0 && calls.every(([, y, , v]) => close(y, 0.8, 0.05) && v < 0), JSON.stringify(calls));
  await tab.page.$eval('.hearth-overlay', (layer) => layer.focus());
  const byKeys = await sprayed(tab, async () => {
    await tab.key('Enter');
    await tab.until('several sprays', () => window.sprayed.length > 2);
    await tab.key('Enter');
  });
  const { x, y } = await tab.fire((fire) => fire.toMetres(fire.clientWidth / 2, fire.clientHeight / 2));
  for (const [across, up] of byKeys) assert.ok(close(across, x, 0.01) && close(up, y, 0.01), `${across}, ${up}`);
  await tool(tab, 'undo');
  await tab.until(
    'no fuel',
    (solid) => document.querySelector('hearth-fire').objects.find((object) => object.id === solid)?.fuel === 'none',
    id,
  );
  assert.deepEqual(tab.problems, []);
});
