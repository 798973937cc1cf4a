/**
 * A picture does not depend on other drawing in its context, on foreign OpenGL state, or on
 * odd sizes.
 */
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { compare } from './compare.mjs';
import { show } from './goldens.mjs';
import { sheet } from './sheet.mjs';
import { Painter } from './painter.mjs';

const painter = new Painter();
after(() => painter.close());

/** Fires of both models, of different sizes; one with all that only it needs in a context. */
const FIRES = [
  { lit: 'default', burnt: 0.4, width: 160, height: 200, values: { particles: 1000 } },
  { lit: 'classic', burnt: 0.4, width: 131, height: 217 },
  { lit: 'forge', burnt: 0.2, width: 120, height: 90, values: { particles: 1000, palette: 'custom' } },
];

/**
 * Fires in one context, drawn in turn, picture by picture: the last picture of each.
 * @param {Painter} painter @param {object[]} fires @param {number} pictures @param {string} [disturbance]
 */
async function inTurn(painter, fires, pictures, disturbance) {
  const { json, bytes } = await painter.call('inTurn', { fires, pictures, disturbance });
  let at = 0;
  return json.map((/** @type {number} */ length) => bytes.toString('base64', at, (at += length)));
}

test('fires in one context look as each alone, to the bit', async () => {
  const together = await inTurn(painter, FIRES, 4);
  const alone = [];
  for (const fire of FIRES) alone.push(...(await inTurn(painter, [fire], 4)));
  assert.ok(together.every((picture, at) => picture.length > 10_000 && together.indexOf(picture) === at));
  assert.deepEqual(
    together.map((picture, at) => picture === alone[at]),
    [true, true, true],
  );
});

test('foreign state in a context does not change a picture', async () => {
  const right = await inTurn(painter, FIRES, 2);
  for (const disturbance of await painter.ask('disturbances')) {
    // Its context stays disturbed.
    const other = new Painter();
    const disturbed = await inTurn(other, FIRES, 2, disturbance).finally(() => other.close());
    // A mask of colours is the one thing here that a host has to undo; and so it is seen
    // that what is left behind would be seen.
    const same = disturbance !== 'a colour without two channels';
    assert.deepEqual(
      disturbed.map((picture, at) => picture === right[at]),
      [same, same, same],
      disturbance,
    );
  }
});

for (const lit of ['default', 'classic', 'seed', 'forge']) {
  for (const [width, height] of [
    [1, 1],
    [3, 1000],
    [1000, 3],
    [641, 359],
  ]) {
    test(`${lit} fits a picture of ${width} × ${height}`, async () => {
      const { rgba } = await painter.still({ lit, width, height });
      assert.equal(rgba.length, 4 * width * height);
      for (let at = 0; at < rgba.length; at += 4) {
        const most = Math.max(...rgba.subarray(at, at + 3));
        assert.ok(most <= rgba[at + 3], `${[...rgba.subarray(at, at + 4)]} at ${at / 4}`);
      }
    });
  }
}

// Not the hard discs of the paper's drawing, which are all rim.
for (const lit of ['default', 'classic']) {
  test(`${lit} is the same fire in odd numbers of pixels`, async () => {
    // One line less of a thousand moves nothing by more than half a pixel.
    const [even, odd] = [
      { width: 640, height: 720 },
      { width: 641, height: 721 },
    ];
    const [a, b] = [sheet(await painter.still({ lit, ...even })), sheet(await painter.still({ lit, ...odd }))];
    const { colour, structure } = compare(a, { ...b, width: a.width, rgb: cut(b, a) });
    if (colour > 2 || structure < 0.93) {
      assert.fail(
        `colours differ by ${colour.toFixed(2)}, structure agrees by ${structure.toFixed(3)}: see ${show(`${lit}-odd`, b, a)}`,
      );
    }
  });
}

/** Both panels of a sheet without the columns and rows that another one has not. */
function cut(from, to) {
  const rgb = new Uint8Array(to.rgb.length);
  const [wide, narrow] = [from.width / 2, to.width / 2];
  for (let y = 0; y < to.height; y += 1) {
    for (let x = 0; x < to.width; x += 1) {
      const column = x < narrow ? x : wide + x - narrow;
      const at = (y * from.width + column) * 3;
      rgb.set(from.rgb.subarray(at, at + 3), (y * to.width + x) * 3);
    }
  }
  return rgb;
}

test('a wall is lit alike in pictures of any shape', async () => {
  const height = 240;
  // A narrow flame, and the wall at so many heights on either side of it.
  const request = { lit: 'torch', values: { backdrop: 'bricks', heat_haze: 0 }, height };
  const lit = async (/** @type {number} */ aspect) => {
    const width = Math.round(aspect * height);
    const { rgba } = await painter.still({ ...request, width });
    let [sum, count] = [0, 0];
    for (let y = 0.2 * height; y < 0.6 * height; y += 1) {
      for (let x = 0.12 * height; x < 0.28 * height; x += 1) {
        for (const side of [-1, 1]) {
          const at = 4 * (Math.round(y) * width + Math.round(width / 2 + side * x));
          sum += rgba[at];
          count += 1;
        }
      }
    }
    return sum / count;
  };
  const usual = await lit(0.9);
  assert.ok(usual > 30, `the wall is lit: ${usual}`);
  for (const aspect of [0.6, 1.5, 16 / 9, 2.4, 4]) {
    const other = await lit(aspect);
    assert.ok(Math.abs(other / usual - 1) < 0.1, `${aspect}: ${other} for ${usual}`);
  }
});
