/**
 * Draws golden pictures: `node write.mjs`, or `node write.mjs default seed` for some, by
 * the beginnings of their names. `cargo xtask goldens` runs this.
 */
import { readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { drawn, file, requests } from './goldens.mjs';
import { encode } from './sheet.mjs';
import { GOLDENS, Painter, named } from './painter.mjs';

/** Most bytes of one picture, and of all that lies in the folder. */
const [LARGEST, ALL] = [50_000, 1_000_000];

const begins = process.argv.slice(2);
const painter = new Painter();
const all = await requests(painter);
try {
  const wanted = named(Object.keys(all), begins, 'picture');
  for (const name of wanted) {
    const png = encode(await drawn(painter, all[name]));
    if (png.length > LARGEST) throw new Error(`${name}.png takes ${png.length} bytes, more than ${LARGEST}`);
    writeFileSync(file(name), png);
    console.log(`${name}.png: ${(png.length / 1000).toFixed(1)} KB`);
  }
} finally {
  await painter.close();
}

// Removes the files of cases that no longer exist.
for (const found of readdirSync(GOLDENS).filter((name) => name.endsWith('.png'))) {
  if (!(path.parse(found).name in all)) rmSync(path.join(GOLDENS, found));
}
const files = readdirSync(GOLDENS);
const bytes = files.reduce((sum, name) => sum + statSync(path.join(GOLDENS, name)).size, 0);
console.log(`${files.length} files, ${(bytes / 1000).toFixed(0)} KB`);
if (bytes > ALL) throw new Error(`that is more than ${ALL} bytes`);
