/**
 * Makes the scripts and style sheets of the site small, each in its place:
 * `node minify.mjs FOLDER`, the folder with `package.json`. A visitor downloads code;
 * comments, long names and blanks are for those who read it in the checkout, and
 * the names between wasm and its script are private.
 *
 * A script that only one other needs goes into that one: fewer files to fetch, and
 * they compress better together. What the package exports, a page or a worker begins
 * with, or is only loaded on request stays a file, and so do what several need and
 * what tests its own name. A style sheet that others import goes into each.
 * Properties keep their names, and licences stay.
 */
import { readFile, readdir, rm, rmdir } from 'node:fs/promises';
import path from 'node:path';
import { OUTSIDE, beginningsOf } from '../packaging/manifest.mjs';
import { build, transform } from './esbuild.mjs';

const folder = path.resolve(process.argv[2] ?? '');
const manifest = JSON.parse(await readFile(path.join(folder, 'package.json'), 'utf8'));
const all = await filesOf('');
const scripts = all.filter((file) => file.endsWith('.js'));
const sheets = all.filter((file) => file.endsWith('.css'));

const COMMON = /** @type {const} */ ({ absWorkingDir: folder, format: 'esm', bundle: true, logLevel: 'warning' });

/** Into which file each script goes. */
const owners = await ownersOf();
/** The style sheets that others import, which go into each of them. */
const shared = new Set((await Promise.all(sheets.map(importsOf))).flat());
await build({
  ...COMMON,
  entryPoints: [...scripts.filter((file) => owners.get(file) === file), ...sheets.filter((file) => !shared.has(file))],
  outdir: folder,
  outbase: folder,
  allowOverwrite: true,
  minify: true,
  charset: 'utf8',
  target: 'es2022',
  legalComments: 'inline',
  plugins: [
    {
      name: 'owners',
      setup({ onLoad, onResolve }) {
        onResolve({ filter: /.*/ }, resolved);
        onLoad({ filter: /\.js$/ }, moved);
      },
    },
  ],
});
const merged = [...scripts.filter((file) => owners.get(file) !== file), ...shared];
await Promise.all(merged.map((file) => rm(path.join(folder, file))));
// A folder whose scripts all went into others is empty.
for (const below of new Set(merged.map((file) => path.dirname(file))))
  await rmdir(path.join(folder, below)).catch(() => {});

/**
 * Lets esbuild follow an import only inside one owner.
 * @param {import('esbuild').OnResolveArgs} asked
 */
function resolved({ path: name, kind, importer, resolveDir }) {
  if (kind === 'entry-point' || kind === 'import-rule') return undefined;
  if (!/^\.\.?\//.test(name)) return { path: name, external: true };
  const [from, to] = [importer, path.join(resolveDir, name)].map((file) => posix(path.relative(folder, file)));
  if (owners.get(from) === owners.get(to) && owners.has(to)) return undefined;
  return { path: relative(owners.get(from) ?? from, to), external: true };
}

/**
 * A script whose `new URL('./file', …)` names the same file from its owner's folder.
 * @param {import('esbuild').OnLoadArgs} asked
 * @returns {Promise<import('esbuild').OnLoadResult>}
 */
async function moved({ path: script }) {
  const from = posix(path.relative(folder, script));
  const text = await readFile(script, 'utf8');
  const contents = text.replace(
    /(new URL\(')(\.\.?\/[^']*)(?=',)/g,
    (_, before, name) => before + relative(owners.get(from) ?? from, path.posix.join(path.posix.dirname(from), name)),
  );
  return { contents: await withSmallSheets(contents), loader: 'js' };
}

/** A script whose style sheets, which stand in it as `/* css *\/` templates, are small. @param {string} script */
async function withSmallSheets(script) {
  const parts = script.split(/\/\* css \*\/ `([^`$\\]*)`/);
  const small = parts.map(async (part, at) =>
    at % 2 === 0
      ? part
      : JSON.stringify((await transform(part, { loader: 'css', minify: true, target: 'es2022' })).code.trim()),
  );
  return (await Promise.all(small)).join('');
}

/** The style sheets that a sheet imports. @param {string} sheet @returns {Promise<string[]>} */
async function importsOf(sheet) {
  const text = await readFile(path.join(folder, sheet), 'utf8');
  return [...text.matchAll(/@import '(.+?)'/g)].map(([, name]) => path.posix.join(path.posix.dirname(sheet), name));
}

/** How a script of `from`'s folder names `to`. @param {string} from @param {string} to */
function relative(from, to) {
  const name = path.posix.relative(path.posix.dirname(from), to);
  return name.startsWith('.') ? name : `./${name}`;
}

/** @returns {Promise<Map<string, string>>} */
async function ownersOf() {
  const { metafile } = await build({
    ...COMMON,
    entryPoints: scripts,
    outdir: folder,
    write: false,
    metafile: true,
    external: OUTSIDE,
  });
  if (!metafile) throw new Error('esbuild lists no imports');
  const own = new Set(beginningsOf(manifest).map((file) => path.posix.normalize(file)));
  for (const file of scripts) {
    const text = await readFile(path.join(folder, file), 'utf8');
    if (text.includes(path.basename(file).replace('.', '\\.'))) own.add(file);
  }
  /** @type {Map<string, string[]>} */
  const importers = new Map(scripts.map((file) => [file, []]));
  for (const [from, { imports }] of Object.entries(metafile.inputs)) {
    for (const { path: to, kind } of imports) {
      if (kind === 'dynamic-import') own.add(to);
      importers.get(to)?.push(from);
    }
  }
  const found = new Map(scripts.map((file) => [file, file]));
  for (let changed = true; changed; ) {
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
  const found = await Promise.all(
    entries.map((entry) => {
      const name = path.posix.join(below, entry.name);
      return entry.isDirectory() ? filesOf(name) : [name];
    }),
  );
  return found.flat();
}

/** @param {string} name */
function posix(name) {
  return name.replaceAll('\\', '/');
}
