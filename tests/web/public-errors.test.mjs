/** Public functions refuse arguments of another form by an error that names the argument and what it must be. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { connectFire } from '../../web/embed-client.js';
import { maskOfImage, maskOfPath, maskOfText } from '../../web/mask.js';
import { mountPanel } from '../../web/panel.js';
import { elementCode, fromFragment, fromQuery, iframeCode, pageLink, toQuery } from '../../web/share.js';
import { mountTools } from '../../web/tools.js';
import { answers, assertRefused, hostileValues } from '../hostile.mjs';

const URL = 'https://fire.example/';
const hostile = {
  toString() {
    throw new Error('mine');
  },
};

for (const [config, words] of /** @type {[any, RegExp][]} */ ([
  [undefined, /config must be an object.*undefined/],
  [null, /config must be an object.*null/],
  ['{}', /config must be an object.*text/],
  [[], /config must be an object.*list/],
  [{ objects: 5 }, /config\.objects must be a list.*5/],
  [{ objects: null }, /config\.objects must be a list.*null/],
  [{ objects: { 0: {} } }, /config\.objects must be a list.*object/],
  [{ values: 7 }, /config\.values must be an object.*7/],
  [{ values: [1] }, /config\.values must be an object.*list/],
  [{ values: { wind: hostile } }, /config\.values\.wind must be a number.*object/],
  [{ values: { wind: Symbol('a') } }, /config\.values\.wind must be a number.*symbol/],
  [{ values: { wind: null } }, /config\.values\.wind must be a number.*null/],
  [{ preset: 3 }, /config\.preset must be a text.*3/],
  [{ preset: hostile }, /config\.preset must be a text.*object/],
])) {
  test(`settings of another form are refused by name: ${words}`, async () => {
    for (const write of [toQuery, elementCode])
      assert.throws(() => write(config), { name: 'TypeError', message: words });
    for (const write of [pageLink, iframeCode])
      await assert.rejects(write(config, URL), { name: 'TypeError', message: words });
  });
}

for (const [call, words] of /** @type {[(...values: any[]) => unknown, RegExp][]} */ ([
  [() => maskOfPath('M0 0', /** @type {any} */ (null)), /^box = "null".*four numbers/],
  [() => maskOfPath('M0 0', /** @type {any} */ ([0, 0, 1])), /^box = .*four numbers/],
  [() => maskOfPath('M0 0', [0, 0, NaN, 1]), /^box = .*four numbers/],
  [() => maskOfPath(/** @type {any} */ (hostile), [0, 0, 1, 1]), /^path = "something of type object".*text/],
  [() => maskOfPath('M0 0', [0, 0, 1, 1], /** @type {any} */ (hostile)), /^width = .*0\.002 to 10/],
  [() => maskOfPath('M0 0', [0, 0, 1, 1], 11), /^width = "11".*0\.002 to 10/],
  [() => maskOfText(/** @type {any} */ (undefined), '1em serif'), /^text = "undefined".*text/],
  [() => maskOfText('A', /** @type {any} */ (null)), /^font = "null".*CSS font/],
  [() => maskOfText(/** @type {any} */ (Symbol('a')), '1em serif'), /^text = "Symbol\(a\)"/],
  [() => maskOfImage(/** @type {any} */ (null)), /^image = "null".*an image/],
  [() => maskOfImage(/** @type {any} */ ('a.png')), /^image = "a.png".*an image/],
])) {
  test(`a mask of something else is refused by name: ${words}`, () => {
    assert.throws(call, { name: 'RangeError', message: words });
  });
}

const EMPTY = ['{}', 'an object without a prototype'];
const OBJECTS = [...EMPTY, 'a date', 'a throwing toString', 'a throwing iterator'];
const TEXTS = ["''", "'x'", 'a long text'];
const NUMBERS = ['-0', '-1', '1.5', '1e300'];
const config = { values: { wind: 1 } };
const long = { values: { note: 'x'.repeat(3000) } };
/** Where a panel or a toolbar begins to use the page, its arguments have passed. */
const host = {
  nodeType: 1,
  getRootNode() {
    throw new TypeError('passed');
  },
};
const fire = new EventTarget();
const mounts = (/** @type {any} */ mount, /** @type {object} */ options) =>
  mount(options).catch((/** @type {Error} */ error) => {
    if (!/passed|is not defined/.test(error.message)) throw error;
  });
/** Without a browser there is no canvas: a mask whose arguments have passed ends there. */
const masks = (/** @type {() => unknown} */ make) => {
  try {
    make();
  } catch (/** @type {any} */ error) {
    if (!/there is no canvas/.test(error.message)) throw error;
  }
};

