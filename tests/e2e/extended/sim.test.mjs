/**
 * The simulation library in a page: the same bits as in Node in every browser, and the
 * examples that draw it.
 */
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, symlinkSync } from 'node:fs';
import { mkdir } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { burnEverything } from '../../sim/fingerprint.mjs';
import { Browser, eventually } from '../driver.mjs';
import { SITE } from '../site.mjs';

const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../..');
const EXAMPLES = path.join(ROOT, 'examples');

/** A checkout whose site is the one under test. */
const tree = mkdtempSync(path.join(tmpdir(), 'hearth-examples-'));
before(async () => {
  await mkdir(path.join(tree, 'dist'));
  symlinkSync(SITE, path.join(tree, 'dist/site'), 'junction');
  symlinkSync(EXAMPLES, path.join(tree, 'examples'), 'junction');
});
after(() => rmSync(tree, { recursive: true }));

const { createSimulation } = await import(pathToFileURL(path.join(SITE, 'web/sim.js')).href);

/** What Node makes of it. */
const inNode = burnEverything(createSimulation);

/** What a browser looks at: the site, and beside it what a page does with it. */
const FOLDERS = [SITE, path.join(ROOT, 'tests/sim')];

const PAGE = `<!doctype html>
  <meta charset="utf-8"><title>The library</title><link rel="icon" href="data:,">
  <script type="module" src="/page.mjs"></script>`;

/** What the page's script has come to. */
function outcome(/** @type {any} */ tab) {
  return tab.until('the page has burnt everything, or failed', () => window.prints ?? window.failure);
}

test('a page burns the same bits as Node', async () => {
  const browser = await Browser.launch(...FOLDERS);
  try {
    const tab = await browser.open(PAGE);
    assert.deepEqual(await outcome(tab), await inNode);
    assert.deepEqual(await tab.problemsAfterFrame(), []);
  } finally {
    await browser.close();
  }
});

test('the library loads with a policy that allows wasm, and else rejects with the reason', async () => {
  const wasm = 'hearth-sim_bg.wasm';
  const policy = (/** @type {string} */ scripts) => ({
    'content-security-policy': `default-src 'self'; img-src data:; script-src ${scripts}`,
  });
  const good = [{ headers: policy("'self' 'wasm-unsafe-eval'") }, { files: { [wasm]: { type: 'text/plain' } } }];
  /** @type {[object, RegExp][]} */
  const bad = [
    [{ headers: policy("'self'") }, /could not be loaded: CompileError/],
    [{ files: { [wasm]: { status: 404, body: 'no' } } }, /could not be loaded: Error: .* answers 404/],
    [{ files: { [wasm]: { keep: 1000 } } }, /could not be loaded: CompileError/],
    [{ without: wasm }, /could not be loaded: TypeError/],
    [{ files: { 'wasm/hearth-sim.js': { status: 404, body: 'no' } } }, /could not be loaded: TypeError/],
  ];
  const browser = await Browser.launch(...FOLDERS);
  try {
    for (const options of good) {
      assert.deepEqual(await outcome(await browser.open(PAGE, options)), await inNode);
    }
    for (const [options, words] of bad) {
      const tab = await browser.open(PAGE, options);
      assert.match(await outcome(tab), words);
      const unheard = (await tab.problemsAfterFrame()).filter((problem) => /uncaught/.test(problem));
      assert.deepEqual(unheard, []);
    }
  } finally {
    await browser.close();
  }
});

test('no call of a simulation loads anything', async () => {
  const browser = await Browser.launch(...FOLDERS);
  try {
    const tab = await browser.open('<!doctype html><link rel="icon" href="data:,">');
    const [before, after, ...done] = await tab.evaluate(async () => {
      const { createSimulation } = await import(/** @type {any} */ ('/web/sim.js'));
      const requests = () => performance.getEntriesByType('resource').length;
      const sim = await createSimulation();
      const before = requests();
      const log = sim.addObject({ kind: 'solid', fuel: 'wood', motion: 'free', y: 0.5 });
      sim.spray(0, 1);
      sim.ignite(log);
      sim.advance(0.05);
      const done = [sim.fuels().length, sim.freeSolids().length];
      sim.set('model', 'classic');
      sim.advance(0.05);
      return [before, requests(), ...done, sim.get('model')];
    });
    assert.equal(after, before);
    assert.deepEqual(done, [1, 1, 'classic']);
  } finally {
    await browser.close();
  }
});

