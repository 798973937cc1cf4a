/**
 * Colour values, automatic seeds, and the parameters that transitions change.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { warmth } from '../../web/element/attributes/attributes.js';
import { isColour, resolved, seedOf } from '../../web/element/attributes/values.js';
import { LOGARITHMIC, WHOLE } from '../../web/generated/interpolation.js';
import { PARAMETERS } from '../../web/parameters.js';

test('the colours are the parameters of that kind', () => {
  const named = PARAMETERS.filter(({ id }) => isColour(id)).map(({ id }) => id);
  assert.deepEqual(
    named,
    PARAMETERS.filter(({ kind }) => kind === 'colour').map(({ id }) => id),
  );
});

test('fires of a document get different seeds, the same ones in the same order, and keep them', () => {
  const seedsOf = () => {
    const ownerDocument = {};
    const fires = Array.from({ length: 200 }, () => /** @type {any} */ ({ ownerDocument }));
    const seeds = fires.map(seedOf);
    assert.deepEqual(fires.map(seedOf), seeds);
    return seeds;
  };
  const seeds = seedsOf();
  assert.deepEqual(seedsOf(), seeds);
  assert.equal(new Set(seeds).size, seeds.length);
  for (const seed of seeds) assert.ok(Number.isInteger(seed) && seed >= 0 && seed < 2 ** 32);
});

test('what replaces every value keeps the seed of `seed="auto"` or the one set since, unless it names one', () => {
  const fire = /** @type {any} */ ({ ownerDocument: {}, getAttribute: () => 'auto' });
  const own = seedOf(fire);
  const start = (/** @type {any} */ config) => resolved(['add', { config, values: {} }], fire)[1].values;
  assert.deepEqual(start(undefined), { seed: own });
  assert.deepEqual(start({ values: { wind: 1 } }), { seed: own });
  // A fire that follows another one.
  assert.deepEqual(start({ values: { seed: 7 } }), {});
  const config = { values: { wind: 1 } };
  assert.deepEqual(resolved(['import', config, 'property'], fire), ['import', config, 'property', true]);
  assert.deepEqual(resolved(['preset', 'torch', 'preset'], fire), ['import', { preset: 'torch' }, 'preset', true]);
  assert.deepEqual(resolved(['set', { seed: 'auto' }], fire), ['set', { seed: own }]);
  const plain = /** @type {any} */ ({ getAttribute: () => null });
  assert.deepEqual(resolved(['preset', 'torch', 'preset'], plain), ['preset', 'torch', 'preset']);
});

test('transitions move log parameters by ratios, and step whole numbers', () => {
  const ids = (/** @type {(parameter: typeof PARAMETERS[number]) => boolean} */ holds) =>
    PARAMETERS.filter(holds)
      .map(({ id }) => id)
      .sort();
  assert.deepEqual(
    [...LOGARITHMIC].sort(),
    ids(({ kind, scale }) => kind === 'number' && scale === 'log'),
  );
  assert.deepEqual(
    [...WHOLE].sort(),
    ids(({ kind }) => kind === 'integer' || kind === 'seed'),
  );
});

test('`warm` is a number of seconds, three by default, and zero without the attribute', () => {
  const read = (/** @type {string | null} */ text) => warmth(/** @type {any} */ ({ getAttribute: () => text }));
  for (const [text, seconds] of /** @type {[string | null, number][]} */ ([
    [null, 0],
    ['false', 0],
    ['', 3],
    [' ', 3],
    ['0', 0],
    ['2.5', 2.5],
    ['30', 30],
    ['31', NaN],
    ['-1', NaN],
    ['hot', NaN],
  ]))
    assert.equal(read(text), seconds, `${text}`);
});
