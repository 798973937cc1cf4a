/**
 * The two models of a fire: a model is set with its values by attribute or URL parameter, in any order; fires keep
 * real time or report that they are slowed.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { onPageThread, simulateClock } from '../clock.mjs';
import { assertBurns, events, recording } from '../assertions.mjs';
import { table } from '../site.mjs';

const { defaultsOf, entry } = await table();

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** Values that only the named model takes: the other one’s range ends before them. */
const ONLY = {
  classic: { emission_speed: 2.5, max_particles: 150 },
  combustion: { source_width: 0.9, buoyancy: 1.5 },
};

for (const [model, only] of Object.entries(ONLY)) {
  const pairs = Object.entries({ ...only, model });
  const orders = [pairs, [...pairs].reverse()];

  test(`${model} as an attribute decides the ranges of all others, wherever it stands`, async () => {
    for (const order of orders) {
      const attributes = order.map(([id, value]) => `${entry[id].attribute}="${value}"`).join(' ');
      const tab = await browser.show(`<hearth-fire paused ${attributes}></hearth-fire>`);
      await tab.ready();
      assert.deepEqual(await tab.fire((fire) => fire.params), { ...defaultsOf(model), ...only, model });
      assert.deepEqual(tab.problems, []);
    }
  });
}

test('the classic model in the address decides the ranges of values before it', async () => {
  const { emission_speed, max_particles } = ONLY.classic;
  const tab = await browser.open(
    `index.html?scene=default&emission_speed=${emission_speed}&max_particles=${max_particles}&model=classic&paused`,
  );
  await tab.ready();
  assert.deepEqual(await tab.fire((fire) => fire.params), {
    ...defaultsOf('classic'),
    ...ONLY.classic,
    model: 'classic',
  });
  assert.deepEqual(tab.problems, []);
});

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
      ([id, value]) => other[id] !== value,
    );
    assert.deepEqual(Object.fromEntries(sent.map(({ id, value }) => [id, value])), Object.fromEntries(differing));
  }
});

test('a burning fire changes its model and burns on', async () => {
  const tab = await browser.show('<hearth-fire model="classic"></hearth-fire>');
  await tab.burnt(1);
  await assertBurns(tab);
  await tab.fire((fire) => fire.set('model', 'combustion'));
  // Its power comes with the first drop of fuel, its flame half a second later.
  await tab.until('the gas fire burns', () => {
    const { power, time } = /** @type {any} */ (document.querySelector('hearth-fire')).stats;
    return power > 50 && time > 0.8;
  });
  await assertBurns(tab);
  await tab.fire((fire) => fire.set('model', 'classic'));
  await tab.until('the classic fire burns', () => {
    const { power, particles } = /** @type {any} */ (document.querySelector('hearth-fire')).stats;
    return power === 0 && particles > 300 && particles < 1500;
  });
  await assertBurns(tab);
  assert.deepEqual(tab.problems, []);
});

test('requested steps are made, however long each of them is', async () => {
  for (const model of Object.keys(ONLY)) {
    const tab = await browser.show(`<hearth-fire paused model="${model}"></hearth-fire>`);
    await tab.ready();
    const { time, stepLength } = await tab.fire(async (fire) => {
      await fire.step(1);
      await fire.step(29);
      return fire.stats;
    });
    assert.ok(time > 0 && stepLength > 0, `${time} s in steps of ${stepLength} s`);
    // The mean leans towards the last steps; their lengths change slowly.
    const steps = time / stepLength;
    assert.ok(steps > 20 && steps < 45, `thirty steps of ${stepLength} s last ${time} s`);
  }
});

test('the statistics fit the model', async () => {
  const tab = await browser.show('<hearth-fire model="classic" quality="medium"></hearth-fire>');
  await tab.burnt(0.5);
  const classic = await tab.fire((fire) => fire.stats);
  assert.deepEqual([classic.power, classic.embers], [0, 0]);
  const step = defaultsOf('classic').time_step;
  assert.ok(Math.abs(classic.stepLength - step) < 1e-3 * step, `steps of ${classic.stepLength} s`);

  await tab.fire((fire) => fire.set('model', 'combustion'));
  await tab.until('power, embers and steps of a gas fire', () => {
    const { power, embers, stepLength, timeScale, particles } = /** @type {any} */ (
      document.querySelector('hearth-fire')
    ).stats;
    return (
      power > 50 &&
      power < 600 &&
      embers > 0 &&
      stepLength > 0 &&
      stepLength < 0.004 &&
      timeScale > 0 &&
      timeScale < 1.2 &&
      particles > 2500
    );
  });
});

/** Opens a small fire whose page has a simulated clock. */
async function onClock(attributes) {
  const fire = `<hearth-fire quality="low" max-pixels="10000" ${attributes}></hearth-fire>`;
  const tab = await browser.open(onPageThread(fire), { before: simulateClock });
  await tab.ready();
  return tab;
}

for (const [model, scale] of [
  ['combustion', 1],
  ['classic', 1],
  ['classic', 0.25],
]) {
  test(`a second of the clock is ${scale} s of a ${model} fire with that time scale, and the fire reports it`, async () => {
    const tab = await onClock(`model="${model}" time-scale="${scale}"`);
    const { reported, shown, slowed } = await tab.fire(async (fire) => {
      const next = () =>
        new Promise((resolve) => {
          fire.addEventListener('stats', () => resolve([fire.stats.time, performance.now() / 1000]), {
            once: true,
          });
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
    assert.ok(Math.abs(shown / scale - 1) < 0.02, `${shown} s of fire a second`);
    assert.ok(Math.abs(reported / scale - 1) < 0.05, `the fire reports ${reported}`);
    assert.equal(slowed, false);
  });
}

for (const model of Object.keys(ONLY)) {
  test(`a ${model} fire whose steps do not fit their frames burns slowly, reports it, and frames keep coming`, async () => {
    const tab = await onClock(`model="${model}"`);
    const cost = (/** @type {number} */ milliseconds) =>
      tab.evaluate((value) => {
        /** @type {any} */ (window).clock.cost = value;
      }, milliseconds);
    await cost(5);
    await tab.until('it reports that it is slowed', () => {
      const { slowed, timeScale, time } = /** @type {any} */ (document.querySelector('hearth-fire')).stats ?? {};
      return slowed === true && timeScale > 0 && timeScale < 0.9 && time > 0;
    });
    await tab.frames(10);
    // Quick again, it keeps up with the clock, and reports that, too.
    await cost(0);
    await tab.until('it is no longer slowed', () => {
      const { slowed, timeScale } = /** @type {any} */ (document.querySelector('hearth-fire')).stats;
      return slowed === false && timeScale > 0.9 && timeScale < 1.1;
    });
    assert.deepEqual(tab.problems, []);
  });
}
