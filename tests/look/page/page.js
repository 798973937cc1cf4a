/**
 * The painter's page: draws what a test asks for and hands the pixels back. A test
 * calls `window.look`.
 */
import init, { Fire, Painter } from '/painter.js';

/** As the engine makes its own context. */
const ATTRIBUTES = { alpha: true, premultipliedAlpha: true, antialias: false, depth: false };

/** Painters by how they were made: compiling shaders takes longer than drawing. */
const painters = new Map();
const snapshots = new Map();

/**
 * A context and what paints in it.
 * @param {string} format  `rgba16f`, `rgba8`, or the best.
 * @param {string[]} without  Extensions that this device has not.
 */
function painter(format = '', without = []) {
  const key = JSON.stringify([format, without]);
  if (!painters.has(key)) {
    const context = new OffscreenCanvas(1, 1).getContext('webgl2', ATTRIBUTES);
    if (!context) throw new Error('this browser has no WebGL2');
    lessCapable(context, without);
    painters.set(key, { context, painter: new Painter(context, format) });
  }
  return painters.get(key);
}

/** Takes extensions from a context, before anybody asks for them. */
function lessCapable(context, without) {
  const { getExtension, getSupportedExtensions } = WebGL2RenderingContext.prototype;
  context.getExtension = (name) => (without.includes(name) ? null : getExtension.call(context, name));
  context.getSupportedExtensions = () => (
    getSupportedExtensions.call(context).filter((name) => !without.includes(name))
  );
}

async function snapshot(name) {
  if (!snapshots.has(name)) {
    const answer = await fetch(`/snapshots/${name}.bin`);
    if (!answer.ok) throw new Error(`there is no snapshot ${name}`);
    snapshots.set(name, new Uint8Array(await answer.arrayBuffer()));
  }
  return snapshots.get(name);
}

/** The fire of a wish: a kept one, or one that has burnt until then. */
async function fireOf({ kept, mode = 'fire', lit, burnt = 0, values = {} }) {
  const fire = kept ? Fire.kept(await snapshot(kept), mode) : Fire.lit(lit);
  for (const [id, value] of Object.entries(values)) fire.set(id, String(value));
  if (lit) fire.burn(burnt);
  return fire;
}

/** Bytes as text, which is what a test can be sent. */
function packed(bytes) {
  let text = '';
  for (let at = 0; at < bytes.length; at += 32768) {
    text += String.fromCharCode(...bytes.subarray(at, at + 32768));
  }
  return btoa(text);
}

/** A fire that stands still, as RGBA from the upper left. */
async function still({ width, height, format, without, lines = 'medium', ...wish }) {
  const fire = await fireOf(wish);
  const { context, painter: of } = painter(format, without);
  Object.assign(context.canvas, { width, height });
  const easel = of.easel(lines);
  easel.paint_still(fire, width, height);
  const pixels = easel.pixels(width, height);
  easel.leave();
  easel.free();
  fire.free();
  complain(context);
  return packed(pixels);
}

/** Nothing that GL refused goes by unnoticed. */
function complain(context) {
  const error = context.getError();
  if (error !== 0) throw new Error(`GL says ${error}`);
}

/** The format of the fields on a device like that. */
const formatOf = ({ format, without }) => painter(format, without).painter.format;

const value = async (wish, id) => {
  const fire = await fireOf(wish);
  const found = fire.value(id);
  fire.free();
  return found;
};

await init();
Object.assign(window, { look: { still, formatOf, value, painter, fireOf, packed, complain } });
