/**
 * Values that no public function should be given, made where they are used: a page gets the source of `hostileValues`.
 */
import assert from 'node:assert/strict';

/** @returns {{[name: string]: any}} */
export function hostileValues() {
  const fail = () => {
    throw new Error('mine');
  };
  const traps = ['get', 'has', 'ownKeys', 'getPrototypeOf', 'getOwnPropertyDescriptor', 'apply'];
  const revoked = Proxy.revocable({}, {});
  revoked.revoke();
  return {
    undefined,
    null: null,
    NaN,
    Infinity,
    '-0': -0,
    '-1': -1,
    1.5: 1.5,
    '1e300': 1e300,
    '10n': 10n,
    true: true,
    "''": '',
    "'x'": 'x',
    'a long text': 'x'.repeat(1e6),
    'a symbol': Symbol('mine'),
    'a function': () => 1,
    '{}': {},
    '[]': [],
    'a long list': Array(1e5).fill(0),
    'an object without a prototype': Object.create(null),
    'a date': new Date(NaN),
    'a throwing toString': { toString: fail, valueOf: fail },
    'a throwing toJSON': { toJSON: fail },
    'a throwing getter': Object.defineProperty({}, 'x', { get: fail, enumerable: true }),
    'a throwing iterator': { [Symbol.iterator]: fail },
    'a throwing proxy': new Proxy({}, Object.fromEntries(traps.map((trap) => [trap, fail]))),
    'a throwing list': new Proxy([], Object.fromEntries(traps.map((trap) => [trap, fail]))),
    'a revoked proxy': revoked.proxy,
    // Its type is "undefined".
    ...(globalThis.document && { 'document.all': document.all }),
  };
}

/**
 * What calls with each hostile value answer: `taken`, or the class and the message of the error.
 * @param {(value: any) => any} call
 * @param {{[name: string]: any}} values
 */
export async function answers(call, values) {
  /** @type {{[name: string]: {kind: string, message: string}}} */
  const all = {};
  for (const [name, value] of Object.entries(values)) {
    try {
      await call(value);
      all[name] = { kind: 'taken', message: '' };
    } catch (/** @type {any} */ error) {
      const known = error instanceof RangeError ? 'RangeError' : error instanceof TypeError ? 'TypeError' : undefined;
      all[name] = { kind: known ?? `${error?.name}`, message: `${error?.message ?? error}` };
    }
  }
  return all;
}

/**
 * A function takes these of the hostile values and refuses the others by a RangeError or TypeError that names the
 * argument in few words.
 * @param {Awaited<ReturnType<typeof answers>>} all
 * @param {RegExp} named what names the argument
 * @param {string[]} taken
 */
export function assertRefused(all, named, taken) {
  const is = (/** @type {string} */ wanted) => Object.keys(all).filter((name) => all[name].kind === wanted);
  assert.deepEqual(is('taken').sort(), [...taken].sort());
  for (const [name, { kind, message }] of Object.entries(all)) {
    if (kind === 'taken') continue;
    assert.match(kind, /^(RangeError|TypeError)$/, `${name}: ${message}`);
    assert.match(message, named, name);
    assert.ok(message.length < 1000, `${name}: ${message.length} characters`);
  }
}
