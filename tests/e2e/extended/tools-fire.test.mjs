/**
 * The tools that light solids, put them out and spray water, and the tools at solids that fall, with a real mouse, a finger and keys.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { canUndo, close, drag, openTools, PHONES, toolStatus, tap, tool, WIDE } from '../tools.mjs';
import { objects } from '../waits.mjs';

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

/** What the fire says of its fuels after so many steps. */
async function fuelAfter(tab, steps) {
  await tab.fire((fire, count) => fire.step(count), steps);
  await tab.frames(3);
  return tab.fire((fire) => fire.stats?.fuel ?? '');
}

/** The power of the flames after so many steps [kW/m]. */
async function powerAfter(tab, steps) {
  await tab.fire((fire, count) => fire.step(count), steps);
  return tab.fire(async (fire) => (await fire.measure(0, 0.5)).power);
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

/** Sprays enough water from there; what the fire says of its fuels then. */
async function putOut(tab, x, y) {
  await tab.fire(async (fire, [across, up]) => {
    for (let call = 0; call < 60; call += 1) {
      await fire.spray(across, up, 0, -3, 20);
      await fire.step(16);
    }
  }, [x, y]);
  return fuelAfter(tab, 400);
}

/** Waits until the toolbar says something. */
const says = (tab, words) => tab.until(`the words ${words}`, (pattern) => (
  new RegExp(pattern).test(document.querySelector('.hearth-status')?.textContent ?? '')
), words.source);

for (const size of [WIDE, ...PHONES]) {
  const touch = 'touch' in size;
  describe(`at ${size.width} × ${size.height}`, () => {
    test('a press puts out what burns', async () => {
      const tab = await openTools(browser, size, PAUSED);
      await add(tab, { kind: 'solid', shape: 'box', x: 0.3, y: 0.6, width: 0.1, height: 0.1, material: 'wood', fuel: 'wood' });
      await tab.fire((fire) => fire.ignite(0.3, 0.6));
      assert.equal(await fuelAfter(tab, 40), 'burning');
      await tool(tab, 'extinguish');
      await tap(tab, 0.3, 0.6, touch);
      assert.notEqual(await fuelAfter(tab, 4), 'burning');
      assert.deepEqual(tab.problems, []);
    });

    test('a press lights wood, which gets fuel in one step, and water that is held over it puts it out', async () => {
      const tab = await openTools(browser, size, PAUSED);
      const id = await add(tab, { kind: 'solid', shape: 'box', x: 0.3, y: 0.6, width: 0.1, height: 0.1, material: 'wood' });
      await tool(tab, 'ignite');
      assert.match(await toolStatus(tab), /^Ignite: Press a solid/);
      await tap(tab, 0.3, 0.6, touch);
      await tab.until('fuel', (solid) => document.querySelector('hearth-fire').objects.find((one) => one.id === solid)?.fuel === 'wood', id);
      await tab.fire((fire) => fire.ready);
      assert.equal(await fuelAfter(tab, 40), 'burning');
      await tool(tab, 'water');
      assert.match(await toolStatus(tab), /^Water: Hold to spray/);
      const calls = await sprayed(tab, () => drag(tab, [0.25, 0.8], [0.35, 0.8], touch));
      assert.ok(calls.length > 0 && calls.every(([, y, , v]) => close(y, 0.8, 0.05) && v < 0), JSON.stringify(calls));
      assert.equal(await putOut(tab, 0.3, 0.8), 'out');
      await tool(tab, 'undo');
      await tab.until('no fuel', (solid) => document.querySelector('hearth-fire').objects.find((one) => one.id === solid)?.fuel === 'none', id);
      assert.deepEqual(tab.problems, []);
    });

    test('a press lights a source that water has put out', async () => {
      const tab = await openTools(browser, size, `${PAUSED}&source_height=0.4&source_width=0.2`);
      await powerAfter(tab, 200);
      assert.ok(await powerAfter(tab, 100) > 50);
      await putOut(tab, 0, 0.7);
      assert.equal(await powerAfter(tab, 100), 0);
      await tool(tab, 'ignite');
      await tap(tab, 0.05, 0.42, touch);
      await tab.fire((fire) => fire.ready);
      await powerAfter(tab, 400);
      assert.ok(await powerAfter(tab, 100) > 50);
      assert.deepEqual(tab.problems, []);
    });

    test('a solid that has fallen is dragged from where it is', async () => {
      const tab = await openTools(browser, size, PAUSED);
      await add(tab, { kind: 'solid', shape: 'box', x: 0.3, y: 0.4, width: 0.3, height: 0.06 });
      const id = await add(tab, { kind: 'solid', shape: 'box', x: 0.3, y: 0.9, width: 0.12, height: 0.12, motion: 'free', material: 'wood' });
      const now = () => tab.fire(async (fire, solid) => (await fire.freeSolids()).find((one) => one.id === solid), id);
      await tab.fire((fire) => fire.step(300));
      const fallen = await now();
      assert.ok(fallen.y < 0.6, `it has fallen to ${fallen.y} m`);
      await tab.frames(3);
      await tool(tab, 'select');
      await drag(tab, [fallen.x, fallen.y], [fallen.x + 0.1, fallen.y + 0.2], touch);
      await tab.until('the move', (solid) => {
        const one = document.querySelector('hearth-fire').objects.find((object) => object.id === solid);
        return one.motion === 'free' && one.x > 0.36;
      }, id);
      const moved = await now();
      assert.ok(close(moved.x, fallen.x + 0.1, 0.03) && close(moved.y, fallen.y + 0.2, 0.03), `it is at ${moved.x}, ${moved.y} m`);
      assert.equal(await canUndo(tab), true);
      await tool(tab, 'undo');
      await tab.until('the start', (solid) => document.querySelector('hearth-fire').objects.find((one) => one.id === solid)?.y > 0.89, id);
      assert.deepEqual(tab.problems, []);
    });
  });
}

test('a solid that does not burn is reported', async () => {
  const tab = await openTools(browser, WIDE, PAUSED);
  await tool(tab, 'ignite');
  await tap(tab, 0.4, 1);
  await says(tab, /^Nothing there has fuel/);
  await add(tab, { kind: 'solid', shape: 'box', x: 0.3, y: 0.6, width: 0.1, height: 0.1, material: 'stone' });
  await tap(tab, 0.3, 0.6);
  await says(tab, /^A solid of stone has no fuel/);
  assert.equal((await objects(tab)).find(({ kind }) => kind === 'solid').fuel, 'none');
  await tab.fire((fire) => fire.set('model', 'classic'));
  await tap(tab, 0.3, 0.6);
  await says(tab, /^The classic model has no fuels/);
  assert.equal(await canUndo(tab), false);
  assert.deepEqual(tab.problems, []);
});

test('keys light and spray at the cross', async () => {
  const tab = await openTools(browser, WIDE, PAUSED);
  const { x, y } = await tab.fire((fire) => fire.toMetres(fire.clientWidth / 2, fire.clientHeight / 2));
  await add(tab, { kind: 'solid', shape: 'circle', x, y, width: 0.2, material: 'wood', fuel: 'wood' });
  await tab.on('.hearth-overlay', (layer) => layer.focus());
  await tab.key('i');
  await tab.key('Enter');
  await tab.frames(3);
  assert.equal(await fuelAfter(tab, 40), 'burning');
  await tab.key('w');
  const calls = await sprayed(tab, async () => {
    await tab.key('Enter');
    await tab.until('several sprays', () => window.sprayed.length > 2);
    await tab.key('Enter');
  });
  for (const [across, up] of calls) assert.ok(close(across, x, 0.01) && close(up, y, 0.01), `${across}, ${up}`);
  const ended = await tab.evaluate(() => window.sprayed.length);
  await tab.frames(10);
  assert.equal(await tab.evaluate(() => window.sprayed.length), ended, 'the second press ends it');
  await tab.fire((fire) => fire.set('model', 'classic'));
  await tab.key('Enter');
  await says(tab, /^The classic model has no water/);
  await tab.key('Enter');
  assert.deepEqual(tab.problems, []);
});
