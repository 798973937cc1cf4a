/** Code on request that fails: the fire burns without it, and one warning names it. */
import assert from 'node:assert/strict';
import { test } from 'node:test';

Object.assign(globalThis, {
  HTMLElement: class {},
  customElements: { get: () => undefined, define: () => {} },
  document: { readyState: 'complete', hidden: false },
});
const { OnDemandCode } = await import('../../web/element/session/on-demand-code.js');

/** The code of a fire with a child, and its warnings. The page's objects throw while `broken` says so. */
function codeOf(page) {
  /** @type {string[]} */
  const warnings = [];
  const fails = (/** @type {string} */ what) => {
    if (page.broken) throw new Error(`no ${what}`);
  };
  const session = {
    begun: true,
    fire: {
      sound: 0,
      querySelector: (selector) => (selector.includes('slot') ? null : {}),
      querySelectorAll() {
        fails('children');
        return [];
      },
      get children() {
        fails('children');
        return [];
      },
      attachInternals: () => ({ states: new Set() }),
    },
    view: {
      declare: (words) => {
        fails('style');
        page.declared = words;
      },
    },
    updateBurning: () => page.loaded(),
    reports: { loads: (loading) => loading, warn: (kind, message) => warnings.push(`${kind}: ${message}`) },
  };
  return { code: new OnDemandCode(/** @type {any} */ (session)), warnings };
}

test('children and page light that fail cause one warning each, throw nothing, and work again', async () => {
  const page = { broken: true, declared: '', loaded: () => {} };
  const hooks = new Promise((resolve) => (page.loaded = () => resolve(undefined)));
  const { code, warnings } = codeOf(page);
  await code.loadChildren();
  code.setBurning(true);
  await hooks;
  for (let frame = 0; frame < 3; frame += 1) {
    await code.loadChildren();
    code.sendChildren();
    code.setLight(100, 'rgb(255 128 0)');
  }
  assert.deepEqual(warnings.map((words) => words.replace(/: Error.*|: TypeError.*/, '')).sort(), [
    'load: The code for children has failed',
    'load: The code for style hooks has failed',
  ]);
  page.broken = false;
  code.setLight(100, 'rgb(255 128 0)');
  assert.match(page.declared, /--hearth-light:0\.5/);
  assert.equal(warnings.length, 2);
});
