/** The parameters in the address of a page, without a browser: what they set, and what is rejected with a message. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { applyUrlParameters, readUrlParameters } from '../../web/pages/url-parameters.js';

const MANY = Array.from({ length: 300 }, (_, at) => `n${at}=1`).join('&');
const SEED = [['seed', '7']];

for (const [about, query, messages, values] of [
  ['names nothing known', 'viscosty=1&seed=7', [/viscosty.*viscosity/], SEED],
  ['names what every object has', '__proto__=1&constructor=2&toString=3&seed=7', [], SEED],
  [
    'names a value twice',
    'seed=7&seed=8&scene=default&preset=seed',
    [/“seed” more than once/, /“preset” more than once/],
    SEED,
  ],
  ['is half an escape', 'seed=7&%=%&%zz=%ff&=&&alt=%', [], SEED],
  ['holds HTML, which the fire rejects', 'exposure=%3Cimg+src=x%3E&seed=7', [], [['exposure', '<img src=x>'], ...SEED]],
  [
    'would fetch something',
    'src=/secret.json&poster=https://a.example/x.png&seed=7',
    [/cannot set “src”/, /cannot set “poster”/],
    SEED,
  ],
  ['sets hundreds', `seed=7&${MANY}`, [/301 values.*200/], []],
  ['is longer than 8 KiB', `seed=7&alt=${'x'.repeat(9000)}`, [/longer than 8192/], []],
  [
    'names the model last',
    'viscosity=0.02&model=classic',
    [],
    [
      ['model', 'classic'],
      ['viscosity', '0.02'],
    ],
  ],
]) {
  test(`an address that ${about} sets what is valid, and each mistake is reported`, () => {
    const { values: read, refused } = readUrlParameters(`?${query}`);
    assert.deepEqual(read, values);
    assert.equal(refused.length, messages.length, refused.join('\n'));
    for (const [at, words] of messages.entries()) assert.match(refused[at], words);
  });
}

test('scene and preset name the scene, options are read, and names of others are kept as they are', () => {
  for (const name of ['scene', 'preset'])
    assert.equal(readUrlParameters(`?${name}=candle&exposure=0.3`).scene, 'candle');
  assert.equal(readUrlParameters('?exposure=0.3').scene, undefined);
  assert.deepEqual(readUrlParameters('?paused&autoplay=false&alt=Embers').options, [
    ['paused', ''],
    ['autoplay', 'false'],
    ['alt', 'Embers'],
  ]);
  const foreign = 'fbclid=a.b&utm_source=mail&utm_source=x&gclid=1&q=fire&source=y&kind=z&ref=';
  const { unknown, refused, values } = readUrlParameters(`?${foreign}&exposure=0.5`);
  assert.deepEqual(unknown, [...new URLSearchParams(foreign)]);
  assert.deepEqual([refused, values], [[], [['exposure', '0.5']]]);
});

test('a fire gets its options and its scene before the values, of which the model is the first', () => {
  const calls = [];
  const fire = { setAttribute: (...args) => calls.push(args), set: (...args) => calls.push(args) };
  applyUrlParameters(fire, readUrlParameters('?wind=1&model=classic&scene=candle&paused'));
  assert.deepEqual(calls, [
    ['paused', ''],
    ['preset', 'candle'],
    ['model', 'classic'],
    ['wind', '1'],
  ]);
});
