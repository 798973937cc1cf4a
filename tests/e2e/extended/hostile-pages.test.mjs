/**
 * Pages with policies and several copies of the module, and pages without a network.
 *
 * These pages come from a server of their own: on the driver's, workers are wrapped.
 */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { Browser, THREAD, except } from '../driver.mjs';
import { assertBurns } from '../assertions.mjs';
import { Panel } from '../panel.mjs';
import { serve } from '../server.mjs';
import { SITE } from '../site.mjs';

/** @type {Browser} */
let browser;
/** @type {import('../server.mjs').Server} */
let site;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
  site = await serve(SITE);
});
after(async () => {
  await browser?.close();
  await site?.close();
});

/** A page without inline scripts and styles. */
const PAGE = `<!doctype html>
<meta charset="utf-8">
<title>A page with a policy</title>
<link rel="icon" href="data:,">
<script type="module" src="/web/hearth-fire.js"></script>
<hearth-fire quality="low"></hearth-fire>`;

/** Runs in the page: records what its policy forbids. */
function recordViolations() {
  const violations = [];
  /** @type {any} */ (window).violations = violations;
  document.addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI, sample }) => {
    violations.push(`${violatedDirective} ${blockedURI} ${sample}`);
  });
}

const violations = (tab) => tab.evaluate(() => /** @type {any} */ (window).violations);

/** Opens a page whose every file has this policy. @param {string} policy @param {string} [page] */
function under(policy, page = site.publish(PAGE, { 'content-security-policy': policy })) {
  site.replace({ '.js': { headers: { 'content-security-policy': policy } } });
  return browser.open(page, { before: recordViolations });
}

/** The fire burns there without a problem. @param {import('../driver.mjs').Tab} tab @param {string} thread */
async function assertBurnsIn(tab, thread) {
  await tab.burnt(0.3);
  assert.equal(await tab.fire((fire) => fire.stats.engine), thread);
  await assertBurns(tab);
}

const WATCHED = except({ webkit: "WebKitGTK's driver puts its scripts into pages of its own server alone" });

test('under the policy that the documents state, the fire burns in a worker', WATCHED, async () => {
  const text = readFileSync(new URL('../../../docs/embedding.md', import.meta.url), 'utf8');
  const [, policy] = /```http\nContent-Security-Policy: (.*)\n```/.exec(text) ?? [];
  const tab = await under(policy);
  await assertBurnsIn(tab, THREAD);
  // The icon of the test's page is none of the fire's.
  assert.deepEqual(
    (await violations(tab)).filter((violation) => !violation.startsWith('img-src')),
    [],
  );
});

test('each rule of the documented policy is needed', async () => {
  const scripts = "script-src 'self' 'wasm-unsafe-eval'";
  const failed = await under(`default-src 'none'; ${scripts}; worker-src 'self'`);
  assert.equal(
    await failed.fire((fire) =>
      fire.ready.then(
        () => '',
        ({ kind }) => kind,
      ),
    ),
    'load',
  );
  const rest = `default-src 'none'; ${scripts}; connect-src 'self'`;
  await assertBurnsIn(await under(`${rest}; worker-src 'none'`), 'main');
  const trusted = `${rest}; worker-src 'self'; require-trusted-types-for 'script'`;
  await assertBurnsIn(await under(`${trusted}; trusted-types other`), 'main');
});

test('under that policy glyphs and images count by their pixels, and an SVG element by its box', WATCHED, async () => {
  const text = readFileSync(new URL('../../../docs/embedding.md', import.meta.url), 'utf8');
  const [, policy] = /```http\nContent-Security-Policy: (.*)\n```/.exec(text) ?? [];
  const page = PAGE.replace(
    '</hearth-fire>',
    '<hearth-solid of="#word" of-text></hearth-solid><hearth-solid of="#drawing"></hearth-solid><hearth-solid of="#canvas"></hearth-solid></hearth-fire>',
  ).concat(
    '<h1 id="word">Fire</h1><canvas id="canvas" width="20" height="20"></canvas><svg id="drawing" viewBox="0 0 10 10"><circle r="5"/></svg>',
  );
  const tab = await under(policy, site.publish(page, { 'content-security-policy': policy }));
  await tab.ready();
  await tab.evaluate(() =>
    /** @type {HTMLCanvasElement} */ (document.querySelector('#canvas')).getContext('2d')?.fillRect(5, 5, 9, 9),
  );
  await tab.fire((fire) => fire.lastElementChild.setAttribute('of', '#canvas'));
  await tab.until('each has its shape', () => {
    const { objects } = /** @type {any} */ (document.querySelector('hearth-fire'));
    return (
      objects
        .slice(1)
        .map(({ shape }) => shape)
        .join() === 'mask,box,mask'
    );
  });
  assert.deepEqual(
    (await violations(tab)).filter((violation) => !violation.startsWith('img-src data')),
    [],
  );
  assert.ok(
    tab.problems.some((problem) =>
      /of = #drawing counts as a box: the policy of the page forbids data: images/.test(problem),
    ),
    tab.problems.join('\n'),
  );
});

