/**
 * The page of the paper's figures: shapes, sliders, colours and the fires that it compares.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { brightest, hex } from '../../web/paper/figures/colours.js';
import { COMPARISONS, valueIn } from '../../web/paper/figures/comparisons.js';
import { countsOf } from '../../web/paper/figures/counts.js';
import { POSITIONS, positionOf, valueAt } from '../../web/paper/figures/range.js';
import { meanOf, shapeOf } from '../../web/paper/figures/shape.js';
import { inSight } from '../../web/paper/figures/sight.js';
import { PARAMETERS } from '../../web/parameters.js';

test('the shape of a fire leaves out a twentieth at each side and at the top', () => {
  const count = 100;
  const row = Float32Array.from({ length: 2 * count }, (_, at) => (at % 2 ? 0.5 + (at >> 1) : at >> 1));
  const { width, height } = shapeOf(row, 0.5, 1);
  assert.deepEqual([width, height], [90, 95]);
});

test('neighbours are within two smoothing radii, and the nearest may be beyond', () => {
  // Two close together, one apart.
  const positions = [0, 0, 0, 0.1, 5, 0];
  const { neighbours, nearest } = shapeOf(positions, 0, 0.06);
  assert.equal(neighbours, 2 / 3);
  assert.ok(Math.abs(nearest - (0.1 + 0.1 + 5) / 3) < 1e-9, `${nearest}`);
});

test('a fire without particles has a shape', () => {
  assert.deepEqual(shapeOf([], 0, 1), { width: 0, height: 0, neighbours: 0, nearest: 0 });
  assert.deepEqual(shapeOf([1, 2], 2, 1), { width: 0, height: 0, neighbours: 0, nearest: 0 });
});

test('the mean of shapes is that of each number', () => {
  const mean = meanOf([
    { width: 1, height: 2, neighbours: 3, nearest: 4 },
    { width: 3, height: 4, neighbours: 5, nearest: 6 },
  ]);
  assert.deepEqual(mean, { width: 2, height: 3, neighbours: 4, nearest: 5 });
});

test('a slider goes from one end to the other, evenly or by ratios', () => {
  for (const log of [false, true]) {
    assert.equal(valueAt(0, 0.06, 6, log), 0.06);
    assert.equal(valueAt(POSITIONS, 0.06, 6, log), 6);
    for (const position of [0, 7, 30, POSITIONS]) {
      assert.ok(Math.abs(positionOf(valueAt(position, 0.06, 6, log), 0.06, 6, log) - position) <= 1);
    }
  }
  assert.equal(valueAt(POSITIONS / 2, 0.06, 6, true), 0.6);
  assert.equal(valueAt(POSITIONS / 2, 0, 1, false), 0.5);
});

test('every compared fire has values that its scene and its slider can have', () => {
  for (const [figure, cells] of Object.entries(COMPARISONS)) {
    for (const { preset, parameter, values, from } of cells) {
      for (const id of Object.keys(values))
        assert.ok(
          PARAMETERS.some((entry) => entry.id === id),
          `${figure}: ${id}`,
        );
      if (!parameter) continue;
      const highest = valueIn(preset, parameter);
      const value = values[parameter] ?? highest;
      assert.ok(value > 0 && value <= highest, `${figure}: ${value}`);
      if (from !== undefined) assert.ok(from < value && value < highest, `${figure}: ${value}`);
    }
  }
});

test('the colour of a picture is that of its brightest pixel', () => {
  assert.equal(hex(brightest([0, 0, 0, 255, 255, 119, 8, 255, 255, 0, 0, 255])), '#ff7708');
});

test('what fails because its fire leaves sight is done again when the fire is back, and nothing else is', async () => {
  /** @type {Set<(entries: {isIntersecting: boolean}[]) => void>} */
  const watching = new Set();
  const scroll = (/** @type {boolean} */ isIntersecting) =>
    [...watching].forEach((act) => {
      act([{ isIntersecting }]);
    });
  /** @type {any} */ (globalThis).IntersectionObserver = class {
    constructor(/** @type {any} */ act) {
      this.act = act;
    }

    observe() {
      watching.add(this.act);
    }

    disconnect() {
      watching.delete(this.act);
    }
  };
  try {
    let tries = 0;
    const done = inSight(/** @type {any} */ ({}), async () => {
      tries += 1;
      if (tries > 1) return tries;
      scroll(false);
      queueMicrotask(() => setImmediate(() => scroll(true)));
      throw new Error('there is no frame');
    });
    scroll(false);
    assert.equal(tries, 0);
    scroll(true);
    assert.equal(await done, 2);
    const failing = inSight(/** @type {any} */ ({}), async () => {
      throw new Error('broken');
    });
    scroll(true);
    await assert.rejects(failing, /broken/);
    assert.equal(watching.size, 0);
  } finally {
    delete (/** @type {any} */ (globalThis).IntersectionObserver);
  }
});

test('an address names numbers of particles; those out of range are left out', () => {
  assert.deepEqual(countsOf(''), [5000, 100_000]);
  assert.deepEqual(countsOf('?n=300,600'), [300, 600]);
  assert.deepEqual(countsOf('?n=300,7,1e9,x'), [300]);
  assert.deepEqual(countsOf('?n='), [5000, 100_000]);
});
