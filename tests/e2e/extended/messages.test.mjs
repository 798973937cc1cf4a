/**
 * Messages between a fire in an iframe and the embedding page. Rejected messages are
 * tested in tests/web/message-bridge.test.mjs.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { BROWSER } from '../driver.mjs';
import { IframeFixture, call, inIframe, send } from '../iframe-fixture.mjs';
import { table } from '../site.mjs';

const { entry } = await table();

/** @type {IframeFixture} */
let fixture;
before(async () => {
  fixture = await IframeFixture.start();
});
after(() => fixture?.close());

describe('messages from an allowed origin', () => {
  test('are all answered', async () => {
    const tab = await fixture.burning({ model: 'classic' });
    const tried = new Set();
    const value = async (method, ...args) => {
      tried.add(method);
      const answer = await call(tab, method, ...args);
      assert.ok(answer?.ok, `${method}: ${JSON.stringify(answer?.error)}`);
      assert.equal(answer.origin, fixture.fireOrigin);
      return answer.value;
    };
    await value('ready');
    const { methods, events, version } = await value('hello');
    assert.equal(version, 1);

    await value('pause');
    assert.equal(await inIframe(tab, (fire) => fire.paused), true);
    await value('reset');
    await value('step', 30);
    await value('advance', 0.1);
    await tab.until('steps are made', () =>
      /** @type {any} */ (window).call('stats').then(({ value: stats }) => stats?.time > 0),
    );
    tried.add('stats');
    await value('play');
    assert.equal(await inIframe(tab, (fire) => fire.paused), false);

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

    const added = await value('addObject', { kind: 'source', x: 0.1 });
    await value('changeObject', added, { x: -0.1 });
    assert.deepEqual(
      (await value('objects')).map(({ id, x }) => [id, x]),
      [
        [1, 0],
        [added, -0.1],
      ],
    );
    await value('removeObject', added);

    await value('set', 'model', 'combustion');
    const log = await value('addObject', { kind: 'solid', x: 0.3, fuel: 'wood' });
    await value('ignite', log);
    await value('extinguish', 0.3, 0.5, 1);
    await value('spray', 0, 1, 0, -4, 20);
    assert.deepEqual(await value('freeSolids'), []);
    assert.equal((await value('measure', 0, 0.5)).place.y, 0.5);
    await value('removeObject', log);

    assert.equal(await value('option', 'quality', 'low'), 'low');
    assert.equal(await value('option', 'quality'), 'low');
    assert.equal(await value('option', 'quality', null), null);
    // Only of `autoplay` is false an attribute.
    assert.equal(await value('option', 'autoplay', false), 'false');
    assert.equal(await value('option', 'interactive', false), null);

    assert.equal(await value('to', { exposure: 0.5 }, { duration: 50, easing: 'linear' }), true);
    assert.equal(await value('get', 'exposure'), 0.5);
    await value('stir', 0, 0.5, 1, 0);
    await value('sparks', 0, 0.5, 3);

    tried.add('toBlob');
    const type = await tab.evaluate(async () => {
      const { value: blob, error } = await /** @type {any} */ (window).call('toBlob', 'image/png');
      return blob ? `${blob.type} ${blob.size > 100}` : error.message;
    });
    assert.equal(type, 'image/png true');

    assert.deepEqual(await value('subscribe', ['stats', 'pause']), ['ready', 'stats', 'pause']);
    assert.deepEqual(await value('unsubscribe', 'stats'), ['ready', 'pause']);
    // Without arguments, other methods answer too, if only with the reason of a refusal.
    for (const method of methods.filter((name) => !tried.has(name))) {
      const { ok, error } = (await call(tab, method)) ?? {};
      assert.ok(ok || (error?.message && !/there is no method/.test(error.message)), method);
    }
    assert.ok(events.includes('stats'));
    assert.deepEqual(tab.problems, []);
  });
});

describe('messages from other origins', () => {
  test('are not answered where other origins are allowed, not even the fire’s own, and “*” is none', async () => {
    const wrong = ['*', 'null', '/', `${fixture.pageOrigin}/`, 'https://*.example', 'javascript:alert(1)'];
    const others = ['https://a.example', fixture.fireOrigin, `http://localhost:${new URL(fixture.pageOrigin).port}`];
    const allow = [...others, ...wrong].join(',');
    const tab = await fixture.open({ allow });
    await inIframe(tab, (fire) => fire.ready.then(() => undefined));
    await send(tab, { hearth: 1, id: 1, method: 'pause' }, 1, 0);
    await send(tab, { hearth: 1, id: 2, method: 'params' }, 2, 500);
    assert.deepEqual(await tab.evaluate(() => /** @type {any} */ (window).received), []);
    assert.equal(await inIframe(tab, (fire) => fire.paused), false);
    // There, a warning of an iframe of another origin reaches neither driver nor page.
    if (BROWSER === 'webkit') return;
    const warnings = tab.problems.filter((problem) => problem.includes('is ignored; the URL parameter “allow”'));
    assert.equal(warnings.length, 1);
    assert.match(warnings[0], new RegExp(fixture.pageOrigin));
    const unclear = tab.problems.filter((problem) => problem.includes('“allow” must list exact origins'));
    assert.equal(unclear.length, wrong.length);
    for (const [at, origin] of wrong.entries()) assert.ok(unclear[at].includes(`“${origin}”`), unclear[at]);
  });
});
