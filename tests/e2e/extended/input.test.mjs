/**
 * Invalid values: the element reports them by an event, a warning and a rejected promise,
 * and keeps the last good values.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { assertBurns, recording } from '../assertions.mjs';
import { table } from '../site.mjs';

const { DEFAULTS } = await table();

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const BAD = /** @type {[string, string, RegExp][]} */ ([
  ['wind', 'strong', /strong/],
  ['wind', 'NaN', /NaN/],
  ['max-particles', '400.5', /400\.5.*whole/],
  ['edges', 'sideways', /sideways.*open, periodic/],
  ['background', 'reddish', /reddish/],
  ['seed', '-1', /-1/],
  ['preset', 'volcano', /volcano/],
  ['model', 'volcano', /volcano.*classic, combustion/],
  ['quality', 'LOW', /quality.*"LOW".*auto, low, medium, high/],
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

test('a rejection without a handler is no uncaught exception', async () => {
  const tab = await browser.show(recording('<hearth-fire></hearth-fire>'));
  await tab.ready();
  await tab.fire((fire) => {
    fire.set('wind', 99);
    fire.wind = 99;
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

test('a panel that fails to load shows a message, the fire burns without it, and Try again shows the panel', async () => {
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
  browser.server.replace({});
  await tab.evaluate(() => /** @type {HTMLElement} */ (document.querySelector('.hearth-panel-message button')).click());
  await tab.until('the panel in the place of the words', () =>
    Boolean(
      document.querySelector('#panel .hearth-panel-stage canvas') && !document.querySelector('.hearth-panel-message'),
    ),
  );
});
