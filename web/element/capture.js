/**
 * Copies of what the canvas shows. This code is loaded by the first `toBlob` or `captureStream`.
 */

/**
 * The frame as a file.
 * @param {HTMLCanvasElement} canvas
 * @param {boolean} drawable whether the graphics context exists
 * @param {string} type
 * @param {number} [quality]
 * @returns {Promise<Blob>}
 */
export async function toBlob(canvas, drawable, type, quality) {
  // The canvas may be empty.
  if (!drawable) throw new Error('there is no frame while the graphics context is lost; it is restored with the event `restored`');
  return new Promise((resolve, reject) => {
    const refused = new Error(`this browser cannot encode the frame as ${String(type).slice(0, 100)}`);
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(refused)), type, quality);
  });
}

/**
 * The frames as a stream.
 * @param {HTMLCanvasElement} canvas
 * @param {boolean} _ whether the graphics context exists: the stream goes on when it is restored
 * @param {number} [fps]
 * @returns {MediaStream}
 */
export function captureStream(canvas, _, fps) {
  if (!canvas.captureStream) throw new Error('this browser cannot capture a canvas');
  return fps === undefined ? canvas.captureStream() : canvas.captureStream(fps);
}
