/** The loop of an engine: why an engine has stopped, and which calls wait for a part of the wasm. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { reasonOf, runEngine } from '../../web/engine/loop.js';
import { base } from './parts.mjs';

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

/** A loop whose engine needs `part` where `needs` says so; with the calls that ran and the events. */
function loop(/** @type {string} */ part, /** @type {(name: string, start: any) => boolean} */ needs) {
  /** @type {string[]} */
  const ran = [];
  /** @type {any[]} */
  const posted = [];
  Object.assign(globalThis, { requestAnimationFrame: () => 1, cancelAnimationFrame: () => {} });
  const Engine = class {
    /** @type {(sent: any[], loaded: Set<string>) => boolean} */
    call([, , name, start], loaded) {
      if (!loaded.has(part) && needs(name, start)) throw part;
      ran.push(name);
      return false;
    }
  };
  const canvas = { getContext: () => null, addEventListener: () => {}, removeEventListener: () => {} };
  const { receive } = runEngine(/** @type {any} */ (Engine), /** @type {any} */ (canvas), {
    post: (message) => posted.push(message),
    show: () => true,
    module: new WebAssembly.Module(base(1)),
    extend: () => {},
    fail: assert.fail,
  });
  return { run: (/** @type {any} */ data) => receive({ data }), ran, posted };
}

test('a fire burns without its children if their code does not arrive, and the list of children is refused', () => {
  const { run, ran, posted } = loop('children', (name, start) => name === 'children' || start?.children);
  run([1, 0, 'add', { children: true }]);
  run([1, 1, 'set', {}]);
  run([1, 2, 'children', []]);
  assert.deepEqual(posted, [{ type: 'part', part: 'children' }]);
  run({ part: 'children', why: 'it gave 404' });
  assert.deepEqual(ran, ['add', 'set']);
  run({ part: 'children', why: 'it gave 404' });
  const [{ id, message }] = posted.at(-1).errors;
  assert.deepEqual(
    [posted.at(-1).request, id, message],
    [2, 'children', 'The code for children could not be loaded: it gave 404'],
  );
});

test('a fire plays, pauses, hides and is resized while a call waits for a part, and the others keep their order', () => {
  const { run, ran } = loop('bodies', (name) => name === 'preset');
  run([1, 0, 'add', {}]);
  run([1, 1, 'preset', 'house-of-cards']);
  for (const name of ['set', 'pause', 'visible', 'step', 'resize', 'play']) run([1, 2, name]);
  // Other fires do not wait.
  run([2, 0, 'add', {}]);
  assert.deepEqual(ran.splice(0), ['add', 'pause', 'visible', 'resize', 'play', 'add']);
  run({ part: 'bodies', module: new WebAssembly.Module(base(1)) });
  assert.deepEqual(ran, ['preset', 'set', 'step']);
});

test('a removal drops what waits for a part, and another fire asks for it again', () => {
  const { run, ran, posted } = loop('bodies', (name, start) => name === 'preset' || start?.bodies);
  run([1, 0, 'add', {}]);
  run([1, 1, 'preset', 'house-of-cards']);
  run([1, 2, 'set', {}]);
  run([1, 3, 'remove']);
  assert.deepEqual(ran.splice(0), ['add', 'remove']);
  run([2, 0, 'add', { bodies: true }]);
  // Before its `add` there is nothing to pause.
  run([2, 1, 'pause']);
  run([2, 2, 'remove']);
  run([3, 0, 'add', { bodies: true }]);
  run([3, 1, 'pause']);
  assert.deepEqual(ran.splice(0), ['remove']);
  assert.equal(posted.length, 3);
  run({ part: 'bodies', module: new WebAssembly.Module(base(1)) });
  assert.deepEqual(ran, ['add', 'pause']);
});
