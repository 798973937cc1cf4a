/**
 * A candle in still air: a round flame with a bright rim and a blue root.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { LINEAR, relativeLuminance } from './figures/colour.mjs';
import { Painter } from './painter.mjs';

const [WIDTH, HEIGHT] = [320, 400];
/** Number of pictures and seconds between them. */
const [PICTURES, APART] = [8, 0.2];
/** Relative luminance from which a pixel is of the flame. */
const LUMINOUS = 0.1;

const painter = new Painter();
after(() => painter.close());

/** Row of the source. */
let foot = 0;
/** The pictures. @type {Buffer[]} */
const pictures = [];

before(async () => {
  const request = { lit: 'candle', width: WIDTH, height: HEIGHT, burnt: 4, particles: 3000 };
  const values = await painter.ask('values', request);
  foot = Math.floor(HEIGHT * (1 - Number(values.source_height) / Number(values.domain_height)));
  const start = await painter.ask('film', request);
  for (let picture = 0; picture < PICTURES; picture += 1) {
    const { bytes } = await painter.call('picture', { time: start + picture * APART, light: false });
    pictures.push(bytes);
  }
});

/**
 * The codes of a pixel.
 * @param {Buffer} rgba @param {number} row @param {number} column
 * @returns {[number, number, number]}
 */
function codes(rgba, row, column) {
  const at = 4 * (row * WIDTH + column);
  return [rgba[at], rgba[at + 1], rgba[at + 2]];
}

/** The luminance along a row. @param {Buffer} rgba @param {number} row */
function across(rgba, row) {
  return Array.from({ length: WIDTH }, (_, column) => relativeLuminance(...codes(rgba, row, column)));
}

/** Height of the tip above the source in pixels, interpolated between two rows. @param {Buffer} rgba */
function tip(rgba) {
  let above = 0;
  for (let row = 0; row < foot; row += 1) {
    const brightest = Math.max(...across(rgba, row));
    if (brightest > LUMINOUS) return foot - row + (brightest - LUMINOUS) / (brightest - above);
    above = brightest;
  }
  return assert.fail('no flame');
}

/** Blue share of the light of these rows. @param {Buffer} rgba @param {number} top @param {number} bottom */
function blueShare(rgba, top, bottom) {
  const sum = [0, 0, 0];
  for (let row = top; row < bottom; row += 1) {
    for (let column = 0; column < WIDTH; column += 1) {
      for (const [channel, code] of codes(rgba, row, column).entries()) sum[channel] += LINEAR[code];
    }
  }
  return sum[2] / (sum[0] + sum[1] + sum[2]);
}

test('a candle has a bright rim around a darker middle', () => {
  for (const rgba of pictures) {
    const row = across(rgba, Math.round(foot - tip(rgba) / 3));
    const [left, right] = [row.findIndex((y) => y > LUMINOUS), row.findLastIndex((y) => y > LUMINOUS)];
    const quarter = Math.round((right - left) / 4);
    const middle = Math.min(...row.slice(left + quarter, right - quarter + 1));
    const rims = [row.slice(left, left + 2 * quarter), row.slice(right - 2 * quarter + 1, right + 1)];
    for (const rim of rims) assert.ok(Math.max(...rim) > 1.05 * middle, `${row.slice(left, right + 1)}`);
  }
});

test('the tip of a candle in still air stays within 3 % of its mean height', () => {
  const tips = pictures.map(tip);
  const mean = tips.reduce((sum, height) => sum + height) / tips.length;
  for (const height of tips) assert.ok(Math.abs(height - mean) <= 0.03 * mean, `${tips}`);
});

test('the root of a candle is blue', () => {
  let [root, upper] = [0, 0];
  for (const rgba of pictures) {
    const height = tip(rgba);
    root += blueShare(rgba, Math.round(foot - height / 10), foot) / PICTURES;
    upper += blueShare(rgba, Math.round(foot - height), Math.round(foot - height / 2)) / PICTURES;
  }
  assert.ok(root > 10 * upper, `${root} against ${upper}`);
});
