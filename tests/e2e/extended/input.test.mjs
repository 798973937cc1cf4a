/**
 * Invalid values: the element reports them by an event, a warning and a rejected promise,
 * and keeps the last good values.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { assertBurns, events, recording } from '../assertions.mjs';
import { table } from '../site.mjs';

const { DEFAULTS, entry } = await table();

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** What `fire.set(…)` does: the values after it, and why it was refused. */
function set(tab, ...args) {
  return tab.fire(
    async (fire, ...given) => {
      const error = await fire.set(...given).then(
        () => null,
        (/** @type {any} */ reason) => ({
          name: reason.name,
          message: reason.message,
          id: reason.id,
          value: reason.value,
          min: reason.min,
          max: reason.max,
        }),
      );
      return { error, params: fire.params };
    },
    ...args,
  );
}

test('an attribute out of range is rejected with an error event, and the fire burns with the default', async () => {
  const tab = await browser.show(recording('<hearth-fire viscosity="99"></hearth-fire>'));
  await tab.ready();
  const [{ kind, id, value, min, max, message }, ...more] = await events(tab, 'error');
  assert.deepEqual(more, []);
  const { viscosity } = entry;
  assert.deepEqual([kind, id], ['bad-parameter', 'viscosity']);
  assert.deepEqual([Number(value), min, max], [99, viscosity.min, viscosity.max]);
  const words = new RegExp(`viscosity.*99.*${viscosity.min}.*${viscosity.max}`);
  assert.match(message, words);
  assert.deepEqual(tab.problems.length, 1);
  assert.match(tab.problems[0], /^console\.warn/);
  assert.match(tab.problems[0], words);
  assert.equal(await tab.fire((fire) => fire.params.viscosity), DEFAULTS.viscosity);
  await tab.burnt(1);
  await assertBurns(tab);
});

const BAD = /** @type {[string, string, RegExp][]} */ ([
  ['viscosity', 'thick', /thick/],
  ['viscosity', 'NaN', /NaN/],
  ['max-particles', '400.5', /400\.5.*whole/],
  ['walls', 'sideways', /sideways.*open, solid, periodic/],
  ['printed-kernel', 'perhaps', /perhaps/],
  ['background', 'reddish', /reddish/],
  ['seed', '-1', /-1/],
  ['preset', 'volcano', /volcano/],
  ['model', 'volcano', /volcano.*classic, combustion/],
]);

test('each invalid attribute is rejected with an error event and a warning, and its fire has the defaults', async () => {
  const fires = BAD.map(
    ([attribute, text]) => `<hearth-fire ${attribute}="${text}" style="width: 40px; height: 50px"></hearth-fire>`,
  );
  const tab = await browser.show(recording(fires.join('')));
  const { errors, params } = await tab.evaluate(async () => {
    const all = /** @type {any[]} */ ([...document.querySelectorAll('hearth-fire')]);
    await Promise.all(all.map((fire) => fire.ready));
    const { events } = /** @type {any} */ (window);
    return { errors: events.filter(({ type }) => type === 'error'), params: all.map((fire) => fire.params) };
  });
  assert.equal(tab.problems.length, BAD.length, tab.problems.join('\n'));
  for (const [at, [attribute, text, reason]] of BAD.entries()) {
    const [{ detail }, ...more] = errors.filter(({ fire }) => fire === at);
    assert.deepEqual([detail.kind, more], ['bad-parameter', []], `${attribute}="${text}"`);
    assert.match(detail.message, reason);
    assert.ok(
      tab.problems.some((problem) => reason.test(problem)),
      `a warning of ${attribute}="${text}"`,
    );
    assert.deepEqual(params[at], DEFAULTS, `${attribute}="${text}"`);
  }
});

