/**
 * What a fire in an iframe answers: the page around it, if, and only if, its address
 * allows that page's origin; what is on a list, and nothing else.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { Around, ask, heard, inside, send } from './around.mjs';
import { table } from './site.mjs';

const { entry } = await table();

/** @type {Around} */
let around;
before(async () => {
  around = await Around.start();
});
after(() => around?.close());

describe('messages from an allowed origin', () => {
  test('are all answered', async () => {
    const tab = await around.burning({ model: 'classic' });
    const tried = new Set();
    const value = async (method, ...args) => {
      tried.add(method);
      const answer = await ask(tab, method, ...args);
      assert.ok(answer?.ok, `${method}: ${JSON.stringify(answer?.error)}`);
      assert.equal(answer.origin, around.there);
      return answer.value;
    };
    await value('ready');
    const { methods, events, version } = await value('hello');
    assert.equal(version, 1);

    await value('pause');
    assert.equal(await inside(tab, (fire) => fire.paused), true);
    await value('reset');
    await value('step', 30);
    await tab.until('steps are made', () => /** @type {any} */ (window).ask('stats').then(({ value: stats }) => stats?.time > 0));
    tried.add('stats');
    await value('play');
    assert.equal(await inside(tab, (fire) => fire.paused), false);

    await value('set', 'viscosity', 0.02);
    assert.equal(await value('get', 'viscosity'), 0.02);
    await value('set', { seed: 7, exposure: 1 });
    const { viscosity, seed, exposure } = await value('params');
    assert.deepEqual({ viscosity, seed, exposure }, { viscosity: 0.02, seed: 7, exposure: 1 });
    const config = await value('exportConfig');
    await value('restore', 'viscosity', 'seed');
    assert.equal(await value('get', 'seed'), entry.seed.default);
    await value('importConfig', config);
    assert.equal(await value('get', 'seed'), 7);
    assert.deepEqual(await value('exportConfig'), config);

    assert.equal(await value('option', 'quality', 'low'), 'low');
    assert.equal(await value('option', 'quality'), 'low');
    assert.equal(await value('option', 'quality', null), null);

    await value('stir', 0, 0.5, 1, 0);
    await value('sparks', 0, 0.5, 3);

    tried.add('toBlob');
    const type = await tab.evaluate(async () => {
      const { value: blob, error } = await /** @type {any} */ (window).ask('toBlob', 'image/png');
      return blob ? `${blob.type} ${blob.size > 100}` : error.message;
    });
    assert.equal(type, 'image/png true');

    assert.deepEqual(await value('subscribe', ['stats', 'pause']), ['ready', 'stats', 'pause']);
    assert.deepEqual(await value('unsubscribe', 'stats'), ['ready', 'pause']);
    assert.deepEqual([...tried].sort(), [...methods].sort());
    assert.ok(events.includes('stats'));
    assert.deepEqual(tab.problems, []);
  });

  test('bring the events that were asked for and no others', async () => {
    const tab = await around.burning();
    await ask(tab, 'subscribe', ['params-change', 'error']);
    await ask(tab, 'set', 'exposure', 1);
    assert.deepEqual((await heard(tab, 'params-change')).detail, { id: 'exposure', value: 1, source: 'property' });
    await ask(tab, 'set', 'exposure', 99);
    const { detail } = await heard(tab, 'error');
    assert.deepEqual([detail.kind, detail.id], ['bad-parameter', 'exposure']);
    await ask(tab, 'unsubscribe', ['params-change']);
    await ask(tab, 'set', 'exposure', 0);
    await ask(tab, 'pause');
    const kinds = await tab.evaluate(() => /** @type {any} */ (window).heard
      .filter(({ event }) => event !== undefined).map(({ event }) => event));
    assert.deepEqual(kinds, ['hello', 'ready', 'params-change', 'error']);
  });

  test('that ask for something bad are refused with what is allowed', async () => {
    const tab = await around.burning();
    const { ok, error } = await ask(tab, 'set', 'exposure', 99);
    assert.equal(ok, false);
    const { min, max } = entry.exposure;
    assert.deepEqual({ ...error, message: '' }, { name: 'RangeError', message: '', id: 'exposure', value: 99, min, max });
    assert.match(error.message, /exposure.*99/);
    for (const [method, args, words] of [
      ['set', ['viscosty', 1], /viscosty.*viscosity/],
      ['set', [{ seed: 9, exposure: 99 }], /exposure/],
      ['set', ['__proto__', { polluted: true }], /__proto__/],
      ['get', ['viscosty'], /viscosty.*viscosity/],
      ['get', ['constructor'], /constructor/],
      ['importConfig', [{ hearth: 1, values: { seed: 9, viscosty: 1 } }], /viscosty/],
      ['importConfig', ['{"hearth": 1'], /./],
      ['option', ['src', '/secret'], /src.*quality/],
      ['option', ['onclick', 'alert(1)'], /onclick/],
      ['subscribe', [['stats', 'everything']], /everything.*stats/],
      ['subscribe', [], /there is no event/],
    ]) {
      const answer = await ask(tab, method, ...args);
      assert.equal(answer.ok, false, `${method} ${JSON.stringify(args)}`);
      assert.match(answer.error.message, words);
    }
    const { value: params } = await ask(tab, 'params');
    assert.deepEqual([params.seed, params.exposure], [entry.seed.default, entry.exposure.default]);
  });

  test('that read a value change none, whatever they name', async () => {
    const tab = await around.burning();
    await ask(tab, 'subscribe', ['params-change', 'error', 'restored']);
    await ask(tab, 'set', 'wind', 1);
    for (const id of [['wind'], [['wind']], { id: 'wind' }, null, 5, true, undefined]) {
      const { ok, error } = await ask(tab, 'get', id);
      assert.deepEqual([ok, error?.name], [false, 'TypeError'], JSON.stringify(id));
      assert.match(error.message, /a text, not/);
    }
    const { error } = await ask(tab, 'get', 'vind');
    assert.deepEqual([error.name, error.id], ['RangeError', 'vind']);
    assert.match(error.message, /vind.*\bwind\b/);
    assert.equal((await ask(tab, 'get', 'wind')).value, 1);
    const events = await tab.evaluate(() => /** @type {any} */ (window).heard
      .filter(({ event }) => event !== undefined).map(({ event }) => event));
    assert.deepEqual(events, ['hello', 'ready', 'params-change']);
  });

  test('set an option to false, which of `autoplay` has to be said', async () => {
    const tab = await around.burning();
    for (const [name, value, attribute] of [
      ['autoplay', false, 'false'], ['autoplay', true, ''], ['autoplay', null, null],
      ['interactive', true, ''], ['interactive', false, null],
    ]) {
      assert.equal((await ask(tab, 'option', name, value)).value, attribute, `${name} ${value}`);
      const property = await inside(tab, (fire, key) => fire[key], name);
      assert.equal(property, name === 'autoplay' ? value !== false : value, `${name} ${value}`);
    }
  });

  test('reach no method but those that are listed', async () => {
    const tab = await around.burning();
    for (const method of [
      'constructor', '__proto__', 'toString', 'remove', 'setAttribute', 'innerHTML', 'destroy', 'then', 'has', '',
    ]) {
      const { ok, error } = await ask(tab, method, 'x');
      assert.deepEqual([ok, error.name], [false, 'TypeError'], method);
      assert.match(error.message, /there is no method .*play, pause/);
    }
  });

  test('of a wrong form are refused with the reason, and what is not ours is left alone', async () => {
    const tab = await around.burning();
    let nested = {};
    for (let depth = 0; depth < 50; depth += 1) nested = { nested };
    for (const [message, id, words] of [
      [{ hearth: 1, id: 'a' }, 'a', /no method “undefined”/],
      [{ hearth: 1, id: 'b', method: 7 }, 'b', /no method “7”/],
      [{ hearth: 1, id: 'c', method: ['play'] }, 'c', /no method/],
      [{ hearth: 1, id: 'd', method: 'play', args: 'now' }, 'd', /“args”/],
      [{ hearth: 2, id: 'e', method: 'play' }, 'e', /version 1, not “2”/],
      [{ hearth: 1, id: 'f', method: 'set', args: ['alt', 'x'.repeat(70_000)] }, 'f', /65536/],
      [{ hearth: 1, id: 'g', method: 'set', args: [nested] }, 'g', /8 deep/],
      [{ hearth: 1, id: 'h', method: 'set', args: [{ ['k'.repeat(70_000)]: 1 }] }, 'h', /65536/],
      [{ hearth: 1, id: 'i', method: 'set', args: Array(10_000).fill(0) }, 'i', /65536/],
      [{ hearth: 1, id: { a: 1 }, method: 'play' }, null, /“id”/],
      [{ hearth: 1, id: 'x'.repeat(101), method: 'play' }, null, /“id”/],
    ]) {
      await tab.evaluate(() => (/** @type {any} */ (window).heard.length = 0));
      const answer = await send(tab, message, id);
      assert.equal(answer?.ok, false, JSON.stringify(message).slice(0, 80));
      assert.match(answer.error.message, words);
    }
    // What JSON cannot hold, and what would hold a page for ever.
    const refused = await tab.evaluate(async () => {
      const page = /** @type {any} */ (window);
      const circle = {};
      circle.self = circle;
      const all = [circle, new Map([[1, 2]]), new ArrayBuffer(8), 10n, new Array(4e9), new Blob(['a'])];
      const answers = [];
      for (const odd of all) answers.push((await page.ask('set', odd)).ok);
      return answers;
    });
    assert.deepEqual(refused, Array(6).fill(false));
    await tab.evaluate(() => (/** @type {any} */ (window).heard.length = 0));
    for (const message of [
      'hearth', null, 7, [], { id: 1 }, { method: 'pause', id: 2 },
      { hearth: 1, id: 3, ok: true }, { hearth: 1, event: 'ready' },
    ]) await send(tab, message, 'nobody', 0);
    // Messages arrive in order: an answer to the last one would be here.
    assert.equal((await ask(tab, 'params')).ok, true);
    assert.equal(await tab.evaluate(() => /** @type {any} */ (window).heard.length), 1);
    assert.equal(await inside(tab, (fire) => fire.paused), false);
  });

  test('are refused beyond a bound while others wait, which are answered all the same', async () => {
    const style = 'body { height: 9000px } iframe { position: absolute; top: 8000px }';
    const tab = await around.open({ allow: around.here, loading: 'lazy' }, { style });
    await heard(tab, 'hello');
    // The fire is out of sight and does not begin, so everything waits for it.
    const refused = await tab.evaluate(async () => {
      const page = /** @type {any} */ (window);
      page.asked = Array.from({ length: 300 }, (_, at) => page.ask('set', 'exposure', at / 100));
      const last = await page.asked[299];
      window.scrollTo(0, 8000);
      return last;
    });
    assert.equal(refused.ok, false);
    assert.equal(refused.error.name, 'BusyError');
    assert.match(refused.error.message, /too many requests.*256/);
    const done = await tab.evaluate(async () => {
      const answers = await Promise.all(/** @type {any} */ (window).asked);
      return answers.map(({ ok }) => ok);
    });
    assert.deepEqual(done, Array.from({ length: 300 }, (_, at) => at < 256));
    assert.equal((await ask(tab, 'get', 'exposure')).value, 2.55);
  });

  test('in a flood do no harm', async () => {
    const tab = await around.burning();
    const answered = await tab.evaluate(async () => {
      const { ask: request } = /** @type {any} */ (window);
      const flood = Array.from({ length: 5000 }, (_, at) => request('set', 'exposure', (at % 3) / 10));
      return (await Promise.all(flood)).filter(({ ok, error }) => ok || error.name === 'BusyError').length;
    });
    assert.equal(answered, 5000);
    assert.equal((await ask(tab, 'set', 'exposure', 1)).ok, true);
    assert.equal((await ask(tab, 'get', 'exposure')).value, 1);
    const { value: before } = await ask(tab, 'stats');
    await tab.until('the fire burns on', (time) => /** @type {any} */ (window).ask('stats')
      .then(({ value }) => value.time > time), before?.time ?? 0);
  });
});

