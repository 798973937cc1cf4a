/** Public functions refuse arguments of another form by an error that names the argument and what it must be. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maskOfImage, maskOfPath, maskOfText } from '../../web/mask.js';
import { elementCode, iframeCode, pageLink, toQuery } from '../../web/share.js';

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
