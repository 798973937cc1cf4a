/** What becomes of alpha in formats whose encoders have none. */

/** Distance to which the colour of the fire goes on where nothing is seen, in case an encoder mixes it in [pixels]. */
const BLED = 8;
/**
 * Continues colours where nothing is seen, to the right and down, then to the left and up.
 * @type {(rgba: Uint8ClampedArray, width: number) => void}
 */
export function bleed(rgba, width) {
  const count = rgba.length / 4;
  const far = new Uint8Array(count).fill(BLED + 1);
  const pass = (/** @type {number} */ from, /** @type {number} */ by) => {
    for (let done = 0, pixel = from; done < count; done += 1, pixel += by) {
      if (rgba[4 * pixel + 3] > 0) {
        far[pixel] = 0;
        continue;
      }
      for (const near of [pixel - by, pixel - by * width]) {
        if (near < 0 || near >= count || far[near] + 1 >= far[pixel]) continue;
        far[pixel] = far[near] + 1;
        rgba.copyWithin(4 * pixel, 4 * near, 4 * near + 3);
      }
    }
  };
  pass(0, 1);
  pass(count - 1, -1);
}

/**
 * Opaque pixels of a picture of twice the height: its colours, and below them alpha as a grey.
 * @type {(rgba: Uint8ClampedArray, width: number) => Uint8ClampedArray<ArrayBuffer>}
 */
export function stacked(rgba, width) {
  bleed(rgba, width);
  const both = new Uint8ClampedArray(2 * rgba.length).fill(255);
  for (let at = 0; at < rgba.length; at += 1) {
    if (at % 4 === 3) continue;
    both[at] = rgba[at];
    both[rgba.length + at] = rgba[at | 3];
  }
  return both;
}
