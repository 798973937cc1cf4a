/**
 * The objects in the panel: a real mouse adds a solid, drags its width, undoes, deletes; the address
 * carries it; changes from outside show; and the accessible controls do the same by keys.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { Panel, actionOf, along } from '../panel.mjs';
import { objects, objectsUntil as until } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const SIZES = [
  { width: 1280, height: 800 },
  { width: 390, height: 844, touch: true },
];

const propertyOf = (/** @type {string} */ name) => `[data-property="${name}"]`;

/** @param {string} query @param {object} [size] */
async function openPage(query, size = SIZES[0]) {
  const tab = await browser.open(`index.html?${query}${query.includes('paused') ? '' : '&paused'}`, size);
  await tab.ready();
  return { tab, panel: await new Panel(tab).mounted() };
}

/** The page of tests that need no fresh one. @type {Awaited<ReturnType<typeof openPage>> | undefined} */
let shared;

/** The shared page with a scene, of which nothing is changed, and no selected object. @param {string} name */
async function scenePage(name) {
  if (shared?.tab !== browser.tab) shared = await openPage(`scene=${name}`);
  const { tab, panel } = /** @type {Awaited<ReturnType<typeof openPage>>} */ (shared);
  tab.problems.length = 0;
  const label = await tab.fire(async (fire, preset) => {
    await fire.importConfig({ hearth: 2, preset, values: {} });
    const { PRESETS } = await import(new URL('web/parameters.js', document.baseURI).href);
    return PRESETS.find((entry) => entry.name === preset).label;
  }, name);
  await titled(panel, label);
  await tab.page.select(actionOf('select-object'), '');
  await tab.evaluate(() => /** @type {HTMLElement | null} */ (document.activeElement)?.blur());
  return { tab, panel };
}

/** The id of the object in a place of the list: each scene has other ids. */
const idAt = async (tab, place) => (await objects(tab))[place].id;

const titled = (panel, text) =>
  panel.until(
    `the scene is called ${text}`,
    (root, wanted) => root.querySelector('[data-action="scenes"]').textContent === `Scene: ${wanted}`,
    text,
  );

/** Clicks a button of the group with the mouse. */
async function press(panel, tab, action) {
  await tab.click(along(await panel.pointAt(actionOf(action)), 0.5));
}

describe('a mouse', () => {
  for (const size of SIZES.toReversed()) {
    test(`adds a solid, drags it, undoes and deletes at ${size.width} × ${size.height}`, async () => {
      const { tab, panel } = await openPage('scene=default', size);
      const first = await tab.fire((fire) => fire.exportConfig());
      await press(panel, tab, 'add:solid');
      const [source, solid] = await until(tab, 'two', (all) => all.length === 2);
      assert.deepEqual([solid.kind, solid.id], ['solid', 2]);
      const { domain_width: width, domain_height: height } = await tab.fire((fire) => fire.params);
      const apart = Math.hypot(solid.x - source.x, solid.y - source.y);
      assert.ok(apart >= (source.width + solid.width) / 2, `it stands ${apart} from the source`);
      assert.ok(
        Math.abs(solid.x) + solid.width / 2 <= width / 2 && solid.y + solid.width / 2 <= height,
        'it is in the frame',
      );
      await titled(panel, 'Default, changed');

      const rail = await panel.pointAt(propertyOf('solid:width'));
      await tab.drag(along(rail, 0.5), along(rail, 0.7));
      await until(tab, 'wider', ([, moved]) => moved.width > 1.4 * solid.width);

      await panel.press('undo');
      await until(tab, 'as narrow as before', ([, moved]) => moved?.width === solid.width);
      await panel.pointAt(actionOf('redo'));
      await panel.press('redo');
      // The width during the drag may be that of any of its moves; this one is the last.
      const [, dragged] = await until(tab, 'wider again', ([, moved]) => moved.width > 1.4 * solid.width);
      assert.deepEqual({ ...dragged, width: solid.width }, solid, 'only its width is another');
      await panel.pointAt(actionOf('undo'));
      await panel.press('undo');
      await until(tab, 'as narrow as before', ([, moved]) => moved?.width === solid.width);
      await panel.press('undo');
      await until(tab, 'one', (all) => all.length === 1);
      assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), first);
      await titled(panel, 'Default');
      for (let step = 0; step < 2; step += 1) {
        await panel.pointAt(actionOf('redo'));
        await panel.press('redo');
      }
      await until(tab, 'as wide as dragged', ([, moved]) => moved?.width === dragged.width);
      assert.deepEqual(tab.problems, []);

      // A link shows the same fire.
      const query = await tab.until(
        'the address has the width',
        (wanted) => {
          const text = new URLSearchParams(location.search).get('objects');
          return text?.includes(wanted) && location.search;
        },
        `"width":${dragged.width}`,
      );
      const other = await openPage(query.slice(1), size);
      assert.deepEqual(await objects(other.tab), [source, dragged]);
      await other.panel.pointAt(actionOf('select-object'));
      await other.tab.click(along(await other.panel.rectangleOf('object:2'), 0.5));
      await press(other.panel, other.tab, 'delete');
      await until(other.tab, 'one again', (all) => all.length === 1);
      assert.deepEqual(other.tab.problems, []);
    });
  }

  test('duplicates a log, which does not stand on another object, and resets all', async () => {
    const { tab, panel } = await scenePage('campfire');
    const before = await objects(tab);
    await panel.pointAt(actionOf('select-object'));
    await tab.click(along(await panel.rectangleOf(`object:${await idAt(tab, 1)}`), 0.5));
    await press(panel, tab, 'duplicate');
    const now = await until(tab, 'one more', (all) => all.length === before.length + 1);
    const { x, y, id, ...copy } = now.at(-1);
    const { x: oldX, y: oldY, id: oldId, ...log } = before[1];
    assert.deepEqual(copy, log);
    assert.notDeepEqual([x, y], [oldX, oldY]);
    await press(panel, tab, 'to:back');
    await until(tab, 'the first in the list', (all) => all[0].id === id);
    await press(panel, tab, 'to:front');
    await until(tab, 'the last in the list', (all) => all.at(-1).id === id);
    await panel.press('reset-all');
    await until(tab, 'those of the scene', (all) => JSON.stringify(all) === JSON.stringify(before));
    await titled(panel, 'Campfire');
    assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), { hearth: 2, preset: 'campfire', values: {} });
    assert.deepEqual(tab.problems, []);
  });
});

