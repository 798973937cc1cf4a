/**
 * A scene of React Three Fiber, in TypeScript and strict mode: the component makes, changes and removes a fire.
 */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { eventually } from '../e2e/driver.mjs';
import { installed } from './package.mjs';
import { browser } from './pages.mjs';

const { open } = browser();
/** @type {string} */
let root;
/** @type {any} */
let server;

before(async () => {
  root = await installed('fiber');
});
after(() => server?.close());

test('its properties are typed', async () => {
  const words = [path.join(root, 'node_modules/typescript/bin/tsc'), '--project', root, '--skipLibCheck'];
  await promisify(execFile)(process.execPath, words).catch(({ stdout }) => assert.fail(stdout));
});

test('a fire in strict mode burns, takes properties, and leaves nothing', async () => {
  const vite = await import(pathToFileURL(path.join(root, 'node_modules/vite/dist/node/index.js')).href);
  const options = { root, logLevel: 'error', configFile: false };
  // The development build of React: only that runs effects twice.
  await vite.build({ ...options, mode: 'development', define: { 'process.env.NODE_ENV': '"development"' } });
  server = await vite.preview({ ...options, preview: { port: 0, host: '127.0.0.1' } });
  const tab = await open(server.resolvedUrls.local[0], { width: 240, height: 240 });
  const set = (/** @type {object} */ state) =>
    tab.evaluate((wanted) => /** @type {any} */ (window).page.setState(wanted), state);
  const fire = (/** @type {string} */ what, /** @type {(fire: any, wanted: number) => unknown} */ is, wanted = 0) =>
    tab.until(
      what,
      (text, value) => {
        const last = /** @type {any} */ (window).page.fires.at(-1);
        return last && new Function('fire', 'wanted', `return (${text})(fire, wanted)`)(last, value);
      },
      String(is),
      wanted,
    );
  const power = (/** @type {number} */ wanted) =>
    fire(`the power is ${wanted}`, (fire, wanted) => fire.fire.values.fuel_power === wanted, wanted);

  await fire('it burns', (fire) => fire.fire.stats.time > 0 && fire.light.intensity > 0);
  const first = await tab.evaluate(() => /** @type {any} */ (window).page.fires.at(-1).fire.values.fuel_power);
  await set({ there: true, power: 2 * first, x: 0.5, wind: 0.4 });
  await power(2 * first);
  await fire('it moves', (fire) => fire.position.x === 0.5 && fire.wind.x === 0.4);
  await fire('the gas feels the wind', (fire) => fire.fire.values.wind > 0.3);
  // A value that is left out has its default again.
  await set({ there: true });
  await power(first);
  await set({ there: true, power: -1 });
  await tab.until('it is refused', () => /** @type {any} */ (window).page.errors.length > 0);
  assert.match(await tab.evaluate(() => /** @type {any} */ (window).page.errors[0]), /fuel_power/);
  await set({ there: false });
  await eventually(
    'the engine has ended',
    async () => tab.page.workers().length,
    (workers) => workers === 0,
    () => tab.frames(1),
    (workers) => `${workers} workers`,
  );
  assert.deepEqual(
    // React Three Fiber has a clock of three.js that warns of its own end.
    tab.problems.filter((problem) => !/fuel_power|THREE\.Clock/.test(problem)),
    [],
  );
});
