/**
 * The objects of a fire: set, read, sent and stored with the settings.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { events, recording } from '../assertions.mjs';
import { destroyedAndBack } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const TWO = [
  { kind: 'source', id: 1, x: -0.3, width: 0.2 },
  { kind: 'source', id: 7, x: 0.3, power: 50 },
];

/** Where the objects stand, by their ids. */
function places(tab) {
  return tab.fire((fire) => Object.fromEntries(fire.objects.map(({ id, x }) => [id, x])));
}

/** The error of a refused `act`. */
function refusal(tab, act, given) {
  return tab.fire(
    async (fire, [source, given]) => {
      try {
        await new Function('fire', 'given', `return (${source})(fire, given)`)(fire, given);
        return null;
      } catch ({ name, message, id, value, min, max }) {
        return { name, message, id, value, min, max };
      }
    },
    [String(act), given],
  );
}

test('objects are added, changed and removed, and each change is reported once', async () => {
  const tab = await browser.show(recording('<hearth-fire paused></hearth-fire>'));
  await tab.ready();
  const ids = await tab.fire(async (fire) => [
    await fire.addObject({ kind: 'source', x: 0.3 }),
    await fire.addObject({ kind: 'source', id: 7 }),
  ]);
  assert.deepEqual(ids, [2, 7]);
  await tab.fire((fire) => fire.changeObject(7, { x: -0.3 }));
  assert.deepEqual(await places(tab), { 1: 0, 2: 0.3, 7: -0.3 });
  // The next one becomes the first, and the parameters are its own.
  await tab.fire((fire) => fire.removeObject(1));
  assert.deepEqual(await places(tab), { 2: 0.3, 7: -0.3 });
  assert.equal(await tab.fire((fire) => fire.params.source_x), 0.3);
  const counts = (await events(tab, 'objects-change')).map(({ objects, source }) => [objects.length, source]);
  assert.deepEqual(counts, [
    [2, 'property'],
    [3, 'property'],
    [3, 'property'],
    [2, 'property'],
  ]);
  assert.deepEqual(
    (await events(tab, 'params-change')).map(({ id }) => id),
    ['source_x'],
  );
  // Without a source nothing burns. The next one has the defaults and an id that no object has had.
  await tab.fire(async (fire) => {
    await fire.removeObject(2);
    await fire.removeObject(7);
  });
  assert.deepEqual(await places(tab), {});
  await tab.fire((fire) => fire.addObject({ kind: 'source' }));
  assert.deepEqual(await places(tab), { 8: 0 });
});

test('an invalid object is rejected with its mistake, and nothing changes', async () => {
  const tab = await browser.show('<hearth-fire paused></hearth-fire>');
  await tab.ready();
  const wrong = [
    [(fire) => fire.addObject({ kind: 'stone' }), 'objects[1].kind', /it must be source or solid/],
    [(fire) => fire.addObject({ kind: 'source', power: 3500 }), 'objects[1].power', /from 0 to 3000 kW\/m/],
    [(fire) => fire.changeObject(9, { x: 0 }), 'id', /the id of an object/],
    [(fire) => fire.changeObject(1, { x: 'far' }), 'objects[0].x', /from -3 to 3 m/],
    [(fire) => fire.removeObject(9), 'id', /the id of an object/],
    [(fire) => fire.set({ objects: 'two' }), 'objects', /an array of objects/],
    [(fire) => fire.set({ objects: Array(65).fill({ kind: 'source' }) }), 'objects', /at most 64/],
  ];
  for (const [act, id, words] of wrong) {
    const error = await refusal(tab, act);
    assert.equal(error?.name, 'RangeError', String(act));
    assert.equal(error.id, id);
    assert.match(error.message, words);
  }
  assert.deepEqual(await places(tab), { 1: 0 });
  const { min, max, value } = await refusal(tab, (fire) => fire.changeObject(1, { power: 3500 }));
  assert.deepEqual([min, max, value], [0, 3000, 3500]);
});

test('the attribute holds objects as JSON, and bad JSON is rejected with a message', async () => {
  const tab = await browser.show(`<hearth-fire paused objects='${JSON.stringify(TWO)}'></hearth-fire>`);
  await tab.ready();
  assert.deepEqual(await places(tab), { 1: -0.3, 7: 0.3 });
  await tab.fire((fire) => fire.setAttribute('objects', '[{"kind": "source"'));
  await tab.fire((fire) => fire.set('exposure', 0.5));
  assert.deepEqual(await places(tab), { 1: -0.3, 7: 0.3 });
  await tab.fire(async (fire) => {
    fire.removeAttribute('objects');
    await fire.set('exposure', 0);
  });
  assert.deepEqual(await places(tab), { 1: 0 });
});

test('objects go with settings, and come back when the element does', async () => {
  const tab = await browser.show('<hearth-fire paused></hearth-fire>');
  await tab.ready();
  await tab.fire((fire, objects) => fire.set({ objects, wind: 1 }), TWO);
  const config = await tab.fire((fire) => fire.exportConfig());
  assert.deepEqual(config, { hearth: 3, values: { wind: 1 }, objects: TWO });
  await destroyedAndBack(tab);
  assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), config);
  await tab.fire((fire) => fire.importConfig({ hearth: 3, values: { source_x: 0.1 } }));
  assert.deepEqual(await places(tab), { 1: 0.1 });
  await tab.fire((fire, config) => fire.importConfig(JSON.stringify(config)), config);
  assert.deepEqual(await places(tab), { 1: -0.3, 7: 0.3 });
  await tab.fire((fire) => fire.restore('objects'));
  assert.deepEqual(await places(tab), { 1: 0 });
});

test('an address carries objects, and the page writes them into its own', async () => {
  const tab = await browser.open(`index.html?scene=default&objects=${encodeURIComponent(JSON.stringify(TWO))}`);
  await tab.ready();
  assert.deepEqual(await places(tab), { 1: -0.3, 7: 0.3 });
  await tab.fire((fire) => fire.changeObject(7, { x: 0.25 }));
  const objects = await tab.until('the address has the objects', () => {
    const text = new URLSearchParams(location.search).get('objects');
    return text?.includes('0.25') && text;
  });
  assert.deepEqual(JSON.parse(objects), [TWO[0], { ...TWO[1], x: 0.25 }]);
});