describe('buttons act on the fire at the selected object', () => {
  test('which is the place of each call', async () => {
    const { tab, panel } = await scenePage('default');
    await tab.fire((fire) => fire.set('ember_rate', 0));
    const id = await tab.fire((fire) =>
      fire.addObject({ kind: 'solid', shape: 'box', x: 0.3, y: 0.6, width: 0.1, height: 0.1, material: 'wood' }),
    );
    await panel.until(
      'the solid is in the list',
      (root, wanted) =>
        [...root.querySelector('[data-action="select-object"]').options].some(({ value }) => value === wanted),
      String(id),
    );
    await panel.pointAt(actionOf('select-object'));
    await tab.click(along(await panel.rectangleOf(`object:${id}`), 0.5));
    await press(panel, tab, 'ignite');
    await until(tab, 'the solid has fuel', (all) => all.at(-1).fuel === 'wood');
    const fuel = (wanted) =>
      tab.until(
        `the fuel is ${wanted}`,
        async (word) => {
          const fire = document.querySelector('hearth-fire');
          await fire.step(20);
          return fire.stats?.fuel === word;
        },
        wanted,
      );
    await fuel('burning');
    await press(panel, tab, 'extinguish');
    await fuel('out');
    // Each call acts where the object is.
    await tab.fire((fire) => {
      window.calls = [];
      for (const name of ['spray', 'sparks', 'stir']) {
        fire[name] = (...call) => {
          window.calls.push([name, ...call]);
          return Object.getPrototypeOf(fire)[name].apply(fire, call);
        };
      }
    });
    for (const [button, name, holds] of [
      ['water', 'spray', (x, y, u, v) => x === 0.3 && y > 0.65 && y < 0.9 && u === 0 && v < 0],
      ['sparks', 'sparks', (x, y) => x === 0.3 && y > 0.65 && y < 0.7],
      ['blow', 'stir', (x, y, u) => x > 0.2 && x < 0.25 && y === 0.6 && u > 5],
    ]) {
      await press(panel, tab, button);
      await tab.until(`a call of ${name}`, (wanted) => window.calls.some(([method]) => method === wanted), name);
      const calls = await tab.evaluate((wanted) => window.calls.filter(([method]) => method === wanted), name);
      for (const [, ...call] of calls) assert.ok(holds(...call), `${name}(${call})`);
    }
    // The fuel is the one step.
    await panel.pointAt(actionOf('undo'));
    await panel.press('undo');
    await until(tab, 'no fuel', (all) => all.at(-1)?.fuel === 'none');
    await tab.fire((fire) => {
      for (const name of ['spray', 'sparks', 'stir']) delete fire[name];
    });
    assert.deepEqual(tab.problems, []);
  });

  test('or show the reason why they cannot', async () => {
    const { tab, panel } = await scenePage('default');
    const statusBegins = (words) =>
      panel.until(
        `the words ${words}`,
        (root, wanted) => root.querySelector('.hearth-controls [role="status"]').textContent.startsWith(wanted),
        words,
      );
    await tab.page.select(actionOf('select-object'), String(await idAt(tab, 0)));
    await press(panel, tab, 'extinguish');
    await statusBegins('A source has no fuel');
    await tab.fire((fire) => fire.addObject({ kind: 'solid', material: 'stone' }));
    await tab.page.select(actionOf('select-object'), String((await objects(tab)).at(-1).id));
    await press(panel, tab, 'ignite');
    await statusBegins('A solid of stone has no fuel');
    await tab.fire((fire) => fire.set('model', 'classic'));
    await press(panel, tab, 'water');
    await statusBegins('The classic model has no water');
    assert.deepEqual(tab.problems, []);
  });
});