describe('messages from anybody else', () => {
  /** Nothing that is asked of this fire brings an answer. */
  async function assertDeaf(tab) {
    await inside(tab, (fire) => fire.ready.then(() => undefined));
    await send(tab, { hearth: 1, id: 1, method: 'pause' }, 1, 0);
    await send(tab, { hearth: 1, id: 2, method: 'params' }, 2, 500);
    assert.deepEqual(await tab.evaluate(() => /** @type {any} */ (window).heard), []);
    assert.equal(await inside(tab, (fire) => fire.paused), false);
  }

  test('are not answered where nobody is allowed', async () => {
    const tab = await around.open({});
    await assertDeaf(tab);
    assert.deepEqual(tab.problems, []);
  });

  test('are not answered where other origins are allowed, not even the fire’s own', async () => {
    const allow = `https://a.example,${around.there},http://localhost:${new URL(around.here).port}`;
    const tab = await around.open({ allow });
    await assertDeaf(tab);
    const said = tab.problems.filter((problem) => problem.includes('does not allow'));
    assert.equal(said.length, 1);
    assert.match(said[0], new RegExp(around.here));
  });

  test('are not answered where “*” and the like are allowed, and that is said', async () => {
    const wrong = ['*', 'null', '/', `${around.here}/`, 'https://*.example', 'javascript:alert(1)'];
    const tab = await around.open({ allow: wrong.join(',') });
    await assertDeaf(tab);
    const said = tab.problems.filter((problem) => problem.includes('“allow” wants exact origins'));
    assert.equal(said.length, wrong.length);
    for (const [at, one] of wrong.entries()) assert.ok(said[at].includes(`“${one}”`), said[at]);
  });

  test('are allowed by exact origins only', async () => {
    const { allowedOrigins } = await import('../../web/embed/message-bridge.js');
    const exact = ['https://a.example', 'http://localhost:8080', 'https://[::1]:90'];
    assert.deepEqual(allowedOrigins([` ${exact[0]} ,${exact[1]},`, exact[2]]), { origins: exact, refused: [] });
    for (const one of [
      '*', 'null', 'a.example', '//a.example', 'https://*.example', 'https://a.example/', 'https://a.example/path',
      'https://a.example?x', 'https://a.example#x', 'https://u:p@a.example', 'https://A.example', 'https://a.example:443',
      'file:///', 'about:blank', 'data:text/html', 'blob:https://a.example', 'javascript:alert(1)', 'https://', 'x y', '%',
    ]) {
      const { origins, refused } = allowedOrigins([one]);
      assert.deepEqual([origins, refused.length], [[], 1], one);
      assert.ok(refused[0].includes(`“${one}”`), refused[0]);
    }
    const many = Array.from({ length: 40 }, (_, at) => `https://a${at}.example`);
    const { origins, refused } = allowedOrigins([many.join(',')]);
    assert.deepEqual(origins, many.slice(0, 16));
    assert.equal(refused.length, 1);
  });

  test('are not answered if another window than the parent sent them', async () => {
    const more = `<iframe srcdoc="<script>
      const ask = () => parent.frames[0].postMessage({ hearth: 1, id: 1, method: 'pause' }, '*');
      addEventListener('message', (event) => parent.heard.push({ sibling: event.data }));
      setInterval(ask, 50);
    </script>"></iframe>`;
    const tab = await around.burning({}, { more });
    await tab.until('the sibling has asked for a while', () => {
      /** @type {any} */ (window).begun ??= performance.now();
      return performance.now() - /** @type {any} */ (window).begun > 500;
    });
    assert.equal(await inside(tab, (fire) => fire.paused), false);
    const events = await tab.evaluate(() => /** @type {any} */ (window).heard.map(({ event }) => event));
    assert.deepEqual(events, ['hello', 'ready']);
  });
});
