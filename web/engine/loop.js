/**
 * The loop of an engine, in a worker or on the main thread: requests frames, listens to the
 * canvas, and stops an engine that throws, which only a defect causes.
 */

import { AT_ONCE, loadedParts } from '../parts.js';

/**
 * @typedef {[fire: number, request: number, ...call: import('./engine.js').Call]} Sent
 * @typedef {{part: string, calls: Sent[]}} Waiting
 * @typedef {import('./engine.js').Part} Arrived  A part that was asked for.
 * @typedef {WebGL2RenderingContext | null} Context
 * @typedef {new (post: Function, canvas: any, context: Context, show: Function, onPage: boolean) => any} EngineClass
 */

/**
 * The parts of the wasm: the values that need each, which a refused call names, and what it computes.
 * @type {{[part: string]: [ids: string[], subject: string]}}
 */
const PARTS = {
  classic: [['model'], 'the classic model'],
  bodies: [['fuel', 'motion'], 'fuels, water and free solids'],
  children: [['children'], 'children'],
  sound: [['sound'], 'sound'],
  films: [['films'], 'films'],
};

/**
 * Runs an engine.
 * @param {EngineClass} Engine
 * @param {HTMLCanvasElement | OffscreenCanvas} canvas the canvas to draw on
 * @param {object} callbacks
 * @param {(message: object) => void} callbacks.post delivers a message
 * @param {(fire: number) => boolean} callbacks.show takes the picture of a fire from the canvas and returns whether
 *   it is already shown. It never throws
 * @param {WebAssembly.Module} callbacks.module the wasm
 * @param {(part: WebAssembly.Module) => void} callbacks.extend adds a part to the wasm
 * @param {(reason: {why: string, at?: string}) => void} callbacks.fail called when the engine has
 *   stopped
 * @param {boolean} [onPage] whether the thread is the page's own, which the engine leaves most of
 * @throws if the browser cannot draw
 */
export function runEngine(Engine, canvas, { post, show, module, extend, fail }, onPage = false) {
  let engine = new Engine(post, canvas, contextOf(canvas), show, onPage);
  let frame = 0;
  /** Calls of fires that wait for a part, which the first of each needs. @type {Map<number, Waiting>} */
  const waiting = new Map();
  const loaded = loadedParts(module, Object.keys(PARTS));

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

  const call = (/** @type {Sent} */ sent) => {
    const [fire, , name] = sent;
    if (name === 'remove') waiting.delete(fire);
    const calls = waiting.get(fire)?.calls;
    // Before its `add` there is no fire.
    if (calls && (calls[0][2] === 'add' || !AT_ONCE.includes(name))) {
      calls.push(sent);
      return;
    }
    try {
      if (engine) requestFrame(engine.call(sent, loaded));
    } catch (error) {
      if (typeof error !== 'string') failed(error);
      else wait(error, sent);
    }
  };
  const wait = (/** @type {string} */ part, /** @type {Sent} */ sent) => {
    if (![...waiting.values()].some((other) => other.part === part)) post({ type: 'part', part });
    waiting.set(sent[0], { part, calls: [sent] });
  };

  /** Adds a part that a call waits for, or refuses the call. @param {Arrived} arrived */
  const add = ({ part, module, why }) => {
    try {
      if (module && !loaded.has(part)) {
        extend(module);
        loaded.add(part);
      }
    } catch (error) {
      why = `${error}`;
    }
    for (const [fire, { part: needed, calls }] of waiting) {
      if (needed === part) {
        waiting.delete(fire);
        const [first] = calls;
        // A fire burns without its children.
        if (why && part === 'children' && first[2] === 'add') {
          first[3].children = false;
        } else if (why) {
          post(refusal(part, why, first));
          calls.shift();
        }
        calls.forEach(call);
      }
    }
  };
  /** Counts a picture of a fire as shown. @param {number} fire */
  const shown = (fire) => {
    try {
      if (engine) requestFrame(engine.shown(fire));
    } catch (error) {
      failed(error);
    }
  };

  return {
    /** Takes what a page sends. @param {{data: Sent | Arrived | number}} message */
    receive({ data }) {
      if (Array.isArray(data)) call(data);
      // The number of a fire whose picture is shown. Zero is a ping.
      else if (data === 0) post({ type: 'answer' });
      else if (typeof data === 'number') shown(data);
      else add(data);
    },
    /** Frees the engine and its context. */
    end() {
      stop()?.free();
    },
  };
}

/**
 * The event of a call that needs a part which could not be loaded: a new fire does not start, and
 * another keeps its settings.
 * @type {(part: string, why: string, sent: Sent) => object}
 */
function refusal(part, why, [fire, request, name]) {
  const [ids, subject] = PARTS[part];
  const message = `The code for ${subject} could not be loaded: ${why}`;
  if (name === 'add') return { type: 'error', fire, kind: 'load', message };
  const refused = name === 'spray' ? ['spray'] : ids;
  return { type: 'refused', fire, request, errors: refused.map((id) => ({ id, message })) };
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
