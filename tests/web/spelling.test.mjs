/**
 * Suggestions for misspelt names, and unknown attributes that cause a warning.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { alike, nearest, suggestion, warnOnce } from '../../web/element/attributes/spelling.js';
import { readUrlParameters } from '../../web/pages/url-parameters.js';

const NAMES = [
  'fuel-power',
  'quality',
  'palette',
  'cool-colour',
  'hot-colour',
  'domain-width',
  'source-width',
  'wind',
  'seed',
];

test('a name suggests those that differ in signs, words or few letters', () => {
  for (const [name, near] of /** @type {[string, string[]][]} */ ([
    ['fuel_power', ['fuel-power']],
    ['fuelpower', ['fuel-power']],
    ['FuelPower', ['fuel-power']],
    ['quailty', ['quality']],
    ['palete', ['palette']],
    ['width', ['domain-width', 'source-width']],
    ['color', ['cool-colour', 'hot-colour']],
    ['hot-color', ['hot-colour']],
    ['wnid', ['wind']],
    ['seeds', ['seed']],
    ['frobnicate', []],
  ]))
    assert.deepEqual(nearest(name, NAMES), near, name);
});

test('transposed, missing, added and changed letters count as one mistake each', () => {
  for (const name of ['wnid', 'wnd', 'winnd', 'wand']) {
    assert.deepEqual(alike(name, NAMES, 1), ['wind'], name);
    assert.deepEqual(alike(name, NAMES, 0), [], name);
  }
});

test('the suggestion ends a sentence', () => {
  assert.equal(suggestion('quailty', NAMES), '; did you mean quality?');
  assert.equal(suggestion('color', NAMES), '; did you mean cool-colour or hot-colour?');
  assert.equal(suggestion('frobnicate', NAMES), '.');
});

test('an unknown attribute is reported once; those of HTML, frameworks and libraries are not', (context) => {
  const warn = context.mock.method(console, 'warn', () => {});
  for (const name of ['palete', 'palete', 'width', 'frobnicate']) warnOnce(name);
  const reported = warn.mock.calls.map(({ arguments: [words] }) => words);
  assert.equal(reported.length, 3);
  assert.match(reported[0], /<hearth-fire>.* palete; did you mean palette\?/);
  assert.match(reported[1], /did you mean .*domain-width.*\? .*style/);
  assert.match(reported[2], /no attribute frobnicate\.$/);
  for (const name of [
    'class',
    'id',
    'title',
    'lang',
    'dir',
    'hidden',
    'slot',
    'part',
    'is',
    'role',
    'tabindex',
    'nonce',
    'draggable',
    'inert',
    'popover',
    'translate',
    'contenteditable',
    'enterkeyhint',
    'inputmode',
    'autofocus',
    'accesskey',
    'spellcheck',
    'exportparts',
    'itemprop',
    'data-x',
    'aria-label',
    'onclick',
    'xml:lang',
    'xmlns',
    ':foo',
    '@click',
    'v-if',
    'x-data',
    '_ngcontent-ng-c1',
    '_nghost-abc',
    'ng-version',
    'ng-reflect-x',
    'hx-get',
    'wire:model',
    '#ref',
    '[prop]',
    '(event)',
    'b-1a2b3c',
  ])
    warnOnce(name);
  assert.equal(warn.mock.callCount(), 3);
});

test('an unknown attribute of another element is reported with its own names', (context) => {
  const warn = context.mock.method(console, 'warn', () => {});
  for (const name of ['materal', 'materal', 'palete']) warnOnce(name, 'hearth-solid', ['of', 'material']);
  const reported = warn.mock.calls.map(({ arguments: [words] }) => words);
  assert.deepEqual(reported, [
    '<hearth-solid>: it has no attribute materal; did you mean material?',
    '<hearth-solid>: it has no attribute palete.',
  ]);
});

test('a query distinguishes foreign names from misspelt ones', () => {
  const { values, options, unknown, refused } = readUrlParameters(
    '?seed=7&fbclid=1&utm_source=a&utm_source=b&viscosty=1&quality=low&fuelpower=3&kind=x&__proto__=1&feed=2',
  );
  assert.deepEqual(values, [['seed', '7']]);
  assert.deepEqual(options, [['quality', 'low']]);
  assert.deepEqual(
    unknown.map(([name]) => name),
    ['fbclid', 'utm_source', 'utm_source', 'kind', '__proto__', 'feed'],
  );
  assert.equal(refused.length, 2);
  assert.match(refused[0], /viscosty.*viscosity/);
  assert.match(refused[1], /fuelpower.*fuel-power/);
});
