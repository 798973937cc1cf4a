/**
 * Names that a fire does not know: attributes, parameters in `controls`, words of an address.
 */
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { Browser } from './driver.mjs';
import { recording } from './laws.mjs';
import { SITE } from './site.mjs';

const { readAddress } = await import(pathToFileURL(path.join(SITE, 'web/pages/url-parameters.js')).href);

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

const SMALL = 'paused quality="low" style="width: 40px; height: 50px"';

/** Waits until the page has warned so often; gives the warnings. */
async function warnings(tab, count) {
  for (let tries = 0; tab.problems.length < count && tries < 200; tries += 1) await tab.frames(1);
  return tab.problems;
}

test('an attribute that does nothing is told once, with the name that may be meant', async () => {
  const names = [
    ['fuel_power', /did you mean fuel-power\?/], ['fuelpower', /did you mean fuel-power\?/],
    ['quailty', /did you mean quality\?/], ['width', /did you mean .*domain-width.*\? .*style/],
    ['palete', /did you mean palette\?/], ['color', /cool-colour or hot-colour\?/], ['frobnicate', /no attribute frobnicate\.$/],
  ];
  const written = names.map(([name]) => `${name}="1"`).join(' ');
  const tab = await browser.open(`<hearth-fire ${SMALL} ${written}></hearth-fire>`.repeat(2));
  await tab.ready();
  const told = await warnings(tab, names.length);
  assert.equal(told.length, names.length, told.join('\n'));
  for (const [name, words] of names) {
    const about = told.filter((one) => one.includes(` ${name}`));
    assert.equal(about.length, 1, `${name}: ${told}`);
    assert.match(about[0], /^console\.warn.*<hearth-fire>/);
    assert.match(about[0], /** @type {RegExp} */ (words));
  }
});

test('an attribute that is set later is told as well, one that goes is not', async () => {
  const tab = await browser.open(`<hearth-fire ${SMALL} data-a="1"></hearth-fire>`);
  await tab.ready();
  await tab.fire((fire) => {
    fire.setAttribute('expozure', '1');
    fire.toggleAttribute('interractive');
    fire.setAttribute('expozure', '2');
    fire.setAttribute('gone', '1');
    fire.removeAttribute('gone');
  });
  await warnings(tab, 2);
  await tab.frames(5);
  const [one, two, ...more] = tab.problems;
  assert.match(one, /expozure.*exposure/);
  assert.match(two, /interractive.*interactive/);
  assert.deepEqual(more, []);
});

test('what HTML, frameworks and libraries write is none of its affair', async () => {
  const names = [
    'class', 'id', 'title', 'lang', 'dir', 'hidden', 'slot', 'part', 'is', 'role', 'tabindex', 'nonce', 'draggable', 'inert',
    'popover', 'translate', 'contenteditable', 'enterkeyhint', 'inputmode', 'autofocus', 'accesskey', 'spellcheck',
    'exportparts', 'itemprop', 'data-x', 'aria-label', 'onclick', 'xml:lang', 'xmlns', ':foo', '@click', 'v-if', 'x-data',
    '_ngcontent-ng-c1', '_nghost-abc', 'ng-version', 'ng-reflect-x', 'hx-get', 'wire:model', '#ref', '[prop]', '(event)', 'b-1a2b3c',
  ];
  const tab = await browser.open(`<hearth-fire ${SMALL.replace('paused', 'paused exposure="1" model="classic"')} ${names.map((name) => `${name}=""`).join(' ')}></hearth-fire>`);
  await tab.fire((fire) => {
    fire.removeAttribute('hidden');
    return fire.ready;
  });
  await tab.frames(10);
  assert.deepEqual(tab.problems, []);
});

test('controls names the parameters that the panel shows, and tells what it does not know', async () => {
  const tab = await browser.open(
    recording('<hearth-fire paused quality="low" controls="fuel_power wind, palete hot-colour" style="width: 700px; height: 500px"></hearth-fire>'),
    { files: { 'panel.js': { body: `export async function mountPanel({ only }) {
      (window.mounted ??= []).push(only ?? 'all');
      return { destroy() { window.mounted.push('gone'); } };
    }` } } },
  );
  const mounted = (wanted) => tab.until(`${JSON.stringify(wanted)}`, (all) => (
    JSON.stringify(/** @type {any} */ (window).mounted) === JSON.stringify(all)
  ), wanted);
  const list = [['fuel_power', 'wind', 'hot_colour']];
  await mounted(list);
  const [error] = await tab.until('a refusal', () => {
    const all = /** @type {any} */ (window).events.filter(({ type }) => type === 'error');
    return all.length > 0 && all.map(({ detail }) => detail);
  });
  assert.deepEqual([error.kind, error.id, error.value], ['bad-parameter', 'controls', 'palete']);
  assert.match(error.message, /did you mean palette\?/);
  assert.equal(await tab.fire((fire) => fire.controls), 'fuel_power wind, palete hot-colour');
  for (const [value, shown, read] of [['', 'all', true], ['controls', 'all', 'controls'], ['exposure', ['exposure'], 'exposure']]) {
    await tab.fire((fire, text) => fire.setAttribute('controls', text), value);
    list.push('gone', shown);
    await mounted(list);
    assert.equal(await tab.fire((fire) => fire.controls), read);
  }
  await tab.fire((fire) => { fire.controls = false; });
  await mounted([...list, 'gone']);
  const set = await tab.fire((fire) => {
    fire.controls = 'wind';
    const one = fire.getAttribute('controls');
    fire.controls = true;
    return [one, fire.getAttribute('controls')];
  });
  assert.deepEqual(set, ['wind', '']);
});

test('an address tells names of others from misspelt ones', () => {
  const { values, options, unknown, refused } = readAddress(
    '?seed=7&fbclid=1&utm_source=a&utm_source=b&viscosty=1&quality=low&fuelpower=3&kind=x&__proto__=1&feed=2',
  );
  assert.deepEqual(values, [['seed', '7']]);
  assert.deepEqual(options, [['quality', 'low']]);
  assert.deepEqual(unknown.map(([name]) => name), ['fbclid', 'utm_source', 'utm_source', 'kind', '__proto__', 'feed']);
  assert.equal(refused.length, 2);
  assert.match(refused[0], /viscosty.*viscosity/);
  assert.match(refused[1], /fuelpower.*fuel-power/);
});
