/**
 * The package's one file of all: element, engine, wasm and the worker's script in
 * one module, for a page that loads one file and nothing else.
 *
 * It is the same element, from its sources, with another `engine/files.js`
 * (inline-files.js here), which has in it what the original looks for beside itself.
 * Only the panel stays
 * outside: an import of it needs the package's folder.
 */
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { deflateRawSync } from 'node:zlib';
import { build } from '../scripts/esbuild.mjs';

const FILES = path.join(path.dirname(fileURLToPath(import.meta.url)), 'inline-files.js');

/** What both scripts have in common. @satisfies {import('../scripts/esbuild.mjs').BuildOptions} */
const COMMON = /** @type {const} */ ({
  bundle: true,
  write: false,
  minify: true,
  target: 'es2022',
  legalComments: 'none',
  logLevel: 'error',
  // The file stands alone, and bundlers must not resolve it.
  define: { 'import.meta.url': '""' },
});

/**
 * The text of the file.
 * @param {string} sources  The folder of the element's scripts as they are written.
 * @param {string} wasm  The folder of the package's wasm and its scripts.
 * @param {{name: string, version: string, license: string}} about
 */
export async function inlined(sources, wasm, { name, version, license }) {
  const deflated = async (/** @type {string} */ name) =>
    deflateRawSync(await readFile(path.join(wasm, name)), { level: 9 }).toString('base64');
  const [worker] = await built({
    entryPoints: [path.join(sources, 'engine/worker.js')],
    format: 'iife',
    plugins: [filesInside(sources, wasm)],
  });
  const [script] = await built({
    entryPoints: [path.join(sources, 'hearth-fire.js')],
    format: 'esm',
    banner: { js: `/* ${name} ${version}, ${license} */` },
    plugins: [
      filesInside(sources, wasm, {
        classic: await deflated('hearth-engine_classic.wasm'),
        bodies: await deflated('hearth-engine_bodies.wasm'),
        children: await deflated('hearth-engine_children.wasm'),
        sound: await deflated('hearth-engine_sound.wasm'),
        films: await deflated('hearth-engine_films.wasm'),
        wasm: await deflated('hearth-engine_bg.wasm'),
        worker: worker.text,
      }),
    ],
  });
  return script.text;
}

/** The files that esbuild makes. @param {import('../scripts/esbuild.mjs').BuildOptions} options */
async function built(options) {
  const { outputFiles = [] } = await build({ ...COMMON, ...options });
  return outputFiles;
}

/**
 * Puts inline-files.js in the place of engine/files.js, with its texts, and finds the
 * scripts of wasm where they are.
 * @param {string} sources
 * @param {string} wasm
 * @param {{[name: string]: string}} [texts]  What `inline:name` is.
 * @returns {import('../scripts/esbuild.mjs').Plugin}
 */
function filesInside(sources, wasm, texts = {}) {
  return {
    name: 'files-inside',
    setup({ onLoad, onResolve }) {
      onResolve({ filter: /\/(panel|tools|record)\.js$/ }, ({ path: name }) => ({
        path: `./${path.basename(name)}`,
        external: true,
      }));
      onResolve({ filter: /\/files\.js$/ }, () => ({ path: FILES, namespace: 'files' }));
      onLoad({ filter: /.*/, namespace: 'files' }, async () => ({
        contents: await readFile(FILES, 'utf8'),
        resolveDir: sources,
      }));
      onResolve({ filter: /^\.\.?\/wasm\// }, ({ path: name }) => ({ path: path.resolve(wasm, path.basename(name)) }));
      onResolve({ filter: /^inline:/ }, ({ path: name }) => ({ path: name.slice(7), namespace: 'text' }));
      onLoad({ filter: /.*/, namespace: 'text' }, ({ path: name }) => ({ contents: texts[name], loader: 'text' }));
    },
  };
}
