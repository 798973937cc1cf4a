/**
 * What the driver does inside a page and inside its workers. Each function is
 * sent there as text, so that none may use anything of this file.
 */

/**
 * Runs in the page and in its workers, before any script of theirs: knows every
 * WebGL2 context, so that a test can lose one as a driver's crash would, and counts
 * what is held in contexts and by wasm. Everything else may be collected.
 */
export function rememberContexts() {
  const scope = /** @type {any} */ (globalThis);
  /** @type {WeakRef<any>[]} */
  const known = [];
  Object.defineProperty(scope, 'contexts', {
    get: () => known.map((reference) => reference.deref()).filter((context) => context !== undefined),
  });
  for (const type of [scope.HTMLCanvasElement, scope.OffscreenCanvas]) {
    if (!type) continue;
    const original = type.prototype.getContext;
    type.prototype.getContext = function getContext(...args) {
      const context = original.apply(this, args);
      if (args[0] === 'webgl2' && context && !scope.contexts.includes(context)) {
        known.push(new WeakRef(context));
        this.addEventListener('webglcontextlost', () => made.delete(context));
      }
      return context;
    };
  }
  // A context that stays has to be free of what was made in it. What a lost one had is gone.
  /** @type {WeakMap<any, {kept: WeakSet<any>, kinds: {[kind: string]: number}}>} */
  const made = new WeakMap();
  const madeIn = (context) => {
    const known = made.get(context) ?? { kept: new WeakSet(), kinds: {} };
    made.set(context, known);
    return known;
  };
  const { prototype } = scope.WebGL2RenderingContext ?? {};
  for (const kind of ['Texture', 'Buffer', 'Framebuffer', 'Program', 'Shader', 'VertexArray', 'Query']) {
    const [create, remove] = [prototype?.[`create${kind}`], prototype?.[`delete${kind}`]];
    if (!create) continue;
    prototype[`create${kind}`] = function counted(...args) {
      const object = create.apply(this, args);
      if (object && !this.isContextLost()) {
        const { kept, kinds } = madeIn(this);
        kept.add(object);
        kinds[kind] = (kinds[kind] ?? 0) + 1;
      }
      return object;
    };
    prototype[`delete${kind}`] = function counted(object) {
      const { kept, kinds } = madeIn(this);
      if (object && kept.delete(object)) kinds[kind] -= 1;
      return remove.call(this, object);
    };
  }
  /** @type {WeakRef<WebAssembly.Memory>[]} */
  const memories = [];
  for (const name of ['instantiate', 'instantiateStreaming']) {
    const original = scope.WebAssembly?.[name];
    if (!original) continue;
    scope.WebAssembly[name] = async (...args) => {
      const made = await original.apply(scope.WebAssembly, args);
      for (const value of Object.values((made.instance ?? made).exports)) {
        if (value instanceof WebAssembly.Memory) memories.push(new WeakRef(value));
      }
      return made;
    };
  }
  const living = () => scope.contexts.filter((context) => !context.isContextLost());
  const total = (kinds) => Object.values(kinds).reduce((sum, number) => sum + number, 0);
  scope.driven = {
    /** The number of live contexts. */
    count: () => living().length,
    /** How many things of a graphics card were made in contexts that are not lost, and not deleted. */
    objects: () => living().reduce((sum, context) => sum + total(madeIn(context).kinds), 0),
    /** Bytes of all wasm's memory. */
    memory: () => memories.reduce((sum, reference) => sum + (reference.deref()?.buffer.byteLength ?? 0), 0),
    /** Loses the live contexts, for so long; returns their number. */
    lose(milliseconds) {
      const lost = living();
      for (const context of lost) {
        // A lost context does not give the extension that brings it back.
        const extension = context.getExtension('WEBGL_lose_context');
        extension.loseContext();
        if (milliseconds !== null) setTimeout(() => extension.restoreContext(), milliseconds);
      }
      return lost.length;
    },
  };
}

/**
 * Runs in the page and in its workers: nothing is drawn in a WebGL2 context. Contexts, programs,
 * textures and frames are real. A software renderer takes a third of the processor in a test that
 * looks at no picture.
 */
