/**
 * The mask of an image file that a visitor chooses, drops or pastes. An SVG is a picture, too: an image runs no script
 * and fetches nothing.
 */

import { maskOfImage } from '../mask.js';
import { MAX_DRAWN, elementsDrawn } from './svg-elements.js';

/** The largest file [bytes], and the most pixels of an image. */
const MAX_BYTES = 20e6;
const MAX_PIXELS = 40e6;

/**
 * What is opaque in an image file.
 * @param {Blob} file
 * @param {number} width  [m]
 * @throws {Error} it is no image, too large, or nothing in it is opaque
 */
export async function maskOfFile(file, width) {
  const name = 'name' in file && file.name ? `“${file.name}”` : 'What was pasted';
  if (!file.type.startsWith('image/')) throw new Error(`${name} is no image.`);
  if (file.size > MAX_BYTES)
    throw new Error(`${name} has ${Math.round(file.size / 1e6)} MB; an image has at most ${MAX_BYTES / 1e6} MB.`);
  if (file.type.includes('svg') && elementsDrawn(await file.text()) > MAX_DRAWN)
    throw new Error(`${name} draws more than ${MAX_DRAWN} elements.`);
  const image = new Image();
  const url = URL.createObjectURL(file);
  try {
    image.src = url;
    await new Promise((resolve, reject) => {
      image.onload = resolve;
      image.onerror = () => reject(new Error(`${name} cannot be read as an image.`));
    });
    const pixels = image.naturalWidth * image.naturalHeight;
    if (pixels > MAX_PIXELS)
      throw new Error(`${name} has ${Math.round(pixels / 1e6)} megapixels; an image has at most ${MAX_PIXELS / 1e6}.`);
    return maskOfImage(image, width);
  } finally {
    URL.revokeObjectURL(url);
  }
}
