/**
 * The border box of an element, and a mask in it, as an object of a fire.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NO_MASK, inMetres, radiusOf, solidOf, sourceOf } from '../../web/element/children/child-box.js';
import { PROPERTIES } from '../../web/generated/properties.js';

/** A world of 100 pixels per metre whose origin is 200 pixels right of and 300 below the corner of the fire. */
const viewport = {
  toMetres: (/** @type {number} */ x, /** @type {number} */ y) => ({ x: (x - 200) / 100, y: (300 - y) / 100 }),
};
const FIRE = /** @type {DOMRect} */ ({ left: 50, top: 20 });

test('a box in pixels of the window is one in metres, with its radius', () => {
  const box = inMetres({ left: 150, right: 350, top: 120, bottom: 220, radius: 10 }, FIRE, viewport);
  assert.deepEqual(box, { left: -1, right: 1, top: 2, bottom: 1, radius: 0.1 });
});

test('the radius is the smallest of the corners, in lengths and percentages, and at most half of the shorter side', () => {
  assert.equal(radiusOf(['10px', '20px', '12px 14px', '30px'], 200, 100), 10);
  assert.equal(radiusOf(['12px 4px', '20px', '20px', '20px'], 200, 100), 4);
  assert.equal(radiusOf(['50%', '50%', '50%', '50%'], 200, 100), 50);
  assert.equal(radiusOf(['25% 10%', '50%', '50%', '50%'], 200, 100), 10);
  assert.equal(radiusOf(['999px', '999px', '999px', '999px'], 200, 100), 50);
  assert.equal(radiusOf(['0px', '8px', '8px', '8px'], 200, 100), 0);
  assert.equal(radiusOf(['8px', '8px', '8px', '8px'], 200, 100, 1.5), 12);
});

test('a solid has the box, in whole tenths of a millimetre', () => {
  const solid = solidOf({ left: -0.123456, right: 0.3, top: 1.2, bottom: 0.9, radius: 0.04 }, 0.9);
  assert.deepEqual(solid, {
    shape: 'box',
    x: 0.0883,
    y: 1.05,
    angle: 0,
    width: 0.4235,
    height: 0.3,
    corner: 0.04,
    mask: NO_MASK,
  });
});

test('a mask is not clipped, and one that is too large is a box', () => {
  const mask = '2x1:PA';
  const solid = solidOf({ left: 4, right: 6, top: 1, bottom: 0.5, radius: 0 }, 0.9, mask);
  assert.deepEqual(solid, { shape: 'mask', x: 5, y: 0.75, angle: 0, width: 2, height: 0.5, corner: 0, mask });
  const large = solidOf({ left: -6, right: 4.1, top: 1, bottom: 0.5, radius: 0 }, 0.9, mask);
  assert.deepEqual([large?.shape, large?.width, large?.mask], ['box', 9.1, NO_MASK]);
});

test('every box makes a solid in the ranges of its properties, or none', () => {
  for (const left of [-1e6, -6, -5, 0, 4.999, 6]) {
    for (const width of [1e-6, 0.3, 1e6]) {
      for (const [bottom, top] of [
        [-1e6, 1e6],
        [0.1, 0.1 + 1e-6],
        [-1e6, -20],
        [20, 1e6],
      ]) {
        for (const mask of ['1x1:P', undefined]) {
          const solid = solidOf({ left, right: left + width, top, bottom, radius: width / 2 }, 3, mask);
          for (const [name, value] of Object.entries(solid ?? {})) {
            const [, min, max] = PROPERTIES.solid[name].every ?? [];
            if (typeof value === 'number')
              assert.ok(value >= Number(min) && value <= Number(max), `${name} = ${value}`);
          }
        }
      }
    }
  }
  assert.equal(solidOf({ left: 7, right: 8, top: 1, bottom: 0, radius: 0 }, 1), null);
  assert.equal(solidOf({ left: 0, right: 1, top: 9, bottom: 8, radius: 0 }, 1), null);
});

test('a source lies along the upper side, within the ranges of its properties', () => {
  const domain = (/** @type {string} */ name) =>
    PROPERTIES.source[name].every ?? PROPERTIES.source[name].combustion ?? [0];
  assert.deepEqual(sourceOf({ left: -0.2, right: 0.4, top: 0.6, bottom: 0.5, radius: 0 }, domain), {
    x: 0.1,
    y: 0.6,
    width: 0.6,
  });
  assert.deepEqual(sourceOf({ left: -20, right: 0, top: 7, bottom: 0.5, radius: 0 }, domain), {
    x: -3,
    y: 6,
    width: 6,
  });
  assert.deepEqual(sourceOf({ left: 0, right: 0.001, top: -6, bottom: -7, radius: 0 }, domain), {
    x: 0.0005,
    y: 0,
    width: 0.01,
  });
});
