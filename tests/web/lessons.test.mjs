/** The cards of lessons without a page. That their numbers move as their texts say is tested in `tests/tests/lessons.rs`. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { linkedValue, sliderValue } from '../../web/docs/cards.js';
import { Reading } from '../../web/docs/reading.js';
import { POSITIONS } from '../../web/paper/figures/range.js';
import { PARAMETERS } from '../../web/parameters.js';
import { readFile } from 'node:fs/promises';

const LEARN = await readFile(new URL('../../docs/learn.md', import.meta.url), 'utf8');
const CARDS = [...LEARN.matchAll(/```json card\n(.*?)```/gs)].map(([, json]) => JSON.parse(json));

test('the slider of each card is a parameter, and goes from the value of fire A to the other end', () => {
  assert.equal(CARDS.length, 6);
  for (const card of CARDS) {
    assert.ok(
      PARAMETERS.some(({ id }) => id === card.slider),
      card.slider,
    );
    const values = Array.from({ length: POSITIONS + 1 }, (_, at) => sliderValue(card, at));
    assert.deepEqual([values[0], values.at(-1)], [card.from, card.to]);
    const up = Math.sign(card.to - card.from);
    assert.ok(
      values.every((value, at) => at === 0 || up * (value - values[at - 1]) >= 0),
      `${values}`,
    );
  }
});

test('a fragment sets the slider of its own card, within its ends, and any other text sets nothing', () => {
  const card = { from: 1, to: 0.25 };
  const value = (/** @type {string} */ fragment) => linkedValue(fragment, 'wind', /** @type {any} */ (card));
  assert.deepEqual(['#wind=0.5', '#wind=7', '#wind=-Infinity'].map(value), [0.5, 1, 0.25]);
  for (const fragment of ['', '#', '#wind', '#wind=', '#wind=x', '#wind=<b>', '#heat-loss=0.5', '#=1'])
    assert.equal(value(fragment), undefined, fragment);
});

test('a number is the mean or the swing over the last four seconds, once there is one', () => {
  const [mean, swing] = [new Reading(), new Reading(true)];
  const add = (/** @type {number} */ time, /** @type {number | undefined} */ value) => {
    for (const reading of [mean, swing]) reading.add(time, value);
  };
  for (let time = 0; time < 0.9; time += 0.1) add(time, 500);
  assert.equal(mean.value, undefined);
  for (let time = 1; time <= 10.01; time += 0.1) add(time, Math.round(10 * time) % 2 ? 4 : 2);
  assert.ok(Math.abs(Number(mean.value) - 3) < 0.05 && Math.abs(Number(swing.value) - 1) < 0.05);
  // Without gas there is no value, and the fire from its start is another.
  add(10.1, undefined);
  assert.ok(Number(mean.value) < 4);
  add(0.5, 9);
  assert.equal(mean.value, undefined);
  mean.clear();
  add(2, 9);
  assert.equal(mean.value, undefined);
});
