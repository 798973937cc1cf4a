/**
 * A page that Vite builds or serves: the package needs no configuration.
 */
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { installed } from './package.mjs';
import { browser, burnsWell, opensScenes } from './pages.mjs';

const PAGES = ['index', 'inline', 'panel', 'wasm', 'sim'];

const { open } = browser();
/** @type {string} */
let root;
/** @type {any} */
let vite;
/** What is to be closed. @type {{close(): Promise<void>}[]} */
const servers = [];

before(async () => {
  root = await installed('vite');
  vite = await import(pathToFileURL(path.join(root, 'node_modules/vite/dist/node/index.js')).href);
});
after(() => Promise.all(servers.map((server) => server.close())));

/** @param {string} origin @param {string} name */
async function burns(origin, name) {
  const tab = await open(new URL(`${name}.html`, origin).href, { width: 640, height: 480 });
  if (name === 'sim') {
    const positions = await tab.until('there are particles', () => /** @type {any} */ (window).positions);
    assert.deepEqual(positions, await inNode());
    assert.deepEqual(tab.problems, []);
    return;
  }
  await burnsWell(tab);
  if (name !== 'panel') return;
  await tab.until('the panel stands', () => {
    const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
    return fire.shadowRoot.querySelector('[part~=panel] canvas')?.width > 0;
  });
  assert.deepEqual(tab.problems, []);
}

/** What the page `sim` computes, in Node. @returns {Promise<number[]>} */
async function inNode() {
  const file = path.join(root, 'node_modules/hearth-fire/sim.js');
  const { createSimulation } = await import(pathToFileURL(file).href);
  const simulation = await createSimulation({ seed: 7 });
  simulation.step(5);
  const positions = [...simulation.positions()];
  simulation.free();
  assert(positions.length > 1000);
  return positions;
}

test('what Vite builds burns, in a worker under trusted types too', async () => {
  const input = Object.fromEntries(PAGES.map((name) => [name, path.join(root, `${name}.html`)]));
  // Below a folder of its own, as on many hosts.
  const options = { root, base: '/below/', logLevel: 'error', configFile: false };
  await vite.build({ ...options, build: { rollupOptions: { input } } });
  const headers = { 'content-security-policy': "require-trusted-types-for 'script'; trusted-types hearth-fire" };
  const server = await vite.preview({ ...options, preview: { port: 0, host: '127.0.0.1', headers } });
  servers.push(server);
  for (const name of PAGES) await burns(server.resolvedUrls.local[0], name);
});

test('a panel without a known folder requests no file from it', async () => {
  const output = { entryFileNames: '[name].js', chunkFileNames: '[name].js', assetFileNames: '[name][extname]' };
  const options = { root, logLevel: 'error', configFile: false };
  // The page's own script leaves that name to the panel's.
  const rollupOptions = { input: { page: path.join(root, 'panel.html') }, output };
  await vite.build({ ...options, build: { outDir: 'plain', rollupOptions } });
  const server = await vite.preview({
    ...options,
    build: { outDir: 'plain' },
    preview: { port: 0, host: '127.0.0.1' },
  });
  servers.push(server);
  const tab = await open(new URL('panel.html', server.resolvedUrls.local[0]).href, { width: 640, height: 480 });
  await burnsWell(tab);
  await opensScenes(tab);
  const [pictures, iframe] = await tab.fire(({ shadowRoot }) => [
    shadowRoot.querySelectorAll('[data-scene] img[src]').length,
    shadowRoot.querySelector('[data-action="copy:iframe"]').hidden,
  ]);
  assert.equal(pictures, 0);
  assert.equal(iframe, true, 'there is no page to put into an iframe');
  assert.deepEqual(tab.problems, []);
});

test("what Vite's server gives while a page is written burns", async () => {
  const server = await vite.createServer({
    root,
    logLevel: 'error',
    configFile: false,
    server: { port: 0, host: '127.0.0.1' },
  });
  await server.listen();
  servers.push(server);
  for (const name of PAGES) await burns(server.resolvedUrls.local[0], name);
});
