/**
 * A fire in an iframe: its address sets it, it fills its iframe, it is transparent, and a
 * client connects the embedding page to it.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { BROWSER, except } from '../driver.mjs';
import { IframeFixture, call, inIframe, received } from '../iframe-fixture.mjs';
import { table } from '../site.mjs';

const { PRESETS, defaultsOf, entry } = await table();

/** @type {IframeFixture} */
let fixture;
before(async () => {
  fixture = await IframeFixture.start();
});
after(() => fixture?.close());

describe('a fire in an iframe', () => {
  test('is the one of its address, and fills its iframe', async () => {
    const query = { scene: 'seed', viscosity: '0.02', quality: 'low', max_particles: '300', paused: '', alt: 'Embers' };
    const tab = await fixture.burning(query);
    const { value: params } = await call(tab, 'params');
    const scene = { ...defaultsOf('classic'), ...PRESETS.find(({ name }) => name === 'seed').values };
    for (const [id, value] of Object.entries({ ...scene, viscosity: 0.02, max_particles: 300 })) {
      assert.equal(params[id], value, id);
    }
    const size = await inIframe(tab, (fire) => {
      const { width, height } = fire.getBoundingClientRect();
      const { quality, paused, alt, stats } = fire;
      return { width, height, quality, paused, alt, time: stats?.time ?? 0 };
    });
    assert.deepEqual(size, { width: 240, height: 240, quality: 'low', paused: true, alt: 'Embers', time: 0 });
    assert.deepEqual(tab.problems, []);
  });

  const warns = except({ webkit: 'a warning of an iframe of another origin reaches neither driver nor page' });
  test('rejects a bad value with a warning and burns with the others', warns, async () => {
    const tab = await fixture.burning({ viscosty: '1', exposure: '99', seed: '7', src: '/secret', wings: '2' });
    const { value: params } = await call(tab, 'params');
    assert.deepEqual([params.seed, params.exposure], [7, entry.exposure.default]);
    const warnings = tab.problems.join('\n');
    for (const words of ['viscosty.*viscosity', 'exposure.*99', 'src']) assert.match(warnings, new RegExp(words));
    // A name that is no fire's, as a link's tracking adds, is no warning.
    assert.doesNotMatch(warnings, /wings/);
    assert.ok(
      tab.problems.every((problem) => problem.startsWith('console.warn')),
      warnings,
    );
  });

  test('burns alone in a window too, accepts every attribute but those that fetch a file or sound, and runs no other script or style', async () => {
    const tab = await fixture.browser.open('web/embed.html?seed=7', { width: 300, height: 200 });
    await tab.burnt(0.3);
    assert.deepEqual(await tab.rectangle('hearth-fire'), { x: 0, y: 0, width: 300, height: 200 });
    assert.deepEqual(tab.problems, []);
    const { options, attributes } = await tab.evaluate(async () => {
      const load = (/** @type {string} */ url) => import(url);
      const { observedAttributes } = /** @type {any} */ (customElements.get('hearth-fire'));
      return { options: (await load('/web/pages/url-parameters.js')).OPTIONS, attributes: observedAttributes };
    });
    const parameters = Object.values(entry).map(({ attribute }) => attribute);
    const own = attributes.filter((name) => !parameters.includes(name) && name !== 'preset');
    assert.deepEqual([...options, 'crackle', 'hiss', 'poster', 'roar', 'sound', 'src'].sort(), own.sort());
    const seen = await tab.evaluate(() => {
      let parsed = true;
      try {
        document.body.insertAdjacentHTML('beforeend', '<p>');
      } catch {
        parsed = false;
      }
      const [paragraph, style, script] = ['p', 'style', 'script'].map((name) => document.createElement(name));
      paragraph.setAttribute('style', 'width: 7px');
      style.append('p { height: 9px }');
      script.append('window.ran = true');
      document.body.append(paragraph, style, script);
      const { width, height } = getComputedStyle(paragraph);
      return { parsed, ran: 'ran' in window, styled: width === '7px' || height === '9px' };
    });
    assert.deepEqual(seen, { parsed: false, ran: false, styled: false });
  });

  // Where page, iframe and fire are of different colour schemes, the browser would
  // give the fire an opaque ground.
  for (const [about, page, iframe, query] of [
    ['one that names no colour scheme', '', '', {}],
    ['a dark one in a light iframe', 'dark', 'light', {}],
    ['one of both schemes in a light iframe', 'light dark', 'light', {}],
    ['a dark one if its address asks for it', 'dark', '', { 'color-scheme': 'dark' }],
    ['one of both schemes if its address asks for them', 'light dark', '', { 'color-scheme': 'auto' }],
  ]) {
    test(`is transparent in ${about}, with either preference`, async () => {
      const style = `body { background: rgb(0, 96, 160) }
        ${page && `:root { color-scheme: ${page} }`} ${iframe && `iframe { color-scheme: ${iframe} }`}`;
      const tab = await fixture.open({ allow: fixture.pageOrigin, paused: '', ...query }, { style, draws: true });
      await received(tab, 'ready');
      // Only Chromium's driver changes the preference while a page runs.
      for (const wanted of BROWSER === 'chromium' ? ['light', 'dark'] : ['light']) {
        if (wanted === 'dark') await tab.page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: wanted }]);
        await tab.frames(4);
        const upper = (await tab.picture(await tab.rectangle('iframe'))).crop(0, 0, 1, 0.5);
        const shown = upper.share((r, g, b) => r < 6 && Math.abs(g - 96) < 6 && Math.abs(b - 160) < 6);
        assert.ok(shown > 0.99, `${shown} of the iframe shows the page with the preference ${wanted}`);
      }
    });
  }

  test('reports why it cannot burn, in its iframe and to the embedding page', async () => {
    fixture.fireServer.replace({ 'hearth-engine_bg.wasm': { status: 404, body: 'gone' } });
    try {
      const tab = await fixture.open({ allow: fixture.pageOrigin });
      await received(tab, 'hello');
      const { ok, error } = await call(tab, 'ready');
      assert.deepEqual([ok, error.kind], [false, 'load']);
      const words = await inIframe(tab, (fire) => fire.shadowRoot.querySelector('[role=status]').textContent);
      assert.equal(words, error.message);
    } finally {
      fixture.fireServer.replace({});
    }
  });
});

