/**
 * What surrounds an engine, in a worker and on the main thread alike: the frames
 * of the display, the events of its canvas, and what becomes of an engine that
 * throws, which only a defect of its own makes it do.
 */

/**
 * Runs an engine.
 * @param {new (post: Function, canvas: any, context: WebGL2RenderingContext | null, show: Function) => any} Engine
 * @param {HTMLCanvasElement | OffscreenCanvas} canvas what it draws on
 * @param {object} around
 * @param {(message: object) => void} around.post takes its messages
 * @param {(fire: number) => boolean} around.show takes the picture of a fire from the
 *   canvas; whether it is shown already. It never throws
 * @param {(error: unknown) => void} around.fail hears that the engine has stopped
 * @throws where the browser cannot draw
 */
export function runEngine(Engine, canvas, { post, show, fail }) {
  let engine = new Engine(post, canvas, contextOf(canvas), show);
  let frame = 0;

  const stop = () => {
    cancelAnimationFrame(frame);
    canvas.removeEventListener('webglcontextlost', lost);
    canvas.removeEventListener('webglcontextrestored', restored);
    const ended = engine;
    engine = undefined;
    return ended;
  };
  const broken = (/** @type {unknown} */ error) => {
    stop();
    fail(error);
  };
  const goOn = (/** @type {boolean} */ wanted) => {
    if (wanted && frame === 0) frame = requestAnimationFrame(draw);
  };
  // No object is made for a frame, not even a function.
  const draw = (/** @type {number} */ now) => {
    frame = 0;
    try {
      if (engine) goOn(engine.frame(now));
    } catch (error) {
      broken(error);
    }
  };
  const context = (/** @type {boolean} */ back) => {
    try {
      if (engine) goOn(engine.context(back));
    } catch (error) {
      broken(error);
    }
  };
  const lost = (/** @type {Event} */ event) => {
    // Without this the browser never gives the context back.
    event.preventDefault();
    context(false);
  };
  const restored = () => context(true);
  canvas.addEventListener('webglcontextlost', lost);
  canvas.addEventListener('webglcontextrestored', restored);

  return {
    /** @param {[fire: number, request: number, ...call: import('./engine.js').Call]} call */
    call(call) {
      try {
        if (engine) goOn(engine.call(call));
      } catch (error) {
        broken(error);
      }
    },
    /** A picture that was on its way is shown. @param {number} fire */
    shown(fire) {
      try {
        if (engine) goOn(engine.shown(fire));
      } catch (error) {
        broken(error);
      }
    },
    /** Frees it and its context. */
    end() {
      stop()?.free();
    },
  };
}

/**
 * The WebGL2 context of a canvas, the same one at each call. It has an alpha channel and
 * neither samples nor depth.
 * @param {HTMLCanvasElement | OffscreenCanvas} canvas
 * @returns {WebGL2RenderingContext | null}
 */
export function contextOf(canvas) {
  return /** @type {any} */ (canvas).getContext('webgl2', { antialias: false, depth: false });
}

/**
 * A canvas whose pictures can be taken away without a copy, where the browser has
 * one that it can draw on.
 * @returns {OffscreenCanvas | undefined}
 */
export function pictureCanvas() {
  if (typeof OffscreenCanvas !== 'function') return undefined;
  const canvas = new OffscreenCanvas(1, 1);
  return 'transferToImageBitmap' in canvas ? canvas : undefined;
}
