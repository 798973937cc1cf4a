/**
 * Measures steps in Node and in headless Chromium and prints one JSON:
 * `{machine, browser, results: [{where, scene, particles, …}]}`.
 *
 * `HEARTH_BENCH` names the folder with the wasm-bindgen output of this package
 * (`hearth_benches.js`, `--target web`), `HEARTH_CHROMIUM` the browser, and
 * `HEARTH_SITE` a built site if the page's own figures are wanted as well. An
 * argument names a file to write to instead of the standard output.
 */
import { readFile, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Browser } from '../../tests/e2e/driver.mjs';
import { measureHearth, measurePaper } from './measure.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));

/** Measures in this process. */
async function inNode(folder) {
  const module = await import(pathToFileURL(path.join(folder, 'hearth_benches.js')).href);
  const bytes = await readFile(path.join(folder, 'hearth_benches_bg.wasm'));
  await module.default({ module_or_path: bytes });
  return [...measureHearth(module.Scene), ...measurePaper()];
}

/** Measures in a page of headless Chromium. */
async function inChromium(browser) {
  const tab = await browser.open('<p>Measuring</p>');
  return tab.evaluate(async () => {
    const load = (/** @type {string} */ url) => import(url);
    const module = await load('/hearth_benches.js');
    const measure = await load('/measure.mjs');
    await module.default();
    return [...measure.measureHearth(module.Scene), ...measure.measurePaper()];
  });
}

/** What the page's own statistics say after some seconds of fire. */
async function onThePage(site) {
  const browser = await Browser.launch(site);
  try {
    const tab = await browser.open('index.html', { width: 1280, height: 720 });
    await tab.burnt(10);
    return await tab.fire((fire) => fire.stats);
  } finally {
    await browser.close();
  }
}

const folder = process.env.HEARTH_BENCH;
if (!folder) throw new Error('HEARTH_BENCH must name the folder with hearth_benches.js');

const node = await inNode(folder);
const browser = await Browser.launch(folder, HERE);
let chromium;
let version;
try {
  chromium = await inChromium(browser);
  version = await browser.browser.version();
} finally {
  await browser.close();
}
const page = process.env.HEARTH_SITE ? await onThePage(process.env.HEARTH_SITE) : undefined;

const [processor] = os.cpus();
const report = `${JSON.stringify(
  {
    machine: {
      processor: processor.model.trim(),
      cores: os.cpus().length,
      system: `${os.type()} ${os.arch()}`,
    },
    node: process.version,
    browser: version,
    results: [
      ...node.map((row) => ({ where: 'node', ...row })),
      ...chromium.map((row) => ({ where: 'chromium', ...row })),
    ],
    page,
  },
  null,
  2,
)}\n`;
if (process.argv[2]) await writeFile(process.argv[2], report);
else process.stdout.write(report);
