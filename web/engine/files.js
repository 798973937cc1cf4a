/**
 * Locations of the engine's files: its wasm and the parts of it, its script, the script of its worker, and saved
 * fires.
 *
 * They have the form that bundlers recognise. No other module has locations, so a build to a
 * single file replaces only this one.
 */

import { PREWARMED } from '../generated/prewarmed.js';
import { PREWARMED_MS } from './time-limit.js';
import { trustedWorker } from './trusted-worker.js';

/**
 * The engine's wasm: its URL or its bytes.
 * @returns {import('./engine.js').Source}
 */
export function wasm() {
  return new URL('../wasm/hearth-engine_bg.wasm', import.meta.url);
}

/**
 * The parts of the wasm, by name: the classic model; solids that burn, water, and free solids; children
 * of the element; the sound.
 * @type {{[name: string]: () => import('./engine.js').Source}}
 */
export const PARTS = {
  classic: () => new URL('../wasm/hearth-engine_classic.wasm', import.meta.url),
  bodies: () => new URL('../wasm/hearth-engine_bodies.wasm', import.meta.url),
  children: () => new URL('../wasm/hearth-engine_children.wasm', import.meta.url),
  sound: () => new URL('../wasm/hearth-engine_sound.wasm', import.meta.url),
  films: () => new URL('../wasm/hearth-engine_films.wasm', import.meta.url),
};

/**
 * The saved fire of a scene as bytes; `undefined` if there is none or it fails to load. The fire
 * then starts without it.
 * @param {string} scene
 * @returns {Promise<Uint8Array | undefined>}
 */
export async function prewarmed(scene) {
  if (!Object.hasOwn(PREWARMED, scene)) return undefined;
  try {
    const signal = AbortSignal.timeout(PREWARMED_MS);
    const response = await fetch(PREWARMED[scene](), { credentials: 'same-origin', signal });
    return response.ok ? new Uint8Array(await response.arrayBuffer()) : undefined;
  } catch {
    return undefined;
  }
}

/**
 * Starts the worker that the engine can run in.
 * @returns {Worker}
 * @throws if the browser or the page's policy does not allow it
 */
export function worker() {
  return trustedWorker(start);
}

function start() {
  try {
    return new Worker(new URL('./worker.js', import.meta.url), { type: 'module', name: 'hearth' });
  } catch {
    // A page may not start a worker from another origin, but a worker that imports it. The URL is
    // not in the form that bundlers recognise, because they would copy it as an asset.
    const here = import.meta.url;
    const text = `import ${JSON.stringify(new URL('./worker.js', here).href)};`;
    const url = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
    try {
      return new Worker(url, { type: 'module', name: 'hearth' });
    } finally {
      // The browser has loaded it by then.
      setTimeout(() => URL.revokeObjectURL(url), 60_000);
    }
  }
}

/** The engine's script. */
export function glue() {
  return import('../wasm/hearth-engine.js');
}
