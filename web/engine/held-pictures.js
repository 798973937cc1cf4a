/**
 * Pictures that stay on the canvas of a worker until they are drawn, loaded where taking a picture at once blocks
 * the worker for long, as without a graphics card. Calls of the page are executed meanwhile.
 */

/** Interval between two checks whether a picture is drawn [ms]. */
const CHECK_MS = 2;

/** The extension by which the engine knows how long drawing takes where the worker does not wait for it. */
const TIMER = 'EXT_disjoint_timer_query_webgl2';

/**
 * Holds pictures; `undefined` without a timer of the graphics, because the quality follows the time of drawing.
 * @param {WebGL2RenderingContext} gl the context of the canvas
 * @param {(message: object) => void} post
 * @param {(fire: number, start: number) => boolean} take takes a picture that was submitted at `start` [ms]. Returns
 *   whether it is lost
 * @param {() => {shown: (fire: number) => void, resume: () => void} | undefined} engine
 */
export function holder(gl, post, take, engine) {
  if (!gl.getExtension(TIMER)) return undefined;
  /** Whether there is a picture. */
  let held = false;
  /** Messages that follow it. @type {object[]} */
  const messages = [];

  return {
    /** Whether nothing may be drawn. */
    get held() {
      return held;
    },
    /** Posts a message, after the picture that was drawn before it. @param {object} message */
    post(message) {
      if (held) messages.push(message);
      else post(message);
    },
    /** Takes the picture of a fire when it is drawn. @type {(fire: number) => void} */
    hold(fire) {
      const start = performance.now();
      const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
      gl.flush();
      held = true;
      const check = () => {
        const lost = gl.isContextLost();
        if (!lost && fence && gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) {
          setTimeout(check, CHECK_MS);
          return;
        }
        gl.deleteSync(fence);
        held = false;
        // A lost context has an empty picture, which would replace the last one.
        const gone = lost || take(fire, start);
        messages.splice(0).forEach(post);
        if (gone) engine()?.shown(fire);
        engine()?.resume();
      };
      setTimeout(check, CHECK_MS);
    },
  };
}
