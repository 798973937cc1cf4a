/** The example for a matrix of lamps writes rows of colours, with the fire at the bottom. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const WEB = process.env.HEARTH_WEB ?? path.join(ROOT, 'dist/site/web');

/** The pictures of a scene, each with its rows of colours. @param {string} scene */
function pictures(scene) {
  const program = path.join(ROOT, 'examples/leds/matrix.mjs');
  const env = { ...process.env, HEARTH_WEB: WEB };
  const text = execFileSync(process.execPath, [program, scene, '0.2', '15'], { env, encoding: 'utf8' });
  return text
    .trim()
    .split('\n\n')
    .map((picture) => picture.split('\n').map((row) => row.split(' ')));
}

test('a picture is 16 rows of 16 colours, whose red is brightest in the lower half', () => {
  const seen = pictures('campfire');
  assert.equal(seen.length, 3);
  assert.notDeepEqual(seen[0], seen[2]);
  for (const picture of seen) {
    assert.deepEqual(
      picture.map((row) => row.length),
      Array(16).fill(16),
    );
    const sums = picture.map((row) => row.reduce((sum, colour) => sum + Number.parseInt(colour.slice(0, 2), 16), 0));
    assert.ok(picture.flat().every((colour) => /^[0-9a-f]{6}$/.test(colour)));
    assert.ok(sums.indexOf(Math.max(...sums)) >= 8, sums.join());
  }
});

test('the same scene gives the same pictures, and another one others', () => {
  const [first, again, other] = ['candle', 'candle', 'match'].map(pictures);
  assert.deepEqual(first, again);
  assert.notDeepEqual(first, other);
});
