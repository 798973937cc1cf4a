/**
 * `<hearth-source>` and `<hearth-solid>`: children of a fire that are objects in it, and the boxes of other elements
 * that they take with `of`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { events, recording } from '../assertions.mjs';
import { acts, fireOf, openChildren, owned, settled, warnings } from '../children.mjs';
import { table } from '../site.mjs';

const { PRESETS } = await table();
/** The power of the candle's source [kW/m]. */
const CANDLE = PRESETS.find(({ name }) => name === 'candle').values.fuel_power;

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** A page whose fire has these children, once every child has its object. */
const opened = (/** @type {string} */ children, attributes = '', before = '') =>
  openChildren(browser, children, attributes, before);

/** The objects of the fire, each as `kind x`, in their order. */
const listed = (tab) => tab.fire((fire) => fire.objects.map(({ kind, x }) => `${kind} ${x}`));

test('a child is an object with the properties that its attributes state', async () => {
  const tab = await opened(
    `
    <hearth-source x="0.2" width="0.3"></hearth-source>
    <hearth-source x="-0.2" birth-temperature="1500"></hearth-source>
    <hearth-solid shape="box" x="-0.1" y="0.9" material="iron"></hearth-solid>`,
    'fuel-power="100"',
  );
  const [first, second, solid] = await owned(tab);
  assert.deepEqual([first.kind, first.x, first.width, first.power], ['source', 0.2, 0.3, 100]);
  assert.deepEqual([second.kind, second.x, second.power], ['source', -0.2, 220]);
  assert.deepEqual(
    [solid.kind, solid.shape, solid.x, solid.y, solid.material, solid.width],
    ['solid', 'box', -0.1, 0.9, 'iron', 0.2],
  );
  assert.equal((await listed(tab)).length, 3);
  await acts(tab, (fire) => fire.set('model', 'classic'));
  assert.equal((await owned(tab))[1].birth_temperature, 1500);
});

test('the first source takes the place of the source of the settings, which comes back with the last one gone', async () => {
  const tab = await opened('<hearth-source x="0.2" power="80"></hearth-source>', 'preset="candle" source-width="0.1"');
  assert.equal(await tab.fire((fire) => fire.objects.filter(({ kind }) => kind === 'source').length), 1);
  const values = (fire) => [fire.params.source_x, fire.params.fuel_power, fire.params.source_width];
  assert.deepEqual(await tab.fire(values), [0.2, 80, 0.1]);
  await acts(tab, (fire) => fire.append(Object.assign(document.createElement('hearth-source'), { id: 'second' })));
  assert.equal(await tab.fire((fire) => fire.objects.filter(({ kind }) => kind === 'source').length), 2);
  await acts(tab, (fire) => fire.firstElementChild.removeAttribute('power'));
  assert.deepEqual(await tab.fire(values), [0.2, CANDLE, 0.1]);
  await acts(tab, (fire) => fire.replaceChildren());
  assert.deepEqual(await tab.fire(values), [0, CANDLE, 0.1]);
  assert.equal(await tab.fire((fire) => fire.objects.filter(({ kind }) => kind === 'source').length), 1);
});

test('a fire without a source gets that of its child', async () => {
  const tab = await opened('<hearth-source x="0.2"></hearth-source>', "objects='[]'");
  assert.deepEqual(await listed(tab), ['source 0.2']);
  await acts(tab, (fire) => fire.firstElementChild.remove());
  assert.deepEqual(await listed(tab), []);
});

test('attributes are live, a call changes the object and not the attribute, and the next attribute wins', async () => {
  const tab = await opened('<hearth-solid x="0.1" y="0.8"></hearth-solid>');
  const child = (act, ...args) =>
    acts(tab, new Function('fire', '...args', `return (${act})(fire.firstElementChild, fire, ...args)`), ...args);
  const values = async () => (({ x, y, width }) => [x, y, width])((await owned(tab))[0]);
  await child(String((solid) => solid.setAttribute('width', '0.3')));
  assert.deepEqual(await values(), [0.1, 0.8, 0.3]);
  await child(String((solid, fire) => fire.changeObject(solid.objectId, { x: -0.2, y: 1 })));
  assert.deepEqual(await values(), [-0.2, 1, 0.3]);
  assert.equal(await tab.fire((fire) => fire.firstElementChild.getAttribute('x')), '0.1');
  // The same text is a change as well; the other properties stay.
  await child(String((solid) => solid.setAttribute('x', '0.1')));
  assert.deepEqual(await values(), [0.1, 1, 0.3]);
  await child(
    String((solid) => {
      solid.removeAttribute('width');
      solid.removeAttribute('y');
    }),
  );
  assert.deepEqual(await values(), [0.1, 0.5, 0.2]);
  // Of a call and an attribute in one task, the later one wins.
  await child(
    String((solid, fire) => {
      solid.setAttribute('x', '0.2');
      fire.changeObject(solid.objectId, { x: 0.3 });
    }),
  );
  assert.deepEqual(await values(), [0.3, 0.5, 0.2]);
  assert.deepEqual(tab.problems, []);
  const origins = (await events(tab, 'objects-change')).map(({ source }) => source);
  assert.deepEqual(origins, ['child', 'property', 'child', 'child', 'child', 'property']);
});

