/**
 * The plots without a page: the spectrum of a known signal peaks at its frequency, the record keeps what was measured,
 * and its CSV has units and the same numbers; the text of the probe's values.
 */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { measuresOf } from '../../web/measures.js';
import { roundUp } from '../../web/plots/chart.js';
import { valuesOf, whyOf } from '../../web/plots/readout.js';
import { Record } from '../../web/plots/record.js';
import { peakOf, spectrumOf } from '../../web/plots/spectrum.js';

/**
 * A signal at times that are not evenly spaced, as frames are.
 * @type {(seconds: number, of: (time: number) => number) => {time: number, value: number}[]}
 */
function sampled(seconds, of) {
  const samples = [];
  for (let at = 0, time = 100; time < 100 + seconds; at += 1, time += 0.012 + (0.01 * ((at * 7) % 11)) / 11)
    samples.push({ time, value: of(time) });
  return samples;
}

const beat = (/** @type {number} */ frequency, /** @type {number} */ time) => Math.sin(2 * Math.PI * frequency * time);

describe('the spectrum', () => {
  for (const frequency of [0.8, 1.9, 3.4, 6.2]) {
    test(`of a beat of ${frequency} Hz peaks there`, () => {
      const peak = peakOf(spectrumOf(sampled(20, (time) => 0.05 + 0.01 * beat(frequency, time))));
      assert.ok(Math.abs(peak - frequency) < 0.07, `${peak} Hz`);
    });
  }

  test('of a beat on a strong trend and a slow drift peaks at the beat', () => {
    const peak = peakOf(spectrumOf(sampled(30, (time) => 3 * time + 1.3 * beat(0.6, time) + beat(1.8, time))));
    assert.ok(Math.abs(peak - 1.8) < 0.07, `${peak} Hz`);
  });

  test('is relative to its greatest', () => {
    const powers = spectrumOf(sampled(10, (time) => beat(2, time))).map(({ power }) => power);
    assert.equal(Math.max(...powers), 1);
    assert.ok(Math.min(...powers) >= 0);
  });

  test('of a short signal, of one that rests and of none is empty and has no peak', () => {
    for (const samples of [sampled(4.5, (time) => beat(2, time)), sampled(10, () => 0), []]) {
      const spectrum = spectrumOf(samples);
      assert.deepEqual(spectrum, []);
      assert.equal(peakOf(spectrum), undefined);
    }
  });
});

/** What a fire of that age measures. */
const measures = (/** @type {number} */ time, more = {}) => ({
  time,
  power: 100 + time,
  flameHeight: 0.5,
  luminosity: 0.02,
  place: { y: 0, gas: true, solid: false },
  profile: [
    { y: 0.5, gas: true, solid: false, temperature: 1000 + time, u: 0, v: 2 },
    { y: 1.5, gas: false, solid: true },
  ],
  ...more,
});

describe('the record', () => {
  test('keeps the last minute', () => {
    const record = new Record();
    for (let time = 0; time <= 90; time += 0.5) record.add(measures(time), { fps: 50 }, 0);
    assert.equal(record.rows[0].time, 30);
    assert.deepEqual(record.rows.at(-1), { time: 90, frameTime: 20, flame: 0.5, power: 190, luminosity: 0.02 });
  });

  test('has one row of a time, and starts again with another fire or model', () => {
    const record = new Record();
    for (const time of [1, 2, 2, 2]) record.add(measures(time), null, 0);
    assert.deepEqual(
      record.rows.map(({ time, frame }) => [time, frame]),
      [
        [1, undefined],
        [2, undefined],
      ],
    );
    record.add(measures(0.5), null, 0);
    assert.deepEqual(
      record.rows.map(({ time }) => time),
      [0.5],
    );
    const { power, ...classic } = measures(0.6);
    record.add(/** @type {any} */ (classic), null, 0);
    assert.deepEqual(
      record.rows.map((row) => 'power' in row),
      [false],
    );
  });

  test('marks a slider that is dragged once, with its last value, for as long as the rows', () => {
    const record = new Record();
    record.mark('wind', 9);
    record.add(measures(1), null, 0);
    for (const value of [0.1, 0.2, 0.3]) record.mark('wind', value);
    record.add(measures(3), null, 0);
    record.mark('fuel_power', 300);
    assert.deepEqual(record.marks, [
      { time: 1, text: 'wind 0.3' },
      { time: 3, text: 'fuel power 300' },
    ]);
    record.add(measures(62), null, 0);
    assert.equal(record.marks.length, 1);
    record.add(measures(0.5), null, 0);
    assert.deepEqual(record.marks, []);
  });

  test('averages the profile, but not over another vertical', () => {
    const record = new Record();
    for (let at = 0; at <= 400; at += 1) record.add(measures(at / 10), null, 0);
    const [low, high] = record.levels;
    assert.equal(low.temperature, 1040);
    // A mean over some seconds lags behind by them.
    assert.ok(Math.abs(low.meanTemperature - 1036) < 0.2, `${low.meanTemperature}`);
    assert.deepEqual([high.temperature, high.meanTemperature, high.meanV], [undefined, undefined, undefined]);
    record.add(measures(40.1), null, 0.3);
    assert.equal(record.levels[0].meanTemperature, 1040.1);
  });

  test('is CSV with units, of numbers or nothing, with as many fields in each line', () => {
    const record = new Record();
    for (let time = 0; time <= 6; time += 0.02)
      record.add(measures(time, { luminosity: 0.02 + 0.01 * beat(2, time) }), { fps: 40 }, 0.1);
    const text = record.csv();
    assert.ok(text.endsWith('\r\n'));
    const [names, ...lines] = text
      .trimEnd()
      .split('\r\n')
      .map((line) => line.split(','));
    assert.deepEqual(names, [
      'time [s]',
      'frame time [ms]',
      'flame height [m]',
      'power [kW/m]',
      'luminosity [m²]',
      'frequency [Hz]',
      'luminosity spectrum [1]',
      'height at x = 0.1 m [m]',
      'temperature [K]',
      'mean temperature [K]',
      'upward velocity [m/s]',
      'mean upward velocity [m/s]',
    ]);
    assert.equal(lines.length, record.rows.length);
    for (const line of lines) {
      assert.equal(line.length, names.length);
      assert.ok(
        line.every((field) => field === '' || Number.isFinite(Number(field))),
        line.join(),
      );
    }
    assert.deepEqual(lines[50].slice(0, 4).map(Number), [1, 25, 0.5, 101]);
    const spectrum = lines.filter((line) => line[5] !== '').map((line) => line.slice(5, 7).map(Number));
    assert.ok(Math.abs(spectrum.find(([, power]) => power === 1)[0] - 2) < 0.1);
    assert.deepEqual(
      lines.slice(0, 3).map((line) => line.slice(7)),
      [
        ['0.5', '1006', lines[0][9], '2', '2'],
        ['1.5', '', '', '', ''],
        ['', '', '', '', ''],
      ],
    );
  });

  test('of nothing has the names alone', () => {
    assert.match(new Record().csv(), /^time \[s\],frame time \[ms\],[^\r]+\r\n$/);
  });
});

