/** Public functions refuse arguments of another form by an error that names the argument and what it must be. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { connectFire } from '../../web/embed-client.js';
import { maskOfImage, maskOfPath, maskOfText } from '../../web/mask.js';
import { mountPanel } from '../../web/panel.js';
import { elementCode, fromFragment, fromQuery, iframeCode, pageLink, toQuery } from '../../web/share.js';
import { words } from '../../web/sim/values.js';
import { mountTools } from '../../web/tools.js';
import { assertRefuses } from '../hostile.mjs';

const URL = 'https://fire.example/';
for (const [config, words] of /** @type {[any, RegExp][]} */ ([
  [undefined, /config must be an object.*undefined/],
  [[], /config must be an object.*list/],
  [{ objects: 5 }, /config\.objects must be a list.*5/],
  [{ values: 7 }, /config\.values must be an object.*7/],
  [{ values: { wind: Symbol('a') } }, /config\.values\.wind must be a number.*symbol/],
  [{ preset: 3 }, /config\.preset must be a text.*3/],
])) {
  test(`settings of another form are refused by name: ${words}`, async () => {
    for (const write of [toQuery, elementCode])
      assert.throws(() => write(config), { name: 'TypeError', message: words });
    for (const write of [pageLink, iframeCode])
      await assert.rejects(write(config, URL), { name: 'TypeError', message: words });
  });
}

const config = { values: { wind: 1 } };
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

/** Each argument of each public function that needs no browser. @type {[named: RegExp, call: (value: any) => any][]} */
const ARGUMENTS = [
  [/config/, (value) => toQuery(value)],
  [/preset/, (preset) => toQuery({ preset })],
  [/wind/, (wind) => toQuery({ values: { wind } })],
  [/config/, (value) => elementCode(value)],
  [/scriptUrl/, (value) => elementCode(config, value)],
  [/shown/, (value) => elementCode(config, undefined, value)],
  [/shown\.width/, (width) => elementCode(config, undefined, { width })],
  [/shown\.attributes/, (attributes) => elementCode(config, undefined, { attributes })],
  [/shown\.attributes/, (fit) => iframeCode(config, URL, { attributes: { fit } })],
  [/config/, (value) => pageLink(value, URL)],
  [/base/, (value) => pageLink(config, value)],
  [/embedUrl/, (value) => iframeCode(config, value)],
  [/search/, (value) => fromQuery(value)],
  [/hash/, (value) => fromFragment(value)],
  [/text/, (value) => masks(() => maskOfText(value, '1em serif'))],
  [/font/, (value) => masks(() => maskOfText('A', value))],
  [/width/, (value) => masks(() => maskOfText('A', '1em serif', value))],
  [/path/, (value) => masks(() => maskOfPath(value, [0, 0, 1, 1]))],
  [/box/, (value) => masks(() => maskOfPath('M0 0', value))],
  [/box/, (value) => masks(() => maskOfPath('M0 0', [value, 0, 1, 1]))],
  [/image/, (value) => masks(() => maskOfImage(value))],
  [/iframe/, (value) => connectFire(value)],
  [/host|options/, (value) => mountPanel(value)],
  [/host/, (value) => mountPanel(/** @type {any} */ ({ host: value, fire }))],
  [/fire/, (value) => mountPanel(/** @type {any} */ ({ host, fire: value }))],
  [/page/, (page) => mounts(mountPanel, { host, fire, page })],
  [/only/, (only) => mounts(mountPanel, { host, fire, only })],
  [/host|options/, (value) => mountTools(value)],
  [/host/, (value) => mountTools(/** @type {any} */ ({ host: value, fire }))],
  [/fire/, (value) => mountTools(/** @type {any} */ ({ host, fire: value }))],
];

for (const [named, call] of ARGUMENTS) {
  test(`hostile values are refused by name: ${call}`, () => assertRefuses(call, named));
}

test('a text in an error of the library neither acts on a terminal nor turns it around', () => {
  assert.equal(words('a\u001b[31m\u0000\u009b\u202e\ufeffb'), '"a\\u001b[31m\\u0000\\u009b\\u202e\\ufeffb"');
  assert.equal(words('é'.repeat(1e6)), `"${'é'.repeat(40)}…"`);
});
