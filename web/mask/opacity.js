/**
 * The opacity of a canvas as the text of a mask.
 *
 * @typedef {OffscreenCanvasRenderingContext2D | CanvasRenderingContext2D} Context
 */

/** The letters of opacities, of runs of transparent pixels and of runs of opaque ones. */
const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';
const OPAQUE = 15;
const RUNS = { 0: 16, [OPAQUE]: 40 };
/** The longest of the runs that differ by a pixel, and of all. */
const SHORT = 17;
const LONG = 4096;

/**
 * The text of the mask that a canvas of at most 256 x 256 pixels is; empty if nothing of it is opaque.
 * @param {Context} context
 * @throws {Error} the page may not read the pixels
 */
export function opacityOf(context) {
  const { width, height } = context.canvas;
  const pixels = context.getImageData(0, 0, width, height).data;
  const opacities = Array.from({ length: width * height }, (_, at) => Math.round((pixels[4 * at + 3] / 255) * OPAQUE));
  return opacities.some((opacity) => opacity > OPAQUE / 2) ? `${width}x${height}:${lettersOf(opacities)}` : '';
}

/** The letters of the pixels, runs of which have one. @param {number[]} opacities */
function lettersOf(opacities) {
  let letters = '';
  for (let at = 0; at < opacities.length; ) {
    const opacity = opacities[at];
    let run = 1;
    const first = RUNS[/** @type {0 | 15} */ (opacity)];
    while (first && opacities[at + run] === opacity && run < LONG) run += 1;
    if (run === 1) {
      letters += LETTERS[opacity];
    } else if (run <= SHORT || run < 32) {
      run = Math.min(run, SHORT);
      letters += LETTERS[first + run - 2];
    } else {
      const doubled = Math.floor(Math.log2(run / 32));
      run = 32 << doubled;
      letters += LETTERS[first + SHORT - 1 + doubled];
    }
    at += run;
  }
  return letters;
}

/**
 * A canvas, to be read or to be drawn reduced.
 * @param {number} width
 * @param {number} height
 * @param {boolean} [isRead]
 * @returns {Context}
 */
export function contextOf(width, height, isRead = true) {
  // Firefox refuses a size in em on an OffscreenCanvas.
  const canvas =
    globalThis.document?.createElement('canvas') ??
    (typeof OffscreenCanvas === 'function' ? new OffscreenCanvas(width, height) : undefined);
  if (!canvas) throw new Error('masks are drawn in browsers: there is no canvas here');
  Object.assign(canvas, { width, height });
  const context = /** @type {Context | null} */ (canvas.getContext('2d', { willReadFrequently: isRead }));
  if (!context) throw new Error('this browser has no memory left for a canvas');
  // A picture of many pixels would take long otherwise.
  context.imageSmoothingQuality = isRead ? 'high' : 'low';
  return context;
}
