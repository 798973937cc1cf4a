/** WebGL2 functions that fail, from the first call on or once in the middle, on each thread. */
import { Browser } from '../../driver.mjs';
import { onPageThread } from '../../clock.mjs';
import { FIRE, outcome } from './outcome.mjs';

/**
 * A fault: the function, what its calls give instead (`throws`, or a value as JSON), and the first
 * call and the number of calls that it strikes.
 * @typedef {[name: string, gives: string, first: number, calls: number]} Fault
 */

const ALWAYS = 1e9;

/** Calls after which a fire has been drawn for some frames. */
const LATER = 40;

const CREATES = ['Shader', 'Program', 'Texture', 'Buffer', 'Framebuffer', 'VertexArray'].map((name) => `create${name}`);
const DRAWS = [
  'drawArraysInstanced',
  'drawArrays',
  'bufferSubData',
  'bufferData',
  'bindFramebuffer',
  'viewport',
  'clear',
  'useProgram',
];

/** @type {Fault[]} */
const FAULTS = [
  .../** @type {Fault[]} */ (CREATES.map((name) => [name, 'null', 1, ALWAYS])),
  .../** @type {Fault[]} */ (CREATES.map((name) => [name, 'throws', 1, 1])),
  .../** @type {Fault[]} */ (DRAWS.map((name) => [name, 'throws', LATER, 1])),
  .../** @type {Fault[]} */ (DRAWS.map((name) => [name, 'throws', 1, ALWAYS])),
  ['getProgramParameter', 'false', 1, ALWAYS],
  ['getShaderParameter', 'false', 1, ALWAYS],
  ['checkFramebufferStatus', '36054', 1, ALWAYS],
  ['getExtension', 'null', 1, ALWAYS],
  ['getParameter', 'null', 1, ALWAYS],
  ['getParameter', '0', 1, ALWAYS],
  ['getError', '1285', 1, ALWAYS],
  ['getError', '1285', LATER, 1],
  ['getUniformLocation', 'null', 1, ALWAYS],
  ['isContextLost', 'true', 1, ALWAYS],
  ['isContextLost', 'true', LATER, 3],
  ['texImage2D', 'throws', 1, ALWAYS],
  ['texStorage2D', 'throws', 1, ALWAYS],
  ['framebufferTexture2D', 'throws', 1, 1],
  ['vertexAttribPointer', 'throws', 1, 1],
  ['fenceSync', 'null', 1, ALWAYS],
  ['getContext', 'null', 1, ALWAYS],
  ['getContext', 'throws', 1, ALWAYS],
  ['getContext', 'null', 1, 1],
  ['transferToImageBitmap', 'throws', LATER, 1],
  ['transferToImageBitmap', 'throws', 1, ALWAYS],
  ['any', 'throws', 1, 1],
  ['any', 'throws', 10, 1],
  ['any', 'throws', 100, 1],
  ['any', 'throws', 1000, 1],
  ['any', 'throws', 3000, 1],
  ['any', 'throws', 10_000, 1],
];

/**
 * Runs in the page or in a worker: spoils a function of every context.
 * @param {string} name @param {string} gives @param {number} first @param {number} calls
 */
function spoil(name, gives, first, calls) {
  const scope = /** @type {any} */ (globalThis);
  let call = 0;
  const holders = [scope.WebGL2RenderingContext, scope.OffscreenCanvas, scope.HTMLCanvasElement]
    .filter(Boolean)
    .map(({ prototype }) => prototype);
  for (const holder of holders) {
    const ofContext = holder === scope.WebGL2RenderingContext.prototype;
    const names = name === 'any' && ofContext ? Object.keys(holder) : [name];
    for (const method of names) {
      const { value: original } = Object.getOwnPropertyDescriptor(holder, method) ?? {};
      if (typeof original !== 'function') continue;
      holder[method] = function spoilt(...args) {
        if (method === 'getContext' && args[0] !== 'webgl2') return original.apply(this, args);
        call += 1;
        if (call < first || call >= first + calls) return original.apply(this, args);
        if (gives === 'throws') throw new Error(`${method} fails in a test`);
        return JSON.parse(gives);
      };
    }
  }
}

/** @returns {AsyncGenerator<import('./outcome.mjs').Finding>} */
export async function* graphics() {
  const browser = await Browser.launch();
  try {
    for (const fault of FAULTS) {
      const act = /** @type {any} */ (`() => (${spoil})(...${JSON.stringify(fault)})`);
      const [name, gives, first, calls] = fault;
      const words = `${name} ${gives === 'throws' ? gives : `gives ${gives}`} ${calls === ALWAYS ? 'always' : `at call ${first}`}`;
      yield await outcome(await browser.open(FIRE, { beforeWorker: act }), `in a worker, ${words}`);
      yield await outcome(await browser.open(onPageThread(FIRE), { before: act }), `on the page’s thread, ${words}`);
    }
  } finally {
    await browser.close();
  }
}
