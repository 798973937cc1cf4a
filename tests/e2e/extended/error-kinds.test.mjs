/**
 * Error kinds: a fire that cannot start reports why, shows its poster and leaves the page
 * intact.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser, STOPPED } from '../driver.mjs';
import { assertBurns, events, recording } from '../assertions.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const WASM = 'hearth-engine_bg.wasm';
const BODY = recording('<hearth-fire><p slot="poster" id="poster">A poster</p></hearth-fire>');

/** Asserts that there is no fire, that an error has the reason, and that nothing else fails. */
async function assertReported(tab, kind, named) {
  const rejected = await tab.fire((fire) =>
    fire.ready.then(
      () => null,
      (error) => error.kind,
    ),
  );
  assert.equal(rejected, kind);
  const errors = await events(tab, 'error');
  assert.equal(errors.length, 1, JSON.stringify(errors));
  assert.equal(errors[0].kind, kind);
  assert.match(errors[0].message, named);
  const seen = await tab.fire((fire) => ({
    words: fire.shadowRoot.querySelector('[role=status]').textContent,
    poster: document.querySelector('#poster').checkVisibility(),
  }));
  assert.deepEqual(seen, { words: errors[0].message, poster: true });
  // Calls from now on are refused, and their promises settle.
  assert.equal(
    await tab.fire((fire) =>
      fire.set('exposure', 1).then(
        () => 'set',
        () => 'refused',
      ),
    ),
    'refused',
  );
  const uncaught = (await tab.problemsAfterFrame()).filter((problem) => problem.startsWith('uncaught'));
  assert.deepEqual(uncaught, []);
}

for (const [what, instead, named] of [
  ['is missing', { status: 404, body: '<!doctype html>', type: 'text/html' }, /hearth-engine_bg\.wasm gave 404/],
  ['never comes', { drop: true }, /could not be loaded/],
  ['is cut off', { keep: 20_000 }, /could not be loaded/],
  ['is a page', { body: '<!doctype html><p>Hello', type: 'text/html' }, /no wasm file.*text\/html/],
  ['is a page that calls itself wasm', { body: '<!doctype html><p>Hello' }, /could not be loaded/],
  ['is empty', { body: '', type: 'text/plain' }, /no wasm file/],
]) {
  test(`wasm that ${what} is reported, and the poster stays`, async () => {
    const tab = await browser.open(BODY, { files: { [WASM]: instead } });
    await assertReported(tab, 'load', named);
  });
}

test('wasm of another MIME type works, and a warning reports it', async () => {
  const tab = await browser.open(BODY, { files: { [WASM]: { type: 'application/octet-stream' } } });
  await tab.burnt(0.5);
  await assertBurns(tab);
  const errors = await events(tab, 'error');
  assert.equal(errors.length, 1);
  assert.equal(errors[0].kind, 'load');
  assert.match(errors[0].message, /application\/octet-stream instead of application\/wasm/);
});

test('a policy that forbids wasm is reported, and the poster stays', async () => {
  const scripts = "script-src 'self' 'unsafe-inline'";
  const tab = await browser.open(BODY, { headers: { 'content-security-policy': scripts } });
  await assertReported(tab, 'load', /could not be loaded/);
});

test('a browser without WebGL2 is reported, and the poster stays', async () => {
  const blind = () => {
    for (const type of [globalThis.HTMLCanvasElement, globalThis.OffscreenCanvas]) {
      if (type) type.prototype.getContext = () => null;
    }
  };
  const tab = await browser.open(BODY, { before: blind, beforeWorker: blind });
  await assertReported(tab, 'unsupported', /WebGL2/);
});

test('a browser without wasm SIMD is reported, and the poster stays', async () => {
  const tab = await browser.open(BODY, { before: () => (WebAssembly.validate = () => false) });
  await assertReported(tab, 'unsupported', /SIMD/);
});

test('an engine that throws is reported, and another continues the fire', STOPPED, async () => {
  const tab = await browser.open(BODY, {
    beforeWorker: () => {
      // A defect of the engine would end in an error out of nowhere, as this.
      addEventListener('message', ({ data }) => {
        if (data[2] === 'reset')
          setTimeout(() => {
            throw new Error('a defect');
          });
      });
    },
  });
  await tab.burnt(0.3);
  await tab.fire(async (fire) => {
    fire.reset();
    await new Promise((resolve) => fire.addEventListener('restored', resolve));
  });
  const errors = await events(tab, 'error');
  assert.deepEqual(
    errors.map(({ kind }) => kind),
    ['stopped'],
  );
  assert.match(errors[0].message, /engine has stopped.*a defect/);
  await assertBurns(tab);
});
