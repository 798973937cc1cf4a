/**
 * Makes the npm package of the built site: `node build.mjs SITE OUT VERSION`.
 *
 * `SITE` is the site's folder of scripts, with its wasm; the package contains what
 * its entry points reach there, and no more. The compiler declares the types of `tsconfig.json`. `cargo xtask package` runs this.
 */
import { execFileSync } from 'node:child_process';
import { appendFile, copyFile, mkdir, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { pictures, reached, typesReached } from './graph.mjs';
import { inlined } from './inline.mjs';
import { DOCS, beginningsOf, packageJson, typesOf } from './manifest.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));
const ROOT = path.resolve(HERE, '../../..');

/** Files of the checkout that the package carries under another name. */
const CARRIED = {
  'LICENSE-MIT': 'LICENSE-MIT',
  'LICENSE-APACHE': 'LICENSE-APACHE',
  // The panel draws its text with this font, whose licence must accompany it.
  'crates/hearth-panel/font/LICENCE.txt': 'LICENSE-FONT',
  'crates/xtask/packaging/README.npm.md': 'README.md',
};

const [site, out, version] = process.argv.slice(2);
if (!version) throw new Error('usage: node build.mjs SITE OUT VERSION');

const source = JSON.parse(await readFile(path.join(site, 'package.json'), 'utf8'));
const built = packageJson(source, version);
const code = await reached(site, beginningsOf(source));

await rm(out, { recursive: true, force: true });
const shown = await pictures(site);
for (const file of [...code, ...(await declarations(site)), ...shown, 'THIRD-PARTY.txt', 'hearth-fire.cdx.json']) {
  await put(path.join(site, file), file);
}
await declare();
for (const [from, to] of Object.entries(CARRIED)) {
  await put(path.join(ROOT, from), to);
}
for (const name of DOCS) {
  const text = await readFile(path.join(ROOT, name), 'utf8');
  await mkdir(path.join(out, path.dirname(name)), { recursive: true });
  await writeFile(path.join(out, name), withoutLinksOut(name, text));
}
await writeFile(path.join(out, 'package.json'), `${JSON.stringify(built, null, 2)}\n`);
await writeFile(
  path.join(out, 'hearth-fire.inline.js'),
  await inlined(path.join(ROOT, 'web'), path.join(out, 'wasm'), built),
);

// For tools that read no `exports`, which look for a file or a folder of that name.
await mkdir(path.join(out, 'inline'));
const inline = { main: '../hearth-fire.inline.js', types: '../hearth-fire.d.ts', type: 'module', sideEffects: true };
await writeFile(path.join(out, 'inline/package.json'), `${JSON.stringify(inline, null, 2)}\n`);

/** Writes the types that follow from scripts, and removes what no entry point reaches. */
async function declare() {
  const run = (/** @type {string[]} */ ...program) => execFileSync(process.execPath, program, { stdio: 'inherit' });
  const compiler = path.join(HERE, '../scripts/node_modules/typescript/bin/tsc');
  run(compiler, '--project', HERE, '--outDir', out);
  await appendFile(
    path.join(out, 'hearth-fire.d.ts'),
    "export type * from './element/types.js';\nexport type * from './parameters.js';\n",
  );
  run(path.join(ROOT, 'crates/codegen/element.mjs'), out);
  const needed = await typesReached(out, typesOf(source));
  for (const file of await declarations(out)) if (!needed.includes(file)) await rm(path.join(out, file));
}

/** The files of types below a folder. @param {string} folder */
async function declarations(folder) {
  const files = await readdir(folder, { recursive: true });
  return files.map((file) => file.replaceAll('\\', '/')).filter((file) => /\.d\.c?ts$/.test(file));
}

/** @type {(from: string, to: string) => Promise<void>} */
async function put(from, to) {
  const target = path.join(out, to);
  await mkdir(path.dirname(target), { recursive: true });
  await copyFile(from, target);
}

/**
 * A document whose links into the rest of the checkout are their labels only, without the pictures there; `web/` of
 * the checkout is the package itself.
 * @param {string} name @param {string} text
 */
function withoutLinksOut(name, text) {
  const inside = text.replaceAll('](../web/', '](../');
  return inside.replace(/(!?)\[([^\]]*)\]\(([^)#:]+)(?:#[^)]*)?\)/g, (link, picture, label, to) => {
    if ([...DOCS, ...shown].includes(path.posix.join(path.posix.dirname(name), to))) return link;
    return picture ? '' : label;
  });
}
