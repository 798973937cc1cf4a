/**
 * What a page gives its engine: parts of the wasm, only those of the same build, each asked for until it is right; calls, of
 * which one that cannot be posted ends the engine.
 */
import assert from 'node:assert/strict';
import { afterEach, test } from 'node:test';
import { connect } from '../../web/engine/engine.js';
import { VERSION } from '../../web/generated/version.js';
import { base, part } from './parts.mjs';

/** What the server answers to the next requests. @type {(Uint8Array<ArrayBuffer> | 'silence')[]} */
const answers = [];
/** How the browser's cache was used. @type {(string | undefined)[]} */
const caches = [];
/** Takes what the engine gets next. @type {(message: any) => void} */
let take = () => {};
/** @type {any} */
let thread;

Object.assign(globalThis, {
  document: { baseURI: 'https://fire.example/', hidden: false },
  Worker: class {
    terminate() {}
    constructor() {
      thread = this;
    }
    /** @param {any} message */
    postMessage(message) {
      if (message.type === 'start')
        queueMicrotask(() => thread.onmessage({ data: { type: 'started', version: VERSION } }));
      else take(message);
    }
  },
  fetch: async (/** @type {string} */ _url, /** @type {RequestInit} */ { signal, cache }) => {
    caches.push(cache);
    const answer = answers.shift();
    if (answer === 'silence') throw signal?.reason;
    return new Response(answer, { headers: { 'content-type': 'application/wasm' } });
  },
});
/** Ends the engine, so that the next test gets another one. */
afterEach(async () => (await connect(base(1), 'worker')).fail('the test is over'));

// The time limit of a download passes at once.
AbortSignal.timeout = () => AbortSignal.abort(new DOMException('no answer', 'TimeoutError'));

/** What the engine gets when it asks for a part. @param {string} name */
async function asked(name) {
  const answer = new Promise((resolve) => {
    take = resolve;
  });
  thread.onmessage({ data: { type: 'part', part: name } });
  const { why, module } = await answer;
  return why ?? module.constructor.name;
}

test('a part that does not arrive or is of another build is refused, and the next call gets the right one', async () => {
  await connect(base(1), 'worker');
  answers.push('silence', part('bodies', 1), part('classic', 2), part('classic', 1));
  assert.match(await asked('classic'), /^no answer within 60 s/);
  assert.equal(await asked('classic'), 'it is not the part "classic"');
  assert.equal(await asked('classic'), 'it is of another build; reload the page');
  assert.equal(await asked('classic'), 'Module');
  // It is kept.
  assert.equal(await asked('classic'), 'Module');
  assert.deepEqual(caches, ['default', 'reload', 'reload', 'reload']);
});

test('a call, a picture or a ping that cannot be posted stops the engine, and every fire hears of it', async () => {
  const calls = /** @type {const} */ ([[1, 1, 'measure', 0, 0], 1, 0]);
  for (const sent of calls) {
    const port = await connect(base(1), 'worker');
    const heard = new Promise((resolve) => port.open({ onMessage: resolve, onPicture: () => {} }));
    take = () => {
      throw new DOMException('Data cannot be cloned, out of memory.', 'DataCloneError');
    };
    port.send(/** @type {any} */ (sent));
    const { kind, message } = /** @type {any} */ (await heard);
    assert.equal(kind, 'stopped');
    assert.match(message, /out of memory/);
    take = () => {};
    assert.notEqual(await connect(base(1), 'worker'), port, 'the next fire gets another engine');
  }
});

test('an engine whose first ping cannot be posted is followed by another', async () => {
  take = () => {
    throw new Error('no memory for a message');
  };
  const port = await connect(base(1), 'worker');
  take = () => {};
  await new Promise((resolve) => setTimeout(resolve));
  assert.notEqual(await connect(base(1), 'worker'), port);
});
