/**
 * Pages with a strict content security policy.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { serve } from '../e2e/server.mjs';
import { copied } from './package.mjs';
import { browser, burnsWell, opensScenes } from './pages.mjs';

const OTHERS = "worker-src 'self'; connect-src 'self'; style-src 'self'; img-src 'self'; report-uri /report";

const { open } = browser();
/** @type {import('../e2e/server.mjs').Server} */
let site;
/** What the site did not serve. @type {string[]} */
const refused = [];

before(async () => {
  site = await serve(await copied());
  site.refused = (problem) => refused.push(problem);
});
after(() => site?.close());

/**
 * Every file comes with the policy: a worker obeys that of its own script.
 * @param {string} scripts
 * @param {Parameters<typeof site.replace>[0]} [others]
 */
function under(scripts, others = {}) {
  const policy = `default-src 'none'; script-src ${scripts}; ${OTHERS}`;
  site.replace({ ...others, '': { headers: { 'content-security-policy': policy } } });
  refused.length = 0;
  return open(`${site.origin}/strict.html`);
}

test('a strict policy that allows wasm is kept, by the worker too', async () => {
  const tab = await under("'self' 'wasm-unsafe-eval'");
  await burnsWell(tab);
  assert.deepEqual(await tab.evaluate(() => /** @type {any} */ (window).violations), []);
  assert.deepEqual(refused, [], 'the browser reported a violation');
});

test('a strict policy is kept by the scenes of the panel, with their pictures or without', async () => {
  const tab = await under("'self' 'wasm-unsafe-eval'", { '/candle.jpg': { drop: true } });
  await tab.ready();
  await tab.fire((fire) => {
    fire.style.cssText = 'width: 640px; height: 480px';
    fire.setAttribute('controls', '');
  });
  await opensScenes(tab);
  // Pictures are loaded where they are seen: one, and then the other.
  await tab.until('one picture is there', () => {
    const root = document.querySelector('hearth-fire')?.shadowRoot;
    const picture = /** @type {HTMLImageElement} */ (root?.querySelector('[data-scene=default] img'));
    return picture.naturalWidth > 0;
  });
  await tab.fire((fire) => fire.shadowRoot.querySelector('[data-scene=candle]').scrollIntoView());
  await tab.until('the other is known to be missing', () =>
    document.querySelector('hearth-fire')?.shadowRoot?.querySelector('[data-scene=candle].bare'),
  );
  await tab.frames(5);
  assert.deepEqual(await tab.evaluate(() => /** @type {any} */ (window).violations), []);
  assert.deepEqual(
    refused.filter((problem) => problem.endsWith('/report')),
    [],
  );
});

test('a policy without wasm causes an error, the poster and a message', async () => {
  const tab = await under("'self'");
  const failures = await tab.until('the fire reports its failure', () => {
    const { failures } = /** @type {any} */ (window);
    return failures.length > 0 && failures;
  });
  assert.deepEqual(
    failures.map(({ kind }) => kind),
    ['load'],
  );
  await tab.until('poster and words are shown', () => {
    const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
    const poster = fire.shadowRoot.querySelector('.poster img');
    const message = fire.shadowRoot.querySelector('[part=message]');
    return (
      poster.complete &&
      poster.checkVisibility() &&
      poster.clientWidth > 0 &&
      message.checkVisibility() &&
      message.textContent.length > 20
    );
  });
  assert.equal(
    await tab.fire((fire) =>
      fire.ready.then(
        () => '',
        (error) => error.kind,
      ),
    ),
    'load',
  );
  // So the site above would have reported a violation.
  assert.deepEqual(await tab.evaluate(() => /** @type {any} */ (window).violations), ['script-src wasm-eval']);
  await tab.frames(5);
  assert(
    refused.some((problem) => problem.endsWith('/report')),
    'the browser reported no violation',
  );
  const uncaught = tab.problems.filter((problem) => problem.startsWith('uncaught'));
  assert.deepEqual(uncaught, []);
});
