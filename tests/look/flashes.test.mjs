/**
 * The analyser of flashes sees what it should in films whose flashes are known, and
 * finds none in the default fire.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Flashes } from './figures/flashes.mjs';

/** A page of 1024 × 768 in pixels of 16. */
const [WIDTH, HEIGHT, PIXEL] = [64, 48, 16];
/** Pictures a second. */
const RATE = 30;

/**
 * A film of three seconds: a square of that side [CSS px] in the middle has the
 * colour that `colour` gives, all else is black.
 * @param {number} side @param {(time: number) => [number, number, number]} colour  Linear.
 */
function film(side, colour) {
  const flashes = new Flashes(WIDTH, HEIGHT, PIXEL);
  const rgba = new Uint8Array(4 * WIDTH * HEIGHT);
  const half = side / PIXEL / 2;
  for (let picture = 0; picture < 3 * RATE; picture += 1) {
    const codes = colour(picture / RATE).map(encode);
    for (let at = 0; at < WIDTH * HEIGHT; at += 1) {
      const [x, y] = [at % WIDTH, Math.floor(at / WIDTH)];
      const inside = Math.abs(x + 0.5 - WIDTH / 2) < half && Math.abs(y + 0.5 - HEIGHT / 2) < half;
      rgba.set(inside ? [...codes, 255] : [0, 0, 0, 255], 4 * at);
    }
    flashes.see(picture / RATE, rgba);
  }
  return flashes.found();
}

const encode = (/** @type {number} */ x) => Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));

/** Grey that goes to and fro between two luminances so many times a second. */
const flashing = (/** @type {number} */ hertz, low = 0, high = 1) => (/** @type {number} */ time) => {
  const light = (time * hertz) % 1 < 0.5 ? high : low;
  return /** @type {[number, number, number]} */ ([light, light, light]);
};

/** A side whose square is a little more, and a little less, than a quarter of a field. */
const [LARGE, LITTLE] = [160, 144];

test('three flashes a second pass, however large', () => {
  assert.ok(film(700, flashing(3)).passes);
});

test('four flashes a second over a large area fail', () => {
  const found = film(LARGE, flashing(4));
  assert.ok(!found.passes && !found.general.passes);
  assert.equal(found.general.flashes, 4);
  assert.ok(found.general.area > 1);
});

test('four flashes a second over a small area pass', () => {
  const found = film(LITTLE, flashing(4));
  assert.ok(found.passes && found.general.area > 0.5, JSON.stringify(found));
});

test('slow large changes pass', () => {
  assert.ok(film(700, (time) => {
    const light = 0.5 + 0.5 * Math.sin(2 * Math.PI * time);
    return [light, light, light];
  }).passes);
});

test('a flicker of a little less than a tenth passes, and one of more fails', () => {
  assert.ok(film(700, flashing(10, 0.3, 0.39)).passes);
  assert.ok(!film(700, flashing(10, 0.3, 0.41)).passes);
});

test('what flashes between bright and brighter passes', () => {
  assert.ok(film(700, flashing(8, 0.84, 1)).passes);
  assert.ok(!film(700, flashing(8, 0.7, 0.85)).passes);
});

test('a slow change that is seen in small steps is one change', () => {
  // Each step is less than a tenth, all of them are more.
  const wave = (/** @type {number} */ hertz) => (/** @type {number} */ time) => {
    const light = 0.5 - 0.25 * Math.cos(2 * Math.PI * hertz * time);
    return /** @type {[number, number, number]} */ ([light, light, light]);
  };
  assert.ok(film(700, wave(2)).passes);
  assert.ok(!film(700, wave(5)).passes);
});

test('red flashes fail that would be too dark as general ones', () => {
  const red = film(700, (time) => ((time * 5) % 1 < 0.5 ? [0.2, 0, 0] : [0.02, 0, 0]));
  assert.ok(red.general.passes && !red.red.passes && !red.passes, JSON.stringify(red));
  // The same in a blue that is as bright.
  const blue = film(700, (time) => ((time * 5) % 1 < 0.5 ? [0, 0, 0.5] : [0, 0, 0.05]));
  assert.ok(blue.passes);
});

test('a wave that runs over a large area fails', () => {
  const flashes = new Flashes(WIDTH, HEIGHT, PIXEL);
  const rgba = new Uint8Array(4 * WIDTH * HEIGHT);
  for (let picture = 0; picture < 3 * RATE; picture += 1) {
    for (let at = 0; at < WIDTH * HEIGHT; at += 1) {
      const light = 0.5 + 0.4 * Math.sin(2 * Math.PI * (5 * (picture / RATE) - (at % WIDTH) / WIDTH));
      rgba.fill(encode(light), 4 * at, 4 * at + 4);
    }
    flashes.see(picture / RATE, rgba);
  }
  assert.ok(!flashes.found().passes);
});

test('a flicker of small places, each in its own time, passes', () => {
  const flashes = new Flashes(WIDTH, HEIGHT, PIXEL);
  const rgba = new Uint8Array(4 * WIDTH * HEIGHT);
  for (let picture = 0; picture < 3 * RATE; picture += 1) {
    for (let at = 0; at < WIDTH * HEIGHT; at += 1) {
      // A third of a field flickers, five times a second.
      const [x, y] = [at % WIDTH - 20, Math.floor(at / WIDTH) - 20];
      const inside = x >= 0 && x < 11 && y >= 0 && y < 10;
      const on = inside && ((picture / RATE) * 5 + ((x * 7 + y * 5) % 6) / 6) % 1 < 0.5;
      rgba.fill(on ? 255 : 0, 4 * at, 4 * at + 4);
    }
    flashes.see(picture / RATE, rgba);
  }
  const { general } = flashes.found();
  assert.ok(general.passes && general.flickers > 1, JSON.stringify(general));
});

test('areas that flash in turn are seen, though no place flashes often', () => {
  const flashes = new Flashes(WIDTH, HEIGHT, PIXEL);
  const rgba = new Uint8Array(4 * WIDTH * HEIGHT);
  for (let picture = 0; picture < 3 * RATE; picture += 1) {
    // Three columns of 96 px in one field: each is bright for a tenth of a second, in turn.
    const turn = Math.floor((picture / RATE) * 10);
    for (let at = 0; at < WIDTH * HEIGHT; at += 1) {
      const on = turn % 2 === 0 && at % WIDTH < 18 && Math.floor((at % WIDTH) / 6) === (turn / 2) % 3;
      rgba.set(on ? [255, 255, 255, 255] : [0, 0, 0, 255], 4 * at);
    }
    flashes.see(picture / RATE, rgba);
  }
  const { general } = flashes.found();
  assert.ok(general.area === 0 && !general.passes, JSON.stringify(general));
});