test('the numbers of the engine get their names, and a missing one has no name', () => {
  const nan = NaN;
  const numbers = [
    12,
    0.25,
    1.8,
    nan,
    0.4,
    0.01,
    900,
    1,
    2,
    0.4,
    nan,
    nan,
    nan,
    0.3,
    ...Array.from({ length: 64 }, (_, at) => [300 + at, 0, 0, 1.2, nan, nan, nan, -0.1]).flat(),
  ];
  const { place, profile, ...rest } = measuresOf(numbers, 0.7);
  assert.deepEqual(rest, { time: 12.25, flameHeight: 0.4, luminosity: 0.01 });
  assert.deepEqual(place, { y: 0.7, gas: true, solid: false, temperature: 900, u: 1, v: 2, density: 0.4 });
  assert.equal(profile.length, 64);
  assert.ok(Math.abs(profile[63].y - (1.8 * 63.5) / 64) < 1e-9);
  assert.equal(profile[63].temperature, 363);
  assert.equal(profile[63].solid, true);
  const [empty] = measuresOf([...numbers.slice(0, 6), ...Array(8 * 65).fill(nan)], 0).profile;
  assert.deepEqual([empty.gas, empty.solid, 'temperature' in empty], [false, false, false]);
});

test('values have units and directions, and are those of the model', () => {
  const gas = { y: 0, gas: true, solid: false, temperature: 1234.4, u: 1, v: 1, density: 0.287 };
  assert.deepEqual(valuesOf(gas), {
    temperature: '961 °C (1234 K)',
    velocity: '1.41 m/s ↗ up and right',
    density: '0.29 kg/m³',
  });
  assert.deepEqual(valuesOf({ ...gas, u: -3, v: 0.01, oxygen: 0.5, fuel: 0.031, soot: 0 }), {
    temperature: '961 °C (1234 K)',
    velocity: '3.00 m/s ← left',
    density: '0.29 kg/m³',
    oxygen: '11 %',
    fuel: '3.1 %',
    soot: '0.00',
  });
  assert.equal(valuesOf({ ...gas, u: 0, v: 0.01 }).velocity, 'at rest');
  assert.equal(valuesOf({ ...gas, u: 0, v: -2 }).velocity, '2.00 m/s ↓ down');
  assert.deepEqual(valuesOf({ y: 0, gas: false, solid: true }), { place: 'in a solid' });
  assert.deepEqual(valuesOf({ y: 0, gas: false, solid: false }), { place: 'no gas' });
});

test('the probe says why: fuel waits, soot glows, hot gas rises, air follows', () => {
  const air = { y: 0, gas: true, solid: false, temperature: 293, u: 0, v: 0, fuel: 0, oxygen: 1, soot: 0 };
  const why = (more = {}) => whyOf({ ...air, ...more });
  assert.match(why() ?? '', /21 %/);
  assert.match(why({ u: 0.5 }) ?? '', /follows/);
  assert.match(why({ temperature: 600, v: 1 }) ?? '', /rises/);
  assert.match(why({ temperature: 600 }) ?? '', /mixes/);
  assert.match(why({ temperature: 1500, oxygen: 0.3, soot: 1 }) ?? '', /used up oxygen/);
  assert.match(why({ temperature: 700, oxygen: 0.1, fuel: 0.5 }) ?? '', /cannot burn/);
  assert.deepEqual([why({ gas: false }), why({ solid: true })], [undefined, undefined]);
});

test('axes end at round numbers', () => {
  assert.deepEqual([0, 0.0123, 0.9, 1, 16.7, 260, 1734].map(roundUp), [1, 0.02, 1, 1, 20, 300, 2000]);
});