describe('the client of the embedding page', () => {
  const script = (/** @type {string} */ body) => `<script type="module">
    import { connectFire } from '/web/embed-client.js';
    window.fire = connectFire(document.querySelector('iframe'));
    ${body}
  </script>`;

  test('offers methods and events before the fire is loaded', async () => {
    const tab = await fixture.open(
      { allow: fixture.pageOrigin },
      {
        more: script(`
      window.changes = [];
      window.early = fire.set('exposure', 1).then(() => fire.get('exposure'));
      fire.addEventListener('params-change', ({ detail }) => changes.push(detail.id));
      fire.addEventListener('ready', () => (window.reported = true));
    `),
      },
    );
    await tab.until('the client is there', () => 'fire' in window);
    assert.equal(await tab.evaluate(() => /** @type {any} */ (window).early), 1);
    const { value, refused } = await tab.evaluate(async () => {
      const { fire } = /** @type {any} */ (window);
      await fire.ready();
      await fire.set({ seed: 7, exposure: 2 });
      const error = await fire.set('exposure', 99).catch((reason) => reason);
      return { value: (await fire.params()).seed, refused: [error.name, error.id, error.max] };
    });
    assert.equal(value, 7);
    assert.deepEqual(refused, ['RangeError', 'exposure', entry.exposure.max]);
    await tab.until('its events come', () => {
      const { changes, reported } = /** @type {any} */ (window);
      return reported && changes.includes('seed') && changes.includes('exposure');
    });
    const { methods, same } = await tab.evaluate(async () => {
      const { fire } = /** @type {any} */ (window);
      const names = (await fire.call('hello')).methods;
      return { methods: names, same: names.filter((name) => typeof fire[name] === 'function') };
    });
    assert.deepEqual(
      same,
      methods.filter((name) => !['hello', 'subscribe', 'unsubscribe'].includes(name)),
    );
  });

  /** Ten seconds pass in half a second. */
  const hurry = `<script>
    const wait = setTimeout;
    window.setTimeout = (act, milliseconds) => wait(act, milliseconds / 20);
  </script>`;

  /** What has become of calls of the client: their values, or why they were refused; nothing if neither. */
  const outcomes = `
    window.outcome = (call) => Promise.race([
      call.catch((error) => error.message),
      new Promise((resolve) => setTimeout(resolve, 200_000, 'nothing')),
    ]);
    window.loads = (iframe) => new Promise((resolve) => iframe.addEventListener('load', resolve, { once: true }));`;

  test('rejects calls while the fire does not answer, until another page is loaded', async () => {
    const tab = await fixture.open({}, { more: hurry + script(outcomes) });
    await tab.until('the client is there', () => 'loads' in window);
    const [first, second, third] = await tab.evaluate(
      async (address) => {
        const { fire, outcome, loads } = /** @type {any} */ (window);
        const iframe = /** @type {HTMLIFrameElement} */ (document.querySelector('iframe'));
        const silent = [await outcome(fire.get('seed')), await outcome(fire.get('seed'))];
        iframe.src = address;
        await loads(iframe);
        return [...silent, await outcome(fire.option('quality'))];
      },
      fixture.address({ allow: fixture.pageOrigin, quality: 'low' }),
    );
    assert.match(first, new RegExp(`does not answer.*allow ${fixture.pageOrigin}`));
    assert.equal(second, first);
    assert.equal(third, 'low');
  });

  test('rejects calls while its iframe is removed, and works again when it is inserted', async () => {
    // A fire out of sight, which does nothing yet.
    const style = 'body { height: 9000px } iframe { position: absolute; top: 8000px }';
    const more = hurry + script(outcomes);
    const tab = await fixture.open({ allow: fixture.pageOrigin, loading: 'lazy', quality: 'low' }, { style, more });
    await received(tab, 'hello');
    const seen = await tab.evaluate(async () => {
      const { fire, outcome, loads } = /** @type {any} */ (window);
      const iframe = /** @type {HTMLIFrameElement} */ (document.querySelector('iframe'));
      await fire.option('quality');
      const open = outcome(fire.set('exposure', 1));
      iframe.remove();
      const gone = [await open, await outcome(fire.option('quality'))];
      document.body.append(iframe);
      await loads(iframe);
      const back = await outcome(fire.option('quality'));
      // To be moved is to be taken off and put back, in one.
      document.body.prepend(iframe);
      return [...gone, back, await outcome(fire.option('quality'))];
    });
    assert.deepEqual(seen, ['the iframe is not on a page', 'the iframe is not on a page', 'low', 'low']);
  });

  test('connects to a fire that has burnt for long, and to the next one in its iframe', async () => {
    const tab = await fixture.burning({}, { more: '<p>' });
    const numbers = await tab.evaluate(
      async (address) => {
        const load = (/** @type {string} */ url) => import(url);
        const { connectFire } = await load('/web/embed-client.js');
        const iframe = /** @type {HTMLIFrameElement} */ (document.querySelector('iframe'));
        const fire = connectFire(iframe);
        const first = await fire.get('seed');
        const loaded = new Promise((resolve) => iframe.addEventListener('load', resolve, { once: true }));
        iframe.src = address;
        await loaded;
        await fire.ready();
        const second = await fire.get('seed');
        fire.close();
        const closed = await fire.get('seed').catch((error) => error.message);
        return [first, second, closed];
      },
      fixture.address({ allow: fixture.pageOrigin, seed: '7' }),
    );
    assert.deepEqual(numbers, [entry.seed.default, 7, 'the connection is closed']);
  });
});
