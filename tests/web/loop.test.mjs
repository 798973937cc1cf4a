/** Why an engine has stopped: the text and the place of a panic, no memory, or a script's error. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { reasonOf, runEngine } from '../../web/engine/loop.js';

const trap = new WebAssembly.RuntimeError('unreachable');
const engine = (/** @type {string} */ panic) => ({ panic: () => panic });

test('a panic has its text and its place', () => {
  const panic = 'panicked at crates/hearth-core/src/grid.rs:12:5:\nindex out of bounds:\nthe index is 9';
  assert.deepEqual(reasonOf(trap, engine(panic)), {
    why: 'index out of bounds:\nthe index is 9',
    at: 'crates/hearth-core/src/grid.rs:12:5',
  });
});

test('a trap without a panic is a lack of memory, in every browser’s words', () => {
  for (const words of ['unreachable', 'unreachable executed', 'Unreachable code should not be executed']) {
    const { why, at } = reasonOf(new WebAssembly.RuntimeError(words), engine(''));
    assert.match(why, /no memory is left/);
    assert.equal(at, undefined);
  }
});

test('other errors keep their words, even if the wasm can no longer be called', () => {
  const broken = {
    panic: () => {
      throw new Error('gone');
    },
  };
  assert.equal(reasonOf(new TypeError('a defect'), broken).why, 'TypeError: a defect');
  assert.equal(reasonOf(new TypeError('a defect'), engine('')).why, 'TypeError: a defect');
});

test('a fire burns without its children if their code does not arrive, and the list of children is refused', async () => {
  const ran = [];
  const posted = [];
  Object.assign(globalThis, { requestAnimationFrame: () => 1, cancelAnimationFrame: () => {} });
  const Engine = class {
    call(sent) {
      const [, , name, start] = sent;
      if (name === 'children' || start?.children) throw 'children';
      ran.push(name);
      return false;
    }
  };
  const canvas = { getContext: () => null, addEventListener: () => {}, removeEventListener: () => {} };
  // A module that the build has divided.
  const module = new WebAssembly.Module(
    new Uint8Array([
      0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 7, 5, 1, 1, 48, 0, 0, 10, 4, 1, 2, 0, 11,
    ]),
  );
  const engine = runEngine(/** @type {any} */ (Engine), /** @type {any} */ (canvas), {
    post: (message) => posted.push(message),
    show: () => true,
    module,
    extend: () => {},
    fail: assert.fail,
  });
  engine.call([1, 0, 'add', { children: true }]);
  engine.call([1, 1, 'set', {}]);
  engine.call([1, 2, 'children', []]);
  assert.deepEqual(posted, [{ type: 'part', part: 'children' }]);
  engine.add({ part: 'children', why: 'it gave 404' });
  assert.deepEqual(ran, ['add', 'set']);
  engine.add({ part: 'children', why: 'it gave 404' });
  const [{ id, message }] = posted.at(-1).errors;
  assert.deepEqual(
    [posted.at(-1).request, id, message],
    [2, 'children', 'The code for children could not be loaded: it gave 404'],
  );
});
