/**
 * Where the engine's files are: its wasm, its script, the script of its worker, and the
 * fires that start burning.
 *
 * They stand here as bundlers look for them, and nowhere else, so that a build of
 * another form, as a single file, has only this module to replace.
 */

import { BURNING } from '../generated/burning.js';

/**
 * The engine's wasm: where it is, or its bytes.
 * @returns {import('./engine.js').Source}
 */
export function wasm() {
  return new URL('../wasm/hearth-engine_bg.wasm', import.meta.url);
}

/**
 * The fire that starts burning of that scene, as bytes; nothing where none is kept, or it
 * does not come: it is then lit as any other.
 * @param {string} scene
 * @returns {Promise<Uint8Array | undefined>}
 */
export async function burning(scene) {
  if (!Object.hasOwn(BURNING, scene)) return undefined;
  try {
    const response = await fetch(BURNING[scene](), { credentials: 'same-origin' });
    return response.ok ? new Uint8Array(await response.arrayBuffer()) : undefined;
  } catch {
    return undefined;
  }
}

/**
 * Starts the worker that the engine can run in.
 * @returns {Worker}
 * @throws where the browser or the page's policy has none
 */
export function worker() {
  try {
    return new Worker(new URL('./worker.js', import.meta.url), { type: 'module', name: 'hearth' });
  } catch {
    // A page may not start a script of another site, but one that loads it.
    // (Bundlers take what stands here for an asset, unless they cannot read it.)
    const here = import.meta.url;
    const start = `import ${JSON.stringify(new URL('./worker.js', here).href)};`;
    const url = URL.createObjectURL(new Blob([start], { type: 'text/javascript' }));
    try {
      return new Worker(url, { type: 'module', name: 'hearth' });
    } finally {
      // The browser has it by then.
      setTimeout(() => URL.revokeObjectURL(url), 60_000);
    }
  }
}

/** The engine's script. */
export function glue() {
  return import('../wasm/hearth-engine.js');
}