export function drawNothing() {
  const { prototype } = /** @type {any} */ (globalThis).WebGL2RenderingContext ?? {};
  if (!prototype) return;
  for (const name of ['drawArrays', 'drawArraysInstanced', 'drawElements', 'drawElementsInstanced']) {
    prototype[name] = () => undefined;
  }
}

/**
 * Runs in a worker after `rememberContexts`: answers the page's driver, on a line of
 * its own so that the worker's messages stay the page's, and forwards its errors.
 * @param {string} line
 */
export function answerPage(line) {
  const { driven } = /** @type {any} */ (globalThis);
  const channel = new BroadcastChannel(line);
  channel.onmessage = ({ data }) => {
    if (data.ask) channel.postMessage({ answer: data.number, value: driven[data.ask](data.with) });
  };
  const report = (/** @type {string} */ problem) => channel.postMessage({ problem });
  addEventListener('error', (event) => report(event.message));
  addEventListener('unhandledrejection', (event) => report(String(event.reason)));
}

/**
 * Runs in the page after `rememberContexts`: starts each worker of this origin
 * with the driver's own lines before its own, and queries them.
 * @param {string} origin  Where the driver's lines are served.
 */
export function followWorkers(origin) {
  if (location.origin !== origin) return;
  const scope = /** @type {any} */ (window);
  const line = `driver-${Math.random()}`;
  const channel = new BroadcastChannel(line);
  const workers = new Set();
  // Before the page's own policy counts. A policy in a header may forbid it.
  let trusted = (/** @type {string} */ url) => url;
  try {
    const policy = scope.trustedTypes?.createPolicy('driver', { createScriptURL: trusted });
    if (policy) trusted = (url) => policy.createScriptURL(url);
  } catch {}
  /** @type {Map<number, (value: number) => void>} */
  const waiting = new Map();
  channel.onmessage = ({ data }) => {
    if (data.problem) console.error(`in a worker: ${data.problem}`);
    else if (data.answer) waiting.get(data.answer)?.(data.value);
  };
  scope.Worker = class Worker extends scope.Worker {
    constructor(url, options) {
      const of = new URL(url, document.baseURI);
      const type = options?.type ?? 'classic';
      const about = new URLSearchParams({ of: of.href, type, line });
      super(of.origin === origin ? trusted(`/driver/worker.js?${about}`) : url, options);
      workers.add(this);
    }

    terminate() {
      workers.delete(this);
      super.terminate();
    }
  };
  let number = 0;
  /** The sum of what page and workers answer; one that cannot start never does. */
  const sum = async (ask, value) => {
    number += 1;
    const own = number;
    let answered = scope.driven[ask](value);
    let missing = workers.size;
    if (missing > 0) {
      await new Promise((resolve) => {
        setTimeout(resolve, 5000);
        waiting.set(own, (more) => {
          answered += more;
          missing -= 1;
          if (missing === 0) resolve(undefined);
        });
        channel.postMessage({ ask, with: value, number: own });
      });
      waiting.delete(own);
    }
    return answered;
  };
  scope.driver = {
    lose: (milliseconds) => sum('lose', milliseconds),
    contexts: () => sum('count'),
    objects: () => sum('objects'),
    memory: () => sum('memory'),
    workers: () => workers.size,
  };
}

/**
 * Runs in a page whose browser reports no problems to its driver: keeps them in
 * `window.keptProblems`.
 */
export function keepProblems() {
  const problems = [];
  /** @type {any} */ (window).keptProblems = problems;
  for (const type of ['error', 'warn', 'assert']) {
    const original = console[type];
    console[type] = (...words) => {
      if (type !== 'assert' || !words[0]) problems.push(`console.${type}: ${words.join(' ')}`);
      original.apply(console, words);
    };
  }
  addEventListener(
    'error',
    (event) => {
      const { target } = /** @type {any} */ (event);
      // Elements have error events of their own, which are the page's to hear.
      if (event instanceof ErrorEvent) problems.push(`uncaught: ${event.message}`);
      else if (target.src ?? target.href) problems.push(`request failed: ${target.src ?? target.href}`);
    },
    true,
  );
  addEventListener('unhandledrejection', (event) => {
    problems.push(`uncaught: ${event.reason}`);
  });
}
