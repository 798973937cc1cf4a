/**
 * The flash analyser finds known flashes of test films.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Flashes } from './figures/flashes.mjs';

/** A page of 1024 × 768 in pixels of 16. */
const [WIDTH, HEIGHT, PIXEL] = [64, 48, 16];
/** Pictures a second. */
const RATE = 30;

/**
 * What is found in a film of three seconds.
 * @param {(time: number, x: number, y: number) => number[]} colour  Linear, of every pixel.
 */
function seen(colour) {
  const flashes = new Flashes(WIDTH, HEIGHT, PIXEL);
  const rgba = new Uint8Array(4 * WIDTH * HEIGHT).fill(255);
  for (let picture = 0; picture < 3 * RATE; picture += 1) {
    for (let at = 0; at < WIDTH * HEIGHT; at += 1) {
      rgba.set(colour(picture / RATE, at % WIDTH, Math.floor(at / WIDTH)).map(encode), 4 * at);
    }
    flashes.see(picture / RATE, rgba);
  }
  return flashes.found();
}

/**
 * The same where a square of that side [CSS px] in the middle has a colour and all else
 * is black.
 * @param {number} side @param {(time: number) => number[]} colour
 */
function film(side, colour) {
  const half = side / PIXEL / 2;
  const off = (/** @type {number} */ x, /** @type {number} */ all) => Math.abs(x + 0.5 - all / 2);
  return seen((time, x, y) => (off(x, WIDTH) < half && off(y, HEIGHT) < half ? colour(time) : BLACK));
}

const BLACK = [0, 0, 0];

const encode = (/** @type {number} */ x) =>
  Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));

/** To and fro between two colours so many times a second. */
const between =
  (/** @type {number} */ hertz, /** @type {number[]} */ colour, /** @type {number[]} */ other) =>
  (/** @type {number} */ time) =>
    (time * hertz) % 1 < 0.5 ? colour : other;

const grey = (/** @type {number} */ light) => [light, light, light];

/** The same between two luminances. */
const flashing = (/** @type {number} */ hertz, low = 0, high = 1) => between(hertz, grey(high), grey(low));

/** A side whose square is a little more, and a little less, than a quarter of a field. */
const [LARGE, LITTLE] = [160, 144];

test('three flashes a second pass, however large', () => {
  assert.ok(film(700, flashing(3)).passes);
});

test('four flashes a second over a large area fail', () => {
  const found = film(LARGE, flashing(4));
  assert.ok(!found.passes && !found.general.passes);
  assert.equal(found.general.flashes, 4);
  assert.ok(found.general.area >= 0.25);
});

test('four flashes a second over a small area pass', () => {
  const found = film(LITTLE, flashing(4));
  assert.ok(found.passes && found.general.area > 0.15, JSON.stringify(found));
});

test('slow large changes pass', () => {
  assert.ok(film(700, (time) => grey(0.5 + 0.5 * Math.sin(2 * Math.PI * time))).passes);
});

test('a flicker of a little less than a tenth passes, and one of more fails', () => {
  assert.ok(film(700, flashing(10, 0.3, 0.39)).passes);
  assert.ok(!film(700, flashing(10, 0.3, 0.41)).passes);
  // As fast as pictures follow each other.
  assert.equal(film(700, flashing(15, 0.3, 0.41)).general.flashes, 15);
});

test('what flashes between bright and brighter passes', () => {
  assert.ok(film(700, flashing(8, 0.84, 1)).passes);
  assert.ok(!film(700, flashing(8, 0.7, 0.85)).passes);
});

test('a slow change that is seen in small steps is one change', () => {
  // Each step is less than a tenth, all of them are more.
  const wave = (/** @type {number} */ hertz) => (/** @type {number} */ time) =>
    grey(0.5 - 0.25 * Math.cos(2 * Math.PI * hertz * time));
  assert.ok(film(700, wave(2)).passes);
  assert.ok(!film(700, wave(5)).passes);
});

const RED = [1, 0, 0];

