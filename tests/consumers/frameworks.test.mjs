/**
 * Pages in Vue, Svelte and Angular use the element without a wrapper: state sets attributes, events set state, in both directions.
 */
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { installed } from './package.mjs';
import { browser, burnsWell } from './pages.mjs';

const { open } = browser();
/** @type {any} */
let server;

before(async () => {
  const root = await installed('frameworks');
  const load = (/** @type {string} */ file) => import(pathToFileURL(path.join(root, 'node_modules', file)).href);
  const [vite, { default: vue }, { svelte }] = await Promise.all([
    load('vite/dist/node/index.js'),
    load('@vitejs/plugin-vue/dist/index.mjs'),
    load('@sveltejs/vite-plugin-svelte/src/index.js'),
  ]);
  const isCustomElement = (/** @type {string} */ tag) => tag.startsWith('hearth-');
  const options = { root, logLevel: 'error', configFile: false };
  await vite.build({
    ...options,
    plugins: [vue({ template: { compilerOptions: { isCustomElement } } }), svelte({ configFile: false })],
    build: { rollupOptions: { input: ['vue', 'svelte', 'angular'].map((name) => path.join(root, `${name}.html`)) } },
  });
  server = await vite.preview({ ...options, preview: { port: 0, host: '127.0.0.1' } });
});
after(() => server?.close());

for (const framework of ['vue', 'svelte', 'angular']) {
  test(`in ${framework}, a fire burns, follows the state and changes it`, async () => {
    const tab = await open(`${server.resolvedUrls.local[0]}${framework}.html`);
    await tab.until('the fire is there', () => document.querySelector('hearth-fire') !== null);
    await burnsWell(tab);
    const page = (/** @type {string} */ name, /** @type {any} */ value) =>
      tab.evaluate((id, to) => /** @type {any} */ (window).page.set(id, to), name, value);
    await tab.until('the state has its particles', () => /** @type {any} */ (window).page.get().particles > 0);
    await page('width', 0.5);
    await tab.until('it follows', () => {
      const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
      return fire.params.source_width === 0.5;
    });
    await tab.fire((fire) => fire.set('source_width', 0.4));
    await tab.until('the state follows', () => /** @type {any} */ (window).page.get().width === 0.4);
    await page('there', false);
    await tab.until('it is gone', () => document.querySelector('hearth-fire') === null);
    assert.deepEqual(tab.problems, []);
  });
}
