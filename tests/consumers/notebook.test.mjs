/**
 * The example for notebooks in a page, with a model as anywidget has: the fire follows it, and it has the fire's statistics.
 */
import assert from 'node:assert/strict';
import { cp } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { serve } from '../e2e/server.mjs';
import { alone } from './package.mjs';
import { browser, burnsWell } from './pages.mjs';

const { open } = browser();
/** @type {import('../e2e/server.mjs').Server} */
let site;

before(async () => {
  const folder = await alone('hearth-fire.inline.js');
  await cp(fileURLToPath(new URL('../../examples/notebook', import.meta.url)), path.join(folder, 'notebook'), {
    recursive: true,
  });
  site = await serve(folder);
});
after(() => site?.close());

/** Runs in the page: shows the widget, whose text is put together as `fire.py` does, with a model. */
async function show() {
  class Model {
    all = /** @type {{[name: string]: any}} */ ({ preset: 'candle', values: { seed: 3 }, height: 200, stats: {} });
    saved = 0;
    events = new EventTarget();
    get = (/** @type {string} */ name) => this.all[name];
    save_changes = () => {
      this.saved += 1;
    };
    on = (/** @type {string} */ name, /** @type {EventListener} */ act) => this.events.addEventListener(name, act);
    off = (/** @type {string} */ name, /** @type {EventListener} */ act) => this.events.removeEventListener(name, act);
    set(/** @type {string} */ name, /** @type {any} */ value) {
      this.all[name] = value;
      this.events.dispatchEvent(new Event(`change:${name}`));
    }
  }
  const files = ['hearth-fire.inline.js', 'notebook/widget.js'];
  const texts = await Promise.all(files.map(async (file) => (await fetch(file)).text()));
  const url = URL.createObjectURL(new Blob([texts.join('')], { type: 'text/javascript' }));
  const { default: widget } = await import(url);
  const model = new Model();
  Object.assign(globalThis, { model, gone: widget.render({ model, el: document.body }) });
}

test('a fire follows the model of a notebook, tells its statistics, and goes with its cell', async () => {
  const tab = await open(site.publish('<!doctype html><title>A cell</title><link rel="icon" href="data:,">'));
  await tab.evaluate(show);
  await burnsWell(tab);
  assert.deepEqual(await tab.fire((fire) => [fire.preset, fire.params.seed, fire.offsetHeight]), ['candle', 3, 200]);
  await tab.until('the model has statistics', () => /** @type {any} */ (globalThis).model.all.stats.particles > 0);
  await tab.evaluate(() => {
    const { model } = /** @type {any} */ (globalThis);
    model.set('values', { fuel_power: 77 });
    model.set('height', 240);
  });
  await tab.until('the fire follows', () => {
    const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
    return fire.params.fuel_power === 77 && fire.offsetHeight === 240;
  });
  await tab.evaluate(() => {
    const { model, gone } = /** @type {any} */ (globalThis);
    gone();
    model.set('values', { fuel_power: 78 });
  });
  assert.equal(await tab.evaluate(() => document.querySelector('hearth-fire')), null);
  assert.deepEqual(tab.problems, []);
});
