/**
 * Parts of the wasm: a page fetches one when a fire needs it, and a fire that does not get it keeps
 * its settings.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { assertBurns, events, recording } from '../assertions.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const CLASSIC = 'hearth-engine_classic.wasm';
const OUTLINES = 'hearth-engine_outlines.wasm';
const QUANTITIES = 'hearth-engine_quantities.wasm';
const FUELS = 'hearth-engine_fuels.wasm';
const BODIES = 'hearth-engine_bodies.wasm';
const WATER = 'hearth-engine_water.wasm';
const VORTICITY = 'hearth-engine_vorticity.wasm';
const GONE = { files: Object.fromEntries([CLASSIC, OUTLINES, QUANTITIES, FUELS, BODIES, WATER, VORTICITY].map((file) => [file, { status: 404, body: '' }])) };

/** The fire's model, and how often the page fetched the part for it. @param {import('../driver.mjs').Tab} tab */
const state = (tab) => tab.fire((fire) => ({
  model: fire.params.model,
  fetched: performance.getEntriesByType('resource').filter(({ name }) => name.endsWith('_classic.wasm')).length,
}));

/** A page whose engine runs at `place`. @param {string} place @param {string} body */
const page = (place, body) => recording(body).replace('<script>', `<script type="module">
    import { HearthFire } from '/web/hearth-fire.js';
    HearthFire.engine = '${place}';
  </script><script>`);

for (const place of ['worker', 'main']) {
  test(`the first classic fire fetches the part, and calls keep their order (${place})`, async () => {
    const tab = await browser.open(page(place, '<hearth-fire></hearth-fire><hearth-fire></hearth-fire>'));
    await tab.burnt(0.3);
    assert.deepEqual(await state(tab), { model: 'combustion', fetched: 0 });
    const radius = await tab.fire(async (fire) => {
      // The second value belongs to the classic model alone.
      const calls = [fire.set('model', 'classic'), fire.set('smoothing_radius', 0.07)];
      await Promise.all(calls);
      return fire.params.smoothing_radius;
    });
    assert.equal(radius, 0.07);
    assert.deepEqual(await state(tab), { model: 'classic', fetched: 1 });
    assert.equal(await tab.fire((fire) => fire.stats.engine), place);
    await tab.evaluate(async () => {
      const [, other] = /** @type {any} */ (document.querySelectorAll('hearth-fire'));
      await other.set('model', 'classic');
    });
    assert.deepEqual(await state(tab), { model: 'classic', fetched: 1 });
    await assertBurns(tab);
    assert.deepEqual(await tab.complaints(), []);
  });

  test(`without the part a fire keeps its settings and burns on (${place})`, async () => {
    const tab = await browser.open(page(place, '<hearth-fire></hearth-fire>'), GONE);
    await tab.burnt(0.3);
    const outcomes = await tab.fire((fire) => Promise.allSettled([
      fire.set({ model: 'classic' }), fire.set('wind', 0.5), fire.importConfig({ preset: 'paper-fire' }),
    ]).then((all) => all.map(({ status, reason }) => reason?.message ?? status)));
    assert.match(outcomes[0], /^The code for the classic model could not be loaded: .*hearth-engine_classic\.wasm gave 404$/);
    assert.equal(outcomes[1], 'fulfilled');
    assert.match(outcomes[2], /^The code for the classic model could not be loaded/);
    assert.deepEqual(await tab.fire(({ params }) => [params.model, params.wind]), ['combustion', 0.5]);
    await assertBurns(tab);
  });
}

test('a classic fire starts, and without the part shows the poster, the reason and a button', async () => {
  const body = recording('<hearth-fire preset="paper-fire"><p slot="poster" id="poster">A poster</p></hearth-fire>');
  const tab = await browser.open(body);
  await tab.burnt(0.3);
  assert.deepEqual(await state(tab), { model: 'classic', fetched: 1 });

  const without = await browser.open(body, GONE);
  assert.equal(await without.fire((fire) => fire.ready.then(() => '', ({ kind }) => kind)), 'load');
  const [error] = await events(without, 'error');
  assert.match(error.message, /^The code for the classic model could not be loaded/);
  assert.ok(await without.fire((fire) => fire.shadowRoot.querySelector('button').checkVisibility()));
  assert.ok(await without.evaluate(() => document.querySelector('#poster')?.checkVisibility()));
});

