/**
 * The engine on the page's own thread: loaded where no worker can draw.
 */

import { pictureCanvas, runEngine } from './loop.js';

/**
 * Starts it. What it is told and says is delivered as from a worker: later, in order.
 * @param {new (post: Function, canvas: any, context: WebGL2RenderingContext | null, show: Function) => any} Engine
 * @param {import('./engine.js').Port} port what it is reached by
 * @throws where the browser cannot draw
 */
export function start(Engine, port) {
  const run = (/** @type {any} */ canvas) => runEngine(Engine, canvas, {
    post: (/** @type {any} */ message) => queueMicrotask(() => port.deliver(message)),
    show: (fire) => {
      // The context may have gone in the midst of the frame; its event is on its way.
      const picture = attempt(() => ('transferToImageBitmap' in canvas ? canvas.transferToImageBitmap() : canvas));
      if (picture) port.draw(fire, picture);
      return true;
    },
    fail: (error) => port.fail(error),
  });
  const offscreen = pictureCanvas();
  // WebKit has such canvases, but not all of its ports can draw on them.
  const engine = (offscreen && attempt(() => run(offscreen))) ?? run(document.createElement('canvas'));
  port.send = (call) => queueMicrotask(() => typeof call === 'number' ? engine.shown(call) : engine.call(call));
  port.end = () => engine.end();
}

/**
 * What `act` gives; nothing where it throws.
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
