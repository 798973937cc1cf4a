/**
 * The target of `of` in the domain of a fire: its border box in metres.
 *
 * @typedef {import('../../generated/properties.js').Domain} Domain
 * @typedef {{left: number, right: number, top: number, bottom: number, radius: number}} Box
 *   sides and corner radius of a border box: in CSS pixels with y downwards, or in metres with y upwards
 */

/** The extent around the middle of the domain to which solids are clipped [m]: half of the largest side of a solid. */
const REACH = 5;

/** Lengths are whole multiples of this [m], so that a still box has the same values in each frame. */
const RESOLUTION = 1e-4;

/** The properties that a target sets. @type {{[kind: string]: string[]}} */
export const TARGET_PROPERTIES = {
  source: ['x', 'y', 'width'],
  solid: ['shape', 'x', 'y', 'angle', 'width', 'height', 'corner', 'mask'],
};

/** The default mask, which a solid of another shape has. */
export const NO_MASK = '16x16:7';

/**
 * The element that `of` names, or the image of a `<picture>`; null if there is none.
 * @param {Element} child
 * @param {string} id
 */
export function targetOf(child, id) {
  const root = child.getRootNode();
  const near = 'getElementById' in root ? /** @type {ShadowRoot} */ (root).getElementById(id) : null;
  const target = near ?? child.ownerDocument.getElementById(id);
  return target?.localName === 'picture' ? (target.querySelector('img') ?? target) : target;
}

/**
 * The border box of an element in CSS pixels of the window; null if it has no area, as with `display: none`.
 * @param {Element} element
 * @returns {Box | null}
 */
export function boxOf(element) {
  const { left, right, top, bottom, width, height } = element.getBoundingClientRect();
  if (!(width > 0 && height > 0)) return null;
  const style = getComputedStyle(element);
  const corners = [
    style.borderTopLeftRadius,
    style.borderTopRightRadius,
    style.borderBottomRightRadius,
    style.borderBottomLeftRadius,
  ];
  const layout = /** @type {HTMLElement} */ (element);
  // Lengths in the style are those before a transform.
  const scale = layout.offsetWidth ? width / layout.offsetWidth : 1;
  return { left, right, top, bottom, radius: radiusOf(corners, width, height, scale) };
}

/**
 * The smallest corner radius in pixels: no corner of the element is outside of its body.
 * @param {string[]} corners computed values: one or two lengths or percentages each
 * @param {number} width of the box in pixels
 * @param {number} height
 * @param {number} scale pixels of a pixel of the style
 */
export function radiusOf(corners, width, height, scale = 1) {
  const radii = corners.flatMap((corner) => {
    const [across, down = across] = corner.split(' ');
    const length = (/** @type {string} */ text, /** @type {number} */ side) =>
      text.endsWith('%') ? (parseFloat(text) / 100) * side : parseFloat(text) * scale;
    return [length(across, width), length(down, height)];
  });
  return Math.max(0, Math.min(width / 2, height / 2, ...radii)) || 0;
}

/**
 * A box in metres.
 * @param {Box} box in pixels of the window
 * @param {DOMRect} fire the box of the fire's element
 * @param {{toMetres: (x: number, y: number) => {x: number, y: number}}} viewport
 * @returns {Box}
 */
export function inMetres({ left, right, top, bottom, radius }, fire, { toMetres }) {
  const ends = [toMetres(left - fire.left, top - fire.top), toMetres(right - fire.left, bottom - fire.top)];
  // A transform may have turned or mirrored the fire.
  const [[from, to], [low, high]] = [ends.map(({ x }) => x), ends.map(({ y }) => y)].map((all) =>
    all.sort((a, b) => a - b),
  );
  return { left: from, right: to, top: high, bottom: low, radius: (radius * (to - from)) / (right - left) };
}

/**
 * A solid with the shape of a box or of a mask in it, which is not clipped; null if it is out of reach.
 * @param {Box} box in metres
 * @param {number} middle height of the middle of the domain [m]
 * @param {string} [mask]
 */
export function solidOf({ left, right, top, bottom, radius }, middle, mask) {
  let [low, high] = [within(bottom, middle - REACH, middle + REACH), within(top, middle - REACH, middle + REACH)];
  let [from, to] = [within(left, -REACH, REACH), within(right, -REACH, REACH)];
  if (to <= from || high <= low) return null;
  const isMask = mask && Math.max(right - left, top - bottom, Math.abs(top + bottom) / 2) <= 2 * REACH;
  if (isMask) [from, to, low, high] = [left, right, bottom, top];
  const [width, height] = [Math.max(to - from, 0.002), Math.max(high - low, 0.002)];
  return {
    shape: isMask ? 'mask' : 'box',
    x: rounded((from + to) / 2),
    y: rounded((low + high) / 2),
    angle: 0,
    width: rounded(width),
    height: rounded(height),
    corner: rounded(Math.min(radius, width / 2, height / 2)),
    mask: isMask ? mask : NO_MASK,
  };
}

/**
 * A source along the upper side of a box, within the ranges of its properties.
 * @param {Box} box in metres
 * @param {(property: string) => Domain} domain
 */
export function sourceOf({ left, right, top }, domain) {
  const values = { x: (left + right) / 2, y: top, width: right - left };
  return Object.fromEntries(
    Object.entries(values).map(([property, value]) => {
      const [, min = -Infinity, max = Infinity] = domain(property);
      return [property, rounded(within(value, min, max))];
    }),
  );
}

/** @type {(value: number, min: number, max: number) => number} */
const within = (value, min, max) => Math.min(Math.max(value, min), max);

/** The nearest whole multiple of the resolution, without the rounding error of a product. @param {number} metres */
const rounded = (metres) => Math.round(metres / RESOLUTION) / Math.round(1 / RESOLUTION) || 0;
