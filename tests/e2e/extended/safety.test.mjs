/**
 * Safety: a link cannot take the page's thread, and a fire without memory cannot take the other
 * fires along.
 */
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { onPageThread, simulateClock } from '../clock.mjs';
import { confined } from '../../confined.mjs';
import { SITE } from '../site.mjs';

const ENGINE = path.join(SITE, 'web/wasm/hearth-engine_bg.wasm');

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** Opens a fire on the page's thread, whose scripts need so many milliseconds to read the clock. */
async function onSlowPage(attributes, cost) {
  const fire = `<script>clock.cost = ${cost}</script><hearth-fire max-pixels="10000" ${attributes}></hearth-fire>`;
  const tab = await browser.open(onPageThread(fire), { before: simulateClock });
  await tab.ready();
  return tab;
}

const LIMITED = () => {
  const { stats, params } = /** @type {any} */ (document.querySelector('hearth-fire'));
  return stats?.limit === 'speed' && params.particles === 100_000;
};

test('on the page’s thread a number of particles that takes too long is reduced, kept in params, and explained', async () => {
  const tab = await onSlowPage('particles="100000"', 10);
  await tab.until('it is reduced', () => {
    const { stats } = /** @type {any} */ (document.querySelector('hearth-fire'));
    return stats?.particles > 0 && stats.particles < 7000 && stats.qualityReason.startsWith('a step');
  });
  assert.ok(await tab.evaluate(LIMITED));
  const reason = await tab.fire((fire) => fire.stats.qualityReason);
  assert.match(reason, /^a step takes [\d.]+ ms of at most 16\.0 ms: [\d,]+ of 100,000 particles$/);
  assert.deepEqual(tab.problems, []);
});

test('wasm of another version is refused, and both versions are named', async () => {
  const wasm = await readFile(ENGINE);
  const [{ module: version }] = WebAssembly.Module.imports(new WebAssembly.Module(wasm));
  assert.match(version, /^\d+\.\d+\.\d+$/);
  const names = (/** @type {string} */ domain) => `${String.fromCharCode(domain.length)}${domain}`;
  const body = Buffer.from(wasm.toString('latin1').replaceAll(names(version), names('9.8.7')), 'latin1');
  const tab = await browser.open('<hearth-fire></hearth-fire>', { files: { 'hearth-engine_bg.wasm': { body } } });
  const { kind, message } = await tab.fire((fire) =>
    fire.ready.catch((error) => ({ kind: error.kind, message: error.message })),
  );
  assert.equal(kind, 'load');
  assert.ok(message.includes(`its wasm has version 9.8.7, the element has version ${version}`), message);
});

test('a script of another version than its wasm is refused, and the version is named', async () => {
  const glue = await readFile(path.join(SITE, 'web/wasm/hearth-engine.js'), 'utf8');
  const version = /"(\d+\.\d+\.\d+)"/.exec(glue)?.[1] ?? '';
  const tab = await browser.open('<hearth-fire></hearth-fire>', {
    files: { 'hearth-engine.js': { body: glue.replaceAll(version, '9.8.7') } },
  });
  const { kind, message } = await tab.fire((fire) =>
    fire.ready.catch((error) => ({ kind: error.kind, message: error.message })),
  );
  assert.equal(kind, 'load');
  assert.ok(message.includes(version), message);
});

test('a worker of another version is not used, and both versions are named', async () => {
  const body = "onmessage = () => postMessage({ type: 'started', version: '9.8.7' });";
  const tab = await browser.open('<hearth-fire max-pixels="10000"></hearth-fire>', {
    files: { 'engine/worker.js': { body } },
  });
  await tab.burnt(0.1);
  assert.equal(tab.problems.length, 1, tab.problems.join('\n'));
  assert.match(tab.problems[0], /worker\.js has version 9\.8\.7, the element has version \d+\.\d+\.\d+/);
});

test('a fire without memory for its particles refuses them with a message, and all fires burn on', async () => {
  const body = confined(await readFile(ENGINE), 18 * 2 ** 20);
  const tab = await browser.open('<hearth-fire></hearth-fire><hearth-fire id="other"></hearth-fire>', {
    files: { 'hearth-engine_bg.wasm': { body } },
  });
  await tab.burnt(0.2);
  const message = await tab.fire((fire) =>
    fire.set('particles', 100_000).then(
      () => '',
      (error) => error.message,
    ),
  );
  assert.match(message, /particles = 100000 is refused: it must be fewer, because there is no memory left/);
  const times = await tab.evaluate(async () => {
    const fires = /** @type {any[]} */ ([...document.querySelectorAll('hearth-fire')]);
    const time = () => fires.map((fire) => fire.stats.time);
    const start = time();
    while (!time().every((now, at) => now > start[at] + 0.1)) await new Promise(requestAnimationFrame);
    return fires.map((fire) => fire.params.particles);
  });
  assert.deepEqual(times, [3000, 3000]);
});

test('a fire for which there is no memory at all reports it, and the others burn on', async () => {
  const body = confined(await readFile(ENGINE), 18 * 2 ** 20);
  const many = { body: '{"values": {"particles": 100000}}', type: 'application/json' };
  const tab = await browser.open('<hearth-fire></hearth-fire>', {
    files: { 'hearth-engine_bg.wasm': { body }, 'many.json': many },
  });
  await tab.burnt(0.2);
  const message = await tab.evaluate(() => {
    document.body.insertAdjacentHTML('beforeend', '<hearth-fire src="/many.json"></hearth-fire>');
    const fire = /** @type {any} */ (document.body.lastElementChild);
    return fire.ready.then(
      () => '',
      (/** @type {Error} */ error) => error.message,
    );
  });
  assert.match(message, /particles = 100000 .*no memory left/);
  await tab.burnt((await tab.fire((fire) => fire.stats.time)) + 0.1);
});
