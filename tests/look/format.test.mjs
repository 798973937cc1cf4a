/**
 * Devices that draw only into 8-bit targets show the same fire, except for rounding.
 * Advected fine structure loses its displacement there: its structure differs, its colours
 * agree.
 */
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { compare } from './compare.mjs';
import { show } from './goldens.mjs';
import { sheet } from './sheet.mjs';
import { Painter } from './painter.mjs';

/** Most that eight bits may change where the structure is the same, in hundredths of OkLab, as everything here. The pale
    mantle of a gas burner has few steps: 4.9. Most scenes stay below half of this. */
const ROUNDED = { colour: 1, worst: 6, structure: 0.98 };

/** And the colours of the whole where it is another: most, of a fireplace, 4.6. */
const SHIFT = 6;

/** What a device lacks that draws into half floats alone, or into no floats. */
const [HALF, NONE] = [['EXT_color_buffer_float'], ['EXT_color_buffer_float', 'EXT_color_buffer_half_float']];

const painter = new Painter();
after(() => painter.close());

/**
 * Every scene whose fire is made of fields, and the values that both formats can draw: eight bits have one slice.
 * @type {[string, {[id: string]: number}][]}
 */
const scenes = [];
for (const lit of await painter.ask('presets')) {
  const { display_mode: mode, model } = await painter.ask('values', { lit });
  if (mode === 'fire') scenes.push([lit, model === 'classic' ? {} : { depth: 1 }]);
}

for (const [name, values] of scenes) {
  test(`eight bits show ${name} up to rounding`, async () => {
    const [floats, bytes] = await both({ lit: name, values: { ...values, detail: 0 } });
    const { colour, worst, structure } = compare(floats, bytes);
    const comparison = `mean ${colour.toFixed(2)}, 99 % below ${worst.toFixed(2)}, structure ${structure.toFixed(4)}`;
    console.log(`   ${name}: ${comparison}`);
    if (colour > ROUNDED.colour || worst > ROUNDED.worst || structure < ROUNDED.structure) {
      assert.fail(`${comparison}: see ${show(`${name}-rgba8`, bytes, floats).join(', ')}`);
    }
  });

  test(`eight bits show ${name} in the same colours`, async () => {
    const [floats, bytes] = await both({ lit: name, values });
    const { shift } = compare(floats, bytes);
    console.log(`   ${name}: shift ${shift.toFixed(2)}`);
    if (shift > SHIFT) assert.fail(`${shift}: see ${show(`${name}-rgba8`, bytes, floats).join(', ')}`);
  });
}

/** A fire in half floats, and in eight bits. @param {import('./painter.mjs').PictureRequest} request */
async function both(request) {
  return [await painter.still(request), await painter.still({ ...request, format: 'rgba8' })].map(sheet);
}

test('a device draws into the best that it has', async () => {
  const formats = await Promise.all(
    [[], HALF, NONE].map((without) => device(without, (painter) => painter.ask('format'))),
  );
  assert.deepEqual(formats, ['rgba16f', 'rgba16f', 'rgba8']);
});

test('half floats give the same bits whichever extension gives them', async () => {
  for (const lit of ['default', 'classic']) {
    const [all, half] = await Promise.all(
      [[], HALF].map((without) => device(without, (painter) => painter.still({ lit, burnt: 1 }))),
    );
    assert.equal(Buffer.compare(all.rgba, half.rgba), 0, lit);
  }
});

/**
 * What a painter without these extensions does.
 * @template T
 * @param {string[]} without @param {(painter: Painter) => Promise<T>} act
 */
async function device(without, act) {
  const other = new Painter(without);
  return act(other).finally(() => other.close());
}