test('children are added, removed and reordered, and keep their ids', async () => {
  const tab = await opened('<hearth-solid x="0.1"></hearth-solid><p>text</p><hearth-solid x="0.2"></hearth-solid>');
  const ids = () => tab.fire((fire) => [...fire.querySelectorAll('hearth-solid')].map(({ objectId }) => objectId));
  const [first, second] = await ids();
  await acts(tab, (fire) => {
    const added = document.createElement('hearth-solid');
    added.setAttribute('x', '0.3');
    fire.prepend(added);
  });
  const [third] = await ids();
  assert.deepEqual(await listed(tab), ['source 0', 'solid 0.3', 'solid 0.1', 'solid 0.2']);
  await acts(tab, (fire) => fire.append(fire.firstElementChild));
  assert.deepEqual(await ids(), [first, second, third]);
  assert.deepEqual(await listed(tab), ['source 0', 'solid 0.1', 'solid 0.2', 'solid 0.3']);
  await acts(tab, (fire) => fire.firstElementChild.remove());
  assert.deepEqual(await listed(tab), ['source 0', 'solid 0.2', 'solid 0.3']);
  assert.deepEqual(await ids(), [second, third]);
});

for (const [name, children] of [
  ['in a paragraph', '<p><hearth-solid x="0.1"></hearth-solid><br><hearth-solid x="0.2"></hearth-solid></p>'],
  ['without end tags', '<hearth-solid x="0.1" /><hearth-solid x="0.2" />'],
  [
    'in lists of lists',
    '<ul><li><hearth-solid x="0.1"></hearth-solid><ul><li><hearth-solid x="0.2"></hearth-solid></ul></ul>',
  ],
  ['one of them inside another kind', '<hearth-solid x="0.1"></hearth-solid><div><hearth-solid x="0.2" /></div>'],
]) {
  test(`objects ${name} are children of the fire, live in their attributes and in number`, async () => {
    const tab = await opened(children);
    const solids = async () => (await listed(tab)).filter((object) => object.startsWith('solid'));
    assert.deepEqual(await solids(), ['solid 0.1', 'solid 0.2']);
    await acts(tab, (fire) => fire.querySelectorAll('hearth-solid')[1].setAttribute('x', '0.3'));
    assert.deepEqual(await solids(), ['solid 0.1', 'solid 0.3']);
    await acts(tab, (fire) => fire.querySelectorAll('hearth-solid')[1].remove());
    assert.deepEqual(await solids(), ['solid 0.1']);
    assert.deepEqual(warnings(tab), []);
  });
}

test('the objects of a fire inside another one are not those of the outer fire', async () => {
  const tab = await opened(`<hearth-solid x="0.1"></hearth-solid>${fireOf('<hearth-solid x="0.2"></hearth-solid>')}`);
  assert.deepEqual((await listed(tab)).slice(1), ['solid 0.1']);
});

test('calls beside a reordering are kept', async () => {
  const tab = await opened('<hearth-solid></hearth-solid>'.repeat(40));
  const ids = await acts(tab, async (fire) => {
    const all = [...fire.children];
    fire.prepend(all[1]);
    // A call is on its way at each moment, also when the list of objects is sent.
    for (const { objectId } of all) {
      fire.changeObject(objectId, { y: 1 });
      await new Promise((resolve) => setTimeout(resolve));
    }
    return all.map(({ objectId }) => objectId);
  });
  const objects = await tab.fire((fire) => fire.objects.slice(1).map(({ id, y }) => [id, y]));
  const [first, second, ...others] = ids;
  assert.deepEqual(
    objects,
    [second, first, ...others].map((id) => [id, 1]),
  );
});