/** Burns on until the lower middle of the window glows; and it moves. */
async function burns(/** @type {any} */ tab) {
  const middle = async () => (await tab.picture()).crop(0.25, 0.4, 0.75, 1);
  const glows = (/** @type {any} */ picture) => picture.glowing() >= 0.02;
  const picture = await eventually(
    'the lower middle glows',
    middle,
    glows,
    () => tab.frames(4),
    (dark) => dark.glowing(),
  );
  await tab.frames(12);
  const moved = picture.difference(await middle());
  assert.ok(moved > 0.2, `the picture moved by ${moved}`);
  assert.deepEqual(await tab.problemsAfterFrame(), []);
}

test('the example in Canvas 2D burns in the built site', async () => {
  const browser = await Browser.launch();
  try {
    const tab = await browser.open('examples/canvas-2d.html', { width: 300, height: 450 });
    await burns(tab);
  } finally {
    await browser.close();
  }
});

const DOC = readFileSync(path.join(ROOT, 'docs/simulation.md'), 'utf8');
const SAMPLES = [...DOC.matchAll(/```html\n([\s\S]*?)```/g)].map(([, html]) => html);

test('the documentation names every member of the library, each in an example and in the types', async () => {
  const sim = await createSimulation();
  const members = Object.getOwnPropertyNames(Object.getPrototypeOf(sim));
  const has = members.filter((name) => name !== 'constructor');
  const refused = await createSimulation({ '': 1 }).catch((error) => error.message);
  const options = refused.split('there are ')[1].split(', ');
  const rows = [...DOC.matchAll(/^\| (`[^|]*) \|/gm)].map(([, cell]) => cell);
  const named = rows.flatMap((cell) => [...cell.matchAll(/`(\w+)/g)].map(([, name]) => name));
  const sorted = (/** @type {string[]} */ names) => [...new Set(names)].sort();
  assert.deepEqual(sorted(named), sorted(['createSimulation', ...has, ...options]));
  const types = readFileSync(path.join(SITE, 'web/sim.d.ts'), 'utf8');
  for (const name of named) {
    assert.match(SAMPLES.join('\n'), new RegExp(`\\b${name}\\b`));
    assert.match(types, new RegExp(`\\b${name}\\b\\??[(:<]`));
  }
  // Node and browsers that support `using` end a simulation with it; so do the types.
  assert.match(DOC, /`using sim = /);
  assert.match(types, /^ {2}\[Symbol\.dispose\]\(\): void;$/m);
});

test('every example of the documentation runs, and prints or draws something', async () => {
  assert.ok(SAMPLES.length > 0);
  const browser = await Browser.launch();
  try {
    const frames = SAMPLES.map(
      (html) => `<iframe width="380" height="280" src="${browser.server.publish(html)}"></iframe>`,
    );
    const tab = await browser.open(`<!doctype html><link rel="icon" href="data:,">${frames.join('')}`, {
      width: 1200,
      height: 900,
    });
    for (const [at, element] of (await tab.page.$$('iframe')).entries()) {
      const frame = await element.contentFrame();
      await frame
        .waitForFunction(() => {
          const canvas = document.querySelector('canvas');
          if (!canvas) return (document.querySelector('#out') ?? document.body).innerText;
          const { width, height } = canvas;
          const blank = Object.assign(document.createElement('canvas'), { width, height });
          return canvas.toDataURL() !== blank.toDataURL();
        })
        .catch((error) => assert.fail(`example ${at + 1} prints and draws nothing: ${error.message}`));
      await frame.evaluate(() => {
        for (const button of document.querySelectorAll('button')) button.click();
      });
    }
    await tab.frames(10);
    assert.deepEqual(await tab.problemsAfterFrame(), []);
  } finally {
    await browser.close();
  }
});
