/**
 * The engine in a worker, which keeps the main thread free. The worker posts `started` with its
 * version, or `stopped`, and then takes calls and posts events. It transfers each picture as a
 * bitmap without a copy.
 */

import { VERSION } from '../generated/version.js';
import { contextOf, pictureCanvas, runEngine } from './loop.js';
import init, { Engine } from '../wasm/hearth-engine.js';

/** Time of taking a picture from which the worker is blocked for long [ms]. */
const LONG_MS = 8;

/** Number of such pictures, one after another, from which they are held. */
const LONG_PICTURES = 8;

/** @type {ReturnType<typeof runEngine> | undefined} */
let engine;
/** What holds pictures. @type {ReturnType<typeof import('./held-pictures.js').holder> | undefined} */
let holder;
/** Number of pictures, one after another, that took long. */
let long = 0;

const canvas = pictureCanvas();
// Creating the first context of a page takes long, so it starts while the wasm loads.
if (canvas) contextOf(canvas);

/** @param {object} message */
const send = (message) => postMessage(message);

/** Takes a picture that was submitted at `start` [ms]. Returns whether it is lost. @type {(fire: number, start: number) => boolean} */
function take(fire, start) {
  try {
    const bitmap = /** @type {OffscreenCanvas} */ (canvas).transferToImageBitmap();
    long = performance.now() - start > LONG_MS ? long + 1 : 0;
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
  if (!canvas || typeof requestAnimationFrame !== 'function') throw new Error();
  await init({ module_or_path: module });
  engine = runEngine(Engine, canvas, {
    post: (message) => (holder ? holder.post(message) : send(message)),
    show(fire, alone) {
      if (holder && alone && long > 0) {
        holder.hold(fire);
        return false;
      }
      if (long === LONG_PICTURES) {
        import('./held-pictures.js').then((held) => {
          holder ??= held.holder(/** @type {WebGL2RenderingContext} */ (contextOf(canvas)), send, take, () => engine);
        }, () => {});
      }
      return take(fire, performance.now());
    },
    held: () => holder?.held,
    module,
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
    () => postMessage({ type: 'stopped' }),
  );
});