test('a child moves between fires, also while one is off the page', async () => {
  const tab = await browser.show(fireOf('<hearth-solid x="0.1"></hearth-solid>') + fireOf(''));
  await tab.ready();
  const lists = () =>
    tab.evaluate(() =>
      [...document.querySelectorAll('hearth-fire')].map((fire) =>
        /** @type {any} */ (fire).objects.map(({ kind }) => kind).join(),
      ),
    );
  const moves = (from, to) =>
    tab.evaluate(
      async (from, to) => {
        const fires = document.querySelectorAll('hearth-fire');
        await Promise.all([...fires].map((fire) => /** @type {any} */ (fire).ready));
        fires[to].append(/** @type {Element} */ (fires[from].firstElementChild));
      },
      from,
      to,
    );
  await moves(0, 1);
  await settled(tab);
  assert.deepEqual(await lists(), ['source', 'source,solid']);
  assert.ok(await tab.evaluate(() => /** @type {any} */ (document.querySelector('hearth-solid')).objectId > 0));
  await moves(1, 0);
  await settled(tab);
  assert.deepEqual(await lists(), ['source,solid', 'source']);
  // A fire that leaves the page keeps its children; what changes meanwhile counts when it is back.
  await tab.fire(async (fire) => {
    const { parentNode, nextSibling } = fire;
    fire.remove();
    await fire.destroy();
    fire.firstElementChild.setAttribute('x', '0.4');
    fire.append(document.createElement('hearth-source'));
    parentNode.insertBefore(fire, nextSibling);
    await fire.ready;
  });
  await settled(tab);
  assert.deepEqual(await listed(tab), ['solid 0.4', 'source 0']);
  assert.deepEqual(tab.problems, []);
});

test('a child without a fire does nothing, and one that is there before the element is defined works', async () => {
  const tab = await opened(
    '<hearth-solid x="0.1"></hearth-solid>',
    '',
    '<hearth-solid x="0.3" pwer="1"></hearth-solid>',
  );
  assert.deepEqual(await listed(tab), ['source 0', 'solid 0.1']);
  const ids = await tab.evaluate(() =>
    [...document.querySelectorAll('hearth-solid')].map((solid) => /** @type {any} */ (solid).objectId),
  );
  assert.deepEqual(
    ids.map((id) => id === null),
    [true, false],
  );
  await tab.evaluate(() => document.querySelector('hearth-solid')?.setAttribute('x', '9'));
  await settled(tab);
  assert.deepEqual(tab.problems, []);
});

test('the code is loaded with the first child', async () => {
  const tab = await browser.open(fireOf(''));
  await tab.ready();
  const loaded = () =>
    tab.evaluate(
      () => performance.getEntriesByType('resource').filter(({ name }) => name.endsWith('children.js')).length,
    );
  assert.equal(await loaded(), 0);
  await tab.fire((fire) => fire.append(document.createElement('hearth-solid')));
  await tab.until(
    'the child has its object',
    () => /** @type {any} */ (document.querySelector('hearth-solid')).objectId,
  );
  assert.equal(await loaded(), 1);
});

test('without the code the fire burns without its children, with a warning', async () => {
  const tab = await browser.open(recording(fireOf('<hearth-solid></hearth-solid>')), {
    without: 'element/children/children.js',
  });
  await tab.ready();
  assert.deepEqual(await listed(tab), ['source 0']);
  const [error, ...more] = await events(tab, 'error');
  assert.deepEqual([error.kind, more.length], ['load', 0]);
  assert.match(error.message, /The code for children could not be loaded/);
});

test('a warm fire has burnt with its children before it is shown', async () => {
  const tab = await browser.show(
    fireOf('<hearth-source power="0"></hearth-source><hearth-solid x="0.1"></hearth-solid>', 'warm="0.5"'),
  );
  await tab.ready();
  assert.deepEqual(await listed(tab), ['source 0', 'solid 0.1']);
  const stats = await tab.until(
    'its statistics',
    () => /** @type {any} */ (document.querySelector('hearth-fire')).stats,
  );
  // With another power something would have burnt.
  assert.ok(
    stats.time >= 0.5 && stats.power === 0 && stats.embers === 0,
    `${stats.time} s, ${stats.power} kW/m, ${stats.embers} embers`,
  );
});

