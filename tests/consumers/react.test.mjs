/**
 * A page in React 19 and TypeScript: attributes and events are typed in each way of installing
 * the package, and React creates, changes and removes the element, in strict mode.
 */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { PACKAGE, installed } from './package.mjs';
import { browser, burnsWell } from './pages.mjs';

const { open } = browser();
/** @type {string} */
let root;
/** @type {any} */
let vite;
/** @type {any} */
let server;

before(async () => {
  root = await installed('react');
  vite = await import(pathToFileURL(path.join(root, 'node_modules/vite/dist/node/index.js')).href);
});
after(() => server?.close());

/** What a parameter is in the model of the page without another value. @param {string} id */
async function byDefault(id) {
  const { PARAMETERS } = await import(pathToFileURL(path.join(PACKAGE, 'parameters.js')).href);
  return PARAMETERS.find((parameter) => parameter.id === id).domains.classic.default;
}

/**
 * Compilers, and how they find files. Those of `node10` read no `exports`.
 * @type {[compiler: string, ...options: string[]][]}
 */
const COMPILERS = [
  ['typescript'],
  ['typescript', '--module', 'nodenext', '--moduleResolution', 'nodenext'],
  ['typescript-5'],
  ['typescript-5', '--moduleResolution', 'node10', '--ignoreDeprecations', '5.0'],
];

// The archive is installed last, for the tests below.
for (const way of /** @type {const} */ (['link', 'copy', 'archive'])) {
  test(`attributes and events are typed where the package is installed as ${way}`, async () => {
    await installed('react', way);
    for (const [compiler, ...options] of COMPILERS) {
      const program = path.join(root, 'node_modules', compiler, 'bin/tsc');
      const words = [program, '--project', root, ...options];
      await promisify(execFile)(process.execPath, words).catch(({ stdout }) => {
        assert.fail(`${[compiler, ...options].join(' ')}:\n${stdout}`);
      });
    }
  });
}

test('a fire in strict mode burns, accepts properties and sends events', async () => {
  const options = { root, logLevel: 'error', configFile: false };
  // The development build of React: only that connects twice.
  await vite.build({ ...options, mode: 'development', define: { 'process.env.NODE_ENV': '"development"' } });
  server = await vite.preview({ ...options, preview: { port: 0, host: '127.0.0.1' } });
  const tab = await open(server.resolvedUrls.local[0]);
  await tab.until('React has made the fire', () => document.querySelector('hearth-fire') !== null);
  await burnsWell(tab);
  const observed = () => tab.evaluate(() => /** @type {any} */ (window).page.observed);
  const setState = (/** @type {object} */ state) =>
    tab.evaluate((wanted) => /** @type {any} */ (window).page.setState(wanted), state);
  const value = (/** @type {string} */ id, /** @type {number} */ wanted) =>
    tab.until(
      `${id} is ${wanted}`,
      (which, right) => /** @type {any} */ (document.querySelector('hearth-fire'))?.params[which] === right,
      id,
      wanted,
    );
  await value('source_width', 0.3);
  await value('viscosity', 0.02);
  await value('max_particles', 500);
  const first = await observed();
  assert.equal(first.ready, 1);
  assert(first.stats.particles > 0);
  assert.equal(await tab.fire((fire) => fire.params.model), 'classic');

  await setState({ there: true, width: 0.5, viscosity: 0.03 });
  await value('source_width', 0.5);
  await value('viscosity', 0.03);
  assert((await observed()).changes.includes('source_width=0.5'));

  // A property that React no longer sets returns to its default.
  await setState({ there: true });
  await value('source_width', await byDefault('source_width'));
  await value('viscosity', await byDefault('viscosity'));

  await setState({ there: true, paused: true });
  await tab.until('it stands still', () => /** @type {any} */ (document.querySelector('hearth-fire')).paused);

  await setState({ there: false });
  await tab.until('it is gone', () => document.querySelector('hearth-fire') === null);
  await setState({ there: true, width: 0.2 });
  await tab.until('another burns', () => /** @type {any} */ (window).page.observed.ready === 2);
  await value('source_width', 0.2);
  assert.deepEqual((await observed()).errors, []);
  assert.deepEqual(tab.problems, []);
});