for (const page of ['index.html', 'web/embed.html']) {
  test(`${page} keeps its own policy, which requires trusted types`, WATCHED, async () => {
    site.replace({});
    const tab = await browser.open(`${site.origin}/${page}`, { before: recordViolations, width: 1000, height: 640 });
    await assertBurnsIn(tab, THREAD);
    assert.ok(
      await tab.evaluate(() => {
        const html = document.head.innerHTML;
        try {
          document.body.innerHTML = '<p>';
          return false;
        } catch {
          return html.includes("require-trusted-types-for 'script'");
        }
      }),
      'the browser requires trusted types',
    );
    if (page === 'index.html') {
      await new Panel(tab).mounted();
      await tab.fire((fire) => fire.toBlob());
      await tab.page.$eval('[data-opens=embed]', (button) => button.click());
      await tab.until('the dialog is open', () => document.querySelector('#embed')?.matches('[open]'));
      await tab.page.$eval('#embed form button', (button) => button.click());
      await tab.until('the dialog is closed', () => !document.querySelector('#embed')?.matches('[open]'));
    }
    const others = (await violations(tab)).filter((violation) => !violation.includes('Element innerHTML'));
    assert.deepEqual(others, []);
  });
}

test('of several copies of the module the first stays, and the others export its class', async () => {
  site.replace({});
  const tab = await browser.open(site.publish(PAGE));
  await tab.ready();
  const found = await tab.evaluate(async () => {
    const warnings = [];
    const { warn } = console;
    console.warn = (text) => void warnings.push(text);
    const [first, second] = [
      await import(/** @type {any} */ ('/web/hearth-fire.js')),
      await import(/** @type {any} */ ('/web/hearth-fire.js?2')),
    ];
    console.warn = warn;
    const made = document.createElement('hearth-fire');
    return {
      same: first.HearthFire === second.HearthFire,
      made: made instanceof second.HearthFire,
      version: second.HearthFire.version,
      warnings,
    };
  });
  assert.deepEqual([found.same, found.made], [true, true]);
  assert.match(found.version, /^\d+\.\d+\.\d+/);
  assert.equal(found.warnings.length, 1);
  assert.equal(found.warnings[0].split(found.version).length, 3, `it names both versions: ${found.warnings[0]}`);
});

test('an element of that name by another author stays, with a warning in the console', WATCHED, async () => {
  const tab = await browser.open(
    site.publish(
      PAGE.replace(
        '</title>',
        `</title>
    <script>customElements.define('hearth-fire', class extends HTMLElement {});</script>`,
      ),
    ),
  );
  await tab.frames(2);
  await tab.until('the element is defined', () => customElements.get('hearth-fire') !== undefined);
  assert.deepEqual(
    tab.problems.filter((problem) => problem.startsWith('uncaught')),
    [],
  );
  assert.ok(
    tab.problems.some((problem) => /defined already/.test(problem)),
    `${tab.problems}`,
  );
});

test('a new engine needs no second download of the wasm', WATCHED, async () => {
  site.replace({});
  const tab = await browser.open(site.publish(PAGE), {
    before: () => {
      // The life of an engine without fires.
      const { setTimeout } = window;
      window.setTimeout = /** @type {any} */ (
        (act, time, ...rest) => {
          const ends = time === 5000 && /** @type {any} */ (window).ends;
          return setTimeout(act, ends ? 0 : time, ...rest);
        }
      );
      // Ended workers.
      const { terminate } = Worker.prototype;
      Worker.prototype.terminate = function ended() {
        /** @type {any} */ (window).ended = true;
        terminate.call(this);
      };
    },
  });
  await tab.burnt(0.2);
  await tab.evaluate(async () => {
    /** @type {any} */ (window).ends = true;
    const removed = /** @type {any} */ (document.querySelector('hearth-fire'));
    await removed.destroy();
    removed.remove();
    /** @type {any} */ (window).removed = removed;
  });
  await tab.until('the engine has ended', () => /** @type {any} */ (window).ended);
  site.replace({ 'hearth-engine_bg.wasm': { drop: true } });
  await tab.evaluate(() => {
    const page = /** @type {any} */ (window);
    page.ends = false;
    document.body.append(page.removed);
  });
  await assertBurnsIn(tab, THREAD);
  site.replace({});
});
