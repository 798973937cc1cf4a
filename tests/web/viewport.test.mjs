/**
 * The fire's domain in its picture, and the number of pixels of the picture.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cappedSize } from '../../web/element/view/visibility.js';
import { alignment, panning, viewportOf } from '../../web/element/view/viewport.js';

test('an alignment is one or two words of object-position, in any order', () => {
  for (const [words, shares] of /** @type {[string, [number, number] | undefined][]} */ ([
    ['center bottom', [0.5, 0]],
    ['bottom center', [0.5, 0]],
    ['left', [0, 0.5]],
    ['top', [0.5, 1]],
    [' RIGHT  Top ', [1, 1]],
    ['center', [0.5, 0.5]],
    ['', undefined],
    ['left right', undefined],
    ['left top center', undefined],
    ['constructor', undefined],
  ]))
    assert.deepEqual(alignment(words), shares, words);
});

test('each fit scales the domain to the picture, and the alignment places it', () => {
  // A domain of 1 m × 2 m in a picture of 300 × 200 pixels.
  for (const [fit, scale] of /** @type {[string, number][]} */ ([
    ['height', 100],
    ['width', 300],
    ['contain', 100],
    ['cover', 300],
    ['unknown', 100],
  ])) {
    for (const x of [0, 0.5, 1]) {
      for (const y of [0, 0.5, 1]) {
        const viewport = viewportOf({ fit, x, y, zoom: 1, panX: 0.3, panY: 0.9 }, 1, 2, 300, 200);
        assert.equal(viewport.scale, scale, fit);
        // The domain's own point at these shares is the picture's.
        assert.equal(viewport.left + (x - 0.5) * scale, 300 * x, `${fit} ${x}`);
        assert.equal(viewport.bottom + 2 * scale * y, 200 * y, `${fit} ${y}`);
      }
    }
  }
});

test('a zoom enlarges the picture, and the pan is the part of it that is seen', () => {
  const camera = { fit: 'height', x: 0.5, y: 0 };
  for (const pan of [0, 0.25, 1]) {
    const { scale, left, bottom } = viewportOf({ ...camera, zoom: 4, panX: pan, panY: pan }, 1, 2, 300, 200);
    assert.equal(scale, 400);
    // The middle of the floor is at 150 and 0 pixels before; three quarters of the picture are hidden.
    assert.equal(left, 4 * 150 - 3 * 300 * pan);
    assert.equal(bottom, 0 - 3 * 200 * pan);
  }
});

test('a pan is two numbers from 0 to 1', () => {
  assert.deepEqual(panning(' 0  0.75 '), [0, 0.75]);
  for (const words of ['', '0.5', '0 0 0', '0 1.1', '-1 0', 'left bottom'])
    assert.equal(panning(words), undefined, words);
});

test('a canvas has at most two pixels for a CSS pixel, one and a half on touch screens', () => {
  assert.deepEqual(cappedSize(300, 200, 1, false), { width: 300, height: 200 });
  assert.deepEqual(cappedSize(900, 600, 3, false), { width: 600, height: 400 });
  assert.deepEqual(cappedSize(900, 600, 3, true), { width: 450, height: 300 });
  assert.deepEqual(cappedSize(300, 200, 1.5, true), { width: 300, height: 200 });
});

test('a canvas is never larger than GPUs can draw, and keeps its aspect ratio', () => {
  assert.deepEqual(cappedSize(16384, 4096, 1, false), { width: 8192, height: 2048 });
  assert.deepEqual(cappedSize(0, 0, 1, false), { width: 0, height: 0 });
});
