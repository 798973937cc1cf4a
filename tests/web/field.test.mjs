/** Isotherms and arrows of a measured field. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { arrowsOf, isotherm } from '../../web/plots/field.js';

/** Verticals of a field. @type {(of: (x: number, y: number) => object) => import('../../web/plots/field.js').Column[]} */
const columns = (of) =>
  Array.from({ length: 24 }, (_, at) => {
    const x = at / 10 - 1.15;
    const profile = Array.from({ length: 64 }, (_, row) => ({
      y: row / 40,
      gas: true,
      solid: false,
      ...of(x, row / 40),
    }));
    return { x, profile };
  });

test('an isotherm lies where a linear field has its temperature, and a colder field has none', () => {
  const field = columns((x, y) => ({ temperature: 273.15 + 1000 * y + 100 * x }));
  const lines = isotherm(field, 500);
  assert.ok(lines.length >= 23, `${lines.length}`);
  for (const [x, y] of lines.flat()) assert.ok(Math.abs(1000 * y + 100 * x - 500) < 1e-6, `${x}, ${y}`);
  assert.deepEqual(isotherm(field, 3000), []);
});

test('an isotherm of a hot disc goes around it, and ends beside a place without gas', () => {
  const disc = (/** @type {number} */ x, /** @type {number} */ y) => ({
    temperature: 2000 - 2000 * Math.hypot(x, y - 0.8),
  });
  const lines = isotherm(columns(disc), 900);
  const radius = (2000 - 1173.15) / 2000;
  for (const [x, y] of lines.flat()) assert.ok(Math.abs(Math.hypot(x, y - 0.8) - radius) < 0.02, `${x}, ${y}`);
  // Closed: each point ends two lines.
  const ends = new Map();
  for (const point of lines.flat())
    ends.set(String(point.map((at) => at.toFixed(6))), (ends.get(String(point.map((at) => at.toFixed(6)))) ?? 0) + 1);
  assert.ok([...ends.values()].every((count) => count === 2));
  const left = isotherm(
    columns((x, y) => (x > 0 ? {} : disc(x, y))),
    900,
  );
  assert.ok(left.length > 0 && left.flat().every(([x]) => x <= 0));
});

test('arrows point along the velocity, with its length, and gas at rest has none', () => {
  const arrows = arrowsOf(
    columns((x) => (x < 0 ? { u: 1, v: 2 } : { u: 0, v: 0.05 })),
    0.1,
  );
  assert.ok(arrows.length > 50);
  for (const [[x, y], [toX, toY]] of arrows) {
    assert.ok(x < 0);
    assert.ok(Math.abs(toX - x - 0.1) < 1e-9 && Math.abs(toY - y - 0.2) < 1e-9);
  }
});
