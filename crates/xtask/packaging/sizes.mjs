/**
 * What a visitor of somebody who uses the package downloads, as it is and as
 * brotli of quality 11 makes it: `node sizes.mjs PACKAGE`. Too much is a failure.
 */
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import { reached } from './graph.mjs';
import { beginningsOf } from './manifest.mjs';

const [folder] = process.argv.slice(2);
const manifest = JSON.parse(await readFile(path.join(folder, 'package.json'), 'utf8'));
const entryFiles = beginningsOf(manifest).map((script) => path.posix.normalize(script));

/** What the element loads only where somebody asks for it. */
const ASKED_FOR = ['element/scale.js', 'engine/main-thread.js', 'element/settings-file.js', 'element/pointer.js', 'element/spelling.js', 'element/transition.js'];

/** Files that one need makes a browser load together; without a ceiling they are only told. */
const DOWNLOADS = [
  { name: 'element and engine', entry: 'hearth-fire.js', ceiling: 107_500 },
  { name: 'bar of colours, on request', entry: 'element/scale.js', ceiling: 3_000 },
  { name: 'pointer, on request', entry: 'element/pointer.js', ceiling: 2_000 },
  { name: 'headless library', entry: 'sim.js', ceiling: 60_000 },
  { name: 'panel, on request', entry: 'panel.js', ceiling: 850_000 },
  { name: 'all of the element in one file', entry: 'hearth-fire.inline.js', ceiling: Infinity },
];

for (const { name, entry, ceiling } of DOWNLOADS) {
  const isLater = (file) => entryFiles.includes(file) || ASKED_FOR.includes(file);
  const found = entry.endsWith('.inline.js') ? [entry] : await reached(folder, [entry], isLater);
  // A kept fire comes with its scene alone.
  const files = found.filter((file) => !file.startsWith('burning/'));
  console.log(name);
  const sum = { raw: 0, small: 0 };
  for (const file of files) {
    const bytes = await readFile(path.join(folder, file));
    const small = brotliCompressSync(bytes).length;
    console.log(`  ${file.padEnd(32)}${String(bytes.length).padStart(12)}${String(small).padStart(12)}`);
    sum.raw += bytes.length;
    sum.small += small;
  }
  const limit = ceiling < Infinity ? ` of at most ${ceiling}` : '';
  console.log(`  ${'bytes, and compressed'.padEnd(32)}${String(sum.raw).padStart(12)}${String(sum.small).padStart(12)}${limit}`);
  if (sum.small > ceiling) {
    console.error(`too large to download: ${name}`);
    process.exitCode = 1;
  }
}
