/** The buttons of the panel that act on the fire at an object. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { act } from '../../web/editing/acts.js';

const SOURCE = { kind: 'source', id: 1, shape: 'line', x: 0, y: 0.1, width: 0.2, angle: 0 };
const BOX = { kind: 'solid', id: 2, shape: 'box', x: 0.3, y: 0.6, width: 0.1, height: 0.1, angle: 0, motion: 'fixed' };

/** A fire with two objects, whose calls are recorded. @param {object} [solid] @param {string} [model] */
function stage(solid, model = 'combustion') {
  const objects = [SOURCE, { ...BOX, material: 'wood', fuel: 'none', ...solid }];
  /** @type {any[][]} */
  const calls = [];
  const names = ['ignite', 'extinguish', 'spray', 'sparks', 'stir'];
  const record = (/** @type {string} */ name) => [
    name,
    async (/** @type {any[]} */ ...given) => calls.push([name, ...given]),
  ];
  const fire = {
    ...Object.fromEntries(names.map(record)),
    params: { model, domain_height: 2 },
    freeSolids: async () => [{ id: 2, x: -0.5, y: 0.2, angle: 0 }],
  };
  const editing = {
    find: (/** @type {number} */ id) => objects.find((object) => object.id === id),
    change: async (/** @type {Map<number, object>} */ values) => calls.push(['change', ...values]),
  };
  return {
    calls,
    press: (/** @type {string} */ name, id = 2) =>
      act(/** @type {any} */ (fire), /** @type {any} */ (editing), name, id),
  };
}

test('each button acts at the place of its object', async () => {
  const { calls, press } = stage();
  await press('ignite');
  assert.deepEqual(calls.splice(0), [
    ['change', [2, { fuel: 'wood', load: 12 }]],
    ['ignite', 2],
  ]);
  await press('ignite', 1);
  assert.deepEqual(calls.splice(0), [['ignite', 0, 0.1]]);
  for (const [button, name, holds] of /** @type {[string, string, (...call: number[]) => boolean][]} */ ([
    ['water', 'spray', (x, y, u, v) => x === 0.3 && y > 0.65 && y < 0.9 && u === 0 && v < 0],
    ['sparks', 'sparks', (x, y) => x === 0.3 && y > 0.65 && y < 0.7],
    ['blow', 'stir', (x, y, u) => x > 0.2 && x < 0.25 && y === 0.6 && u > 5],
  ])) {
    await press(button);
    assert.ok(calls.length > 0);
    for (const [method, ...call] of calls.splice(0)) assert.ok(method === name && holds(...call), `${name}(${call})`);
  }
});

test('a solid that has fallen gets sparks where it is, and burning fuel goes out', async () => {
  const { calls, press } = stage({ motion: 'free', fuel: 'wood' });
  await press('sparks');
  await press('extinguish');
  assert.deepEqual(calls, [
    ['sparks', -0.5, 0.2 + 0.05 + 0.03],
    ['extinguish', 2],
  ]);
});

test('what cannot be done has a reason', async () => {
  await assert.rejects(stage().press('extinguish', 1), /^Error: A source has no fuel/);
  await assert.rejects(stage().press('extinguish'), /^Error: The selected solid has no fuel/);
  await assert.rejects(stage({ material: 'stone' }).press('ignite'), /^Error: A solid of stone has no fuel/);
  await assert.rejects(stage({}, 'classic').press('water'), /^Error: The classic model has no water/);
});
