/**
 * What each tool draws, moves and removes between a press and a release, without a browser; each is one step of the
 * history.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { toolsOf } from './tool-context.mjs';

const close = (a, b, tolerance = 2e-3) => Math.abs(a - b) <= tolerance;
const box = (fields) => ({ kind: 'solid', shape: 'box', width: 0.1, height: 0.1, ...fields });
const ids = (objects) => objects.map(({ id }) => id).join();

for (const [tool, check] of Object.entries({
  box: (solid) =>
    solid.shape === 'box' &&
    close(solid.x, 0) &&
    close(solid.y, 1.1) &&
    close(solid.width, 0.3) &&
    close(solid.height, 0.2),
  circle: (solid) =>
    solid.shape === 'circle' &&
    close(solid.x, -0.15) &&
    close(solid.y, 1.2) &&
    close(solid.width, 2 * Math.hypot(0.3, 0.2)),
  line: (solid) => solid.shape === 'line' && close(solid.width, Math.hypot(0.3, 0.2)) && close(solid.angle, -33.7, 0.1),
  brush: (solid) => solid.shape === 'stroke' && solid.points.split(' ').length >= 2,
  source: (source) =>
    source.kind === 'source' && close(source.width, Math.hypot(0.3, 0.2)) && close(source.x, 0) && close(source.y, 1.1),
})) {
  test(`${tool} draws between a press and a release, as one step`, async () => {
    const tools = await toolsOf();
    const [, drawn, ...more] = await tools.drag(tool, [
      [-0.15, 1.2],
      [0, 1.15],
      [0.15, 1],
    ]);
    assert.ok(check(drawn), JSON.stringify(drawn));
    assert.deepEqual(more, []);
    assert.equal(tools.editing.selected.id, drawn.id);
    assert.match(tools.shown.messages.at(-1), / at -?\d\.\d\d, \d\.\d\d m\.$/);
    assert.deepEqual(tools.shown.preview, []);
    assert.equal((await tools.undo()).length, 1);
    await tools.history.redo();
    assert.deepEqual(tools.fire.objects[1], drawn);
  });
}

test('a press that does not move draws nothing, and a gesture that is cancelled neither', async () => {
  const tools = await toolsOf();
  assert.equal(
    (
      await tools.drag('box', [
        [0, 1],
        [0.004, 1],
      ])
    ).length,
    1,
  );
  tools.pointers.begin('box', 1, { x: 0, y: 1 }, tools.how());
  tools.pointers.move(1, { x: 0.2, y: 1.2 }, tools.how());
  assert.equal(tools.shown.preview.length, 1);
  // A second finger ends what the first one draws.
  tools.pointers.begin('circle', 2, { x: 0, y: 1 }, tools.how());
  assert.equal(tools.pointers.has(1), false);
  tools.pointers.cancelAll();
  tools.pointers.end(1, { x: 0.2, y: 1.2 }, tools.how());
  await tools.fire.settled();
  assert.equal(tools.fire.objects.length, 1);
  assert.equal(tools.history.canUndo, false);
});

test('a polygon has the corners that are clicked and closes at the first or the last one; a press asks for a word', async () => {
  for (const last of [
    [-0.1, 1],
    [0.1, 1.2],
  ]) {
    const tools = await toolsOf();
    for (const place of [[-0.1, 1], [0.1, 1], [0.1, 1.2], last]) await tools.drag('polygon', [place]);
    const [, polygon] = tools.fire.objects;
    assert.deepEqual([polygon.shape, polygon.points.split(' ').length], ['polygon', 3]);
    assert.equal(tools.pointers.active, false);
    await tools.drag('text', [[0, 0.8]]);
    assert.deepEqual(tools.shown.word, { x: 0, y: 0.8 });
  }
});

test('a line and a turn snap to 15° with Shift', async () => {
  const tools = await toolsOf();
  const [, line] = await tools.drag(
    'line',
    [
      [0, 1],
      [0.2, 1.19],
    ],
    { snaps: true },
  );
  assert.ok(close(line.angle, 45, 0.1), `${line.angle}`);
});

test('a solid that is drawn on fire burns at its surface, and goes with its fire in one step', async () => {
  const tools = await toolsOf();
  tools.style.burns = true;
  const [, disc, fire] = await tools.drag('circle', [
    [0, 1.1],
    [0.1, 1.1],
  ]);
  assert.deepEqual([fire.kind, fire.shape, fire.solid], ['source', 'solid', disc.id]);
  // Some 150 kW/m for each metre around it.
  assert.ok(close(fire.power, 150 * Math.PI * disc.width, 2), `${fire.power} kW/m`);
  assert.equal(
    (
      await tools.drag('erase', [
        [-0.3, 1.1],
        [0, 1.1],
      ])
    ).length,
    1,
  );
  assert.equal((await tools.undo()).length, 3);
  assert.equal((await tools.undo()).length, 1);
});

test('a source is as strong by its width as the first one', async () => {
  const tools = await toolsOf();
  const [first, second] = await tools.drag('source', [
    [-0.1, 1],
    [0.1, 1],
  ]);
  assert.ok(close(second.power / second.width, first.power / first.width, 1), `${second.power}`);
});

test('the sixty-fifth solid is refused with a message', async () => {
  const tools = await toolsOf(Array.from({ length: 64 }, (_, at) => box({ x: at / 8 - 4, y: 1.7, width: 0.05 })));
  assert.equal(
    (
      await tools.drag('circle', [
        [0, 1],
        [0.1, 1],
      ])
    ).length,
    65,
  );
  assert.match(tools.shown.messages.at(-1), /at most 64 solids/);
});

test('select moves, sizes and turns, each as one step; erase removes', async () => {
  const tools = await toolsOf([box({ x: 0, y: 1.1, width: 0.3, height: 0.2 })]);
  const only = (objects) => objects[1];
  let solid = only(
    await tools.drag('select', [
      [0, 1.1],
      [0.05, 1],
      [0.1, 0.9],
    ]),
  );
  assert.ok(close(solid.x, 0.1) && close(solid.y, 0.9), JSON.stringify(solid));
  solid = only(
    await tools.drag('select', [
      [0.25, 0.8],
      [0.27, 0.77],
      [0.3, 0.75],
    ]),
  );
  assert.ok(close(solid.width, 0.4) && close(solid.height, 0.3), JSON.stringify(solid));
  // The handle that turns is above.
  solid = only(
    await tools.drag('select', [
      [0.1, solid.y + solid.height / 2 + 0.07],
      [0.3, 1],
      [0.4, solid.y],
    ]),
  );
  assert.ok(close(solid.angle, -90, 4), JSON.stringify(solid));
  for (const [name, before] of [
    ['angle', 0],
    ['width', 0.3],
    ['x', 0],
  ])
    assert.ok(close(only(await tools.undo())[name], before), name);
  assert.equal(
    (
      await tools.drag('erase', [
        [-0.3, 1.1],
        [0, 1.1],
      ])
    ).length,
    1,
  );
  assert.equal(only(await tools.undo()).width, 0.3);
});

test('a drag that is cancelled puts the object back', async () => {
  const tools = await toolsOf([box({ x: 0, y: 1.1 })]);
  tools.pointers.begin('select', 1, { x: 0, y: 1.1 }, tools.how());
  tools.pointers.move(1, { x: 0.3, y: 1.1 }, tools.how());
  tools.pointers.cancel(1);
  await tools.fire.settled();
  assert.equal(tools.fire.objects[1].x, 0);
});

test('undo and redo while a tool draws cancel what it draws, and no step', async () => {
  for (const move of ['undo', 'redo']) {
    const tools = await toolsOf();
    const at = [
      [-0.3, 1],
      [-0.2, 1.1],
    ];
    const first = await tools.drag('box', at);
    const both = await tools.drag('circle', at);
    const cases = { box: both, line: both, polygon: both, brush: both, select: both, erase: both };
    for (const [tool, wanted] of Object.entries(cases)) {
      tools.pointers.begin(tool, 1, { x: -0.3, y: 1 }, tools.how());
      await tools.fire.settled();
      tools.pointers.move(1, { x: 0.1, y: 1.3 }, tools.how());
      await tools.fire.settled();
      await tools.editing[move]();
      await tools.fire.settled();
      tools.pointers.end(1, { x: 0.1, y: 1.3 }, tools.how());
      await tools.fire.settled();
      assert.deepEqual(tools.fire.objects, wanted, tool);
    }
    assert.deepEqual(await tools.undo(), first);
  }
});

test('several objects are selected, moved, aligned and removed together, each as one step', async () => {
  const tools = await toolsOf([box({ x: -0.2, y: 1.2 }), box({ x: 0.15, y: 1.025, height: 0.15 })]);
  const { editing, edits } = tools;
  const [, left, right] = tools.fire.objects;
  await tools.drag('select', [[-0.2, 1.2]]);
  assert.equal(editing.all.length, 1);
  await tools.drag('select', [[0.15, 1.02]], { adds: true });
  assert.equal(tools.shown.messages.at(-1), '2 objects are selected.');
  let [, a, b] = await tools.drag('select', [
    [-0.2, 1.2],
    [-0.15, 1],
    [-0.1, 0.9],
  ]);
  assert.ok(
    close(a.x - left.x, 0.1) && close(a.y - left.y, -0.3) && close(b.x - right.x, 0.1) && close(b.y - right.y, -0.3),
  );
  const align = async (to) => {
    editing.press();
    edits.align(to);
    await tools.fire.settled();
    [, a, b] = tools.fire.objects;
  };
  await align('left');
  assert.ok(close(a.x - a.width / 2, b.x - b.width / 2));
  await align('middle');
  assert.ok(close(a.y, b.y));
  edits.remove();
  await tools.fire.settled();
  assert.equal(tools.fire.objects.length, 1);
  for (const [what, holds] of [
    ['back', () => close(a.y, b.y)],
    ['not in the middle', () => a.y !== b.y && close(a.x - a.width / 2, b.x - b.width / 2)],
    ['not at the left', () => close(b.x - right.x, a.x - left.x)],
    ['where they were', () => a.x === left.x && a.y === left.y && b.x === right.x && b.y === right.y],
  ]) {
    [, a, b] = await tools.undo();
    assert.ok(a && b && holds(), what);
  }
  // A click on one of several selects it alone.
  await tools.drag('select', [[-0.2, 1.2]]);
  assert.deepEqual(
    editing.all.map(({ id }) => id),
    [left.id],
  );
  edits.duplicate();
  await tools.fire.settled();
  assert.equal(tools.fire.objects.length, 4);
  assert.equal(editing.selected.id, 4);
});

test('the selected solid goes to the front and to the back, each as one step; a press finds the last one', async () => {
  const tools = await toolsOf([
    box({ x: -0.05, y: 1.1, width: 0.2, height: 0.2 }),
    box({ x: 0.05, y: 1.05, width: 0.2, height: 0.2 }),
  ]);
  const order = async (front) => {
    tools.editing.press();
    tools.edits.order(front);
    await tools.fire.settled();
    return ids(tools.fire.objects);
  };
  tools.editing.select(3);
  assert.equal(await order(false), '3,1,2');
  await tools.drag('select', [[0, 1.08]]);
  assert.equal(tools.editing.selected.id, 2);
  assert.equal(await order(false), '2,3,1');
  tools.editing.select(3);
  assert.equal(await order(true), '2,1,3');
  for (const before of ['2,3,1', '3,1,2', '1,2,3']) assert.equal(ids(await tools.undo()), before);
});

test('a moved object snaps to the edges and the middle of others with a guide, and with Alt it does not', async () => {
  const tools = await toolsOf([box({ x: 0.3, y: 0.6, width: 0.2 }), box({ x: -0.2, y: 1.1 })]);
  const moved = async (x, keys) => {
    tools.pointers.move(1, { x, y: 1 }, tools.how(keys));
    await tools.fire.settled();
    return tools.fire.objects[2].x;
  };
  tools.pointers.begin('select', 1, { x: -0.2, y: 1.1 }, tools.how());
  // Three pixels beside the middle of the other.
  assert.ok(close(await moved(0.3075), 0.3, 1e-4));
  assert.equal(tools.shown.guides.length, 1);
  assert.ok(close(await moved(0.31, { free: true }), 0.31, 1e-4));
  assert.deepEqual(tools.shown.guides, []);
  assert.ok(close(await moved(0.2925), 0.3, 1e-4));
  tools.pointers.end(1, { x: 0.2925, y: 1 }, tools.how());
  await tools.fire.settled();
  assert.deepEqual(tools.shown.guides, []);
  assert.equal((await tools.undo())[2].x, -0.2);
});

test('a solid that has fallen is dragged from where it is, and does not fall while it is dragged', async () => {
  const tools = await toolsOf([box({ x: 0.3, y: 0.9, motion: 'free', material: 'wood' })]);
  tools.places.set(2, { x: 0.3, y: 0.5, angle: 10 });
  tools.pointers.begin('select', 1, { x: 0.3, y: 0.5 }, tools.how());
  tools.pointers.move(1, { x: 0.4, y: 0.7 }, tools.how());
  await tools.fire.settled();
  assert.equal(tools.fire.objects[1].motion, 'still');
  tools.pointers.end(1, { x: 0.4, y: 0.7 }, tools.how());
  await tools.fire.settled();
  const [, solid] = tools.fire.objects;
  assert.deepEqual([solid.motion, solid.x, solid.y, solid.angle], ['free', 0.4, 0.7, 10]);
  const [, before] = await tools.undo();
  assert.deepEqual([before.motion, before.y], ['free', 0.9]);
});

test('values stay within the ranges of their properties', async () => {
  const tools = await toolsOf([box({ x: 0, y: 1 })]);
  tools.edits.change([{ width: 99, height: 0 }], [tools.fire.objects[1]]);
  await tools.fire.settled();
  const [, { width, height }] = tools.fire.objects;
  assert.deepEqual([width, height], [10, 0.002]);
});

test('a hundred random actions undone give the first scene, for each of ten seeds', async () => {
  const WAYS = ['box', 'circle', 'line', 'brush', 'source', 'polygon', 'erase', 'select', 'select'];
  for (let first = 1; first <= 10; first += 1) {
    let seed = first;
    const chance = (many) => (seed = (seed * 48271) % 2147483647) % many;
    const place = () => [chance(100) / 100 - 0.5, 0.2 + chance(100) / 100];
    const tools = await toolsOf([box({ x: 0.2, y: 0.8 }), box({ x: -0.2, y: 1 })]);
    const before = tools.fire.objects;
    for (let action = 0; action < 100; action += 1) {
      const [{ all }, what] = [tools.editing, chance(WAYS.length + 4)];
      if (what < WAYS.length) await tools.drag(WAYS[what], [place(), place(), place()], { adds: chance(3) === 0 });
      else if (all.length > 0)
        [
          () => tools.edits.remove(),
          () => tools.edits.duplicate(),
          () => tools.edits.order(true),
          () => tools.edits.align('left'),
        ][what - WAYS.length]();
      if (chance(8) === 0) await tools.history.undo();
    }
    tools.pointers.cancelAll();
    await tools.fire.settled();
    assert.equal(tools.history.canUndo, true);
    while (tools.history.canUndo) await tools.history.undo();
    assert.deepEqual(tools.fire.objects, before, `of seed ${first}`);
  }
});
