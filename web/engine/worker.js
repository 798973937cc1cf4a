/**
 * The engine in a worker, which keeps the main thread free. The worker posts `started` with its
 * version, or `stopped` with the reason, and then takes calls and posts events. It transfers each
 * picture as a bitmap without a copy.
 */

import { VERSION } from '../generated/version.js';
import { contextOf, pictureCanvas, runEngine } from './loop.js';
import init, { Engine } from '../wasm/hearth-engine.js';

/** @type {ReturnType<typeof runEngine> | undefined} */
let engine;

const canvas = pictureCanvas();
// Creating the first context of a page takes long, so it starts while the wasm loads.
if (canvas) contextOf(canvas);

/** @param {WebAssembly.Module} module */
async function start(module) {
  if (!canvas) throw new Error('there is no canvas in a worker');
  if (typeof requestAnimationFrame !== 'function') throw new Error('there are no frames in a worker');
  await init({ module_or_path: module });
  engine = runEngine(Engine, canvas, {
    post: (message) => postMessage(message),
    show: (fire) => {
      try {
        const bitmap = canvas.transferToImageBitmap();
        postMessage({ type: 'picture', fire, bitmap }, { transfer: [bitmap] });
        return false;
      } catch {
        // The context was lost during the frame; its event follows.
        return true;
      }
    },
    extend: (part) => init(/** @type {any} */ ({ part })),
    fail: (reason) => postMessage({ type: 'stopped', ...reason }),
  });
}

addEventListener('message', ({ data }) => {
  if (Array.isArray(data)) engine?.call(/** @type {any} */ (data));
  // A number: the picture of that fire is shown. Zero asks for an answer.
  else if (data === 0) postMessage({ type: 'answer' });
  else if (typeof data === 'number') engine?.shown(data);
  else if (data.part) engine?.add(data);
  else start(data.module).then(
    () => postMessage({ type: 'started', version: VERSION }),
    (error) => postMessage({ type: 'stopped', why: String(error) }),
  );
});
