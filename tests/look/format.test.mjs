/**
 * Devices that draw only into 8-bit targets show the same fire, except for rounding.
 * Advected fine structure loses its displacement there: its structure differs, its colours
 * agree.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { compare } from './compare.mjs';
import { show, requests } from './goldens.mjs';
import { sheet } from './sheet.mjs';
import { Painter } from './painter.mjs';

/** Most that eight bits may change where the structure is the same, in hundredths of
    OkLab, as everything here. The thin smoke of a stack has few steps between black and grey: 4.5.
    Most scenes stay below half of this. */
const ROUNDED = { colour: 0.6, worst: 6, structure: 0.99 };

/** And the colours of the whole where it is another: most, of the ground below a campfire, 2.0. */
const SHIFT = 3;

/** What a device lacks that draws into half floats alone, or into no floats. */
const [HALF, NONE] = [['EXT_color_buffer_float'], ['EXT_color_buffer_float', 'EXT_color_buffer_half_float']];

/** @type {Painter} */
let painter;
before(async () => {
  painter = await Painter.open();
});
after(() => painter?.close());

/** Every scene whose fire is made of fields: what is kept of it. */
const scenes = Object.entries(requests()).filter(([name, request]) => request.kept === name && request.mode === 'fire');

for (const [name, request] of scenes) {
  test(`eight bits show ${name} up to rounding`, async () => {
    const [floats, bytes] = await both({ ...request, values: { detail: 0 } });
    const { colour, worst, structure } = compare(floats, bytes);
    const comparison = `mean ${colour.toFixed(2)}, 99 % below ${worst.toFixed(2)}, structure ${structure.toFixed(4)}`;
    console.log(`   ${name}: ${comparison}`);
    if (colour > ROUNDED.colour || worst > ROUNDED.worst || structure < ROUNDED.structure) {
      assert.fail(`${comparison}: see ${show(`${name}-rgba8`, bytes, floats).join(', ')}`);
    }
  });

  test(`eight bits show ${name} in the same colours`, async () => {
    const [floats, bytes] = await both(request);
    const { shift } = compare(floats, bytes);
    console.log(`   ${name}: shift ${shift.toFixed(2)}`);
    if (shift > SHIFT) assert.fail(`${shift}: see ${show(`${name}-rgba8`, bytes, floats).join(', ')}`);
  });
}

/** A fire in half floats, and in eight bits. @param {import('./painter.mjs').PictureRequest} request */
async function both(request) {
  const floats = await painter.still({ ...request, format: 'rgba16f' });
  return [floats, await painter.still({ ...request, without: NONE })].map(sheet);
}

test('a device draws into the best that it has', async () => {
  const formats = await Promise.all([[], HALF, NONE].map((without) => painter.ask('formatOf', { without })));
  assert.deepEqual(formats, ['rgba16f', 'rgba16f', 'rgba8']);
});

for (const [name, request] of scenes.filter(([name]) => ['default', 'classic'].includes(name))) {
  test(`half floats give ${name} the same bits whichever extension gives them`, async () => {
    const [all, half] = await Promise.all([[], HALF].map((without) => painter.still({ ...request, without })));
    assert.equal(Buffer.compare(all.rgba, half.rgba), 0);
  });
}