test('both kinds of children work in the classic model', async () => {
  const tab = await opened(
    '<hearth-source x="0.2" rate="900"></hearth-source><hearth-source life-min="0.5"></hearth-source><hearth-solid x="0.3"></hearth-solid>',
    'model="classic"',
  );
  const [first, second, solid] = await owned(tab);
  assert.deepEqual([first.rate, first.speed, second.life_min, second.rate, solid.x], [900, 1, 0.5, 1500, 0.3]);
  await acts(tab, (fire) => fire.children[0].removeAttribute('rate'));
  await acts(tab, (fire) => fire.children[1].removeAttribute('life-min'));
  assert.deepEqual(
    (await owned(tab)).slice(0, 2).map(({ rate, life_min }) => [rate, life_min]),
    [
      [1500, 0.3],
      [1500, 0.3],
    ],
  );
  assert.deepEqual(tab.problems, []);
});

test('an error names the element, the attribute, the value and the range, and the last valid value stays', async () => {
  const tab = await opened(
    '<hearth-solid id="lid" x="0.1" width="0" y="0.7"></hearth-solid><hearth-source power="700" x="0.2"></hearth-source>',
  );
  const [solid, source] = await owned(tab);
  assert.deepEqual([solid.x, solid.y, solid.width, source.x, source.power], [0.1, 0.7, 0.2, 0.2, 220]);
  await acts(tab, (fire) => fire.firstElementChild.setAttribute('material', 'straw'));
  await acts(tab, (fire) => fire.firstElementChild.setAttribute('of', 'headline'));
  assert.equal((await owned(tab))[0].material, 'stone');
  const words = await events(tab, 'error');
  assert.deepEqual(words.map(({ id, value, min, max }) => [id, value, min, max]).sort(), [
    ['material', 'straw', undefined, undefined],
    ['of', 'headline', undefined, undefined],
    ['power', '700', 0, 600],
    ['width', '0', 0.002, 10],
  ]);
  const all = warnings(tab).join('\n');
  assert.match(all, /<hearth-solid id="lid">: width = "0" is refused: it must be a number from 0.002 to 10 m/);
  assert.match(all, /<hearth-source>: power = "700" is refused: it must be a number from 0 to 600 kW\/m/);
  assert.match(all, /<hearth-solid id="lid">: material = "straw" is refused: it must be one of stone, wood/);
  assert.match(all, /<hearth-solid id="lid">: of = headline is refused: it must be # and the id of an element/);
});

test('outlines and flags are attributes, and a text that is too long is refused', async () => {
  const tab = await opened('<hearth-solid shape="polygon" points="0,0.1 0.1,-0.1 -0.1,-0.1" front></hearth-solid>');
  const shape = async () => (({ shape, points, front }) => [shape, points, front])((await owned(tab))[0]);
  assert.deepEqual(await shape(), ['polygon', '0,0.1 0.1,-0.1 -0.1,-0.1', true]);
  await acts(tab, (fire) => fire.firstElementChild.removeAttribute('front'));
  await acts(tab, (fire) => fire.firstElementChild.setAttribute('points', '0,0 '.repeat(30_000)));
  assert.deepEqual(await shape(), ['polygon', '0,0.1 0.1,-0.1 -0.1,-0.1', false]);
  assert.match(warnings(tab).join(), /<hearth-solid>: points = "a text of more than 66000 letters" is refused/);
});

test('an unknown attribute causes one warning with the name that may be meant', async () => {
  const tab = await opened(
    '<hearth-solid materal="wood" class="a" data-x="1"></hearth-solid><hearth-solid materal="wood"></hearth-solid>',
  );
  await acts(tab, (fire) => fire.firstElementChild.setAttribute('birth_temperature', '1'));
  await tab.until('both are reported', (count) => count >= 2, warnings(tab).length + 2);
  assert.equal(warnings(tab).length, 2, warnings(tab).join('\n'));
  assert.match(warnings(tab)[0], /<hearth-solid>: it has no attribute materal; did you mean material\?/);
});

test('children beyond 64 are refused with a message, and get their index when there is room', async () => {
  const tab = await opened('<hearth-solid></hearth-solid>'.repeat(65));
  const ids = () => tab.fire((fire) => [...fire.children].map(({ objectId }) => objectId));
  assert.deepEqual(
    (await ids()).map((id) => id === null),
    [...Array(64).fill(false), true],
  );
  assert.equal(warnings(tab).length, 1);
  assert.match(warnings(tab)[0], /<hearth-solid>: objects = 65 solids is refused: it must be at most 64 solids/);
  await acts(tab, (fire) => fire.firstElementChild.remove());
  assert.ok((await ids()).every((id) => id > 0));
});

test('a preset, settings and a reset keep the objects of the children', async () => {
  const tab = await opened(
    '<hearth-source x="0.2"></hearth-source><hearth-solid x="0.3" y="0.9"></hearth-solid>',
    "objects='[]'",
  );
  const kept = async (why) => {
    const [source, solid] = await owned(tab);
    assert.deepEqual([source?.x, solid?.x, solid?.y, solid?.width], [0.2, 0.3, 1.1, 0.2], why);
  };
  await acts(tab, (fire) => fire.changeObject(fire.lastElementChild.objectId, { y: 1.1 }));
  await acts(tab, (fire) => fire.setAttribute('preset', 'candle'));
  await kept('a preset');
  assert.equal(await tab.fire((fire) => fire.params.fuel_power), CANDLE);
  assert.equal((await listed(tab)).length, 4);
  await acts(tab, (fire) => fire.importConfig({ hearth: 2, values: { wind: 1 } }));
  await kept('settings');
  await acts(tab, (fire) => fire.restore());
  await kept('all defaults');
  await acts(tab, (fire) => fire.setAttribute('objects', '[{"kind": "solid", "x": -0.4}]'));
  await kept('the attribute objects');
  await acts(tab, (fire) => fire.reset());
  await kept('a reset');
  assert.deepEqual(tab.problems, []);
});

test('an attribute of a child that changes right after its object was replaced is kept with the object', async () => {
  const tab = await opened('<hearth-solid x="0.3"></hearth-solid>');
  for (const [y, replace] of /** @type {[number, (fire: any) => void][]} */ ([
    [0.7, (fire) => fire.setAttribute('preset', 'candle')],
    [0.8, (fire) => fire.importConfig({ hearth: 2, values: { wind: 1 } })],
    [
      0.9,
      (fire) => {
        fire.objects = [];
      },
    ],
  ])) {
    // The engine gets the change after it has replaced the objects.
    await acts(tab, new Function('fire', 'y', `(${replace})(fire); fire.firstElementChild.setAttribute('y', y);`), y);
    assert.deepEqual(
      (await owned(tab)).map(({ x, y }) => [x, y]),
      [[0.3, y]],
      `${replace}`,
    );
  }
  assert.deepEqual(tab.problems, []);
});

test('undo and export carry the objects as they are', async () => {
  const tab = await opened('<hearth-solid x="0.3"></hearth-solid>');
  await tab.fire(async (fire) => {
    await fire.changeObject(fire.firstElementChild.objectId, { x: 0.1 });
    const config = await fire.exportConfig();
    await fire.changeObject(fire.firstElementChild.objectId, { x: -0.1 });
    await fire.importConfig(config);
  });
  await settled(tab);
  assert.deepEqual(await listed(tab), ['source 0', 'solid 0.1']);
  // What a call removes stays away until an attribute changes.
  await acts(tab, async (fire) => {
    const before = fire.objects;
    await fire.removeObject(fire.firstElementChild.objectId);
    window.before = before;
  });
  assert.deepEqual(await owned(tab), [null]);
  await acts(tab, (fire) => fire.set({ objects: window.before }));
  assert.equal((await owned(tab))[0].x, 0.1);
  await acts(tab, (fire) => fire.set({ objects: [] }));
  await acts(tab, (fire) => fire.firstElementChild.setAttribute('y', '0.6'));
  assert.deepEqual(
    (await owned(tab)).map(({ x, y }) => [x, y]),
    [[0.3, 0.6]],
  );
});

test('settings of the same page hold the objects of its children once', async () => {
  const config = { hearth: 2, values: {}, objects: [{ kind: 'source' }, { kind: 'solid', id: 1001, x: 0.3 }] };
  const src = `data:application/json,${encodeURIComponent(JSON.stringify(config))}`;
  const tab = await opened('<hearth-solid x="0.1"></hearth-solid>', `src="${src}"`);
  assert.deepEqual(await listed(tab), ['source 0', 'solid 0.3']);
  assert.deepEqual(tab.problems, []);
});
