/**
 * Whether a burning word is read: its mask is found again in the picture of its coal. And whether it burns along its
 * outline: where the light beside it is.
 */
import { decoded } from './masks.mjs';

/** The solid of the fire and its box in the picture. @param {import('./driver.mjs').Tab} tab */
export const solidOf = (tab) =>
  tab.fire((fire) => {
    const { mask, x, y, width, height } = fire.objects.find(({ shape }) => shape === 'mask');
    const [a, b] = [fire.toPixels(x - width / 2, y + height / 2), fire.toPixels(x + width / 2, y - height / 2)];
    return { mask, left: a.x, top: a.y, right: b.x, bottom: b.y };
  });

/** Runs in the page: whether the fire has a word. */
export const hasMask = () =>
  /** @type {any} */ (document.querySelector('hearth-fire')).objects.some(({ shape }) => shape === 'mask');

/** Luma of the pixels of a picture; 0 outside. @param {import('./picture.mjs').Picture} picture */
function lumaOf({ width, height, rgb }) {
  return (x, y) => {
    if (x < 0 || y < 0 || x >= width || y >= height) return 0;
    const [r, g, b] = rgb.subarray(3 * (y * width + x), 3 * (y * width + x) + 3);
    return 0.3 * r + 0.6 * g + 0.1 * b;
  };
}

/** Whether a pixel is in the mask. @param {Awaited<ReturnType<typeof solidOf>>} solid */
function insideOf({ mask, left, top, right, bottom }) {
  const pixels = decoded(mask);
  return (x, y) => {
    const [across, down] = [(x + 0.5 - left) / (right - left), (y + 0.5 - top) / (bottom - top)];
    return across >= 0 && across < 1 && down >= 0 && down < 1 && pixels.at(across, down) > 7;
  };
}

/** Luma of embers in coal, on average over its veins: flames are brighter, and gaps without a flame are darker. */
const COAL = [30, 90];
const VEINS = 3;

/**
 * Correlation of the mask with what looks like coal in its box.
 * @param {import('./picture.mjs').Picture} picture @param {Awaited<ReturnType<typeof solidOf>>} solid
 */
export function correlation(picture, solid) {
  const [luma, isIn] = [lumaOf(picture), insideOf(solid)];
  const pairs = [];
  for (let y = Math.round(solid.top); y < solid.bottom; y += 2) {
    for (let x = Math.round(solid.left); x < solid.right; x += 2) {
      let sum = 0;
      for (let dy = -VEINS; dy <= VEINS; dy += 1)
        for (let dx = -VEINS; dx <= VEINS; dx += 1) sum += luma(x + dx, y + dy);
      const mean = sum / (2 * VEINS + 1) ** 2;
      pairs.push([Number(isIn(x, y)), Number(mean > COAL[0] && mean < COAL[1])]);
    }
  }
  const mean = (at) => pairs.reduce((sum, pair) => sum + pair[at], 0) / pairs.length;
  const [a, b] = [mean(0), mean(1)];
  const total = (of) => pairs.reduce((sum, pair) => sum + of(pair[0] - a, pair[1] - b), 0);
  return total((p, q) => p * q) / Math.sqrt(total((p) => p * p) * total((_, q) => q * q));
}

/** How far light is from the outline that it burns on [px], and luma below which nothing shines. */
const NEAR = 15;
const DARK = 8;

/**
 * Light near the solid, as a share of all light beside it in the lowest third of the flame.
 * @param {import('./picture.mjs').Picture} picture @param {Awaited<ReturnType<typeof solidOf>>} solid
 */
export function lightAtOutline(picture, solid) {
  const [luma, isIn] = [lumaOf(picture), insideOf(solid)];
  const rim = [];
  for (let angle = 0; angle < 32; angle += 1)
    for (let at = 1; at <= NEAR; at += 2)
      rim.push([at * Math.cos((angle * Math.PI) / 16), at * Math.sin((angle * Math.PI) / 16)]);
  const lit = [];
  for (let y = 0; y < picture.height; y += 1)
    for (let x = 0; x < picture.width; x += 1)
      if (luma(x, y) > DARK && !isIn(x, y)) lit.push({ x, y, light: luma(x, y) });
  const rows = lit.map(({ y }) => y);
  const [top, bottom] = [Math.min(...rows), Math.max(...rows)];
  const lowest = lit.filter(({ y }) => y > bottom - (bottom - top) / 3);
  const sum = (of) => of.reduce((sum, { light }) => sum + light, 0);
  const near = lowest.filter(({ x, y }) => rim.some(([dx, dy]) => isIn(x + dx, y + dy)));
  return { share: sum(near) / sum(lowest), light: sum(lit) };
}
