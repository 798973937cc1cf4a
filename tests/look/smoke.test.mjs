/**
 * Smoke in the light of a fire: bright towards the flame, in the shadow of smoke farther away.
 */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { after, test } from 'node:test';
import { Picture } from '../e2e/picture.mjs';
import { relativeLuminance } from './figures/colour.mjs';
import { Painter } from './painter.mjs';

const painter = new Painter();
after(() => painter.close());

test('smoke is at least twice as bright near its flame as far from it', async () => {
  const values = { background: '#000000', ground: 'none', smoke_opacity: 2, ember_rate: 0, bloom: 0 };
  const { width, height, rgba } = await painter.still({ lit: 'smoke-stack', values });
  const { rgba: dark } = await painter.still({ lit: 'smoke-stack', values: { ...values, layers: 'smoke' } });
  /**
   * Mean light of opaque smoke between two rows, in units of that without a fire.
   * @param {number} top @param {number} bottom
   */
  const lit = (top, bottom) => {
    let [sum, without] = [0, 0];
    for (let at = top * width; at < bottom * width; at += 1) {
      /** @param {Uint8Array} of @returns {[number, number, number]} */
      const codes = (of) => [of[4 * at], of[4 * at + 1], of[4 * at + 2]];
      const shade = relativeLuminance(...codes(dark));
      const light = relativeLuminance(...codes(rgba));
      // Flame is brighter than any smoke.
      if (shade > 0.002 && light < 0.15) [sum, without] = [sum + light, without + shade];
    }
    return sum / without;
  };
  const near = lit(Math.round(0.65 * height), Math.round(0.8 * height));
  const far = lit(0, Math.round(0.2 * height));
  assert.ok(near >= 2 * far, `${near} against ${far}`);
});

/** Side of the pictures of a plume beside a flame; the rows of its foot there. */
const SIDE = 200;
const FOOT = [98, 113];
/** Luminance from which smoke without a fire is opaque enough. */
const OPAQUE = 0.002;

/**
 * A flame at night, and a plume of fuel that smokes without oxygen, 0.7 m beside it, as pixels' luminances.
 * @param {number} side  1: the plume is on the right; -1: on the left.
 * @param {string} layers
 */
function plume(side, layers) {
  const common = { kind: 'source', width: 0.2 };
  const settings = {
    hearth: 3,
    values: {
      ...{ domain_width: 2, domain_height: 2, particles: 5000, ember_rate: 0, background: '#000', bloom: 0 },
      ...{ smoke_opacity: 2, smoke_life: 10, soot_life: 2, air_demand: 1, radiative_cooling: 1800, layers },
    },
    objects: [
      { ...common, x: -0.35 * side, y: 0.6, width: 0.3, power: 150, oxygen: 0.6 },
      { ...common, x: 0.35 * side, y: 0.1, power: 60, oxygen: 0 },
    ],
  };
  const size = `${SIDE}x${SIDE}`;
  const options = ['render', '-', '--at', '4', '--size', size, '--quality', 'medium', '--out', '-'];
  const png = execFileSync(process.env.HEARTH_COMMAND ?? '', options, { input: JSON.stringify(settings) });
  const { rgb } = Picture.decode(png);
  return Array.from({ length: SIDE * SIDE }, (_, at) => {
    return relativeLuminance(rgb[3 * at], rgb[3 * at + 1], rgb[3 * at + 2]);
  });
}

for (const [side, name] of /** @type {[number, string][]} */ ([
  [1, 'left'],
  [-1, 'right'],
])) {
  test(`smoke with a flame on its ${name} is at least twice as bright on that side`, () => {
    const [lit, dark] = [plume(side, 'both'), plume(side, 'smoke')];
    let [near, far] = [0, 0];
    for (let row = FOOT[0]; row < FOOT[1]; row += 1) {
      // The plume is in that half of the picture, and counted from the flame's side.
      const column = (/** @type {number} */ away) => (side > 0 ? SIDE / 2 + away : SIDE / 2 - 1 - away) + row * SIDE;
      const places = Array.from({ length: SIDE / 2 }, (_, away) => column(away)).filter((at) => dark[at] > OPAQUE);
      const third = Math.floor(places.length / 3);
      for (let k = 0; k < third; k += 1) {
        const ends = [places[k], places[places.length - 1 - k]];
        [near, far] = [near + lit[ends[0]] / dark[ends[0]], far + lit[ends[1]] / dark[ends[1]]];
      }
    }
    assert.ok(near >= 2 * far, `${near} against ${far}`);
  });
}
