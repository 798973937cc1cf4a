/**
 * Masks: what is opaque in a text, a path or an image, as the shape of a solid.
 */

/** The properties of a solid that stands for a mask. */
export interface HearthMask {
  shape: 'mask';
  /** The opacity of its pixels. */
  mask: string;
  /** [m] */
  width: number;
  /** [m], in the proportions of the picture */
  height: number;
}

/**
 * The mask of a line of text, as wide as its ink: 1 m, or `width`. A font of the page must have loaded:
 * `await document.fonts.load(font)`. The size of the font has no effect. Throws a RangeError if no glyph has
 * ink or `font` is no CSS font.
 */
export function maskOfText(text: string, font: string, width?: number): HearthMask;

/**
 * The mask of a filled SVG path, in a box of left, top, width and height. Throws a RangeError if nothing of it is in
 * the box.
 */
export function maskOfPath(path: string, box: readonly [number, number, number, number], width?: number): HearthMask;

/**
 * The mask of the opacity of an image, a video, a canvas or a bitmap. Throws a RangeError if it has no opaque
 * pixels, or if the page may not read them.
 */
export function maskOfImage(image: CanvasImageSource, width?: number): HearthMask;
