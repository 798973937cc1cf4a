/**
 * The engine on the main thread, loaded if no worker can draw.
 */

import { pictureCanvas, runEngine } from './loop.js';

/**
 * Starts the engine. Calls and events are delivered later and in order, as with a worker.
 * @param {import('./loop.js').EngineClass} Engine
 * @param {import('./engine.js').Port} port the connection to it
 * @param {WebAssembly.Module} module the wasm
 * @param {(part: WebAssembly.Module) => void} extend adds a part to the wasm
 * @throws if the browser cannot draw
 */
export function start(Engine, port, module, extend) {
  const run = (/** @type {any} */ canvas) =>
    runEngine(
      Engine,
      canvas,
      {
        post: (/** @type {any} */ message) => queueMicrotask(() => port.deliver(message)),
        show: (fire) => {
          // The context may be lost during the frame; its event follows.
          const picture = attempt(() => ('transferToImageBitmap' in canvas ? canvas.transferToImageBitmap() : canvas));
          if (picture) port.draw(fire, picture);
          return true;
        },
        module,
        extend,
        fail: ({ why, at }) => port.fail(at ? `${why} (${at})` : why),
      },
      true,
    );
  const offscreen = pictureCanvas();
  // Some ports of WebKit have an `OffscreenCanvas` but cannot draw on it.
  const engine = (offscreen && attempt(() => run(offscreen))) ?? run(document.createElement('canvas'));
  port.send = (data) => queueMicrotask(() => engine.receive({ data }));
  port.end = () => engine.end();
}

/**
 * The result of `act`; `undefined` if it throws.
 * @template T
 * @param {() => T} act
 * @returns {T | undefined}
 */
function attempt(act) {
  try {
    return act();
  } catch {
    return undefined;
  }
}
