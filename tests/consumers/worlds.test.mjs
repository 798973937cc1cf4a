/**
 * Fires in scenes of three.js by both of its renderers, of PixiJS, Phaser, Babylon.js and PlayCanvas, with the packages and
 * recipes of the examples: what hides a fire and what it hides, its colours beside the element's, its light, its motion, and
 * what it leaves.
 */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { cp } from 'node:fs/promises';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { eventually } from '../e2e/driver.mjs';
import { serve } from '../e2e/server.mjs';

import { installed } from './package.mjs';
import { browser } from './pages.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));
const { open } = browser();
/** @type {string} */
let root;
/** @type {import('../e2e/server.mjs').Server} */
let site;
before(async () => {
  root = await installed('worlds', 'archive', path.join(HERE, '../../examples/worlds'));
  await cp(path.join(HERE, 'worlds'), root, { recursive: true });
  site = await serve(root);
});
after(() => site?.close());

const RENDERERS = /** @type {const} */ ([
  ['WebGLRenderer', 'bare.html'],
  ['WebGPURenderer', 'nodes.html'],
]);

/** What a part of a page's script returns. @param {import('../e2e/driver.mjs').Tab} tab @param {string} name @param {any[]} given @returns {Promise<any>} */
const seenIn = (tab, name, given) =>
  tab.page.evaluate((part, all) => /** @type {any} */ (globalThis).worlds[part](...all), name, given);

const engines = (/** @type {import('../e2e/driver.mjs').Tab} */ tab, /** @type {number} */ wanted) =>
  eventually(
    `there are ${wanted} engines`,
    async () => tab.page.workers().length,
    (workers) => workers === wanted,
    () => tab.frames(1),
    (workers) => `${workers} workers`,
  );

/** @param {{[background: string]: {count: number, mean: number}}} colours @param {number} most [ΔE] */
function areThoseOfTheElement(colours, most) {
  for (const [background, { count, mean }] of Object.entries(colours)) {
    assert(count > 500, `${count} pixels over ${background}`);
    assert(mean < most, `${mean} over ${background}`);
  }
}

for (const [renderer, page] of RENDERERS) {
  describe(`in ${renderer}`, () => {
    /** @type {import('../e2e/driver.mjs').Tab} */
    let bare;
    before(async () => {
      bare = await open(`${site.origin}/${page}`);
      await bare.until('its script', () => 'worlds' in globalThis);
    });

    const seen = (/** @type {string} */ name, /** @type {any[]} */ ...given) => seenIn(bare, name, given);

    test('a thing before a fire hides it, one amid its sheets a part of it, and one behind is hidden', async () => {
      const { behind, amid, before: hidden } = await seen('plates');
      const [red, green] = [0, 1].map((channel) => [behind, amid, hidden].map((sums) => sums[channel]));
      assert.equal(red[2], 0);
      assert(red[0] > red[1] && red[1] > 0.05 * red[0], `${red}`);
      assert(green[0] < green[1] && green[1] < green[2], `${green}`);
    });

    test('embers fly at depths of their own', async () => {
      const [behind, amid, hidden] = await seen('embers');
      assert.equal(hidden, 0);
      assert(amid > 0.1 * behind && amid < 0.9 * behind, `${amid} of ${behind}`);
    });

    test('over black and white, a fire has the colours of the element', async () => {
      const { times, ...colours } = await seen('differences');
      assert.equal(times[0].toFixed(3), times[1].toFixed(3));
      areThoseOfTheElement(colours, 1.5);
    });

    test('a target of light gets light beyond white, which is mapped once', async () => {
      assert((await seen('light')) > 1.5);
    });

    test('a fire is soft at things', async () => {
      const [hard, soft] = await seen('soft');
      assert(soft < 0.8 * hard && soft > 0.05 * hard, `${soft} of ${hard}`);
    });

    test('a fire fades as the camera passes through it', async () => {
      const light = await seen('passing', [5, 1.2, 0.6, 0.3, 0.1, 0, -1]);
      for (const [at, less] of light.slice(1).entries()) assert(less <= light[at], `${light}`);
      assert(light[3] > 0 && light[3] < 0.5 * light[0], `${light}`);
      assert.equal(light.at(-1), 0);
    });

    test('the light is brighter where more fuel burns', async () => {
      const [weak, strong] = await seen('lights');
      assert(weak > 0 && strong > 2 * weak, `${weak}, ${strong}`);
    });

    test('motion along the sheets moves the source through the gas; depth and the camera do not', async () => {
      const [first, along, inward, turned] = await seen('motions');
      assert.equal(first, 0);
      assert(Math.abs(along - 0.2) < 0.01, `${along}`);
      assert.deepEqual([inward, turned], [along, along]);
    });

    test('the gas feels the wind of the world along the sheets', async () => {
      const [along, inward, aside] = await seen('winds');
      assert(Math.abs(along - 0.8) < 0.01, `${along}`);
      assert(Math.abs(inward) < 0.05, `${inward}`);
      assert(Math.abs(aside + 0.8) < 0.01, `${aside}`);
    });

    test('fires share an engine', async () => {
      await seen('several');
      await engines(bare, 1);
      await seen('freeSeveral');
    });

    test('fires that come and go leave no texture, geometry or worker', async () => {
      const [first, last] = await seen('mounts', 10);
      assert.deepEqual(last, first);
      if (renderer === 'WebGLRenderer') assert.deepEqual(last, { textures: 0, geometries: 0 });
      // Its context goes with the worker.
      await engines(bare, 0);
      assert.deepEqual(bare.problems, []);
    });

    test('what is wrong is refused by name', async () => {
      const told = await seen('refusals');
      for (const [at, name] of ['presett', 'width', 'warm', 'soft', 'fuel_power'].entries())
        assert.match(told[at], new RegExp(name));
    });
  });
}

for (const engine of ['pixi', 'phaser', 'babylon', 'playcanvas']) {
  test(`in ${engine}, a fire has the colours of the element, moves with what carries it, and ends`, async () => {
    const flat = await open(`${site.origin}/flat.html`);
    await flat.until('its script', () => 'worlds' in globalThis);
    const seen = (/** @type {string} */ name, /** @type {any[]} */ ...given) => seenIn(flat, name, given);
    const { times, ...colours } = await seen('differences', engine);
    assert.equal(times[0].toFixed(3), times[1].toFixed(3));
    areThoseOfTheElement(colours, 0.5);
    const { source, change } = await seen('carried', 0.2);
    assert(Math.abs(source - 0.2) < 0.01, `${source}`);
    // What has left the source stays.
    assert(change < 1, `${change}`);
    await seen('free');
    await engines(flat, 0);
    assert.deepEqual(flat.problems, []);
  });
}

test('a strict compiler accepts the types beside those of the engines', async () => {
  const words = ['--noEmit', '--strict', '--skipLibCheck', '--target', 'es2022', '--module', 'esnext'];
  const program = path.join(root, 'node_modules/typescript/bin/tsc');
  const given = [program, ...words, '--moduleResolution', 'bundler', '--lib', 'es2023,dom', 'types.ts'];
  await promisify(execFile)(process.execPath, given, { cwd: root }).catch(({ stdout }) => assert.fail(stdout));
});
