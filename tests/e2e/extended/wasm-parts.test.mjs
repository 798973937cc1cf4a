/**
 * Parts of the wasm: a page fetches one when a fire needs it, and a fire that does not get it keeps
 * its settings.
 */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { Browser, THREADS } from '../driver.mjs';
import { assertBurns, events, recording } from '../assertions.mjs';
import { SITE } from '../site.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const CLASSIC = 'hearth-engine_classic.wasm';
const BODIES = 'hearth-engine_bodies.wasm';

/** How often the page fetched a file. @param {import('../driver.mjs').Tab} tab @param {string} file */
const fetched = (tab, file) =>
  tab.evaluate((end) => performance.getEntriesByType('resource').filter(({ name }) => name.endsWith(end)).length, file);

/** The fire's model, and how often the page fetched the part for it. @param {import('../driver.mjs').Tab} tab */
const state = async (tab) => ({
  model: await tab.fire((fire) => fire.params.model),
  fetched: await fetched(tab, CLASSIC),
});

/** A page whose engine runs on `thread`. @param {string} thread @param {string} body */
const page = (thread, body) =>
  recording(body).replace(
    '<script>',
    `<script type="module">
    import { HearthFire } from '/web/hearth-fire.js';
    HearthFire.engine = '${thread}';
  </script><script>`,
  );

for (const thread of THREADS) {
  test(`the first classic fire fetches the part, and calls keep their order (${thread})`, async () => {
    const tab = await browser.open(page(thread, '<hearth-fire></hearth-fire><hearth-fire></hearth-fire>'));
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
    assert.equal(await tab.fire((fire) => fire.stats.engine), thread);
    await tab.evaluate(async () => {
      const [, other] = /** @type {any} */ (document.querySelectorAll('hearth-fire'));
      await other.set('model', 'classic');
    });
    assert.deepEqual(await state(tab), { model: 'classic', fetched: 1 });
    await assertBurns(tab);
    assert.deepEqual(await tab.problemsAfterFrame(), []);
  });
}

test('a fire that does not get a part keeps its settings and burns on, and the call rejects with the reason', async () => {
  // An empty module has no version, and so not that of the element.
  const empty = Buffer.from([0, 97, 115, 109, 1, 0, 0, 0]);
  const tab = await browser.open('<hearth-fire></hearth-fire>', {
    files: { [CLASSIC]: { body: empty, type: 'application/wasm' }, [BODIES]: { status: 404, body: '' } },
  });
  await tab.burnt(0.3);
  const outcomes = await tab.fire((fire) =>
    Promise.allSettled([
      fire.set({ model: 'classic' }),
      fire.set('wind', 0.5),
      fire.importConfig({ preset: 'paper-fire' }),
      fire.addObject({ kind: 'solid', fuel: 'wood' }),
      fire.addObject({ kind: 'solid', motion: 'free' }),
      fire.addObject({ kind: 'solid' }),
      fire.spray(0, 1),
    ]).then((all) => all.map(({ status, reason }) => reason?.message ?? status)),
  );
  const classic = /^The code for the classic model could not be loaded: its wasm has version none/;
  const bodies =
    /^The code for fuels, water and free solids could not be loaded: .*hearth-engine_bodies\.wasm gave 404$/;
  for (const at of [0, 2]) assert.match(outcomes[at], classic);
  for (const at of [3, 4, 6]) assert.match(outcomes[at], bodies);
  for (const at of [1, 5]) assert.equal(outcomes[at], 'fulfilled');
  const kept = await tab.fire(({ params, objects }) => [params.model, params.wind, objects.length]);
  assert.deepEqual(kept, ['combustion', 0.5, 2]);
  await assertBurns(tab);
});

test('a fire whose part never arrives plays and pauses at once, and its removal drops the call', async () => {
  const tab = await browser.open('<hearth-fire quality="low"></hearth-fire>', {
    files: { [BODIES]: { silent: true } },
  });
  await tab.burnt(0.3);
  const outcome = await tab.fire(async (fire) => {
    const call = fire.importConfig({ preset: 'house-of-cards' });
    await fire.pause();
    const paused = [fire.paused, fire.matches(':state(burning)')];
    await fire.play();
    fire.remove();
    await fire.destroy();
    const dropped = await call.catch(({ message }) => message);
    document.body.append(fire);
    await fire.ready;
    return { paused, dropped, preset: fire.preset };
  });
  assert.deepEqual(outcome, { paused: [true, false], dropped: 'the fire was removed', preset: 'default' });
  await assertBurns(tab);
});

test('a part of another build is refused, and the fire gets the right one with the next call', async () => {
  const other = readFileSync(path.join(SITE, 'web/wasm', CLASSIC));
  // The hash of its build ends it.
  other[other.length - 1] ^= 1;
  const tab = await browser.open('<hearth-fire quality="low"></hearth-fire>', {
    files: { [CLASSIC]: { body: other, type: 'application/wasm' } },
  });
  await tab.burnt(0.3);
  const classic = () => tab.fire((fire) => fire.set('model', 'classic').then(() => fire.params.model, String));
  assert.match(await classic(), /could not be loaded: it is of another build/);
  await assertBurns(tab);
  browser.server.replace({});
  assert.equal(await classic(), 'classic');
  await assertBurns(tab);
});

test('a classic fire that does not get its part shows the poster, the reason and a button', async () => {
  const body = recording('<hearth-fire preset="paper-fire"><p slot="poster" id="poster">A poster</p></hearth-fire>');
  const tab = await browser.open(body, { files: { [CLASSIC]: { status: 404, body: '' } } });
  assert.equal(
    await tab.fire((fire) =>
      fire.ready.then(
        () => '',
        ({ kind }) => kind,
      ),
    ),
    'load',
  );
  const [error] = await events(tab, 'error');
  assert.match(error.message, /^The code for the classic model could not be loaded/);
  assert.ok(await tab.fire((fire) => fire.shadowRoot.querySelector('button').checkVisibility()));
  assert.ok(await tab.evaluate(() => document.querySelector('#poster')?.checkVisibility()));
});

test('the first solid with fuel and the first spray fetch their part, once', async () => {
  const tab = await browser.open('<hearth-fire autoplay="false" seed="1" particles="1500"></hearth-fire>');
  await tab.ready();
  await tab.fire((fire) => fire.step(100));
  assert.equal(await fetched(tab, BODIES), 0);
  const states = await tab.fire(async (fire) => {
    const all = [];
    const note = async () => {
      await fire.step(60);
      all.push(fire.stats.fuel);
    };
    // The statistics of a paused fire follow each picture.
    fire.pause();
    const box = { kind: 'solid', shape: 'box', x: 0.7, y: 0.2, width: 0.1, height: 0.1 };
    const id = await fire.addObject({ ...box, fuel: 'wood', load: 1 });
    await note();
    await fire.ignite(id);
    await note();
    await fire.spray(0, 1, 0, -4, 40);
    return all;
  });
  assert.deepEqual(states, ['unlit', 'burning']);
  assert.equal(await fetched(tab, BODIES), 1);
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});
