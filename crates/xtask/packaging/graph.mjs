/**
 * The import graph of the package: what a script imports, statically or on request; what it
 * names in its folder as `new URL('./file', import.meta.url)`, as wasm, workers and style
 * sheets are named; and what a page names.
 */
import { readFile, readdir } from 'node:fs/promises';
import path from 'node:path';
import { build } from '../scripts/esbuild.mjs';
import { OUTSIDE } from './manifest.mjs';

const BESIDE = /new URL\(\s*(['"])(\.\.?\/[^'"]+)\1,\s*import\.meta\.url\s*\)/g;
const IN_PAGE = /(?:src|href|content)=(['"])(\.\/[^'"]+)\1/g;
const TYPES = /(?:from|import\(|declare module)\s*(['"])(\.\.?\/[^'"]+\.c?js)\1/g;

/**
 * The files that these scripts and pages reach, including themselves, as paths below `folder`.
 * @param {string} folder
 * @param {string[]} beginnings
 * @param {(file: string) => boolean} [later]  Files to leave out where they are imported on
 *   request only.
 * @returns {Promise<string[]>}
 */
export async function reached(folder, beginnings, later = () => false) {
  const found = new Set();
  const waiting = beginnings.map((file) => path.posix.normalize(file));
  for (let file = waiting.shift(); file !== undefined; file = waiting.shift()) {
    if (found.has(file)) continue;
    found.add(file);
    if (file.endsWith('.html')) waiting.push(...(await named(folder, file, IN_PAGE)));
    if (!file.endsWith('.js')) continue;
    for (const { to, dynamic } of await imports(folder, file)) {
      if (!dynamic || !later(to)) waiting.push(to);
    }
    waiting.push(...(await named(folder, file, BESIDE)));
  }
  return [...found].sort();
}

/**
 * The pictures of the scenes, which the panel finds in its folder by their names; no text
 * names them, or bundlers would look for them.
 * @param {string} folder
 * @returns {Promise<string[]>}
 */
export async function pictures(folder) {
  const found = await readdir(path.join(folder, 'scenes')).catch(() => []);
  return found
    .filter((name) => name.endsWith('.jpg'))
    .map((name) => `scenes/${name}`)
    .sort();
}

/**
 * The declarations that these reach.
 * @param {string} folder
 * @param {string[]} files
 * @returns {Promise<string[]>}
 */
export async function typesReached(folder, files) {
  const found = new Set();
  const waiting = files.map((file) => path.posix.normalize(file));
  for (let file = waiting.shift(); file !== undefined; file = waiting.shift()) {
    if (found.has(file)) continue;
    found.add(file);
    waiting.push(...(await named(folder, file, TYPES)).map((script) => script.replace(/(c?)js$/, 'd.$1ts')));
  }
  return [...found].sort();
}

/** What scripts import, by folder and file: esbuild reports it for all that it bundles. */
const known = new Map();

/**
 * What a script imports from the package.
 * @type {(folder: string, file: string) => Promise<{to: string, dynamic: boolean}[]>}
 */
async function imports(folder, file) {
  const root = path.resolve(folder);
  if (!known.has(path.join(root, file))) {
    const { metafile } = await build({
      entryPoints: [file],
      absWorkingDir: root,
      bundle: true,
      write: false,
      metafile: true,
      format: 'esm',
      logLevel: 'error',
      external: OUTSIDE,
    });
    for (const [input, { imports: all }] of Object.entries(metafile.inputs)) {
      const inside = all.filter(({ external }) => !external);
      known.set(
        path.join(root, input),
        inside.map(({ path: to, kind }) => ({ to, dynamic: kind === 'dynamic-import' })),
      );
    }
  }
  return known.get(path.join(root, file));
}

/**
 * The files beside this one that its text names.
 * @type {(folder: string, file: string, pattern: RegExp) => Promise<string[]>}
 */
async function named(folder, file, pattern) {
  const text = await readFile(path.join(folder, file), 'utf8');
  return [...text.matchAll(pattern)].map(([, , name]) => path.posix.join(path.posix.dirname(file), name));
}