/** Each argument of each public function that needs no browser: its call, and what it takes of the hostile values. */
/** @type {[name: string, named: RegExp, call: (value: any) => any, taken: string[]][]} */
const ARGUMENTS = [
  ['toQuery(config)', /config/, (value) => toQuery(value), [...OBJECTS, 'a throwing toJSON']],
  ['toQuery({preset})', /preset/, (preset) => toQuery({ preset }), ['undefined', ...TEXTS]],
  [
    'toQuery({values})',
    /config/,
    (values) => toQuery({ values }),
    ['undefined', ...EMPTY, 'a date', 'a throwing iterator'],
  ],
  [
    'toQuery({values: {wind}})',
    /wind/,
    (wind) => toQuery({ values: { wind } }),
    ['NaN', 'Infinity', 'true', ...NUMBERS, ...TEXTS],
  ],
  ['toQuery({objects})', /objects/, (objects) => toQuery({ objects }), ['undefined', '[]', 'a long list']],
  ['elementCode(config)', /config/, (value) => elementCode(value), [...OBJECTS, 'a throwing toJSON']],
  ['elementCode(, scriptUrl)', /scriptUrl/, (value) => elementCode(config, value), ['undefined', ...TEXTS]],
  [
    'elementCode(, , shown)',
    /shown/,
    (value) => elementCode(config, undefined, value),
    ['undefined', ...EMPTY, 'a date', 'a throwing toString', 'a throwing toJSON', 'a throwing iterator'],
  ],
  [
    'elementCode(, , {width})',
    /shown\.width/,
    (width) => elementCode(config, undefined, { width }),
    ['undefined', '1.5', '1e300'],
  ],
  [
    'elementCode(, , {attributes})',
    /shown\.attributes/,
    (attributes) => elementCode(config, undefined, { attributes }),
    ['undefined', ...EMPTY, 'a date', 'a throwing iterator'],
  ],
  [
    'iframeCode(, , {attributes: {fit}})',
    /shown\.attributes/,
    (fit) => iframeCode(config, URL, { attributes: { fit } }),
    ['NaN', 'Infinity', 'true', ...NUMBERS, ...TEXTS],
  ],
  ['pageLink(config)', /config/, (value) => pageLink(value, URL), [...OBJECTS, 'a throwing toJSON']],
  [
    'pageLink({label}) as a fragment',
    /config/,
    (label) => pageLink({ ...long, label }, URL),
    [
      'undefined',
      'null',
      'NaN',
      'Infinity',
      'true',
      ...NUMBERS,
      ...TEXTS,
      'a symbol',
      'a function',
      '[]',
      'a long list',
      ...OBJECTS,
    ],
  ],
  ['pageLink(, base)', /base/, (value) => pageLink(config, value), []],
  ['iframeCode(, embedUrl)', /embedUrl/, (value) => iframeCode(config, value), []],
  ['fromQuery(search)', /search/, (value) => fromQuery(value), TEXTS],
  ['fromQuery(, names)', /names/, (value) => fromQuery('', value), ['undefined', ...TEXTS, '[]', 'a long list']],
  ['fromFragment(hash)', /hash/, (value) => fromFragment(value), TEXTS],
  ['maskOfText(text)', /text/, (value) => masks(() => maskOfText(value, '1em serif')), TEXTS],
  ['maskOfText(, font)', /font/, (value) => masks(() => maskOfText('A', value)), TEXTS],
  ['maskOfText(, , width)', /width/, (value) => masks(() => maskOfText('A', '1em serif', value)), ['undefined', '1.5']],
  ['maskOfPath(path)', /path/, (value) => masks(() => maskOfPath(value, [0, 0, 1, 1])), TEXTS],
  ['maskOfPath(, box)', /box/, (value) => masks(() => maskOfPath('M0 0', value)), []],
  ['maskOfPath(, [left])', /box/, (value) => masks(() => maskOfPath('M0 0', [value, 0, 1, 1])), NUMBERS],
  [
    'maskOfPath(, , width)',
    /width/,
    (value) => masks(() => maskOfPath('M0 0', [0, 0, 1, 1], value)),
    ['undefined', '1.5'],
  ],
  ['maskOfImage(image)', /image/, (value) => masks(() => maskOfImage(value)), []],
  [
    'maskOfImage(, width)',
    /width/,
    (value) => masks(() => maskOfImage(/** @type {any} */ ({ width: 1, height: 1 }), value)),
    ['undefined', '1.5'],
  ],
  ['connectFire(iframe)', /iframe/, (value) => connectFire(value), []],
  ['mountPanel(options)', /host|options/, (value) => mountPanel(value), []],
  ['mountPanel({host})', /host/, (value) => mountPanel(/** @type {any} */ ({ host: value, fire })), []],
  ['mountPanel({fire})', /fire/, (value) => mountPanel(/** @type {any} */ ({ host, fire: value })), []],
  ['mountPanel({page})', /page/, (page) => mounts(mountPanel, { host, fire, page }), ['undefined', ...TEXTS]],
  ['mountPanel({script})', /script/, (script) => mounts(mountPanel, { host, fire, script }), ['undefined', ...TEXTS]],
  ['mountPanel({embed})', /embed/, (embed) => mounts(mountPanel, { host, fire, embed }), ['undefined', ...TEXTS]],
  ['mountPanel({only})', /only/, (only) => mounts(mountPanel, { host, fire, only }), ['undefined', '[]']],
  ['mountTools(options)', /host|options/, (value) => mountTools(value), []],
  ['mountTools({host})', /host/, (value) => mountTools(/** @type {any} */ ({ host: value, fire })), []],
  ['mountTools({fire})', /fire/, (value) => mountTools(/** @type {any} */ ({ host, fire: value })), []],
  [
    'mountTools({closed})',
    /closed/,
    (closed) => mounts(mountTools, { host, fire, closed }),
    ['undefined', 'a function'],
  ],
];

for (const [name, named, call, taken] of ARGUMENTS) {
  test(`hostile values are refused by name: ${name}`, async () => {
    assertRefused(await answers(call, hostileValues()), named, taken);
  });
}
