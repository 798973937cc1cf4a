/**
 * Makes the scripts and style sheets of the site small, each in its place:
 * `node minify.mjs FOLDER`, the folder with `package.json`. A visitor downloads code;
 * comments, long names and blanks are for those who read it in the checkout.
 *
 * A script that only one other needs goes into that one: fewer files to fetch, and
 * they compress better together. What the package exports, a page or a worker begins
 * with, or is only loaded when asked stays a file, and so do what several need and
 * what looks whether it bears its own name. Properties keep their names, and licences
 * stay.
 */
import { readFile, readdir, rm } from 'node:fs/promises';
import path from 'node:path';
import { beginningsOf } from '../packaging/manifest.mjs';
import { build } from './esbuild.mjs';

const folder = path.resolve(process.argv[2] ?? '');
const manifest = JSON.parse(await readFile(path.join(folder, 'package.json'), 'utf8'));
const all = await filesOf('');
const scripts = all.filter((file) => file.endsWith('.js'));

const COMMON = { absWorkingDir: folder, format: 'esm', bundle: true, logLevel: 'warning' };

/** Into which file each script goes. */
const owners = await ownersOf();
await build({
  ...COMMON,
  entryPoints: all.filter((file) => owners.get(file) === file || file.endsWith('.css')),
  outdir: folder,
  outbase: folder,
  allowOverwrite: true,
  minify: true,
  charset: 'utf8',
  target: 'es2022',
  legalComments: 'inline',
  plugins: [{ name: 'owners', setup: ({ onResolve }) => onResolve({ filter: /.*/ }, resolved) }],
});
for (const [file, owner] of owners) if (owner !== file) await rm(path.join(folder, file));

/**
 * Lets esbuild follow an import only inside one owner.
 * @param {import('esbuild').OnResolveArgs} asked
 */
function resolved({ path: name, kind, importer, resolveDir }) {
  if (kind === 'entry-point') return undefined;
  const [from, to] = [importer, path.join(resolveDir, name)].map((file) => posix(path.relative(folder, file)));
  return owners.get(from) === owners.get(to) && owners.has(to) ? undefined : { path: name, external: true };
}

/** @returns {Promise<Map<string, string>>} */
async function ownersOf() {
  const { metafile } = await build({
    ...COMMON, entryPoints: scripts, outdir: folder, write: false, metafile: true, external: ['node:*'],
  });
  const own = new Set(beginningsOf(manifest).map((file) => path.posix.normalize(file)));
  for (const file of scripts) {
    const text = await readFile(path.join(folder, file), 'utf8');
    if (text.includes(path.basename(file).replace('.', '\\.'))) own.add(file);
  }
  /** @type {Map<string, string[]>} */
  const importers = new Map(scripts.map((file) => [file, []]));
  for (const [from, { imports }] of Object.entries(metafile.inputs)) {
    for (const { path: to, kind } of imports) {
      // What a file names beside itself is beside its owner only in the same folder.
      if (kind === 'dynamic-import' || path.dirname(from) !== path.dirname(to)) own.add(to);
      importers.get(to)?.push(from);
    }
  }
  const found = new Map(scripts.map((file) => [file, file]));
  for (let changed = true; changed;) {
    changed = false;
    for (const [file, by] of importers) {
      const wanting = new Set(by.map((from) => found.get(from)));
      const [owner] = wanting;
      if (own.has(file) || wanting.size !== 1 || found.get(file) === owner) continue;
      found.set(file, /** @type {string} */ (owner));
      changed = true;
    }
  }
  return found;
}

/** Every file below a folder of the site. @type {(below: string) => Promise<string[]>} */
async function filesOf(below) {
  const entries = await readdir(path.join(folder, below), { withFileTypes: true });
  const found = await Promise.all(entries.map((entry) => {
    const name = path.posix.join(below, entry.name);
    return entry.isDirectory() ? filesOf(name) : [name];
  }));
  return found.flat();
}

/** @param {string} name */
function posix(name) {
  return name.replaceAll('\\', '/');
}
