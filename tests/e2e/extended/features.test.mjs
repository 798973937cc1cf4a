/**
 * Every feature of the platform that an element needs is checked: without it, `ready` rejects with the kind
 * `unsupported` and the poster stays. Without a feature that only makes a fire better, it burns.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { NEEDED } from '../../../web/engine/features.js';
import { Browser } from '../driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

/** What a fire has come to in a page without a feature. */
async function without(/** @type {string} */ path, isInWorker = false) {
  const [owner, name] = path.includes('.') ? path.split(/\.(?=[^.]*$)/) : ['globalThis', path];
  const remove = `
    delete ${owner}['${name}'];
    if (${owner}['${name}'] !== undefined) Object.defineProperty(${owner}, '${name}', { value: undefined });`;
  const tab = await browser.open(
    `<!doctype html><script>
      window.uncaught = [];
      addEventListener('error', ({ message }) => uncaught.push(message));
      addEventListener('unhandledrejection', ({ reason }) => uncaught.push(String(reason)));
      ${isInWorker ? '' : remove}
    </script>
    <script type="module" src="./web/hearth-fire.js"></script>
    <hearth-fire style="width: 60px; height: 60px"><p slot="poster">Embers</p></hearth-fire>`,
    isInWorker ? { beforeWorker: /** @type {any} */ (`() => {${remove}}`) } : {},
  );
  return tab.fire(async (/** @type {any} */ fire) => {
    const set = fire.set('wind', 0.1).then(
      () => 'set',
      () => 'refused',
    );
    const ready = await fire.ready.then(
      () => 'ready',
      (/** @type {any} */ error) => `${error.kind}: ${error.message}`,
    );
    const poster = fire.querySelector('p').getClientRects().length > 0;
    return { ready, set: await set, poster, uncaught: /** @type {any} */ (window).uncaught };
  });
}

for (const path of [...NEEDED, 'WebAssembly']) {
  test(`without ${path} the poster stays, with the reason`, async () => {
    const { ready, ...seen } = await without(path);
    assert.match(ready, new RegExp(`^unsupported: .*has no ${path.replaceAll('.', '\\.')}`));
    assert.deepEqual(seen, { set: 'refused', poster: true, uncaught: [] });
  });
}

for (const [path, isInWorker] of /** @type {[string, boolean][]} */ ([
  ['Document.prototype.adoptedStyleSheets', false],
  ['HTMLElement.prototype.attachInternals', false],
  ['OffscreenCanvas', false],
  ['Worker', false],
  ['matchMedia', false],
  ['requestIdleCallback', false],
  ['CompressionStream', false],
  ['localStorage', false],
  ['OffscreenCanvas', true],
  ['WebAssembly', true],
])) {
  test(`without ${path} ${isInWorker ? 'in workers ' : ''}a fire burns`, async () => {
    const { ready, set, uncaught } = await without(path, isInWorker);
    assert.deepEqual({ ready, set, uncaught }, { ready: 'ready', set: 'set', uncaught: [] });
  });
}
