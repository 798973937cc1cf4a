/**
 * Round flames in still air: a candle with a bright body and a blue root, and the cones of a gas burner.
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
/** Relative luminance from which a pixel is of a cone of gas that was mixed with air. */
const CONE = 0.17;

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

test('a candle has a bright body without a rim, above a darker zone at its wick', () => {
  for (const rgba of pictures) {
    const height = tip(rgba);
    const row = across(rgba, Math.round(foot - height / 2));
    const [left, right] = [row.findIndex((y) => y > LUMINOUS), row.findLastIndex((y) => y > LUMINOUS)];
    const quarter = Math.round((right - left) / 4);
    const body = Math.max(...row.slice(left + quarter, right - quarter + 1));
    const rim = Math.max(...row.slice(left, left + quarter), ...row.slice(right - quarter + 1));
    assert.ok(body >= rim, `${row.slice(left, right + 1)}`);
    const middle = Math.round((left + right) / 2);
    const dark = across(rgba, Math.round(foot - height / 8))[middle];
    assert.ok(dark < 0.7 * body, `${dark} at the wick, ${body} in the body`);
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
  assert.ok(root > 5 * upper, `${root} against ${upper}`);
});

test('each nozzle of the gas burner has an equal blue cone that narrows, and a pale mantle above', async () => {
  const values = { bloom: 0, background: '#000000' };
  const { width, height, rgba } = await painter.still({ lit: 'gas-burner', values });
  const nozzles = 5;
  const lights = [];
  for (let nozzle = 0; nozzle < nozzles; nozzle += 1) {
    // The nozzles divide the picture evenly, and solids are below the flames.
    const columns = [Math.round((nozzle * width) / nozzles), Math.round(((nozzle + 1) * width) / nozzles)];
    /** The pixels of this flame in a row whose light is in a range. */
    const across = (/** @type {number} */ row, /** @type {number} */ least, most = 1) => {
      const found = [];
      for (let column = columns[0]; column < columns[1]; column += 1) {
        const at = 4 * (row * width + column);
        const light = relativeLuminance(rgba[at], rgba[at + 1], rgba[at + 2]);
        if (light >= least && light < most) found.push({ column, light });
      }
      return found;
    };
    const rows = Array.from({ length: Math.round(0.77 * height) }, (_, row) => row);
    const cone = rows.filter((row) => across(row, CONE).length > 0);
    const mantle = rows.filter((row) => across(row, CONE / 8, CONE).length > 0);
    /** From the first to the last pixel of the cone: its sheet is around unburnt gas. */
    const wide = (/** @type {number} */ share) => {
      const found = across(cone[Math.floor(share * cone.length)], CONE);
      return found[found.length - 1].column - found[0].column + 1;
    };
    assert.ok(wide(0.2) < 0.75 * wide(0.65), `${wide(0.2)} above ${wide(0.65)} pixels`);
    assert.ok(cone.length > 1.4 * wide(0.65), `${cone.length} high, ${wide(0.65)} wide`);
    assert.ok(cone[0] - mantle[0] > 0.5 * cone.length, `${cone[0] - mantle[0]} above ${cone.length} pixels`);
    lights.push(cone.flatMap((row) => across(row, CONE)).reduce((sum, { light }) => sum + light, 0));
  }
  assert.ok(Math.min(...lights) > 0.8 * Math.max(...lights), `${lights}`);
});
