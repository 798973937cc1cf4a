/**
 * The calls of the tools that act on the fire, without a browser: blow, sparks, ignite, extinguish and water, by a
 * pointer and by the cross that stands for it while keys draw. None is a step of the history.
 */
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { TOOLS } from '../../web/tools/table.js';
import { toolsOf } from './tool-context.mjs';

const close = (a, b) => Math.abs(a - b) < 1e-9;
const calls = ({ fire }, name) => fire.calls.filter(([called]) => called === name).map(([, ...args]) => args);
const wood = { kind: 'solid', shape: 'box', x: 0.3, y: 0.6, width: 0.1, height: 0.1, material: 'wood' };

/** Lets the time of intervals pass [ms]. */
function timed(t) {
  t.mock.timers.enable({ apis: ['setInterval', 'setTimeout'] });
  return (milliseconds) => t.mock.timers.tick(milliseconds);
}

for (const way of [1, -1]) {
  test(`a drag to the ${way > 0 ? 'right' : 'left'} blows that way while it is pressed`, async (t) => {
    const pass = timed(t);
    const tools = await toolsOf([], { model: 'classic' });
    tools.pointers.begin('blow', 1, { x: -0.1 * way, y: 0.3 }, tools.how());
    pass(100);
    assert.deepEqual(calls(tools, 'stir'), [], 'a press has no direction');
    tools.pointers.move(1, { x: 0.1 * way, y: 0.3 }, tools.how());
    const [[x, y, u, v]] = calls(tools, 'stir');
    assert.deepEqual([x, y, Math.sign(u), v], [0.1 * way, 0.3, way, 0]);
    assert.equal(tools.shown.preview.length, 1, 'an arrow');
    pass(100);
    const { length } = calls(tools, 'stir');
    assert.ok(length > 2, `${length} calls`);
    tools.pointers.end(1, { x: 0.1 * way, y: 0.3 }, tools.how());
    pass(1000);
    assert.equal(calls(tools, 'stir').length, length);
    assert.equal(tools.history.canUndo, false);
  });
}

test('a drag throws sparks along its way', async () => {
  const tools = await toolsOf();
  await tools.drag('sparks', [
    [-0.3, 1.1],
    [0, 1.1],
    [0.3, 1.1],
  ]);
  const thrown = calls(tools, 'sparks');
  assert.ok(thrown.reduce((sum, [, , count]) => sum + count, 0) > 40);
  const places = thrown.map(([x]) => x);
  assert.deepEqual(
    places,
    [...places].sort((a, b) => a - b),
  );
  assert.ok(places[0] === -0.3 && close(places.at(-1), 0.3) && thrown.every(([, y]) => close(y, 1.1)));
  assert.equal(tools.fire.objects.length, 1);
  assert.equal(tools.history.canUndo, false);
});

test('a press lights a solid of wood, which gets fuel in one step', async () => {
  const tools = await toolsOf([wood]);
  await tools.drag('ignite', [[0.3, 0.6]]);
  assert.deepEqual(calls(tools, 'ignite'), [[0.3, 0.6, 0.1]]);
  assert.equal(tools.fire.objects[1].fuel, 'wood');
  assert.equal((await tools.undo())[1].fuel, 'none');
  assert.equal(tools.history.canUndo, false);
});

test('a press lights the nearest source within the width of a finger, and a drag what it crosses', async () => {
  const tools = await toolsOf();
  const [{ x, y }] = tools.fire.objects;
  await tools.drag('ignite', [
    [x + 0.05, y + 0.02],
    [x + 0.12, y + 0.02],
    [x + 0.13, y + 0.02],
    [x, y + 0.3],
    [x + 0.9, y + 0.5],
  ]);
  // The third place is too near to the second one, and the last ones are far.
  assert.deepEqual(calls(tools, 'ignite'), [
    [x + 0.05, y + 0.02, 0.1],
    [x + 0.12, y + 0.02, 0.1],
  ]);
  await tools.drag('ignite', [[x, y + 0.3]], { perPixel: 0.0065 });
  const [, , [, , radius]] = calls(tools, 'ignite');
  assert.ok(radius > 0.3 && radius < 0.4, `${radius}`);
  assert.deepEqual(tools.shown.messages, []);
});

test('a press puts out what burns', async () => {
  const tools = await toolsOf([{ ...wood, fuel: 'wood' }]);
  await tools.drag('extinguish', [[0.3, 0.6]]);
  assert.deepEqual(calls(tools, 'extinguish'), [[0.3, 0.6, 0.2]]);
  assert.equal(tools.history.canUndo, false);
});

test('what cannot burn is reported', async () => {
  const tools = await toolsOf([{ ...wood, material: 'stone' }]);
  const message = async (tool, place) => {
    await tools.drag(tool, [place]);
    return tools.shown.messages.at(-1);
  };
  assert.match(await message('ignite', [0.4, 1]), /^Nothing to light there: touch wood/);
  assert.match(await message('extinguish', [0.4, 1]), /^Nothing there has fuel/);
  assert.match(await message('ignite', [0.3, 0.6]), /^A solid of stone has no fuel/);
  assert.equal(tools.fire.objects[1].fuel, 'none');
  tools.fire.params.model = 'classic';
  assert.match(await message('ignite', [0.3, 0.6]), /^The classic model has no fuels/);
  assert.match(await message('water', [0.3, 0.6]), /^The classic model has no water/);
  assert.deepEqual(tools.fire.calls, []);
  assert.equal(tools.history.canUndo, false);
});

