/**
 * Time limits: time counts while the page is visible and its timers run.
 */
import assert from 'node:assert/strict';
import { afterEach, beforeEach, test } from 'node:test';
import { countdown } from '../../web/engine/time-limit.js';

const real = { setInterval, clearInterval, now: performance.now, document: globalThis.document };
let now = 0;
/** @type {Set<() => void>} */
const timers = new Set();

/** Seconds pass; the browser calls the timers that often in each. */
function pass(seconds, calls = 1) {
  for (; seconds > 0; seconds -= 1) {
    now += 1000;
    for (let call = 0; call < calls; call += 1) for (const act of [...timers]) act();
  }
}

beforeEach(() => {
  timers.clear();
  Object.assign(globalThis, {
    document: { hidden: false },
    setInterval: (act) => {
      timers.add(act);
      return act;
    },
    clearInterval: (act) => timers.delete(act),
  });
  performance.now = () => now;
});
afterEach(() => {
  const { now: clock, ...others } = real;
  Object.assign(globalThis, others);
  performance.now = clock;
});

test('the limit ends after its seconds, once', () => {
  let ended = 0;
  countdown(10, () => (ended += 1));
  pass(9);
  assert.equal(ended, 0);
  pass(1);
  assert.equal(ended, 1);
  pass(20);
  assert.equal(ended, 1);
  assert.equal(timers.size, 0);
});

test('a cancelled limit never ends', () => {
  const cancel = countdown(2, () => assert.fail('it ended'));
  pass(1);
  cancel();
  pass(5);
  assert.equal(timers.size, 0);
});

test('a hidden page has no time', () => {
  let ended = false;
  countdown(3, () => (ended = true));
  globalThis.document.hidden = true;
  pass(1000);
  assert.equal(ended, false);
  globalThis.document.hidden = false;
  pass(3);
  assert.equal(ended, true);
});

test('a suspended computer, a breakpoint and a blocked page count for nothing', () => {
  let ended = false;
  countdown(3, () => (ended = true));
  now += 3_600_000;
  pass(0);
  for (const act of [...timers]) act();
  assert.equal(ended, false);
  pass(2);
  assert.equal(ended, false);
  pass(1);
  assert.equal(ended, true);
});

test('a page twenty times too slow for its timers has no time', () => {
  countdown(10, () => assert.fail('it ended'));
  for (let left = 100; left > 0; left -= 1) {
    now += 19_000;
    pass(1);
  }
});
