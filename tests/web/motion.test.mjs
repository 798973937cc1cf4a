/** How a source moves through its gas as what carries it moves. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Motion } from '../../web/worlds/motion.js';

/** A motion in a fire whose picture shows more than its domain, and the values that it sets. */
function moved() {
  const values = { source_x: 0, source_height: 0.2, source_width: 0.2, domain_width: 1, domain_height: 1.4 };
  const fire = { values, set: (given) => Object.assign(values, given), call: async () => {} };
  return { values, motion: new Motion(/** @type {any} */ (fire)) };
}
/** Left, lower, right and upper edge of the picture [m]. @type {[number, number, number, number]} */
const AREA = [-1, 0, 1, 2];

test('small motions add up until the fire feels them', () => {
  const { values, motion } = moved();
  motion.move(0.0015, 0, AREA);
  assert.equal(values.source_x, 0);
  motion.move(0.0015, 0, AREA);
  assert.equal(values.source_x, 0.003);
});

test('a source stays inside of the domain and of the picture', () => {
  const { values, motion } = moved();
  for (let step = 0; step < 20; step += 1) motion.move(0.1, 0.1, AREA);
  assert.deepEqual([values.source_x, values.source_height], [0.3, 1.4 - 0.2]);
  for (let step = 0; step < 40; step += 1) motion.move(-0.1, -0.1, AREA);
  assert.deepEqual([values.source_x, values.source_height], [-0.3, 0]);
  for (let step = 0; step < 40; step += 1) motion.move(0.1, 0, [-0.4, 0, 0.4, 2]);
  assert.equal(values.source_x.toFixed(6), '0.200000');
});

test('what is put elsewhere does not move through the gas', () => {
  const { values, motion } = moved();
  motion.move(1.5, 0, AREA);
  assert.equal(values.source_x, 0);
});

test('a fire that does not burn yet is carried as a whole', () => {
  const values = /** @type {{[id: string]: number}} */ ({});
  const fire = { values, set: (/** @type {any} */ given) => Object.assign(values, given), call: async () => {} };
  const motion = new Motion(/** @type {any} */ (fire));
  motion.move(0.3, 0.1, AREA);
  assert.deepEqual([values, motion.x, motion.y], [{}, 0, 0]);
  Object.assign(values, moved().values);
  motion.move(0.1, 0, AREA);
  assert.deepEqual([values.source_x, values.source_height], [0.1, 0.2]);
});