test('the part of another build is refused', async () => {
  // An empty module has no version, and so that of the element: it adds nothing.
  const empty = Buffer.from([0, 97, 115, 109, 1, 0, 0, 0]);
  const tab = await browser.open('<hearth-fire></hearth-fire>', { files: { [CLASSIC]: { body: empty, type: 'application/wasm' } } });
  await tab.burnt(0.3);
  const refused = await tab.fire((fire) => fire.set('model', 'classic').then(() => '', ({ message }) => message));
  assert.match(refused, /^The code for the classic model could not be loaded/);
  await assertBurns(tab);
});

/** A solid of each shape that is a list of points or a picture. */
const SHAPES = {
  polygon: { shape: 'polygon', points: '-0.1,0 0.1,0 0,0.2' },
  stroke: { shape: 'stroke', points: '-0.1,0 0.1,0.1', height: 0.03 },
  mask: { shape: 'mask', mask: '16x16:7', width: 0.1 },
};

for (const [shape, properties] of Object.entries(SHAPES)) {
  test(`the first ${shape} fetches the code for its outline, and without it is refused`, async () => {
    const solid = { kind: 'solid', x: 0.3, y: 0.5, ...properties };
    const add = (/** @type {import('../driver.mjs').Tab} */ tab) => tab.fire(async (fire, object) => {
      const box = await fire.addObject({ kind: 'solid', shape: 'box' });
      const outcome = await fire.addObject(object).then(() => 'added', ({ message }) => message);
      const { kind: _, ...shape } = object;
      const changed = await fire.changeObject(box, shape).then(() => 'changed', ({ message }) => message);
      return [outcome, changed, fire.objects.filter(({ kind }) => kind === 'solid').map((one) => one.shape).join()];
    }, solid);
    const tab = await browser.open('<hearth-fire></hearth-fire>');
    await tab.burnt(0.3);
    const fetched = () => tab.evaluate((part) => performance.getEntriesByType('resource').filter(({ name }) => name.endsWith(part)).length, OUTLINES);
    assert.equal(await fetched(), 0);
    assert.deepEqual(await add(tab), ['added', 'changed', `${shape},${shape}`]);
    assert.equal(await fetched(), 1);
    await assertBurns(tab);

    const without = await browser.open('<hearth-fire></hearth-fire>', GONE);
    await without.burnt(0.3);
    const [outcome, changed, shapes] = await add(without);
    for (const message of [outcome, changed]) assert.match(message, /^The code for polygons, strokes and masks could not be loaded/);
    assert.equal(shapes, 'box');
    await assertBurns(without);
  });
}

