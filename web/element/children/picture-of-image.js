/**
 * An image, a canvas or an SVG element as it is drawn in its content box.
 *
 * @typedef {import('./child-picture.js').Drawing} Drawing
 */

import { imageOfSvg } from './picture-of-svg.js';

/** The most pixels of a picture: those of 8192 x 8192. */
const MAX_PIXELS = 2 ** 26;

/** Whether an image has loaded or cannot. @param {Element} element */
export const isComplete = (element) => !('complete' in element) || Boolean(element.complete);

/**
 * How to draw a picture; as a string, the reason why it cannot be drawn. Undefined if its key is known.
 * @param {Element} element
 * @param {string} known the key of the last drawing
 * @returns {Promise<Drawing | string | undefined>}
 */
export async function imageIn(element, known) {
  const isSvg = element.localName === 'svg';
  const copied = isSvg
    ? await imageOfSvg(/** @type {SVGSVGElement} */ (element), contentOf(element).inner, known)
    : { image: /** @type {HTMLImageElement | HTMLCanvasElement} */ (element), drawTexts: undefined, key: undefined };
  if (!(copied instanceof Object)) return copied;
  const { image, drawTexts, key } = copied;
  const [across, up] =
    'naturalWidth' in image ? [image.naturalWidth, image.naturalHeight] : [image.width, image.height];
  if (!(across > 0 && up > 0)) return isSvg ? 'the policy of the page forbids data: images' : 'it has no pixels';
  if (across * up > MAX_PIXELS) return `it has more than ${MAX_PIXELS} pixels`;
  // Decoding takes no time of the page here.
  if ('decode' in image) await image.decode().catch(() => {});
  const { outer, inner, scale, css } = contentOf(element);
  const [width, height] = fitted(css.objectFit, [across * scale, up * scale], [inner.width, inner.height]);
  const [x, y = x] = css.objectPosition.split(' ');
  const left = inner.left + offset(x, inner.width - width, scale);
  const top = inner.top + offset(y, inner.height - height, scale);
  return {
    outer,
    box: inner,
    key,
    draw: (context) => {
      context.drawImage(image, left, top, width, height);
      drawTexts?.(context);
    },
  };
}

/**
 * The border box and the content box of an element in pixels of the window, the pixels of one of the style, and the
 * style.
 * @param {Element} element
 */
function contentOf(element) {
  const css = getComputedStyle(element);
  const outer = element.getBoundingClientRect();
  const { offsetWidth } = /** @type {HTMLElement} */ (element);
  const scale = offsetWidth ? outer.width / offsetWidth : 1;
  const [above, right, below, left] = ['Top', 'Right', 'Bottom', 'Left'].map((side) => {
    const { [`padding${side}`]: padding, [`border${side}Width`]: border } = /** @type {any} */ (css);
    return (parseFloat(padding) + parseFloat(border)) * scale;
  });
  const [width, height] = [outer.width - left - right, outer.height - above - below];
  return { css, scale, outer, inner: { left: outer.left + left, top: outer.top + above, width, height } };
}

/**
 * The size of a picture in a box.
 * @type {(fit: string, picture: [number, number], box: [number, number]) => [number, number]}
 */
function fitted(fit, [across, up], [width, height]) {
  const [wide, high] = [width / across, height / up];
  const inside = Math.min(wide, high);
  /** @type {{[fit: string]: number}} */
  const scales = { contain: inside, cover: Math.max(wide, high), none: 1, 'scale-down': Math.min(inside, 1) };
  const scale = scales[fit];
  return scale ? [across * scale, up * scale] : [width, height];
}

/**
 * A length or a share of the room as pixels; the middle where it is a sum.
 * @type {(text: string, room: number, scale: number) => number}
 */
function offset(text, room, scale) {
  const number = parseFloat(text);
  if (Number.isNaN(number)) return room / 2;
  return text.endsWith('%') ? (number / 100) * room : number * scale;
}