test('water falls from the pointer while it is pressed', async (t) => {
  const pass = timed(t);
  const tools = await toolsOf([wood]);
  tools.pointers.begin('water', 1, { x: 0.25, y: 0.8 }, tools.how());
  tools.pointers.move(1, { x: 0.35, y: 0.8 }, tools.how());
  pass(100);
  tools.pointers.end(1, { x: 0.35, y: 0.8 }, tools.how());
  pass(1000);
  const sprayed = calls(tools, 'spray');
  assert.deepEqual(
    sprayed.map(([x]) => x),
    [0.25, 0.35, 0.35],
  );
  for (const [, y, u, v, grams] of sprayed) assert.ok(y === 0.8 && u === 0 && v < 0 && grams > 0);
});

test('the cross presses and releases, and what acts on the fire acts at once', async (t) => {
  const pass = timed(t);
  const tools = await toolsOf([{ ...wood, x: 0, y: 0.9, fuel: 'wood' }]);
  const { cross, shown, how } = tools;
  cross.press('sparks', how());
  cross.press('sparks', how());
  cross.press('ignite', how());
  await Promise.resolve();
  assert.deepEqual(tools.fire.calls.slice(0, 2), [
    ['sparks', 0, 0.9, 24],
    ['sparks', 0, 0.9, 24],
  ]);
  assert.deepEqual(shown.cross, { x: 0, y: 0.9 });
  cross.press('water', how());
  pass(200);
  assert.ok(calls(tools, 'spray').length > 2);
  cross.press('water', how());
  const { length } = calls(tools, 'spray');
  pass(200);
  assert.equal(calls(tools, 'spray').length, length, 'the second press ends it');
  assert.deepEqual(cross.move(0.1, 0.2, how()), { x: 0.1, y: 1.1 });
  assert.deepEqual(shown.cross, { x: 0.1, y: 1.1 });
  for (const [u, v] of [
    [1, 0],
    [-1, 0],
  ]) {
    cross.puff(how(), { x: u, y: v });
    const [x, y, right] = calls(tools, 'stir').at(-1);
    assert.deepEqual([x, y, Math.sign(right)], [0.1, 1.1, u], 'it blows and moves nothing');
    pass(1000);
    const puffs = calls(tools, 'stir').length;
    pass(1000);
    assert.equal(calls(tools, 'stir').length, puffs, 'for a moment');
  }
  assert.equal(tools.history.canUndo, false);
});

test('keys draw with the cross, and choose several', async () => {
  const tools = await toolsOf([
    { ...wood, x: 0 },
    { ...wood, x: 0.3 },
  ]);
  const { cross, editing, how } = tools;
  cross.press('box', how());
  cross.move(0.1, 0.1, how());
  cross.press('box', how());
  await tools.fire.settled();
  const drawn = tools.fire.objects[3];
  assert.deepEqual([drawn.shape, drawn.width, drawn.height], ['box', 0.1, 0.1]);
  editing.select(2);
  cross.point({ x: 0.3, y: 0.6 });
  cross.press('select', how({ adds: true }));
  assert.deepEqual(
    editing.all.map(({ id }) => id),
    [2, 3],
  );
  assert.equal(tools.pointers.active, false, 'a press that adds is a click');
});

test('pointers and keys probe where they are, and keys have it announced', async () => {
  const tools = await toolsOf();
  await tools.drag('probe', [
    [0.1, 0.5],
    [0.2, 0.5],
  ]);
  tools.cross.move(0.1, 0, tools.how());
  tools.cross.press('probe', tools.how());
  assert.deepEqual(
    tools.shown.probes.map(([{ x }, { announce = false } = {}]) => [x, announce]),
    [
      [0.1, false],
      [0.2, false],
      [0.1, false],
      [0.1, true],
    ],
  );
});

test('the document of the toolbar names the key of every tool, and every tool that acts on the fire', async () => {
  const text = await readFile(new URL('../../docs/embedding.md', import.meta.url), 'utf8');
  const [, keys] = /Keys for tools\.\*\* 1 to 9, (.*?) choose a tool/.exec(text);
  const named = keys.split(/, | and /);
  assert.deepEqual(
    named.sort(),
    TOOLS.map(({ key }) => key.toUpperCase())
      .filter((key) => !/[1-9]/.test(key))
      .sort(),
  );
  const [, acts] = /\*\*Act on the fire\.\*\*(.*?)\n- /s.exec(text);
  for (const { name, label } of TOOLS)
    if (['blow', 'sparks', 'ignite', 'extinguish', 'water'].includes(name))
      assert.ok(acts.includes(`*${label}*`), label);
});
