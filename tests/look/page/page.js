/**
 * The painter's page: draws what a test requests and returns the pixels. A test
 * calls `window.look`.
 */
import init, { Fire, Painter, locus, presets } from '/painter.js';
import { Film, glance } from '/film.mjs';

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

/** Takes extensions from a context, before any code requests them. */
function lessCapable(context, without) {
  const { getExtension, getSupportedExtensions } = WebGL2RenderingContext.prototype;
  context.getExtension = (name) => (without.includes(name) ? null : getExtension.call(context, name));
  context.getSupportedExtensions = () => getSupportedExtensions.call(context).filter((name) => !without.includes(name));
}

async function snapshot(name) {
  if (!snapshots.has(name)) {
    const answer = await fetch(`/snapshots/${name}.bin`);
    if (!answer.ok) throw new Error(`there is no snapshot ${name}`);
    snapshots.set(name, new Uint8Array(await answer.arrayBuffer()));
  }
  return snapshots.get(name);
}

/** The fire of a request: a kept one, or one that has burnt until then. */
async function fireOf({ kept, mode = '', lit, burnt = 0, values = {} }) {
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
async function still({ width, height, format, without, quality = 'medium', ...request }) {
  const fire = await fireOf(request);
  const { context, painter: of } = painter(format, without);
  Object.assign(context.canvas, { width, height });
  const brush = of.of_one_fire(quality);
  brush.paint_still(fire, width, height);
  const pixels = brush.pixels(width, height);
  brush.destroy();
  brush.free();
  fire.free();
  report(context);
  return packed(pixels);
}

/** Throws an error if GL has refused a call. */
function report(context) {
  const error = context.getError();
  if (error !== 0) throw new Error(`GL error ${error}`);
}

/** The format of the fields on a device like that. */
const formatOf = ({ format, without }) => painter(format, without).painter.format;

const value = async (request, id) => {
  const fire = await fireOf(request);
  const found = fire.value(id);
  fire.free();
  return found;
};

/**
 * Two fires in one context, drawn in turn, picture by picture: the last picture of each.
 * Where there is only one, it is drawn alone.
 */
async function inTurn(requests, pictures, disturbance) {
  const { context, painter: of } = painter();
  const fires = await Promise.all(requests.map(fireOf));
  const brushes = fires.map(() => of.of_one_fire('medium'));
  const last = [];
  for (let picture = 1; picture <= pictures; picture += 1) {
    requests.forEach(({ width, height }, index) => {
      Object.assign(context.canvas, { width, height });
      fires[index].burn(requests[index].burnt + picture / 30);
      if (disturbance) DISTURBANCES[disturbance](context);
      brushes[index].paint(fires[index], width, height);
      last[index] = packed(brushes[index].pixels(width, height));
    });
  }
  for (const brush of brushes) brush.destroy();
  report(context);
  if (disturbance) painters.clear();
  return last;
}

/** States in which foreign code may leave a context. */
const DISTURBANCES = {
  'tests on': (gl) => {
    for (const test of [gl.DEPTH_TEST, gl.STENCIL_TEST, gl.SCISSOR_TEST, gl.CULL_FACE]) gl.enable(test);
    gl.scissor(3, 3, 5, 5);
    gl.cullFace(gl.FRONT_AND_BACK);
    gl.depthFunc(gl.NEVER);
    gl.stencilFunc(gl.NEVER, 1, 255);
  },
  blending: (gl) => {
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.DST_COLOR, gl.ZERO);
  },
  'another target, view and colour': (gl) => {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 4, 4, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.viewport(1, 1, 2, 2);
    gl.clearColor(1, 0, 1, 1);
  },
  'other textures': (gl) => {
    const texture = gl.createTexture();
    for (let unit = 0; unit < 8; unit += 1) {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    }
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array([255, 0, 255, 255]));
  },
  'another program and its arrays': (gl) => {
    const program = gl.createProgram();
    for (const [kind, source] of [
      [gl.VERTEX_SHADER, '#version 300 es\nin vec4 at;\nvoid main() { gl_Position = at; }'],
      [gl.FRAGMENT_SHADER, '#version 300 es\nprecision highp float;\nout vec4 c;\nvoid main() { c = vec4(1.0); }'],
    ]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    gl.bindVertexArray(gl.createVertexArray());
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, 12, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
  },
};
/** The state that every host restores: the renderer does not query it. */
DISTURBANCES['a colour without two channels'] = (gl) => gl.colorMask(true, false, true, true);
const disturbances = () => Object.keys(DISTURBANCES);

let film;
/** Starts to watch a fire that burns. */
async function watch(request) {
  film?.brush.destroy();
  const { context, painter: of } = painter();
  film = new Film({ context, brush: of.of_one_fire('medium'), fire: await fireOf(request), locus });
}
/** Watches it until that time. */
function until(seconds) {
  film.until(seconds);
  report(film.context);
}
/** The same, and returns the figures of the film. */
function seen(seconds) {
  until(seconds);
  return film.found();
}

/** The figures of a short and coarse film of a fire. */
async function glanced(request, seconds) {
  const { context, painter: of } = painter();
  const [brush, fire] = [of.of_one_fire('low'), await fireOf(request)];
  const found = glance({ context, brush, fire }, seconds);
  brush.destroy();
  brush.free();
  fire.free();
  report(context);
  return found;
}

await init();
Object.assign(window, { look: { still, formatOf, value, inTurn, disturbances, presets, watch, until, seen, glanced } });
