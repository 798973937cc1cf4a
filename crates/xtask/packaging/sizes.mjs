/**
 * What a visitor downloads, as it is and as brotli of quality 11 makes it: `node sizes.mjs
 * FOLDER`, the npm package or the folder `web` of the site. A download over its ceiling is a
 * failure.
 */
import { readFile, stat } from 'node:fs/promises';
import path from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import { reached } from './graph.mjs';
import { beginningsOf } from './manifest.mjs';

const [folder] = process.argv.slice(2);
const manifest = JSON.parse(await readFile(path.join(folder, 'package.json'), 'utf8'));
const entryFiles = beginningsOf(manifest).map((script) => path.posix.normalize(script));

/** Other entry points, which nothing loads by itself. */
const isEntry = (file) => entryFiles.includes(file);
/** Scripts that are imported only on request; the scripts of wasm always follow. */
const onRequest = (file) => isEntry(file) || !file.startsWith('wasm/');
/** Parts of wasm, which are fetched on request. */
const isPart = (file) => /^wasm\/[\w-]+_(?!bg\.)\w+\.wasm$/.test(file);
/** The files that `entry` always loads. */
const loaded = async (entry) => (await reached(folder, [entry], onRequest)).filter((file) => !isPart(file));

const ELEMENT = 'hearth-fire.js';
const always = await loaded(ELEMENT);
const requested = (await reached(folder, [ELEMENT], isEntry)).filter((file) => !always.includes(file));
const tools = await loaded('tools.js');
const plots = (await reached(folder, ['tools.js'], isEntry)).filter((file) => ![...tools, ...always, ...requested].includes(file));

/** Files that a browser loads for one purpose; without a ceiling they are only printed. */
const DOWNLOADS = [
  { name: 'element and engine', files: always, ceiling: 120_000 },
  { name: "element's rest, each on request", files: requested, ceiling: 75_200 },
  { name: 'headless library', files: await loaded('sim.js'), ceiling: 66_200 },
  { name: 'library\'s rest, on request', files: (await reached(folder, ['sim.js'])).filter(isPart), ceiling: 55_000 },
  { name: 'panel, on request', files: await loaded('panel.js'), ceiling: 816_500 },
  { name: 'tools, on request', files: tools, ceiling: 30_000 },
  { name: 'probe and plots, on request', files: plots, ceiling: 6_000 },
  { name: 'all of the element in one file', files: await present('hearth-fire.inline.js'), ceiling: Infinity },
];

for (const { name, files, ceiling } of DOWNLOADS) {
  console.log(name);
  const sum = { raw: 0, small: 0 };
  // A stored fire is loaded with its scene only.
  for (const file of files.filter((one) => !one.endsWith('.fire'))) {
    const bytes = await readFile(path.join(folder, file));
    const small = brotliCompressSync(bytes).length;
    console.log(row(file, bytes.length, small));
    sum.raw += bytes.length;
    sum.small += small;
  }
  console.log(row('bytes, and compressed', sum.raw, sum.small) + (ceiling < Infinity ? ` of at most ${ceiling}` : ''));
  if (sum.small > ceiling) {
    console.error(`too large to download: ${name}`);
    process.exitCode = 1;
  }
}

/** @type {(name: string, raw: number, small: number) => string} */
function row(name, raw, small) {
  return `  ${name.padEnd(32)}${String(raw).padStart(12)}${String(small).padStart(12)}`;
}

/** The file, where this folder has it. @param {string} file */
async function present(file) {
  return stat(path.join(folder, file)).then(() => [file], () => []);
}
