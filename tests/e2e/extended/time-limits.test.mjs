/**
 * Servers that take a request and never answer: the fire burns with what it has, and every promise
 * settles. The last `src` wins.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { assertBurns, events, recording } from '../assertions.mjs';
import { Browser } from '../driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const WASM = 'hearth-engine_bg.wasm';
const SMALL = 'quality="low" style="width: 60px; height: 80px"';

/** Runs in the page: the limits of its downloads are a hundredth of theirs. */
function hurry() {
  const { timeout } = AbortSignal;
  AbortSignal.timeout = (milliseconds) => timeout.call(AbortSignal, milliseconds / 100);
}

/** Runs in the page: a download of `late.json` starts when the test calls `arrive`. */
function holdFile() {
  const { fetch } = window;
  const arrival = new Promise((resolve) => {
    /** @type {any} */ (window).arrive = resolve;
  });
  window.fetch = async (...request) => {
    if (String(request[0]).endsWith('late.json')) await arrival;
    return fetch(...request);
  };
}

/** Runs in the page: notes that the download of `never.json` was ended. */
function watchFile() {
  const { fetch } = window;
  window.fetch = (...request) => {
    if (String(request[0]).endsWith('never.json')) {
      request[1]?.signal?.addEventListener('abort', () => Object.assign(window, { ended: true }));
    }
    return fetch(...request);
  };
}

const settings = (values) => ({ body: JSON.stringify({ hearth: 3, values }), type: 'application/json' });

/** The sources of the changes, of this page's fire, that set a value. */
const changes = (tab, id) =>
  tab.evaluate(
    (wanted) =>
      /** @type {any} */ (window).events
        .filter(({ type, detail }) => type === 'params-change' && detail.id === wanted)
        .map(({ detail }) => [detail.value, detail.source]),
    id,
  );

test('a fire begins with its preset and attributes if its file never arrives', async () => {
  const tab = await browser.open(
    recording(`<hearth-fire ${SMALL} src="never.json" preset="candle" wind="0.5"></hearth-fire>`),
    {
      files: { 'never.json': { silent: true } },
    },
  );
  await tab.ready();
  assert.deepEqual(await tab.fire((fire) => [fire.preset, fire.wind]), ['candle', 0.5]);
  await assertBurns(tab);
});

test('a file that does not arrive within its limit is reported', async () => {
  const tab = await browser.open(recording(`<hearth-fire ${SMALL} src="never.json"></hearth-fire>`), {
    files: { 'never.json': { silent: true } },
    before: hurry,
  });
  await tab.ready();
  await tab.until('an error event', () => /** @type {any} */ (window).events.some(({ type }) => type === 'error'));
  const [{ kind, message }] = await events(tab, 'error');
  assert.equal(kind, 'load');
  assert.match(message, /src = "never\.json".*did not arrive within 10 s/);
  await assertBurns(tab);
});

test('a file that arrives late is applied, and the values of the page still override it', async () => {
  const tab = await browser.open(recording(`<hearth-fire ${SMALL} src="late.json" wind="0.5"></hearth-fire>`), {
    files: { 'late.json': settings({ wind: 1, exposure: 2, bloom: 0.3 }) },
    before: holdFile,
  });
  await tab.ready();
  await tab.fire((fire) => fire.set('exposure', 1.5));
  await tab.evaluate(() => /** @type {any} */ (window).arrive());
  await tab.until('it is applied', () => /** @type {any} */ (document.querySelector('hearth-fire')).bloom === 0.3);
  assert.deepEqual(await tab.fire((fire) => [fire.wind, fire.exposure]), [0.5, 1.5]);
  assert.deepEqual(await changes(tab, 'bloom'), [[0.3, 'src']]);
});

