/** Values that no public function should be given. */
import assert from 'node:assert/strict';

/** @type {{[name: string]: any}} */
const VALUES = {
  undefined,
  null: null,
  NaN,
  Infinity,
  '-1': -1,
  1.5: 1.5,
  '1e300': 1e300,
  '10n': 10n,
  true: true,
  "''": '',
  'a long text': 'x'.repeat(1e6),
  'a symbol': Symbol('mine'),
  'a function': () => 1,
  '{}': {},
  '[]': [],
  'a long list': Array(1e5).fill(0),
  'a date': new Date(NaN),
};

/**
 * A function takes each value or refuses it by a RangeError or TypeError that names the argument in few words, and it
 * refuses some of them.
 * @param {(value: any) => any} call
 * @param {RegExp} named  What names the argument.
 * @param {string[]} [refused]
 */
export async function assertRefuses(call, named, refused = ['10n', 'a symbol', 'a function', 'a long list']) {
  for (const [name, value] of Object.entries(VALUES)) {
    try {
      await call(value);
    } catch (/** @type {any} */ error) {
      assert.ok(error instanceof RangeError || error instanceof TypeError, `${name}: ${error?.stack}`);
      assert.match(error.message, named, name);
      assert.ok(error.message.length < 1000, `${name}: ${error.message.length} characters`);
      continue;
    }
    assert.ok(!refused.includes(name), `${name} is taken`);
  }
}
