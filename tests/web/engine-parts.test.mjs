/** The parts of the wasm that a page gives its engine: only those of the same build, each asked for until it is right. */
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { connect, preload } from '../../web/engine/engine.js';
import { VERSION } from '../../web/generated/version.js';
import { base, part } from './parts.mjs';

/** What the server answers to the next requests. @type {(Uint8Array<ArrayBuffer> | 'silence')[]} */
const answers = [];
/** The files that are fetched. @type {string[]} */
const files = [];
/** How the browser's cache was used. @type {(string | undefined)[]} */
const caches = [];
/** What the engine gets. @type {any[]} */
let sent = [];
/** @type {any} */
let thread;

const { timeout } = AbortSignal;
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
      else sent.push(message);
    }
  },
  fetch: async (/** @type {string} */ url, /** @type {RequestInit} */ { signal, cache }) => {
    files.push(url.replace(/.*_/, ''));
    caches.push(cache);
    const answer = answers.shift();
    if (answer !== 'silence') return new Response(answer, { headers: { 'content-type': 'application/wasm' } });
    return new Promise((_, reject) => signal?.addEventListener('abort', () => reject(signal.reason)));
  },
});
// The time limit of a download passes at once.
AbortSignal.timeout = () => timeout.call(AbortSignal, 1);

/** What the engine gets when it asks for a part. @param {string} name */
async function asked(name) {
  sent = [];
  thread.onmessage({ data: { type: 'part', part: name } });
  while (sent.length === 0) await new Promise((resolve) => setTimeout(resolve, 1));
  return sent[0].why ?? sent[0].module.constructor.name;
}

test('a part that does not arrive or is of another build is refused, and the next call gets the right one', async () => {
  const port = await connect(base(1), 'worker');
  after(() => port.end());
  answers.push('silence', part('bodies', 1), part('classic', 2), part('classic', 1));
  assert.match(await asked('classic'), /^no answer within 60 s/);
  assert.equal(await asked('classic'), 'it is not the part "classic"');
  assert.equal(await asked('classic'), 'it is of another build; reload the page');
  assert.equal(await asked('classic'), 'Module');
  // It is kept.
  assert.equal(await asked('classic'), 'Module');
  assert.deepEqual(caches, ['default', 'reload', 'reload', 'reload']);
});

test('the parts of a preset load with the wasm, once', async () => {
  files.length = 0;
  await preload('default');
  assert.deepEqual(files, []);
  answers.push(part('scenes', 1), part('bodies', 1));
  await preload('rope');
  assert.deepEqual(files, ['scenes.wasm', 'bodies.wasm']);
  assert.equal(await asked('scenes'), 'Module');
  assert.equal(await asked('bodies'), 'Module');
  assert.equal(files.length, 2);
});