for (const [how, act] of /** @type {[string, (fire: any) => unknown][]} */ ([
  ['settings', (fire) => fire.importConfig({ hearth: 3, values: { bloom: 0.4 } })],
  ['another file', (fire) => (fire.src = 'data:application/json,{"hearth":3,"values":{"bloom":0.4}}')],
])) {
  test(`of a late file and ${how} that the page names meanwhile, the last applies`, async () => {
    const tab = await browser.open(recording(`<hearth-fire ${SMALL} src="late.json"></hearth-fire>`), {
      files: { 'late.json': settings({ bloom: 0.3 }) },
      before: holdFile,
    });
    await tab.ready();
    await tab.fire(act);
    await tab.until('it is applied', () => /** @type {any} */ (document.querySelector('hearth-fire')).bloom === 0.4);
    await tab.evaluate(() => /** @type {any} */ (window).arrive());
    await tab.fire((fire) => fire.set('wind', 0.1));
    assert.equal(await tab.fire((fire) => fire.bloom), 0.4);
    assert.deepEqual(
      (await changes(tab, 'bloom')).map(([value]) => value),
      [0.4],
    );
    assert.deepEqual(await events(tab, 'error'), []);
  });
}

for (const [what, act] of /** @type {[string, (fire: any) => unknown][]} */ ([
  ['changing `src`', (fire) => (fire.src = 'soon.json')],
  ['removing `src`', (fire) => fire.removeAttribute('src')],
])) {
  test(`${what} ends the download of the earlier file`, async () => {
    const tab = await browser.open(recording(`<hearth-fire ${SMALL} src="never.json"></hearth-fire>`), {
      files: { 'never.json': { silent: true }, 'soon.json': settings({ bloom: 0.4 }) },
      before: watchFile,
    });
    await tab.ready();
    await tab.fire(act);
    await tab.until('the download has ended', () => /** @type {any} */ (window).ended);
    if (what.startsWith('changing')) {
      await tab.until(
        'the other is applied',
        () => /** @type {any} */ (document.querySelector('hearth-fire')).bloom === 0.4,
      );
    }
    assert.deepEqual(await events(tab, 'error'), []);
    await assertBurns(tab);
  });
}

test('wasm that never comes is reported within its limit, and the next attempt burns', async () => {
  const tab = await browser.open(recording('<hearth-fire></hearth-fire>'), {
    files: { [WASM]: { silent: true } },
    before: hurry,
  });
  const failure = await tab.fire((fire) =>
    fire.ready.then(
      () => null,
      ({ kind, message }) => [kind, message],
    ),
  );
  assert.equal(failure[0], 'load');
  assert.match(failure[1], /could not be loaded: no answer within 60 s/);
  assert.equal((await events(tab, 'error'))[0].message, failure[1]);
  browser.server.replace({});
  await tab.fire((fire) => {
    fire.remove();
    document.body.append(fire);
  });
  await tab.burnt(0.3);
  await assertBurns(tab);
});

test('a saved fire that never comes holds nothing', async () => {
  const tab = await browser.open(`<hearth-fire ${SMALL} preset="fireside" warm="0.1"></hearth-fire>`, {
    files: { '.fire': { silent: true } },
    before: hurry,
  });
  await tab.ready();
  await assertBurns(tab);
});

test('code that never comes rejects the call that needs it', async () => {
  const tab = await browser.open(recording(`<hearth-fire ${SMALL}></hearth-fire>`), {
    files: { 'transition.js': { silent: true }, 'capture.js': { silent: true } },
    before: () => {
      const { setTimeout } = window;
      // Only the code that the test's calls need is in a hurry: a busy machine may be slow with the rest.
      window.setTimeout = /** @type {any} */ (
        (act, time, ...rest) =>
          setTimeout(act, time === 30_000 && /** @type {any} */ (window).isHurried ? 300 : time, ...rest)
      );
    },
  });
  await tab.ready();
  await tab.evaluate(() => {
    /** @type {any} */ (window).isHurried = true;
  });
  for (const call of [['to', { wind: 1 }], ['toBlob']]) {
    const outcome = await tab.fire(
      (fire, name, ...values) =>
        fire[name](...values).then(
          () => '',
          ({ message }) => message,
        ),
      ...call,
    );
    assert.match(outcome, /no answer within 30 s/);
  }
  const errors = await events(tab, 'error');
  assert.deepEqual(
    errors.map(({ kind }) => kind),
    ['load', 'load'],
  );
  await assertBurns(tab);
});
