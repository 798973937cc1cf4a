/**
 * Numbers and colours of the colour bar.
 */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { colour, formatNumber, ticks } from '../../web/element/view/scale.js';
import { PARAMETERS, QUANTITIES } from '../../web/parameters.js';

const entry = Object.fromEntries(PARAMETERS.map((parameter) => [parameter.id, parameter]));

/** Every range that a picture may have, from a thousandth on: both ways, or from some least on. */
const RANGES = [0.001, 0.1, 1, 10, 1000, 100_000].flatMap((power) =>
  [1, 2, 5].flatMap((digit) => {
    const most = Number((digit * power).toPrecision(3));
    return [
      [0, most],
      [-most, most],
      [most / 10, most],
      [most / 2, most],
      [0.3 * most, 1.2 * most],
      [0, 0.6 * most],
      [0, 0.7 * most],
    ];
  }),
);

describe('its numbers', () => {
  test('are one to three round ticks between the ends, even and apart from both', () => {
    for (const [least, most] of RANGES) {
      const between = ticks(least, most, false);
      assert.ok(between.length >= 1 && between.length <= 3, `${least} to ${most}: ${between}`);
      for (const tick of between) {
        const share = (tick - least) / (most - least);
        assert.ok(share > 0.1 && share < 0.9, `${tick} of ${least} to ${most}`);
        assert.ok(formatNumber(tick).replace(/[^1-9]/g, '').length <= 2, `${tick} of ${least} to ${most}`);
      }
      const marks = [least, ...between, most];
      const gaps = marks.slice(1).map((mark, at) => (mark - marks[at]) / (most - least));
      assert.ok(Math.max(...gaps) < 0.61, `${marks} are uneven`);
    }
    for (const most of [1, 2, 5, 10, 20, 50]) {
      for (const tick of ticks(0, most, true)) assert.ok(Number.isInteger(tick), `${tick} of ${most}`);
    }
  });

  test('are written as people read them', () => {
    for (const [value, text] of [
      [0, '0'],
      [-0, '0'],
      [2000, '2000'],
      [0.1 + 0.2, '0.3'],
      [-200, '−200'],
      [20_000, '20\u202f000'],
      [5e-6, '5·10⁻⁶'],
      [1e8, '10⁸'],
      [-2e7, '−2·10⁷'],
      [0.002, '0.002'],
    ])
      assert.equal(formatNumber(value), text);
  });

  test('come with every display that is no fire, of which the table has each', () => {
    const shown = entry.display_mode.choices.filter((name) => name in QUANTITIES);
    const lights = entry.bloom.when.display_mode.concat(entry.exposure.when.display_mode);
    assert.deepEqual(
      shown,
      entry.display_mode.choices.filter((name) => !lights.includes(name)),
    );
    assert.deepEqual(Object.keys(QUANTITIES).sort(), [...shown].sort());
  });
});

test('its colours grow brighter from the dark end, or from the middle both ways', () => {
  const light = ([r, g, b]) => 0.2126 * (r / 255) ** 2.2 + 0.7152 * (g / 255) ** 2.2 + 0.0722 * (b / 255) ** 2.2;
  const lights = (signed, from, to) =>
    Array.from({ length: 11 }, (_, at) => light(colour(from + ((to - from) * at) / 10, signed)));
  for (const row of [lights(false, 0, 1), lights(true, 0.5, 1), lights(true, 0.5, 0)]) {
    assert.deepEqual(
      row,
      [...row].sort((a, b) => a - b),
    );
    assert.ok(row[0] < 0.03 && row[10] > 0.4, `${row[0]} to ${row[10]}`);
  }
});
