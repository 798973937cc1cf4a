/**
 * A page that Vite builds or serves where npm has linked the folder of the package.
 */
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { PACKAGE, installed } from './package.mjs';
import { browser, burnsWell } from './pages.mjs';

const { open } = browser();
/** @type {any} */
let vite;
/** @type {object} */
let options;
/** What is to be closed. @type {{close(): Promise<void>}[]} */
const servers = [];
const address = { port: 0, host: '127.0.0.1' };

before(async () => {
  const root = await installed('vite', 'link');
  vite = await import(pathToFileURL(path.join(root, 'node_modules/vite/dist/node/index.js')).href);
  // What Vite keeps beside the packages is of the archive.
  options = { root, logLevel: 'error', configFile: false, cacheDir: 'linked-cache', build: { outDir: 'linked' } };
});
after(() => Promise.all(servers.map((server) => server.close())));

test('what Vite builds of a linked folder burns', async () => {
  await vite.build(options);
  const server = await vite.preview({ ...options, preview: address });
  servers.push(server);
  await burnsWell(await open(server.resolvedUrls.local[0]));
});

test("what Vite's server gives of a linked folder that it may read burns", async () => {
  const server = await vite.createServer({ ...options, server: { ...address, fs: { allow: ['.', PACKAGE] } } });
  await server.listen();
  servers.push(server);
  await burnsWell(await open(server.resolvedUrls.local[0]));
});
