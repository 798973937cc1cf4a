/**
 * A fire over a white page: its light is orange, not pink.
 */
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { okLab } from './figures/colour.mjs';
import { Painter } from './painter.mjs';

const SCENES = [
  'campfire',
  'bonfire-in-wind',
  'burning-logs',
  'wooden-word',
  'ring-of-fire',
  'sheltered-candle',
  'match',
];
/** The chroma from which a colour has a hue [OkLab / 100]. */
const COLOURED = 2.5;
/** Hues between these are pink and red; orange is above [degrees of OkLab]. */
const REDDISH = [-30, 45];
/** Opacity of flame, and of a solid. */
const [FLAME, SOLID] = [0.03, 0.98];
/** Distance of what is outside the flame from its pixels. */
const APART = 3;

const painter = new Painter();
after(() => painter.close());

/**
 * The pixels of flame and those near it.
 * @param {import('./painter.mjs').Pixels} pixels
 */
function flameOf({ width, height, rgba }) {
  const flame = new Uint8Array(width * height);
  for (let at = 0; at < width * height; at += 1) {
    if (rgba[4 * at + 3] < 255 * FLAME) continue;
    const [column, row] = [at % width, Math.floor(at / width)];
    const [left, right] = [Math.max(column - APART, 0), Math.min(column + APART, width - 1)];
    for (let y = Math.max(row - APART, 0); y <= Math.min(row + APART, height - 1); y += 1) {
      flame.fill(1, y * width + left, y * width + right + 1);
    }
  }
  return flame;
}

/** A premultiplied pixel over white. @param {Uint8Array} rgba @param {number} at */
function overWhite(rgba, at) {
  const behind = 255 - rgba[4 * at + 3];
  const [r, g, b] = [0, 1, 2].map((channel) => Math.round(Math.min(rgba[4 * at + channel] + behind, 255)));
  return okLab(r, g, b);
}

for (const lit of SCENES) {
  test(`${lit}: at most 0.5 % of a white page is reddish outside flame and solids`, async () => {
    const { width, height, rgba } = await painter.still({ lit });
    const flame = flameOf(await painter.still({ lit, values: { ground: 'none', layers: 'fire', bloom: 0 } }));
    let reddish = 0;
    for (let at = 0; at < width * height; at += 1) {
      if (flame[at] || rgba[4 * at + 3] > 255 * SOLID) continue;
      const [, a, b] = overWhite(rgba, at);
      const hue = (Math.atan2(b, a) * 180) / Math.PI;
      if (Math.hypot(a, b) > COLOURED && hue > REDDISH[0] && hue < REDDISH[1]) reddish += 1;
    }
    const share = reddish / (width * height);
    assert.ok(share <= 0.005, `${(100 * share).toFixed(2)} %`);
  });
}
