/**
 * Smoke in the light of its fire: bright towards the flame, in the shadow of smoke farther away.
 */
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
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