test('an object is named and switched off, in the list of the panel and by its own controls, and undone', async () => {
  const { tab, panel } = await scenePage('campfire');
  const first = await tab.fire((fire) => fire.exportConfig());
  await panel.pointAt(actionOf('select-object'));
  const id = await idAt(tab, 1);
  await tab.click(along(await panel.rectangleOf(`enabled:${id}`), 0.5));
  await until(tab, 'the log is off', (all) => all[1].enabled === false);
  await tab.page.select(actionOf('select-object'), String(id));
  await panel.pointAt(propertyOf('solid:name'));
  await panel.in((root) => {
    const field = root.querySelector('[data-property="solid:name"]');
    field.value = 'Back log';
    field.dispatchEvent(new Event('change'));
  });
  await until(tab, 'the log has a name', (all) => all[1].name === 'Back log');
  await panel.until(
    'the list has the name',
    (root, wanted) =>
      [...root.querySelector('[data-action="select-object"]').options].some(({ text }) => text === wanted),
    `Back log · Solid ${id} · off`,
  );
  await titled(panel, 'Campfire, changed');
  for (let step = 0; step < 2; step += 1) {
    await panel.pointAt(actionOf('undo'));
    await panel.press('undo');
  }
  await until(tab, 'as before', (all) => all[1].enabled && all[1].name === '');
  assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), first);
  assert.deepEqual(tab.problems, []);
});

test('a source on a solid goes with it, and undo restores both', async () => {
  const { tab, panel } = await scenePage('default');
  await tab.fire(async (fire) => {
    await fire.addObject({ kind: 'solid', id: 7 });
    await fire.addObject({ kind: 'source', shape: 'solid', solid: 7 });
  });
  await tab.page.select(actionOf('select-object'), '7');
  await press(panel, tab, 'delete');
  await until(tab, 'the first source alone', (all) => all.length === 1);
  await panel.pointAt(actionOf('undo'));
  await panel.press('undo');
  const all = await until(tab, 'both again', (all) => all.length === 3);
  assert.deepEqual(
    all.slice(1).map(({ kind, shape }) => [kind, shape]),
    [
      ['solid', 'circle'],
      ['source', 'solid'],
    ],
  );
});

test('the list follows the page, and a removed object is not selected', async () => {
  const { tab, panel } = await scenePage('default');
  const [first, id] = await tab.fire(async (fire) => {
    const added = await fire.addObject({ kind: 'solid', shape: 'box', material: 'brick' });
    return [fire.objects[0].id, added];
  });
  const listed = (/** @type {string[]} */ names) =>
    panel.until(
      `the list has ${names}`,
      (root, wanted) =>
        [...root.querySelector('[data-action="select-object"]').options].map(({ text }) => text).join() === wanted,
      ['none', ...names].join(),
    );
  await listed([`Source ${first}`, `Solid ${id} · brick box`]);
  await panel.pointAt(actionOf('select-object'));
  await panel.rectangleOf(`object:${id}`);
  await tab.page.select(actionOf('select-object'), String(id));
  await panel.pointAt(propertyOf('solid:corner'));
  await tab.fire((fire, solid) => fire.changeObject(solid, { material: 'none', shape: 'line' }), id);
  await listed([`Source ${first}`, `Solid ${id} · invisible line`]);
  await tab.fire((fire, solid) => fire.removeObject(solid), id);
  await listed([`Source ${first}`]);
  assert.equal(await tab.page.$eval(actionOf('select-object'), (list) => list.value), '');
  assert.equal(await panel.in((root) => root.querySelector('[data-property="solid:corner"]').checkVisibility()), false);
});

