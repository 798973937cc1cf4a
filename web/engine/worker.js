/**
 * The engine in a worker, which keeps the main thread free. The worker posts `started` with its
 * version, or `stopped`, and then takes calls and posts events. It transfers each picture as a
 * bitmap without a copy.
 */

import { VERSION } from '../generated/version.js';
import { contextOf, pictureCanvas, runEngine } from './loop.js';
import init, { Engine } from '../wasm/hearth-engine.js';

const canvas = pictureCanvas();
// Creating the first context of a page takes long, so it starts while the wasm loads.
if (canvas) contextOf(canvas);

/** Posts the picture on the canvas. Returns whether it is lost. @param {number} fire */
function postPicture(fire) {
  try {
    const bitmap = /** @type {OffscreenCanvas} */ (canvas).transferToImageBitmap();
    postMessage({ type: 'picture', fire, bitmap }, { transfer: [bitmap] });
    return false;
  } catch {
    // The context was lost during the frame; its event follows.
    return true;
  }
}

/** @param {WebAssembly.Module} module */
async function start(module) {
  // The page then runs the engine itself, and needs no reason.
  if (!canvas || !globalThis.requestAnimationFrame || !globalThis.performance) throw new Error();
  await init({ module_or_path: module });
  const { receive } = runEngine(Engine, canvas, {
    post: (message) => postMessage(message),
    show: postPicture,
    module,
    extend: (part) => init(/** @type {any} */ ({ part })),
    fail: (reason) => postMessage({ type: 'stopped', ...reason }),
  });
  addEventListener('message', receive);
}

addEventListener(
  'message',
  ({ data }) =>
    start(data.module).then(
      () => postMessage({ type: 'started', version: VERSION }),
      () => postMessage({ type: 'stopped' }),
    ),
  { once: true },
);
