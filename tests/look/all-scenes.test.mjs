/**
 * A few seconds of every scene. `cargo measure look` watches a minute of each.
 */
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { glance } from './figures/film.mjs';
import { Painter } from './painter.mjs';

const painter = new Painter();
after(() => painter.close());

test('no scene flashes, or shines through more than it covers', async (t) => {
  // Each until it fills its height, and then for a few seconds.
  for (const lit of await painter.ask('presets')) {
    await t.test(lit, async () => {
      const { flashes, exceeds, luminous } = await glance(painter, { lit, burnt: 3 }, 3);
      assert.ok(flashes.passes && exceeds === 0, JSON.stringify({ flashes, exceeds }));
      assert.ok(luminous > 0.002, `${luminous} of it is luminous`);
    });
  }
});
