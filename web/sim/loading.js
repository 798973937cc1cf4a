/** Loads the wasm of the library, and its parts when a simulation needs them. */

import { checkPart, loadedParts } from '../parts.js';
import { known, words } from './values.js';

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

/** The names of the parts that the loaded wasm has. @type {Set<string>} */
export const loadedNames = new Set();

/** Adds a part to the loaded wasm. @type {(name: string, part: WebAssembly.Module) => void} */
let extend;

/**
 * The wasm module: the loaded one, or that at `wasm`, or the file beside the library. After a
 * failure, the next call tries again.
 * @param {unknown} wasm
 * @param {[string, any][]} parts parts of it that are elsewhere
 */
export function loaded(wasm, parts) {
  const missing = NEEDED.find(
    (path) => !path.split('.').reduce((/** @type {any} */ object, name) => object?.[name], globalThis),
  );
  if (missing)
    throw Object.assign(new Error(`This program has no ${missing}, which ${KNOWN}.`), { kind: 'unsupported' });
  for (const [name] of parts) known('wasmParts', name, Object.keys(PARTS));
  const attempt = module.then((already) => already ?? load(wasm, parts));
  module = attempt.catch(() => undefined);
  return attempt;
}

/** @type {(wasm: unknown, parts: [string, any][]) => Promise<any>} */
async function load(wasm, parts) {
  const compiled = compiling('wasm', wasm ?? new URL('../wasm/hearth-sim_bg.wasm', import.meta.url));
  const others = parts
    .filter(([, source]) => source !== undefined)
    .map(([name, source]) => /** @type {const} */ ([name, compiling(`wasmParts.${name}`, source)]));
  try {
    const glue = await import('../wasm/hearth-sim.js');
    const ready = await compiled();
    // The glue cannot replace a module that it has started.
    if (!WebAssembly.Module.exports(ready).some(({ name }) => name === 'fire_new')) {
      throw new TypeError('this is the wasm of something else');
    }
    await glue.default({ module_or_path: ready });
    // A later attempt has the module of the first, with the parts that it got.
    if (extend === undefined) for (const name of loadedParts(ready, Object.keys(PARTS))) loadedNames.add(name);
    extend = (name, part) => {
      if (loadedNames.has(name)) return;
      checkPart(part, name, ready);
      glue.default(/** @type {any} */ ({ part }));
      loadedNames.add(name);
    };
    for (const [name, source] of others) {
      extend(name, await source());
      adding[name] = Promise.resolve();
    }
    // Node has no request that a call can wait for, and reads the files from a disk.
    if (NODE) await Promise.all(Object.keys(PARTS).map((name) => add(name).catch(() => {})));
    return glue;
  } catch (cause) {
    const simd = cause instanceof WebAssembly.CompileError ? `; it needs SIMD, which ${KNOWN}` : '';
    throw new Error(`the simulation's wasm could not be loaded: ${cause}${simd}`, { cause });
  }
}

/** The parts of the wasm that are there or on their way. @type {{[part: string]: Promise<void>}} */
const adding = {};

/** The files of the parts. @type {{[part: string]: () => URL}} */
const PARTS = {
  classic: () => new URL('../wasm/hearth-sim_classic.wasm', import.meta.url),
  bodies: () => new URL('../wasm/hearth-sim_bodies.wasm', import.meta.url),
};

/** @type {(name: string, cause: unknown) => Error} */
const missingPart = (name, cause) =>
  new Error(`the part "${name}" of the wasm could not be loaded: ${cause}`, { cause });

/** Loads a part. After a failure, the next call tries again. @param {string} name */
export function add(name) {
  adding[name] ??= compiledFrom(PARTS[name]())
    .then((part) => extend(name, part))
    .catch((cause) => {
      delete adding[name];
      throw missingPart(name, cause);
    });
  return adding[name];
}

/** Loads a part while the caller waits, with a synchronous XMLHttpRequest. @param {string} name */
export function addNow(name) {
  try {
    const url = PARTS[name]();
    const request = new XMLHttpRequest();
    request.open('GET', url, false);
    // Each character is a byte.
    request.overrideMimeType('text/plain; charset=x-user-defined');
    request.send();
    if (request.status !== 200) throw new Error(`${url} answers ${request.status}`);
    extend(name, new WebAssembly.Module(Uint8Array.from(request.responseText, (byte) => byte.charCodeAt(0))));
  } catch (cause) {
    throw missingPart(name, cause);
  }
}

/**
 * Compiles what an option gives.
 * @param {string} name of the option
 * @param {any} source
 * @returns {() => Promise<WebAssembly.Module>}
 * @throws {TypeError}
 */
function compiling(name, source) {
  if (source instanceof WebAssembly.Module) return async () => source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) {
    return () => WebAssembly.compile(/** @type {BufferSource} */ (source));
  }
  if (typeof source === 'string' || source instanceof URL) return () => compiledFrom(source);
  throw new TypeError(`${name} must be a URL, bytes or a WebAssembly.Module, not ${words(source)}`);
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
