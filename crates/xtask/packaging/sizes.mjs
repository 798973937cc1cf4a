/**
 * What a visitor downloads of the npm package or of the folder `web` of the site, as it is and as brotli of quality 11
 * makes it: `node sizes.mjs FOLDER`. A download that has grown over its record is a failure;
 * `node sizes.mjs FOLDER --write` records the sizes, in the documents too.
 */
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import { reached } from './graph.mjs';
import { beginningsOf } from './manifest.mjs';
import { compared, documented } from './size-record.mjs';

/** The recorded sizes [B], by download. */
const RECORD = new URL('../../../benches/sizes.json', import.meta.url);

/** The documents that name them. */
const DOCUMENTS = ['../../../README.md', '../../../docs/package.md', 'README.npm.md'].map(
  (file) => new URL(file, import.meta.url),
);

const [folder, option] = process.argv.slice(2);
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
const sound = [
  ...(await reached(folder, ['sound/player.js'])).filter((file) => !always.includes(file)),
  'wasm/hearth-engine_sound.wasm',
];
const films = [
  ...(await reached(folder, ['record.js', 'record/dialog.js'])).filter((file) => !always.includes(file)),
  'wasm/hearth-engine_films.wasm',
];
const requested = (await reached(folder, [ELEMENT], isEntry)).filter(
  (file) => ![...always, ...sound, ...films].includes(file),
);
const tools = await loaded('tools.js');
const plots = (await reached(folder, ['tools.js'], isEntry)).filter(
  (file) => ![...tools, ...always, ...requested].includes(file),
);

/** Files that a browser loads for one purpose. */
const DOWNLOADS = [
  { name: 'element and engine', files: always },
  { name: 'classic model, on request', files: ['wasm/hearth-engine_classic.wasm'] },
  { name: 'fuels, water and free solids, on request', files: ['wasm/hearth-engine_bodies.wasm'] },
  { name: 'children, on request', files: ['wasm/hearth-engine_children.wasm'] },
  { name: 'other scripts of the element, each on request', files: requested.filter((file) => !isPart(file)) },
  { name: 'sound, on request', files: sound },
  { name: 'films and their dialog, on request', files: films },
  { name: 'panel, on request', files: await loaded('panel.js') },
  { name: 'tools, on request', files: tools },
  { name: 'probe and plots of the tools, on request', files: plots },
  {
    name: 'a fire in three.js, without it and the engine',
    files: (await loaded('three.js')).filter((file) => !always.includes(file)),
  },
  {
    name: 'a fire in nodes of three.js, without it and the engine',
    files: (await loaded('three/webgpu.js')).filter((file) => !always.includes(file)),
  },
  { name: 'headless library', files: await loaded('sim.js') },
];

/** @type {{[name: string]: number}} */
const sizes = {};
for (const { name, files } of DOWNLOADS) {
  console.log(name);
  const sum = { raw: 0, small: 0 };
  // A stored fire is loaded with its scene only.
  for (const file of files.filter((file) => !file.endsWith('.fire'))) {
    const bytes = await readFile(path.join(folder, file));
    const small = brotliCompressSync(bytes).length;
    console.log(row(file, bytes.length, small));
    sum.raw += bytes.length;
    sum.small += small;
  }
  console.log(row('bytes, and compressed', sum.raw, sum.small));
  sizes[name] = sum.small;
}

if (option === '--write') {
  await writeFile(RECORD, `${JSON.stringify(sizes, undefined, 2)}\n`);
  for (const document of DOCUMENTS) await writeFile(document, documented(await readFile(document, 'utf8'), sizes));
  console.log('wrote benches/sizes.json, and the sizes in three documents');
}
const recorded = JSON.parse(await readFile(RECORD, 'utf8'));
const { grown, fallen } = compared(sizes, recorded);
for (const message of fallen) console.log(`smaller than recorded: ${message}; run \`cargo xtask size\``);
for (const message of grown) console.error(`larger than recorded: ${message}; \`cargo xtask size\` records it`);
if (grown.length > 0) process.exitCode = 1;

/** @type {(name: string, raw: number, small: number) => string} */
function row(name, raw, small) {
  return `  ${name.padEnd(32)}${String(raw).padStart(12)}${String(small).padStart(12)}`;
}
