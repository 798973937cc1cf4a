/**
 * Figures of a few seconds of a fire's pixels. `cargo measure look` measures a minute of
 * every scene.
 */
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { BARS } from './measurements.mjs';
import { Film } from './figures/film.mjs';
import { Painter } from './painter.mjs';

const painter = new Painter();
after(() => painter.close());

/** The figures of so many seconds. @param {import('./painter.mjs').PictureRequest} request @param {number} seconds */
async function seen(request, seconds) {
  const film = await Film.of(painter, request);
  await film.until(seconds);
  return film.found();
}

for (const lit of ['default', 'classic']) {
  test(`the pixels of ${lit} are those of a fire`, async () => {
    const found = await seen({ lit, burnt: 2 }, 2.5);
    for (const { words, figure, holds, brief } of BARS) {
      if (brief) assert.ok(holds(figure(found)), `${words}: ${JSON.stringify(figure(found))}`);
    }
    assert.ok(found.luminous > 0.02, `${found.luminous} of it is luminous`);
  });
}

test('light that no black body emits is recognised', async () => {
  const found = await seen({ lit: 'default', burnt: 1, values: { palette: 'copper' } }, 0.5);
  for (const id of ['locus', 'warm']) {
    const { figure, holds } = BARS.find((bar) => bar.id === id) ?? assert.fail(id);
    assert.ok(!holds(figure(found)), `${id}: ${figure(found)}`);
  }
});