test('a saturated red to and from another colour flashes', () => {
  for (const other of [grey(1), [0, 0, 1], [0, 0.6, 0], BLACK]) {
    const { red } = film(LARGE, between(4, RED, other));
    assert.ok(!red.passes && red.flashes === 4, `${other}: ${JSON.stringify(red)}`);
    assert.ok(film(LITTLE, between(4, RED, other)).red.passes && film(700, between(3, RED, other)).red.passes);
  }
  // Too dark to be a general flash.
  const dark = film(700, between(5, [0.2, 0, 0], BLACK));
  assert.ok(dark.general.passes && !dark.red.passes && !dark.passes, JSON.stringify(dark));
});

test('what is no change of a saturated red by much is no red flash', () => {
  for (const [colour, other] of [
    [RED, [0.7, 0, 0]], // Darker alone.
    [RED, [0.8, 0.2, 0]], // Both are saturated reds.
    [
      [1, 0.4, 0],
      [0.6, 0.24, 0],
    ], // Orange.
    [[1, 0.4, 0], BLACK],
    [
      [0, 0, 1],
      [0, 1, 0],
    ], // Far apart, and neither is red.
    [[0.003, 0, 0], BLACK], // Invisible.
  ]) {
    const { red } = film(700, between(5, colour, other));
    assert.ok(red.flashes === 0, `${colour} and ${other}: ${JSON.stringify(red)}`);
  }
});

test('a slow fade between red and blue is one change, and a fast one too', () => {
  const fade = (/** @type {number} */ hertz) => (/** @type {number} */ time) => {
    const share = 0.5 - 0.5 * Math.cos(2 * Math.PI * hertz * time);
    return [0.5 * share, 0, 0.5 * (1 - share)];
  };
  assert.equal(film(700, fade(2)).red.flashes, 2);
  assert.equal(film(700, fade(5)).red.flashes, 5);
});

test('a wave that runs over a large area fails', () => {
  assert.ok(!seen((time, x) => grey(0.5 + 0.4 * Math.sin(2 * Math.PI * (5 * time - x / WIDTH)))).passes);
});

/** A number between 0 and 1 of every pixel, independent of its neighbours'. */
const chance = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ which) => {
  const bits = Math.imul(x + WIDTH * y + 1 + WIDTH * HEIGHT * which, 0x9e3779b1);
  return (Math.imul(bits ^ (bits >>> 15), 0x85ebca6b) >>> 8) / 2 ** 24;
};

test('small places that flicker pass, each in its own time, and fail in step', () => {
  /** All of the page, four to six times a second. */
  const flicker = (/** @type {boolean} */ own) =>
    seen((time, x, y) => {
      const phase = own ? (4 + 2 * chance(x, y, 0)) * time + chance(x, y, 1) : 5 * time;
      // Not all as strong.
      return phase % 1 < 0.5 ? grey(0.3 + 0.6 * chance(x, y, 2)) : BLACK;
    });
  const own = flicker(true);
  assert.ok(own.passes && own.general.flickers > 0.9, JSON.stringify(own));
  const inStep = flicker(false);
  assert.ok(!inStep.passes && inStep.general.flashes === 5, JSON.stringify(inStep));
});

test('so do they where they come and go smoothly', () => {
  const flicker = (/** @type {boolean} */ own) =>
    seen((time, x, y) => {
      const phase = own ? (4 + 2 * chance(x, y, 0)) * time + chance(x, y, 1) : 5 * time;
      return grey((0.2 + 0.4 * chance(x, y, 2)) * (1 - Math.cos(2 * Math.PI * phase)));
    });
  const own = flicker(true);
  assert.ok(own.passes && own.general.flickers > 0.9, JSON.stringify(own));
  const inStep = flicker(false);
  assert.ok(!inStep.passes && inStep.general.flashes === 5, JSON.stringify(inStep));
});

test('areas that flash in turn are seen, though no place flashes often', () => {
  // Three columns of 96 px in one field: each is bright for a tenth of a second, in turn.
  const { general } = seen((time, x) => {
    const turn = Math.floor(time * 10 + 1e-6);
    return grey(Number(turn % 2 === 0 && x < 18 && Math.floor(x / 6) === (turn / 2) % 3));
  });
  assert.ok(general.flickers === 0 && !general.passes, JSON.stringify(general));
});
