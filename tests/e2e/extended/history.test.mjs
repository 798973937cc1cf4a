/**
 * `fire.history` without a panel: random steps, changes of the page, undo and redo, in a real engine, with children. The
 * settings after undo of all are the first ones, and a fire that is removed and inserted again goes on with the same
 * settings.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const SEQUENCES = 200;

test('random steps are undone exactly, and changes of the page stay', async () => {
  const tab = await browser.show(`<hearth-fire paused preset="campfire">
    <hearth-source x="0.1"></hearth-source><hearth-solid y="0.7"></hearth-solid></hearth-fire>`);
  await tab.ready();
  const failures = await tab.fire(async (fire, sequences) => {
    const { history } = fire;
    let seed = 1;
    const random = (/** @type {number} */ below) => {
      seed = (seed * 16807) % 2147483647;
      return Math.floor((seed / 2147483647) * below);
    };
    const anyId = () => fire.objects[random(fire.objects.length)]?.id ?? 1;
    /** @type {(() => unknown)[]} */
    const acts = [
      () => fire.set('fuel_power', 50 + random(500)),
      () => fire.set({ turbulence: random(9), source_x: random(5) / 10 }),
      () => fire.set('spacing', 0.02 + random(20) / 1000),
      () => fire.set('particles', 300 + random(5000)),
      () => fire.restore('fuel_power', 'spacing'),
      () => fire.set('model', random(2) ? 'classic' : 'combustion'),
      () => fire.addObject({ kind: random(3) ? 'solid' : 'source', x: random(9) / 10 - 0.4 }),
      () => fire.changeObject(anyId(), { y: random(9) / 10 }),
      () => fire.removeObject(anyId()),
      () => fire.importConfig({ preset: 'candle', values: { wind: 0.2 } }),
      () => fire.set({ objects: [...fire.objects].reverse() }),
      () => {
        fire.preset = ['candle', 'campfire', 'bonfire-in-wind'][random(3)];
      },
    ];
    const act = () => Promise.resolve(acts[random(acts.length)]()).catch(() => {});
    const settings = async () => JSON.stringify(await fire.exportConfig());
    const failed = [];
    const other = document.createElement('hearth-fire');
    other.paused = true;
    document.body.append(other);
    await other.ready;
    const reset = await settings();
    let steps = 0;
    fire.addEventListener('history-change', ({ detail }) => {
      steps += detail.type === 'step' ? 1 : 0;
    });
    for (let sequence = 0; sequence < sequences; sequence += 1) {
      const first = await settings();
      const { bloom } = fire.params;
      steps = 0;
      const calls = Array.from({ length: 1 + random(5) }, () => history.step(act));
      await Promise.all(calls);
      const last = await settings();
      // The page changes a value that no step has.
      const page = random(2) === 1;
      if (page) await fire.set('bloom', 0.5);
      for (let undone = 0; undone < steps; undone += 1) await history.undo();
      if (page && fire.params.bloom !== 0.5) failed.push([sequence, 'the page', fire.params.bloom]);
      if (page) await fire.set({ bloom });
      const back = await settings();
      if (back !== first) failed.push([sequence, first, back]);
      while (await history.redo());
      if (!page && (await settings()) !== last) failed.push([sequence, last, await settings()]);
      if (sequence % 10 === 9) {
        // What the element has is what the engine has.
        await other.importConfig(await fire.exportConfig());
        const [own, same] = [fire, other].map(({ params, objects }) => JSON.stringify([params, objects]));
        if (own !== same) failed.push([sequence, own, same]);
        await fire.importConfig(reset);
        // The list of the children is sent anew.
        const solid = fire.lastElementChild;
        solid.setAttribute('x', `${random(9) / 10}`);
        fire.append(solid.cloneNode());
        solid.remove();
        await new Promise(requestAnimationFrame);
      }
    }
    return failed.slice(0, 3);
  }, SEQUENCES);
  assert.deepEqual(failures, []);
  assert.deepEqual(
    tab.problems.filter((problem) => !/is refused/.test(problem)),
    [],
  );
});

test('a fire that is inserted again has the settings of the last one, and its history', async () => {
  const tab = await browser.show('<hearth-fire paused></hearth-fire>');
  await tab.ready();
  const seen = await tab.fire(async (fire) => {
    const events = [];
    fire.addEventListener('history-change', ({ detail }) => events.push(detail.type));
    const { history } = fire;
    const first = await fire.exportConfig();
    await history.step(() => fire.set('particles', 900));
    await history.step(() => fire.set({ model: 'classic', viscosity: 0.02 }));
    const last = await fire.exportConfig();
    fire.remove();
    await new Promise(requestAnimationFrame);
    document.body.append(fire);
    await fire.ready;
    const again = await fire.exportConfig();
    await history.undo();
    await history.undo();
    return { same: [again, await fire.exportConfig()], whole: [last, first], can: history.canUndo, events };
  });
  assert.deepEqual(seen.same, seen.whole);
  assert.deepEqual([seen.can, seen.events], [false, ['step', 'step', 'undo', 'undo']]);
});
