/** Write your word: the scene of a mask, its lines, and that no server gets to know it. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { linesOf, sceneOf } from '../../web/pages/word/scene.js';
import { PRESETS } from '../../web/parameters.js';
import { fitsQuery, fromFragment, iframeCode, pageLink } from '../../web/share.js';

const MASK = '16x16:7';
const { values: frame } = PRESETS.find(({ name }) => name === 'burning-word') ?? { values: {} };

for (const [shape, ratio] of Object.entries({ letter: 1.3, word: 0.3, sentence: 0.05, pillar: 20 })) {
  test(`a ${shape} is whole in its frame, above the floor, and burns at its surface`, () => {
    const { preset, values, objects } = sceneOf({ shape: 'mask', mask: MASK, width: 1, height: ratio });
    const [source, solid] = /** @type {any[]} */ (objects);
    const high = values.domain_height ?? frame.domain_height;
    assert.equal(preset, 'burning-word');
    assert.ok(
      solid.width <= 0.81 * frame.domain_width && solid.y + solid.height / 2 <= high / 2,
      'there is room for flames',
    );
    assert.ok(solid.y - solid.height / 2 > 0.08);
    assert.ok(Math.abs(solid.height / solid.width / ratio - 1) < 0.02, 'in its shape');
    assert.deepEqual([source.shape, source.solid, solid.plane, solid.material], ['solid', solid.id, 'before', 'coal']);
    assert.ok(source.power > 0 && source.power <= 3000, `${source.power} kW/m`);
  });
}

test('words of a long text share lines of about the same length, and a word stays whole', () => {
  for (const text of ['FIRE', 'Winter menu', 'Donaudampfschifffahrt', '火', 'نار'])
    assert.deepEqual(linesOf(text), [text]);
  assert.deepEqual(linesOf('  Happy birthday, dear Johanna '), ['Happy birthday,', 'dear Johanna']);
  assert.deepEqual(linesOf(' \n '), []);
});

test('a mask travels in the fragment alone, however short', async () => {
  const config = /** @type {any} */ (sceneOf({ shape: 'mask', mask: MASK, width: 1, height: 0.3 }));
  assert.ok(!fitsQuery(config));
  const link = new URL(await pageLink(config, 'https://fire.example/?utm_source=x'));
  assert.equal(link.search, '');
  assert.ok(!link.href.includes(MASK.split(':')[0]));
  assert.deepEqual(await fromFragment(link.hash), config);
  const [, src] = /src="([^"]*)"/.exec(await iframeCode(config, 'https://fire.example/embed.html')) ?? [];
  assert.equal(new URL(String(src)).search, '');
  assert.ok(fitsQuery({ ...config, objects: undefined }));
});
