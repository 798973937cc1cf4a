/**
 * The engine in a worker: the page's thread stays free. The worker posts `started`, or why
 * it cannot start; from then on it takes calls and posts events. Each picture is sent as a
 * bitmap, which costs no copy.
 */

import { contextOf, pictureCanvas, runEngine } from './loop.js';
import init, { Engine } from '../wasm/hearth-engine.js';

/** @type {ReturnType<typeof runEngine> | undefined} */
let engine;

const canvas = pictureCanvas();
// While the wasm is still on its way: the first context of a page takes a while.
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
        // The context went in the midst of the frame; its event is on its way.
        return true;
      }
    },
    fail: (error) => postMessage({ type: 'stopped', why: String(error) }),
  });
}

addEventListener('message', ({ data }) => {
  if (Array.isArray(data)) engine?.call(/** @type {any} */ (data));
  // A number: that fire's picture is shown.
  else if (typeof data === 'number') engine?.shown(data);
  else start(data.module).then(
    () => postMessage({ type: 'started' }),
    (error) => postMessage({ type: 'stopped', why: String(error) }),
  );
});