test('a bad value leaves the last good one in place', async () => {
  const tab = await browser.show(recording('<hearth-fire viscosity="0.02"></hearth-fire>'));
  await tab.ready();
  await tab.fire((fire) => fire.setAttribute('viscosity', 'much'));
  await tab.until('the refusal', () => /** @type {any} */ (window).events.at(-1)?.type === 'error');
  assert.equal(await tab.fire((fire) => fire.params.viscosity), 0.02);
});

test('a set of values is taken as a whole or not at all', async () => {
  const tab = await browser.show('<hearth-fire></hearth-fire>');
  await tab.ready();
  const good = await set(tab, { viscosity: 0.02, buoyancy: 0.5 });
  assert.equal(good.error, null);
  assert.deepEqual([good.params.viscosity, good.params.buoyancy], [0.02, 0.5]);
  const bad = await set(tab, { viscosity: 0.03, buoyancy: 9 });
  assert.deepEqual(
    [bad.error.name, bad.error.id, Number(bad.error.value), bad.error.min, bad.error.max],
    ['RangeError', 'buoyancy', 9, entry.buoyancy.min, entry.buoyancy.max],
  );
  assert.deepEqual([bad.params.viscosity, bad.params.buoyancy], [0.02, 0.5]);
});

test('an unknown name is answered with the nearest known one', async () => {
  const tab = await browser.show('<hearth-fire></hearth-fire>');
  await tab.ready();
  const { error } = await set(tab, 'viscosty', 0.02);
  assert.match(error.message, /viscosty.*viscosity/);
});

test('no kind of nonsense is taken for a number', async () => {
  const tab = await browser.show('<hearth-fire></hearth-fire>');
  await tab.ready();
  const nonsense = [{}, [], '', ' ', true, 'x'.repeat(100_000), '0.02m'];
  for (const value of nonsense) {
    const { error, params } = await set(tab, 'viscosity', value);
    assert.ok(error, `${JSON.stringify(value)?.slice(0, 40)} was taken`);
    assert.ok(error.message.length < 500, 'a hostile value floods no console');
    assert.equal(params.viscosity, DEFAULTS.viscosity);
  }
  const unwritable = await tab.fire(async (fire) => {
    const refused = [];
    for (const value of [NaN, Infinity, Symbol('fire'), () => 1, 10n]) {
      await fire.set('viscosity', value).catch(() => refused.push(typeof value));
    }
    return { refused, viscosity: fire.params.viscosity };
  });
  assert.deepEqual(unwritable, {
    refused: ['number', 'number', 'symbol', 'function', 'bigint'],
    viscosity: DEFAULTS.viscosity,
  });
});

test('a rejection without a handler is no uncaught exception', async () => {
  const tab = await browser.show(recording('<hearth-fire></hearth-fire>'));
  await tab.ready();
  await tab.fire((fire) => {
    fire.set('viscosity', 99);
    fire.viscosity = 99;
  });
  await tab.until(
    'two refusals',
    () => /** @type {any} */ (window).events.filter(({ type }) => type === 'error').length === 2,
  );
  await tab.frames(4);
  assert.deepEqual(
    tab.problems.filter((problem) => problem.startsWith('uncaught')),
    [],
  );
});

const POSTER =
  '<img slot="poster" id="poster" alt="A fire" src="data:image/svg+xml,' +
  '%3Csvg xmlns=%22http://www.w3.org/2000/svg%22 width=%2240%22 height=%2240%22/%3E">';

