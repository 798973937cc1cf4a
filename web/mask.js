/**
 * Masks: what is opaque in a text, a path or an image, as the shape of a solid. Each function returns the
 * properties of a solid that stands for it:
 *
 *     fire.addObject({ kind: 'solid', ...maskOfText('FIRE', '700 1em Georgia', 1.2), y: 0.3 });
 *
 * The browser draws what it is given, up to 256 pixels across; the fire gets the opacity of each pixel as
 * a text. Nothing of a URL is in it.
 *
 * @typedef {{shape: 'mask', mask: string, width: number, height: number}} HearthMask
 * @typedef {import('./mask/opacity.js').Context} Context
 */

import { contextOf, opacityOf } from './mask/opacity.js';
import { cut } from './quoted.js';

/** The pixels of the longer side. */
const PIXELS = 256;
/**
 * The mask of a line of text, as wide as its ink. A font of the page must have loaded:
 * `await document.fonts.load(font)`.
 * @param {string} text
 * @param {string} font  A CSS font; its size has no effect.
 * @param {number} [width]  [m]
 * @returns {HearthMask}
 * @throws {RangeError} no glyph has ink, or it is no font
 */
export function maskOfText(text, font, width = 1) {
  if (typeof text !== 'string') throw refused('text', text, 'a text');
  if (typeof font !== 'string') throw refused('font', font, 'a CSS font, such as "700 1em Georgia"');
  checkWidth(width);
  const measure = contextOf(1, 1);
  measure.font = '10px serif';
  const before = measure.font;
  measure.font = '20px serif';
  const other = measure.font;
  measure.font = font;
  if (measure.font === other) {
    measure.font = before;
    measure.font = font;
    if (measure.font === before) throw refused('font', font, 'a CSS font, such as "700 1em Georgia"');
  }
  const {
    actualBoundingBoxLeft: left,
    actualBoundingBoxRight: right,
    actualBoundingBoxAscent: above,
    actualBoundingBoxDescent: below,
  } = measure.measureText(text);
  return maskOf('text', text, [-left, -above, left + right, above + below], width, (context) => {
    context.font = font;
    context.fillText(text, 0, 0);
  });
}

/**
 * The mask of an SVG path, filled.
 * @param {string} path  As the attribute `d` of a path.
 * @param {readonly [number, number, number, number]} box  What is seen of it: left, top, width and height.
 * @param {number} [width]  Of the box [m]
 * @returns {HearthMask}
 * @throws {RangeError} nothing of it is in the box
 */
export function maskOfPath(path, box, width = 1) {
  if (typeof path !== 'string') throw refused('path', path, 'a text of SVG');
  if (!Array.isArray(box) || box.length !== 4 || !box.every(Number.isFinite))
    throw refused('box', box, 'a list of four numbers: left, top, width and height');
  return maskOf('path', path, box, width, (context) => context.fill(new Path2D(path)));
}

/**
 * The mask of an image: its opacity.
 * @param {CanvasImageSource} image  An image, a video, a canvas or a bitmap, whose pixels the page may read.
 * @param {number} [width]  [m]
 * @returns {HearthMask}
 * @throws {RangeError} it has no pixels yet or no opaque ones, or the page may not read them
 */
export function maskOfImage(image, width = 1) {
  const allowed = 'an image, a video or a canvas';
  if (typeof image !== 'object' || image === null) throw refused('image', image, allowed);
  const sized = /** @type {{[side: string]: any}} */ (image);
  const across = sized.naturalWidth ?? sized.videoWidth ?? sized.displayWidth ?? sized.width;
  const up = sized.naturalHeight ?? sized.videoHeight ?? sized.displayHeight ?? sized.height;
  return maskOf('image', 'an image', [0, 0, across, up], width, (context) =>
    context.drawImage(image, 0, 0, across, up),
  );
}

/** Throws for a width that a solid cannot have. @param {unknown} width */
function checkWidth(width) {
  if (typeof width !== 'number' || !(width >= 0.002 && width <= 10))
    throw refused('width', width, 'a number from 0.002 to 10 m');
}

/**
 * The mask of what `draw` draws in a box.
 * @param {string} id @param {string} value @param {readonly number[]} box @param {number} width
 * @param {(context: Context) => void} draw
 * @returns {HearthMask}
 */
function maskOf(id, value, [left, top, across, up], width, draw) {
  checkWidth(width);
  if (!(typeof across === 'number' && typeof up === 'number' && across > 0 && up > 0 && across + up < Infinity))
    throw refused(id, value, 'something with a width and a height');
  const scale = PIXELS / Math.max(across, up);
  const columns = Math.max(Math.round(across * scale), 1);
  const rows = Math.max(Math.round(up * scale), 1);
  const context = contextOf(columns, rows);
  context.setTransform(columns / across, 0, 0, rows / up, (-left * columns) / across, (-top * rows) / up);
  let mask;
  try {
    draw(context);
    mask = opacityOf(context);
  } catch (cause) {
    throw refused(id, value, 'something whose pixels the page may read', cause);
  }
  if (!mask) throw refused(id, value, 'something with opaque pixels');
  return { shape: 'mask', mask, width, height: Math.min(Math.max((width * up) / across, 0.002), 10) };
}

/** @param {string} id @param {unknown} value @param {string} allowed @param {unknown} [cause] */
function refused(id, value, allowed, cause) {
  const shown = typeof value === 'object' && value ? 'something of type object' : String(value);
  return Object.assign(new RangeError(`${id} = "${cut(shown)}" is refused: it must be ${allowed}`, { cause }), { id });
}
