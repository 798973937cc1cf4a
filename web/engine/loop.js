/**
 * The loop of an engine, in a worker or on the main thread: requests frames, listens to the
 * canvas, and stops an engine that throws, which only a defect causes.
 */

/**
 * Runs an engine.
 * @param {new (post: Function, canvas: any, context: WebGL2RenderingContext | null, show: Function, onPage: boolean) => any} Engine
 * @param {HTMLCanvasElement | OffscreenCanvas} canvas the canvas to draw on
 * @param {object} callbacks
 * @param {(message: object) => void} callbacks.post delivers a message
 * @param {(fire: number) => boolean} callbacks.show takes the picture of a fire from the canvas
 *   and returns whether it is already shown. It never throws
 * @param {(reason: {why: string, at?: string}) => void} callbacks.fail called when the engine has
 *   stopped
 * @param {boolean} [onPage] whether the thread is the page's own, which the engine leaves most of
 * @throws if the browser cannot draw
 */
export function runEngine(Engine, canvas, { post, show, fail }, onPage = false) {
  let engine = new Engine(post, canvas, contextOf(canvas), show, onPage);
  let frame = 0;

  const stop = () => {
    cancelAnimationFrame(frame);
    canvas.removeEventListener('webglcontextlost', lost);
    canvas.removeEventListener('webglcontextrestored', restored);
    const ended = engine;
    engine = undefined;
    return ended;
  };
  const failed = (/** @type {unknown} */ error) => {
    // Damaged memory cannot be freed.
    stop()?.__destroy_into_raw();
    fail(reasonOf(error, Engine));
  };
  const requestFrame = (/** @type {boolean} */ needed) => {
    if (needed && frame === 0) frame = requestAnimationFrame(draw);
  };
  // A frame creates no object and no function.
  const draw = (/** @type {number} */ now) => {
    frame = 0;
    try {
      if (engine) requestFrame(engine.frame(now));
    } catch (error) {
      failed(error);
    }
  };
  const context = (/** @type {boolean} */ back) => {
    try {
      if (engine) requestFrame(engine.context(back));
    } catch (error) {
      failed(error);
    }
  };
  const lost = (/** @type {Event} */ event) => {
    // Otherwise the browser never restores the context.
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
        if (engine) requestFrame(engine.call(call));
      } catch (error) {
        failed(error);
      }
    },
    /** Counts a picture of a fire as shown. @param {number} fire */
    shown(fire) {
      try {
        if (engine) requestFrame(engine.shown(fire));
      } catch (error) {
        failed(error);
      }
    },
    /** Frees the engine and its context. */
    end() {
      stop()?.free();
    },
  };
}

/**
 * Why an engine has stopped, and the place of a panic in its source. The allocator traps without
 * a panic.
 * @param {unknown} error
 * @param {any} Engine
 * @returns {{why: string, at?: string}}
 */
export function reasonOf(error, Engine) {
  let why = String(error);
  try {
    const panic = /^panicked at (.+?):\n(.*)/s.exec(Engine.panic());
    if (panic) return { why: panic[2], at: panic[1] };
    if (/unreachable/i.test(why)) why = 'no memory is left';
  } catch {
    // The error itself has to do.
  }
  return { why };
}

/**
 * The WebGL2 context of a canvas, the same at each call. It has alpha, but neither multisampling
 * nor depth.
 * @param {HTMLCanvasElement | OffscreenCanvas} canvas
 * @returns {WebGL2RenderingContext | null}
 */
export function contextOf(canvas) {
  return /** @type {any} */ (canvas).getContext('webgl2', { antialias: false, depth: false });
}

/**
 * A canvas whose pictures can be taken without a copy; `undefined` if the browser has none.
 * @returns {OffscreenCanvas | undefined}
 */
export function pictureCanvas() {
  if (typeof OffscreenCanvas !== 'function') return undefined;
  const canvas = new OffscreenCanvas(1, 1);
  return 'transferToImageBitmap' in canvas ? canvas : undefined;
}