for (const [missing, word, before] of [
  [
    'WebGL2',
    /WebGL ?2/i,
    () => {
      // In a worker there is no canvas of the page.
      for (const type of [globalThis.HTMLCanvasElement, OffscreenCanvas]) {
        if (!type) continue;
        const original = /** @type {any} */ (type.prototype.getContext);
        /** @type {any} */ (type.prototype).getContext = function getContext(kind, ...rest) {
          return kind === 'webgl2' ? null : original.call(this, kind, ...rest);
        };
      }
    },
  ],
  [
    'wasm SIMD',
    /SIMD/i,
    () => {
      WebAssembly.validate = () => false;
    },
  ],
]) {
  test(`a browser without ${missing} shows a message and the poster`, async () => {
    const body = recording(`<hearth-fire>${POSTER}</hearth-fire>`);
    const tab = await browser.open(body, { before, beforeWorker: before });
    await tab.until('an error event', () => /** @type {any} */ (window).events.some(({ type }) => type === 'error'));
    const [{ kind, message }] = await events(tab, 'error');
    assert.equal(kind, 'unsupported');
    assert.match(message, /** @type {RegExp} */ (word));
    await tab.frames();
    const shown = await tab.fire((fire) => fire.shadowRoot.textContent);
    assert.match(shown, /** @type {RegExp} */ (word), 'words stand in the element');
    const poster = await tab.rectangle('#poster');
    assert.ok(poster.width > 0 && poster.height > 0, 'the poster is shown');
    assert.deepEqual(
      tab.problems.filter((problem) => problem.startsWith('uncaught')),
      [],
    );
  });

  if (missing !== 'WebGL2') continue;
  test(`the page reports that ${missing} is missing`, async () => {
    const tab = await browser.open('index.html', { before, beforeWorker: before });
    await tab.until(
      `words about ${missing}`,
      (source) => {
        const fire = document.querySelector('hearth-fire');
        const text = document.body.innerText + (fire?.shadowRoot?.textContent ?? '');
        return new RegExp(source, 'i').test(text);
      },
      /** @type {RegExp} */ (word).source,
    );
    assert.deepEqual(
      tab.problems.filter((problem) => problem.startsWith('uncaught')),
      [],
    );
  });
}

test('an engine that cannot be loaded shows a message and the poster', async () => {
  const body = recording(`<hearth-fire>${POSTER}</hearth-fire>`);
  const tab = await browser.open(body, { without: 'hearth-engine_bg.wasm' });
  await tab.until('an error event', () => /** @type {any} */ (window).events.some(({ type }) => type === 'error'));
  const [{ kind }] = await events(tab, 'error');
  assert.equal(kind, 'load');
  const shown = await tab.fire((fire) => fire.shadowRoot.textContent);
  assert.match(shown, /could not be loaded/);
  const poster = await tab.rectangle('#poster');
  assert.ok(poster.width > 0 && poster.height > 0, 'the poster is shown');
  assert.deepEqual(
    tab.problems.filter((problem) => problem.startsWith('uncaught')),
    [],
  );
});

test('a fire without a context reports it once, and its removal reports nothing', async () => {
  const blind = () => {
    for (const type of [globalThis.HTMLCanvasElement, OffscreenCanvas]) {
      if (type) type.prototype.getContext = () => null;
    }
  };
  const tab = await browser.open(recording('<hearth-fire></hearth-fire>'), { before: blind, beforeWorker: blind });
  await tab.until('an error event', () => /** @type {any} */ (window).events.length > 0);
  await tab.fire(async (fire) => {
    fire.remove();
    for (let left = 5; left > 0; left -= 1) await new Promise(requestAnimationFrame);
  });
  const errors = await events(tab, 'error');
  assert.deepEqual(
    errors.map(({ kind }) => kind),
    ['unsupported'],
  );
  assert.equal(tab.problems.length, 1);
});

test('a panel that fails to load shows a message, and the fire burns without it', async () => {
  const tab = await browser.open('index.html', {
    width: 1000,
    height: 600,
    without: 'hearth-panel_bg.wasm',
  });
  await tab.until('words in the place of the panel', () =>
    /cannot be shown/.test(/** @type {HTMLElement} */ (document.querySelector('#panel')).innerText),
  );
  await tab.burnt(1);
  await assertBurns(tab);
  assert.deepEqual(
    tab.problems.filter((problem) => problem.startsWith('uncaught')),
    [],
  );
});
