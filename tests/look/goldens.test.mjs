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
  'no fine structure': { detail: 0 },
  'a quarter of a stop less light': { exposure: -0.25 },
  'another spectrum': { luminance_exponent: 0.45 },
};

for (const [mistake, values] of Object.entries(WRONG)) {
  test(`${mistake} is reported`, async () => {
    const { colour, shift, structure } = compare(await drawn(painter, { lit: 'default', values }), golden('default'));
    // Clearly, and not by a hair.
    const clearly = [colour / TOLERANCE.colour, shift / TOLERANCE.shift, (1 - structure) / (1 - TOLERANCE.structure)];
    assert.ok(Math.max(...clearly) > 1.5, `only ${clearly.map((ratio) => ratio.toFixed(2))} of what is tolerated`);
  });
}
