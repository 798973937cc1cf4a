/** Loads the wasm of the library. */

import { words } from './values.js';

/** The maximum time until the wasm arrives [ms]. */
const WASM_MS = 60_000;

/** Whether this is Node, or another runtime with its modules. */
const NODE = Boolean(/** @type {{process?: {versions?: {node?: string}}}} */ (globalThis).process?.versions?.node);

/** What the library needs besides the language, which some runtimes lack. */
export const NEEDED = [
  'WebAssembly',
  'WebAssembly.compile',
  'WebAssembly.instantiate',
  'TextDecoder',
  'TextEncoder',
  'URL',
];

const KNOWN = 'every browser since 2023 and Node 18 have';

/** @type {Promise<any>} The loaded wasm module, or undefined. */
let module = Promise.resolve();

/**
 * The wasm module: the loaded one, or that at `wasm`, or the file beside the library. After a
 * failure, the next call tries again.
 * @param {unknown} wasm
 */
export function loaded(wasm) {
  const missing = NEEDED.find(
    (path) => !path.split('.').reduce((/** @type {any} */ object, name) => object?.[name], globalThis),
  );
  if (missing)
    throw Object.assign(new Error(`This program has no ${missing}, which ${KNOWN}.`), { kind: 'unsupported' });
  const attempt = module.then((already) => already ?? load(wasm));
  module = attempt.catch(() => undefined);
  return attempt;
}

/** @param {unknown} wasm */
async function load(wasm) {
  const compiled = compiling(wasm ?? new URL('../wasm/hearth-sim_bg.wasm', import.meta.url));
  try {
    const glue = await import('../wasm/hearth-sim.js');
    const ready = await compiled();
    // The glue cannot replace a module that it has started.
    if (!WebAssembly.Module.exports(ready).some(({ name }) => name === 'fire_new')) {
      throw new TypeError('this is the wasm of something else');
    }
    await glue.default({ module_or_path: ready });
    return glue;
  } catch (cause) {
    const simd = cause instanceof WebAssembly.CompileError ? `; it needs SIMD, which ${KNOWN}` : '';
    throw new Error(`the simulation's wasm could not be loaded: ${cause}${simd}`, { cause });
  }
}

/**
 * Compiles what the option `wasm` gives.
 * @param {any} source
 * @returns {() => Promise<WebAssembly.Module>}
 * @throws {TypeError}
 */
function compiling(source) {
  if (source instanceof WebAssembly.Module) return async () => source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) {
    return () => WebAssembly.compile(/** @type {BufferSource} */ (source));
  }
  if (typeof source === 'string' || source instanceof URL) return () => compiledFrom(source);
  throw new TypeError(`wasm must be a URL, bytes or a WebAssembly.Module, not ${words(source)}`);
}

/**
 * The module at a URL. Node cannot fetch `file:` and reads the file instead.
 * @param {string | URL} url
 */
async function compiledFrom(url) {
  const base = globalThis.document?.baseURI ?? globalThis.location?.href;
  const { href, protocol } = new URL(url, base);
  if (protocol === 'file:' && NODE) {
    // A bundler for browsers would resolve a literal name.
    const files = 'node:fs/promises';
    const { readFile } = await import(/* @vite-ignore */ /* webpackIgnore: true */ files);
    return WebAssembly.compile(await readFile(new URL(href)));
  }
  const response = await fetch(href, { signal: globalThis.AbortSignal?.timeout?.(WASM_MS) });
  if (!response.ok) throw new Error(`${href} answers ${response.status}`);
  // Streaming needs the right content type.
  return response.headers.get('content-type') === 'application/wasm' &&
    typeof WebAssembly.compileStreaming === 'function'
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}
