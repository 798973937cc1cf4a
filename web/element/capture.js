/**
 * Copies of what the canvas shows. This code is loaded by the first `toBlob` or `captureStream`.
 */

/**
 * The frame as a file.
 * @param {HTMLCanvasElement} canvas
 * @param {string} type
 * @param {number} [quality]
 * @returns {Promise<Blob>}
 */
export function toBlob(canvas, type, quality) {
  return new Promise((resolve, reject) => {
    const refused = new Error(`this browser cannot encode the frame as ${type}`);
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(refused)), type, quality);
  });
}

/**
 * The frames as a stream.
 * @param {HTMLCanvasElement} canvas
 * @param {number} [fps]
 * @returns {MediaStream}
 */
export function captureStream(canvas, fps) {
  if (!canvas.captureStream) throw new Error('this browser cannot capture a canvas');
  return fps === undefined ? canvas.captureStream() : canvas.captureStream(fps);
}
