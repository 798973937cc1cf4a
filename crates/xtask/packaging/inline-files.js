/**
 * `web/engine/files.js` of the single-file build: the same, from texts that
 * are in the file itself. No fire is kept in it: each is lit.
 */

import BODIES from 'inline:bodies';
import CHILDREN from 'inline:children';
import CLASSIC from 'inline:classic';
import FILMS from 'inline:films';
import SOUND from 'inline:sound';
import WASM from 'inline:wasm';
import WORKER from 'inline:worker';
import { trustedWorker } from './engine/trusted-worker.js';

/** The engine's wasm. */
export function wasm() {
  return unpacked(WASM);
}

/** The parts of the wasm. */
export const PARTS = {
  classic: () => unpacked(CLASSIC),
  bodies: () => unpacked(BODIES),
  children: () => unpacked(CHILDREN),
  sound: () => unpacked(SOUND),
  films: () => unpacked(FILMS),
};

/**
 * The bytes of wasm. It lies deflated in the file, which saves an eighth of the
 * download, and more than half of it where a server does not compress.
 * @param {string} text
 * @returns {Promise<ArrayBuffer>}
 */
function unpacked(text) {
  const packed = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).arrayBuffer();
}

/**
 * Starts the worker that the engine can run in.
 * @returns {Worker}
 * @throws where the browser or the page's policy has none
 */
export function worker() {
  const url = URL.createObjectURL(new Blob([WORKER], { type: 'text/javascript' }));
  try {
    return trustedWorker(() => new Worker(url, { name: 'hearth' }));
  } finally {
    // The browser has it by then.
    setTimeout(() => URL.revokeObjectURL(url), 60_000);
  }
}

/** No saved fires: the single file contains none. */
export async function prewarmed() {}

/** The engine's script. */
export function glue() {
  return import('./wasm/hearth-engine.js');
}
