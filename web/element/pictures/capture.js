/**
 * Copies of what the canvas shows, and films. This code is loaded by the first `toBlob`, `captureStream` or `record`.
 */

import { countdown } from '../../engine/time-limit.js';
import { cut } from '../../quoted.js';

/** Maximum time until a fire has a picture [s]. */
const PICTURE_S = 10;

/**
 * The canvas when it shows a frame.
 * @param {Promise<HTMLCanvasElement>} drawn
 * @returns {Promise<HTMLCanvasElement>}
 */
function framed(drawn) {
  return new Promise((resolve, reject) => {
    const cancel = countdown(PICTURE_S, () =>
      reject(new Error(`no frame was drawn in ${PICTURE_S} s, because the fire is not visible`)),
    );
    drawn.then(resolve, reject).finally(cancel);
  });
}

/**
 * The frame as a file.
 * @param {import('../session/session.js').FireSession} session
 * @param {string | import('../types.js').HearthPicture} how its type, or all that a page can choose
 * @param {number} [share] the quality
 * @returns {Promise<Blob>}
 */
export async function toBlob(session, how, share) {
  const { type, quality, width, background } = optionsOf(how, share);
  const canvas = await framed(session.view.drawn());
  // The canvas may be empty.
  if (!session.drawable)
    throw new Error('there is no frame while the graphics context is lost; it is restored with the event `restored`');
  const encode = () =>
    new Promise((/** @type {(blob: Blob) => void} */ resolve, reject) => {
      const refused = new Error(`this browser cannot encode the frame as ${cut(type)}`);
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(refused)), type, quality);
    });
  if (width === undefined && background === undefined) return encode();
  const { redraw } = await import('./redraw.js');
  return redraw(session, canvas, { width, background }, encode);
}

/**
 * The frames as a stream, with the sound if there is any. It goes on when a lost context is restored.
 * @param {import('../session/session.js').FireSession} session
 * @param {number} [fps]
 * @returns {Promise<MediaStream>}
 */
export async function captureStream(session, fps) {
  if (fps !== undefined && !(typeof fps === 'number' && fps >= 0 && fps < Infinity))
    throw new RangeError('fps must be a number of frames per second, 0 or more');
  const canvas = await framed(session.view.drawn());
  if (!canvas.captureStream) throw new Error('this browser cannot capture a canvas');
  const stream = fps === undefined ? canvas.captureStream() : canvas.captureStream(fps);
  const track = session.code.player?.track();
  if (track) stream.addTrack(track);
  return stream;
}

/**
 * A film of the fire. Its code is loaded with the first one.
 * @param {import('../session/session.js').FireSession} session
 * @param {import('../types.js').HearthFilm} [options]
 * @returns {Promise<Blob | undefined>}
 */
export async function record(session, options) {
  const films = await session.reports.loads(import('../../record.js'), 'The code for films');
  return films.record(session, options);
}

/**
 * The options of a picture.
 * @param {unknown} how
 * @param {unknown} share
 * @returns {{type: string, quality?: number, width?: number, background?: string}}
 * @throws {TypeError} one is of another type
 */
function optionsOf(how, share) {
  const given = /** @type {any} */ (typeof how === 'object' ? (how ?? {}) : { type: how, quality: share });
  const { type = 'image/png', quality, width, background } = given;
  for (const [name, value, kind] of [
    ['type', type, 'string'],
    ['quality', quality, 'number'],
    ['width', width, 'number'],
    ['background', background, 'string'],
  ])
    if (value !== undefined && typeof value !== kind)
      throw new TypeError(`${name} must be a ${kind}, not a ${typeof value}`);
  return { type, quality, width, background };
}