test('the first solid with fuel fetches the code for it, burns when it is lit, and without the code is refused', async () => {
  // Beside a low fire: the flames of a strong one reach it and light it again.
  const solid = { kind: 'solid', shape: 'box', x: 0.7, y: 0.2, width: 0.1, height: 0.1, fuel: 'wood', load: 1 };
  // Steps that the clock does not count: the same fire on a busy machine, where a flame would light it at another time.
  const tab = await browser.open('<hearth-fire autoplay="false" seed="1" max-particles="1500" ember-rate="0" fuel-power="60"></hearth-fire>');
  await tab.ready();
  await tab.fire((fire) => fire.step(100));
  const fetched = () => tab.evaluate((part) => performance.getEntriesByType('resource').filter(({ name }) => name.endsWith(part)).length, FUELS);
  assert.equal(await fetched(), 0);
  assert.equal(await tab.fire((fire) => fire.stats.fuel), '');
  const states = await tab.fire(async (fire, object) => {
    const all = [];
    const note = async () => {
      await fire.step(60);
      all.push(fire.stats.fuel);
    };
    // The statistics of a paused fire follow each picture.
    fire.pause();
    const id = await fire.addObject(object);
    await note();
    await fire.ignite(id);
    await note();
    await fire.extinguish(id);
    await fire.step(300);
    await note();
    await fire.ignite(0.7, 0.15);
    await note();
    await fire.extinguish(0.7, 0.2, 0.3);
    await fire.play();
    return all;
  }, solid);
  assert.deepEqual(states, ['unlit', 'burning', 'out', 'burning']);
  assert.equal(await fetched(), 1);
  assert.deepEqual(await tab.complaints(), []);
  const refused = await tab.fire(async (fire) => {
    const calls = [fire.ignite(99), fire.ignite(5, 5), fire.extinguish(1), fire.ignite(NaN, 1), fire.ignite('x')];
    return (await Promise.allSettled(calls)).map(({ reason }) => reason?.message ?? 'done');
  });
  for (const message of refused.slice(0, 3)) assert.match(message, /^place = \d+ is refused: it must be a solid with fuel/);
  for (const message of refused.slice(3)) assert.match(message, /is refused/);
  await assertBurns(tab);

  const without = await browser.open('<hearth-fire></hearth-fire>', GONE);
  await without.burnt(0.3);
  const { fuel: _, ...cold } = solid;
  const outcomes = await without.fire(async (fire, objects) => Promise.allSettled(objects.map((object) => fire.addObject(object)))
    .then((all) => all.map(({ status, reason }) => reason?.message ?? status)), [cold, solid]);
  assert.equal(outcomes[0], 'fulfilled');
  assert.match(outcomes[1], /^The code for (solids that burn|polygons, strokes and masks) could not be loaded/);
  await assertBurns(without);
});

test('the display modes that show particles or a quantity fetch their code, and without it are refused', async () => {
  const show = (/** @type {import('../driver.mjs').Tab} */ tab, /** @type {string[]} */ modes) => tab.fire(async (fire, all) => {
    const outcomes = [];
    for (const mode of all) {
      outcomes.push(await fire.set('display_mode', mode).then(() => '', ({ message }) => message));
      await fire.step(2);
    }
    return outcomes;
  }, modes);
  const others = ['particles', 'temperature', 'density', 'pressure', 'velocity', 'vorticity', 'distance', 'fuel', 'soot', 'neighbours', 'sprites'];
  const tab = await browser.open('<hearth-fire></hearth-fire>', GONE);
  await tab.burnt(0.3);
  for (const message of await show(tab, others)) assert.match(message, /^The code for quantities of the gas could not be loaded/);
  // Those of a fire need no code.
  assert.deepEqual(await show(tab, ['paper', 'fire']), ['', '']);
  await assertBurns(tab);
  const whole = await browser.open('<hearth-fire></hearth-fire>');
  await whole.burnt(0.3);
  assert.deepEqual(await show(whole, [...others, 'paper', 'fire']), Array(others.length + 2).fill(''));
  assert.deepEqual(await whole.complaints(), []);
});

test('a scene that needs both parts gets both', async () => {
  const tab = await browser.open('<hearth-fire model="classic"><hearth-solid shape="polygon" points="-0.1,0 0.1,0 0,0.2"></hearth-solid></hearth-fire>');
  await tab.burnt(0.3);
  await tab.until('the solid is there', () => /** @type {any} */ (document.querySelector('hearth-fire')).objects.length === 2);
  assert.equal(await tab.fire((fire) => fire.params.model), 'classic');
});

test('the code for a stored burning scene loads before the engine runs', async () => {
  const tab = await browser.open(page('worker', '<hearth-fire preset="fireside" warm></hearth-fire>'), {
    files: { 'engine/worker.js': { silent: true } },
  });
  await tab.until('the code', () => (
    performance.getEntriesByType('resource').some(({ name }) => name.endsWith('hearth-engine_burning.wasm'))
  ));
});