test('a search finds a property and shows its row', async () => {
  const { tab, panel } = await scenePage('campfire');
  await panel.pointAt(actionOf('reset-all'));
  await tab.click(along(await panel.rectangleOf('search'), 0.5));
  await tab.page.keyboard.type('corner radius');
  // The logs are lines, which have no corners: the first stone has some.
  await panel.rectangleOf(`object:${await idAt(tab, 4)}`);
  // Each letter finds fewer rows, which move.
  await tab.until(
    'the only row',
    () =>
      Object.keys(/** @type {any} */ (window).panelRectangles)
        .filter((name) => name.startsWith('label:'))
        .join() === 'label:model,label:solid:corner',
  );
  const rail = await panel.rectangleOf('solid:corner');
  await tab.drag(along(rail, 0.3), along(rail, 0.2));
  await until(tab, 'rounder', (all) => all[4].corner > 0.1);
});

test('the sixty-fourth solid is the last, and a text gives the reason', async () => {
  const { tab, panel } = await scenePage('default');
  await tab.fire((fire) =>
    fire.set({
      objects: [
        { kind: 'source' },
        ...Array.from({ length: 64 }, (_, at) => ({ kind: 'solid', x: at / 8 - 4, width: 0.1 })),
      ],
    }),
  );
  const button = actionOf('add:solid');
  await panel.until(
    'the button is off',
    (root, selector) => root.querySelector(selector).getAttribute('aria-disabled') === 'true',
    button,
  );
  assert.match(
    await panel.in((root) => root.querySelector('fieldset[name="Objects"]').textContent),
    /at most 64 solids/,
  );
  await press(panel, tab, 'add:solid');
  await tab.frames(6);
  assert.equal((await objects(tab)).length, 65);
  assert.deepEqual(tab.problems, []);
});

test('accessible controls add, change, reset and delete by keys', async () => {
  const { tab, panel } = await scenePage('campfire');
  const enter = async (action) => {
    await tab.page.focus(actionOf(action));
    await tab.key('Enter');
  };
  const count = (await objects(tab)).length;
  await enter('add:source');
  const now = await until(tab, 'one more', (all) => all.length === count + 1);
  const { id, width, power } = now.at(-1);
  assert.deepEqual([width, power], [now[0].width / 2, now[0].power / 2]);
  await panel.until('its controls', (root) => root.querySelector('[data-property="source:width"]').checkVisibility());
  const names = await tab.page.$$eval('[data-property]', (found) =>
    found
      .filter((control) => control.checkVisibility())
      .map((control) => [control.dataset.property, control.labels?.[0]?.textContent]),
  );
  assert.ok(
    names.every(([, name]) => name),
    JSON.stringify(names),
  );
  assert.ok(names.every(([place]) => place.startsWith('source:')));

  await tab.page.focus(propertyOf('source:width'));
  await tab.key('ArrowRight');
  const wider = await until(tab, 'wider', (all) => all.at(-1).width > width);
  assert.deepEqual(wider.slice(0, -1), now.slice(0, -1));
  // The list selects; the first source has its parameters instead of properties, and a name.
  await tab.page.select(actionOf('select-object'), String(now[0].id));
  await panel.until(
    'its name alone',
    (root) =>
      [...root.querySelectorAll('[data-property]')]
        .filter((row) => row.checkVisibility())
        .map((row) => row.dataset.property)
        .join() === 'source:name',
  );
  const stone = now[4].id;
  await tab.page.select(actionOf('select-object'), String(stone));
  await tab.page.focus(propertyOf('solid:angle'));
  await tab.key('ArrowRight');
  await until(tab, 'turned', (all) => all[4].angle !== 8);
  await enter('restore:solid:angle');
  await until(tab, 'as in the scene', (all) => all[4].angle === 8);
  await enter('to:back');
  await until(tab, 'behind the others', (all) => all[0].id === stone);
  await enter('undo');
  await until(tab, 'in its place', (all) => all[4].id === stone);
  await tab.page.select(actionOf('select-object'), String(id));
  await enter('delete');
  await until(tab, 'as many as before', (all) => all.length === count);
  await titled(panel, 'Campfire');
  assert.deepEqual(tab.problems, []);
});
