/**
 * Copies of what the canvas shows. This code is loaded by the first `toBlob` or `captureStream`.
 */

import { countdown } from '../engine/time-limit.js';

/** Maximum time until a fire has a picture [s]. */
const PICTURE_S = 10;

/**
 * The canvas when it shows a frame.
 * @param {Promise<HTMLCanvasElement>} drawn
 * @returns {Promise<HTMLCanvasElement>}
 */
function framed(drawn) {
  return new Promise((resolve, reject) => {
    const cancel = countdown(PICTURE_S, () => reject(new Error(`no frame was drawn in ${PICTURE_S} s, because the fire is not visible`)));
    drawn.then(resolve, reject).finally(cancel);
  });
}

/**
 * The frame as a file.
 * @param {Promise<HTMLCanvasElement>} drawn settles with the first frame
 * @param {() => boolean} drawable whether the graphics context exists
 * @param {string} type
 * @param {number} [quality]
 * @returns {Promise<Blob>}
 */
export async function toBlob(drawn, drawable, type, quality) {
  const canvas = await framed(drawn);
  // The canvas may be empty.
  if (!drawable()) throw new Error('there is no frame while the graphics context is lost; it is restored with the event `restored`');
  return new Promise((resolve, reject) => {
    const refused = new Error(`this browser cannot encode the frame as ${String(type).slice(0, 100)}`);
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(refused)), type, quality);
  });
}

/**
 * The frames as a stream. It goes on when a lost context is restored.
 * @param {Promise<HTMLCanvasElement>} drawn settles with the first frame
 * @param {() => boolean} _
 * @param {number} [fps]
 * @returns {Promise<MediaStream>}
 */
export async function captureStream(drawn, _, fps) {
  const canvas = await framed(drawn);
  if (!canvas.captureStream) throw new Error('this browser cannot capture a canvas');
  return fps === undefined ? canvas.captureStream() : canvas.captureStream(fps);
}
