/** The worker of films: each message is answered, or the page hears of an error. */
import assert from 'node:assert/strict';
import { test } from 'node:test';

test('an answer that cannot be posted is an error of the worker, and the next one is posted', async (context) => {
  /** @type {(event: any) => void} */
  let receive = () => {};
  /** @type {unknown[]} */
  const posted = [];
  let fails = true;
  Object.assign(globalThis, {
    OffscreenCanvas: class {},
    addEventListener: (/** @type {string} */ _name, /** @type {typeof receive} */ listener) => (receive = listener),
    postMessage: (/** @type {unknown} */ answer) => {
      if (fails) throw new Error('no memory for a message');
      posted.push(answer);
    },
  });
  await import('../../web/record/worker.js');
  const thrown = new Promise((resolve) => {
    context.mock.method(globalThis, 'setTimeout', (/** @type {() => void} */ act) => {
      try {
        act();
      } catch (error) {
        resolve(error);
      }
    });
  });
  receive({ data: { open: { format: 'wav' } } });
  assert.match(String(await thrown), /no memory for a message/);
  fails = false;
  receive({ data: { open: { format: 'wav' } } });
  await new Promise(setImmediate);
  assert.deepEqual(posted, [{ format: 'wav' }]);
});