test('the first free solid fetches the code for it, falls, and without the code is refused', async () => {
  const solid = { kind: 'solid', shape: 'box', x: 0.5, y: 0.6, width: 0.1, height: 0.1, motion: 'free' };
  const tab = await browser.open('<hearth-fire max-particles="1500" floor="solid"></hearth-fire>');
  await tab.burnt(0.3);
  const fetched = () => tab.evaluate((part) => performance.getEntriesByType('resource').filter(({ name }) => name.endsWith(part)).length, BODIES);
  assert.equal(await fetched(), 0);
  const place = await tab.fire(async (fire, object) => {
    const id = await fire.addObject(object);
    await fire.step(60);
    // The values are those of the start.
    return fire.objects.find((one) => one.id === id)?.y;
  }, solid);
  assert.equal(place, 0.6);
  assert.equal(await fetched(), 1);
  await assertBurns(tab);
  assert.deepEqual(await tab.complaints(), []);

  const without = await browser.open('<hearth-fire></hearth-fire>', GONE);
  await without.burnt(0.3);
  const outcome = await without.fire((fire, object) => fire.addObject(object).then(() => 'added', ({ message }) => message), solid);
  assert.match(outcome, /^The code for free solids could not be loaded/);
  await assertBurns(without);
});

test('the first spray fetches the code for it, puts out the fire, and without the code is refused', async () => {
  const body = '<hearth-fire max-particles="1500" ember-rate="0" floor="solid"></hearth-fire>';
  const tab = await browser.open(body);
  await tab.burnt(0.5);
  const fetched = () => tab.evaluate((part) => performance.getEntriesByType('resource').filter(({ name }) => name.endsWith(part)).length, WATER);
  assert.equal(await fetched(), 0);
  const [before, after] = await tab.fire(async (fire) => {
    fire.pause();
    await fire.step(30);
    const { power } = fire.stats;
    for (let call = 0; call < 60; call += 1) {
      await fire.spray(0, 1, 0, -4, 40);
      await fire.step(8);
    }
    await fire.step(300);
    return [power, fire.stats.power];
  });
  assert.ok(after < 0.1 * before, `${before} kW/m, then ${after}`);
  assert.equal(await fetched(), 1);
  assert.deepEqual(await tab.complaints(), []);
  const refused = await tab.fire(async (fire) => {
    const calls = [fire.spray(0, Infinity), fire.spray(0, 1, 21), fire.spray(0, 1, 0, 0, 0), fire.spray(0, 1, 0, 0, 1001), fire.spray('x', 1)];
    await fire.set('model', 'classic');
    calls.push(fire.spray(0, 0.5));
    return (await Promise.allSettled(calls)).map(({ reason }) => reason?.message ?? 'done');
  });
  for (const message of refused) assert.match(message, /is refused/);
  assert.equal(refused.at(-1), 'model = "classic" is refused: it must be combustion: the classic model has no water');

  const without = await browser.open('<hearth-fire></hearth-fire>', GONE);
  await without.burnt(0.3);
  assert.match(await without.fire((fire) => fire.spray(0, 1).then(() => 'sprayed', ({ message }) => message)), /^The code for water could not be loaded/);
  await assertBurns(without);
});

test('the first confinement of vorticity fetches the code for it, and without the code is refused', async () => {
  const tab = await browser.open('<hearth-fire max-particles="1500"></hearth-fire>');
  await tab.burnt(0.3);
  const fetched = () => tab.evaluate((part) => performance.getEntriesByType('resource').filter(({ name }) => name.endsWith(part)).length, VORTICITY);
  assert.equal(await fetched(), 0);
  await tab.fire((fire) => fire.set('vorticity_confinement', 0.3));
  await tab.fire((fire) => fire.step(60));
  assert.equal(await fetched(), 1);
  await assertBurns(tab);
  assert.deepEqual(await tab.complaints(), []);

  const without = await browser.open('<hearth-fire></hearth-fire>', GONE);
  await without.burnt(0.3);
  const outcome = await without.fire((fire) => fire.set('vorticity_confinement', 0.3).then(() => 'set', ({ message }) => message));
  assert.match(outcome, /^The code for vorticity confinement could not be loaded/);
  assert.equal(await without.fire((fire) => fire.params.vorticity_confinement), 0);
  await assertBurns(without);
});
