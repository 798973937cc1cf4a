/**
 * Loops keep the limits of flashes: what the command mixes across their ends flashes no more than the fire.
 */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { Flashes } from './figures/flashes.mjs';

/** A page of 1024 × 768 in pixels of 16. */
const [WIDTH, HEIGHT, PIXEL] = [64, 48, 16];
const BYTES = 4 * WIDTH * HEIGHT;
/** Pictures a second, and how often a loop plays. */
const [RATE, ROUNDS] = [30, 3];

for (const scene of ['default', 'campfire', 'torch', 'bonfire-in-wind', 'candle']) {
  test(`a loop of ${scene} passes when it plays again and again`, () => {
    const options = `--loop --seconds 2 --quality low --size ${WIDTH}x${HEIGHT} --supersample 2 --background black`;
    const words = ['film', scene, ...options.split(' '), '--as', 'rgba', '--out', '-'];
    const all = execFileSync(process.env.HEARTH_COMMAND ?? '', words, { maxBuffer: 1 << 26 });
    const count = all.length / BYTES;
    assert.equal(count, 2 * RATE);
    const flashes = new Flashes(WIDTH, HEIGHT, PIXEL);
    for (let picture = 0; picture < ROUNDS * count; picture += 1) {
      const at = (picture % count) * BYTES;
      flashes.see(picture / RATE, all.subarray(at, at + BYTES));
    }
    const found = flashes.found();
    assert.ok(found.passes, JSON.stringify(found));
  });
}
