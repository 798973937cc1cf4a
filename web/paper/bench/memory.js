/**
 * The page in the iframe: counts the memory of WebAssembly, and the textures, buffers and canvases that WebGL2 is
 * asked for. The engine runs on this page's thread, because a page cannot look into a worker.
 */

import { HearthFire } from '../../hearth-fire.js';
import { addFire, fill } from './fires.js';

HearthFire.engine = 'main';

/** Bytes of each texture and buffer that exists. @type {Map<object, number>} */
const allocated = new Map();
/** The memories of all wasm. @type {Set<WebAssembly.Memory>} */
const memories = new Set();
/** The contexts that draw. @type {Set<WebGL2RenderingContext>} */
const contexts = new Set();

const GL = WebGL2RenderingContext;
/** Numbers of a texel. @type {{[format: number]: number}} */
const CHANNELS = { [GL.RGBA]: 4, [GL.RGB]: 3, [GL.RG]: 2, [GL.RED]: 1 };
/** Bytes of such a number. @type {{[type: number]: number}} */
const BYTES = { [GL.FLOAT]: 4, [GL.HALF_FLOAT]: 2, [GL.UNSIGNED_BYTE]: 1 };

/**
 * Runs `note` after each call of a function.
 * @param {any} object
 * @param {string} name
 * @param {(self: any, args: any[]) => void} note
 */
function observe(object, name, note) {
  const original = object[name];
  object[name] = function observed(/** @type {any[]} */ ...args) {
    const result = original.apply(this, args);
    note(this, args);
    return result;
  };
}

observe(GL.prototype, 'texImage2D', (gl, [, , , width, height, , format, type]) => {
  contexts.add(gl);
  const texture = gl.getParameter(GL.TEXTURE_BINDING_2D);
  if (texture) allocated.set(texture, width * height * (CHANNELS[format] ?? 4) * (BYTES[type] ?? 4));
});
observe(GL.prototype, 'bufferData', (gl, [target, data]) => {
  const buffer = gl.getParameter(
    target === GL.ARRAY_BUFFER ? GL.ARRAY_BUFFER_BINDING : GL.ELEMENT_ARRAY_BUFFER_BINDING,
  );
  if (buffer) allocated.set(buffer, typeof data === 'number' ? data : data.byteLength);
});
for (const name of ['deleteTexture', 'deleteBuffer'])
  observe(GL.prototype, name, (_, [object]) => allocated.delete(object));

/** The functions that instantiate wasm. @type {any} */
const wasm = WebAssembly;
for (const name of ['instantiate', 'instantiateStreaming']) {
  const original = wasm[name];
  wasm[name] = async (/** @type {any[]} */ ...args) => {
    const made = await original.apply(wasm, args);
    for (const value of Object.values((made.instance ?? made).exports)) {
      if (value instanceof WebAssembly.Memory) memories.add(value);
    }
    return made;
  };
}

/** What is held now [bytes]. */
function held() {
  const canvases = [...contexts].map((gl) => gl.drawingBufferWidth * gl.drawingBufferHeight);
  const shown = [...document.querySelectorAll('hearth-fire')].flatMap((fire) =>
    [...(fire.shadowRoot?.querySelectorAll('canvas') ?? [])].map(({ width, height }) => width * height),
  );
  const sum = (/** @type {Iterable<number>} */ numbers) => [...numbers].reduce((a, b) => a + b, 0);
  return {
    wasm: sum([...memories].map(({ buffer }) => buffer.byteLength)),
    gpu: sum(allocated.values()) + 4 * sum([...canvases, ...shown]),
  };
}

/**
 * The memory of a full fire, in turn for each of these sizes of a particle [m], or for the default one.
 * @param {import('./rows.js').Model} model
 * @param {number} count
 * @param {(number | undefined)[]} sizes
 * @param {() => Promise<void>} pause
 */
export async function measure(model, count, sizes, pause) {
  const fire = addFire(document.body, model, count);
  await fill(fire, count, pause);
  const found = [];
  for (const size of sizes) {
    await pause();
    if (size !== undefined) fire.set('particle_size', size);
    // The first picture after a change allocates.
    for (let pictures = 0; pictures < 3; pictures += 1) await fire.step(1);
    if (size !== undefined && Math.abs(fire.params.particle_size - size) > 1e-6) {
      throw new Error(`particle_size = ${size} was refused`);
    }
    found.push({ ...held(), pictureMs: fire.stats?.drawMs ?? 0 });
  }
  return found;
}

/** @type {any} */ (window).measure = measure;
