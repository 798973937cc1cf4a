/**
 * The single-file build works alone.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { serve } from '../e2e/server.mjs';
import { alone } from './package.mjs';
import { browser, burnsWell, page } from './pages.mjs';

const FILE = 'hearth-fire.inline.js';

const { open } = browser();
/** @type {import('../e2e/server.mjs').Server} */
let site;
/** @type {import('../e2e/server.mjs').Server} */
let elsewhere;

before(async () => {
  const folder = await alone(FILE);
  site = await serve(folder);
  elsewhere = await serve(folder);
});
after(async () => {
  await site?.close();
  await elsewhere?.close();
});

test('one file burns, in a worker, and loads nothing more', async () => {
  const tab = await open(site.publish(page(FILE)));
  await burnsWell(tab);
  const loaded = await tab.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name));
  const fetched = loaded.filter((name) => name.startsWith('http'));
  assert.deepEqual(fetched, [`${site.origin}/${FILE}`]);
});

test('and from another site', async () => {
  elsewhere.replace({ '': { headers: { 'access-control-allow-origin': '*' } } });
  await burnsWell(await open(site.publish(page(`${elsewhere.origin}/${FILE}`))));
});

test('where a policy forbids a worker from a blob, it burns on the main thread', async () => {
  const policy = "script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'";
  const tab = await open(site.publish(page(FILE), { 'content-security-policy': policy }));
  await tab.ready();
  await tab.burnt(1);
  assert.equal(await tab.fire((fire) => fire.stats.engine), 'main');
  const others = tab.problems.filter((problem) => !problem.includes('Content Security Policy'));
  assert.deepEqual(others, []);
});
