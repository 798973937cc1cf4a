/**
 * Assertions for every page with a fire.
 */
import assert from 'node:assert/strict';
import { after, before } from 'node:test';
import { fileURLToPath } from 'node:url';
import { Browser } from '../e2e/driver.mjs';
import { assertBurns } from '../e2e/assertions.mjs';

/**
 * A browser for the tests of a file.
 * @returns {{open: Browser['open']}}
 */
export function browser() {
  /** @type {Browser} */
  let started;
  before(async () => {
    started = await Browser.launch(fileURLToPath(new URL('plain', import.meta.url)));
  });
  after(() => started?.close());
  return { open: (...args) => started.open(...args) };
}

/**
 * The page's fire burns in a worker, or on `thread`, without a problem.
 * @param {import('../e2e/driver.mjs').Tab} tab
 * @param {'worker' | 'main'} [thread]
 */
export async function burnsWell(tab, thread = 'worker') {
  await tab.ready();
  await tab.burnt(1);
  await assertBurns(tab);
  assert.equal(await tab.fire((fire) => fire.stats.engine), thread);
  assert.deepEqual(tab.problems, []);
}

/**
 * The fire's panel comes and shows its scenes.
 * @param {import('../e2e/driver.mjs').Tab} tab
 */
export async function opensScenes(tab) {
  await tab.until('the panel has its buttons', () => {
    const root = document.querySelector('hearth-fire')?.shadowRoot;
    return root?.querySelector('[part~=panel] canvas') && root.querySelector('[data-action=scenes]');
  });
  await tab.fire((fire) => fire.shadowRoot.querySelector('[data-action=scenes]').click());
}

/**
 * A page with a fire, as small as there can be one.
 * @param {string} script where the element's module is
 */
export function page(script) {
  return `<!doctype html>
    <meta charset="utf-8">
    <title>A page with a fire</title>
    <link rel="icon" href="data:,">
    <script type="module" src="${script}"></script>
    <body style="margin: 0; background: black">
    <hearth-fire style="width: 240px; height: 240px"></hearth-fire>`;
}
