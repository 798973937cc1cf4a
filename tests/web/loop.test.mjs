/** Why an engine has stopped: the text and the place of a panic, no memory, or a script's error. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { reasonOf } from '../../web/engine/loop.js';

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
