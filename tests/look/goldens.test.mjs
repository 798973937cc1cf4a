/**
 * Fires match their golden pictures, and the comparison reports every mistake that is
 * visible.
 */
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import path from 'node:path';
import { after, test } from 'node:test';
import { compare } from './compare.mjs';
import { mismatch, drawn, golden, show, TOLERANCE, requests } from './goldens.mjs';
import { hueTurned, toneMappedByChannel } from './negative-controls.mjs';
import { coarse, sheet } from './sheet.mjs';
import { GOLDENS, Painter } from './painter.mjs';

const painter = new Painter();
after(() => painter.close());
const REQUESTS = await requests(painter);

for (const [name, request] of Object.entries(REQUESTS)) {
  test(`${name} looks as it did`, async () => {
    const [actual, expected] = [await drawn(painter, request), golden(name)];
    const differences = mismatch(actual, expected);
    if (differences !== '') assert.fail(`${differences}: see ${show(name, actual, expected).join(', ')}`);
  });
}

test('every kept picture is one that is drawn', () => {
  const kept = readdirSync(GOLDENS).filter((file) => file.endsWith('.png'));
  assert.deepEqual(kept.map((file) => path.parse(file).name).sort(), Object.keys(REQUESTS).sort());
});

/** Settings that make a picture as a mistake in the drawing would. */
const WRONG = {
  'no glow': { bloom: 0 },
  'no fine structure': { detail: 0 },
  'no smoke': { smoke_opacity: 0 },
  'a quarter of a stop more light': { exposure: 0.25 },
  'a quarter of a stop less light': { exposure: -0.25 },
  'another spectrum': { luminance_exponent: 0.45 },
  'the paper instead': { display_mode: 'paper' },
};

for (const lit of ['default', 'classic']) {
  for (const [mistake, values] of Object.entries(WRONG)) {
    test(`${mistake} is reported of ${lit}`, async () => {
      assertReported(await drawn(painter, { lit, values }), golden(lit));
    });
  }
  for (const [mistake, make] of Object.entries({
    'a hue turned by 8° towards yellow': hueTurned(8),
    'a hue turned by 8° towards red': hueTurned(-8),
    'another tone map': toneMappedByChannel,
  })) {
    test(`${mistake} is reported of ${lit}`, async () => {
      const right = await painter.still({ lit });
      const [wrong, expected] = [make(right), right].map(sheet);
      assertReported(wrong, coarse(expected));
    });
  }

  test(`invisible differences are not reported of ${lit}`, async () => {
    const right = await painter.still({ lit });
    // Rounding elsewhere: each channel one step off, this way or that.
    let seed = 1;
    const step = () => {
      seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
      return Math.floor((seed / 2 ** 32) * 3) - 1;
    };
    const rgba = right.rgba.map((value) => Math.min(Math.max(value + (value > 0 ? step() : 0), 0), 255));
    assert.equal(mismatch(sheet({ ...right, rgba }), coarse(sheet(right))), '');
  });
}

/** @param {import('../e2e/picture.mjs').Picture} wrong @param {import('../e2e/picture.mjs').Picture} right */
function assertReported(wrong, right) {
  const { colour, shift, structure } = compare(wrong, right);
  // Clearly, and not by a hair.
  const clearly = [colour / TOLERANCE.colour, shift / TOLERANCE.shift, (1 - structure) / (1 - TOLERANCE.structure)];
  assert.ok(Math.max(...clearly) > 1.5, `only ${clearly.map((ratio) => ratio.toFixed(2))} of what is tolerated`);
}
