/**
 * A change of the model, and the clock of a fire. The order of values and the pace of slow machines are tested in
 * `crates/hearth-engine`, the order of an address in `tests/web/url-parameters.test.mjs`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { onPageThread, simulateClock } from '../clock.mjs';
import { events, recording } from '../assertions.mjs';
import { table } from '../site.mjs';

const { defaultsOf } = await table();

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

test('a change of the model reports every value that differs', async () => {
  const tab = await browser.show(recording('<hearth-fire paused model="classic"></hearth-fire>'));
  await tab.ready();
  for (const [before, now, change, source] of [
    ['classic', 'combustion', (fire) => fire.setAttribute('model', 'combustion'), 'attribute'],
    [
      'combustion',
      'classic',
      (fire) => {
        fire.model = 'classic';
      },
      'property',
    ],
  ]) {
    await tab.evaluate(() => {
      /** @type {any} */ (window).events.length = 0;
    });
    await tab.fire(change);
    await tab.until(
      `the model is ${now}`,
      (name) => /** @type {any} */ (document.querySelector('hearth-fire')).model === name,
      now,
    );
    const sent = await events(tab, 'params-change');
    assert.deepEqual([...new Set(sent.map((message) => message.source))], [source]);
    const other = defaultsOf(/** @type {string} */ (before));
    const differing = Object.entries(defaultsOf(/** @type {string} */ (now))).filter(
      ([id, value]) => Object.hasOwn(other, id) && other[id] !== value,
    );
    assert.deepEqual(Object.fromEntries(sent.map(({ id, value }) => [id, value])), Object.fromEntries(differing));
  }
});

test('a second of the clock is a quarter of a second of a fire with that time scale, and the fire reports it', async () => {
  const fire = '<hearth-fire quality="low" max-pixels="10000" model="classic" time-scale="0.25"></hearth-fire>';
  const tab = await browser.open(onPageThread(fire), { before: simulateClock });
  await tab.ready();
  const { reported, shown, slowed } = await tab.fire(async (fire) => {
    const next = () =>
      new Promise((resolve) => {
        fire.addEventListener('stats', () => resolve([fire.stats.time, performance.now() / 1000]), { once: true });
      });
    const [fireStart, clockStart] = await next();
    let [fireNow, clockNow] = [fireStart, clockStart];
    let slowed = false;
    while (clockNow - clockStart < 4) {
      [fireNow, clockNow] = await next();
      slowed ||= fire.stats.slowed;
    }
    return { reported: fire.stats.timeScale, shown: (fireNow - fireStart) / (clockNow - clockStart), slowed };
  });
  assert.ok(Math.abs(4 * shown - 1) < 0.02, `${shown} s of fire a second`);
  assert.ok(Math.abs(4 * reported - 1) < 0.05, `the fire reports ${reported}`);
  assert.equal(slowed, false);
});
