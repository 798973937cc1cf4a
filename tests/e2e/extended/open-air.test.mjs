/**
 * A fire in open air goes on as any fire: after a tab that was hidden, in a transition of its domain
 * and its source, and after a change of the element's size.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { assertBurns, assertGlows, assertStands, events, recording } from '../assertions.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

const FIRE = '<hearth-fire edges="open" quality="low" style="width: 240px; height: 240px"></hearth-fire>';

/**
 * No gas is at the limit of the speed, and the air around the fire is simulated.
 * @param {import('../driver.mjs').Tab} tab
 */
async function assertCalm(tab) {
  const { atSpeedLimit, asleep, particles } = await tab.fire((fire) => fire.stats);
  assert.equal(atSpeedLimit, 0);
  assert.ok(asleep < 0.2 && particles > 300, `${particles} particles, ${asleep} of the air asleep`);
}

test('a fire burns on without a burst after another tab was in front', async () => {
  const tab = await browser.show(recording(FIRE));
  await tab.burnt(1.5);
  const other = await browser.browser.newPage();
  await other.bringToFront();
  const age = await tab.fire((fire) => fire.stats.time);
  await other.close();
  await tab.page.bringToFront();
  await tab.burnt(age + 0.7);
  await assertBurns(tab);
  await assertCalm(tab);
  assert.deepEqual(await events(tab, 'error'), []);
  assert.deepEqual(tab.problems, []);
});

test('a fire goes on while its domain, its source and its size change', async () => {
  const tab = await browser.show(recording(FIRE));
  await tab.burnt(1);
  const age = await tab.fire((fire) => fire.stats.time);
  const whole = await tab.fire((fire) =>
    fire.to({ domain_width: 2.4, domain_height: 2, source_x: 0.3, wind: 0.5 }, { duration: 600 }),
  );
  assert.equal(whole, true);
  assert.ok((await tab.fire((fire) => fire.stats.time)) >= age, 'the fire does not start again');
  await assertGlows(tab);
  await assertCalm(tab);
  for (const [width, height] of [
    [400, 120],
    [120, 300],
    [240, 240],
  ]) {
    const before = await tab.fire(
      (fire, [across, up]) => {
        fire.style.width = `${across}px`;
        fire.style.height = `${up}px`;
        return fire.stats.time;
      },
      [width, height],
    );
    await tab.burnt(before + 0.3);
    await assertCalm(tab);
  }
  const until = await tab.fire(async (fire) => {
    fire.setAttribute('source-x', '-0.4');
    fire.setAttribute('zoom', '3');
    return fire.stats.time;
  });
  await tab.burnt(until + 0.5);
  await assertCalm(tab);
  await tab.fire((fire) => {
    fire.removeAttribute('zoom');
    fire.pause();
  });
  await assertStands(tab);
  assert.deepEqual(await events(tab, 'error'), []);
  assert.deepEqual(tab.problems, []);
});
