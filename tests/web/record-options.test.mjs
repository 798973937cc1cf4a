/**
 * Which films there are, and what they take. `e2e/extended/record.test.mjs` records some.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FORMATS, checkMemory, estimate, filmOf } from '../../web/record/options.js';

const params = /** @type {any} */ ({ background: '#00000000', backdrop: 'none' });
const of = (/** @type {any} */ options, values = params) =>
  filmOf(options, { width: 300, height: 451, params: values });

test('a film without options is of five seconds, 30 pictures a second, in the size of the picture', () => {
  const film = {
    format: 'auto',
    width: 300,
    height: 452,
    fps: 30,
    from: 0,
    loop: false,
    count: 150,
    alpha: true,
    sound: false,
    stackedAlpha: false,
    premultiplied: false,
    describe: false,
  };
  assert.deepEqual(of(undefined), film);
  assert.deepEqual(of({ width: 101 }).height, 152);
  assert.deepEqual(of({ height: 902 }).width, 600);
});

test('a rate is one that the format has, a third of a hundred by two decimals too', () => {
  assert.equal(of({ format: 'gif', fps: 33.33, seconds: 3 }).count, 100);
  assert.equal(of({ format: 'gif' }).fps, 25);
  assert.throws(() => of({ format: 'gif', fps: 60 }), /fps 60: a GIF has one of 20, 25, 33\.33, 50/);
  assert.throws(() => of({ fps: 29.97 }), /fps 29\.97: a film has one of 24, 25, 30, 50, 60/);
});

for (const [options, words] of /** @type {[any, RegExp][]} */ ([
  [{ format: 'avi' }, /format “avi”: it is one of webp, apng/],
  [{ format: 'toString' }, /format “toString”/],
  [{ width: 4097 }, /width 4097: it is a whole number from 16 to 4096/],
  [{ width: 200.5 }, /width 200\.5: it is a whole number/],
  [{ height: '200' }, /height “200”/],
  [{ seconds: 0 }, /seconds 0: it is a number from 0\.02 to 600/],
  [{ seconds: Number.NaN }, /seconds NaN/],
  [{ seconds: 11, loop: true }, /seconds 11: it is a number from 1 to 10/],
  [{ from: -1 }, /from -1: it is a number from 0/],
  [{ background: 'url(x)' }, /background “url\(x\)”: it is “scene”, “transparent” or a colour/],
  [{ quality: 1 }, /“quality” is no option of a film/],
  [{ format: 'wav', loop: true }, /“wav” has no loop/],
  [{ sound: true }, /“auto” has no sound: webm, mp4 and wav have it/],
  [{ format: 'webm', sound: true, loop: true }, /a loop has no sound/],
  [{ format: 'webm', width: 101, height: 100 }, /both are even in webm/],
  [{ format: 'webm', stackedAlpha: true }, /stackedAlpha is for mp4: webp, .* have alpha of their own/],
  [{ format: 'webp', premultiplied: true }, /premultiplied is for a sheet/],
  [
    { format: 'wav', describe: true },
    /WAV has no place for a text: webp, apng, gif, webm, mp4, zip, png, sheet have one/,
  ],
]))
  test(`refused: ${JSON.stringify(options)}`, () =>
    assert.throws(() => of(options), { name: 'RangeError', message: words }));

test('MP4 has no alpha: the refusal names the formats that have, and any opaque background is one', () => {
  const words = /MP4 has no alpha: state a background .*, stackedAlpha, .*: webp, apng, gif, webm, zip, png, sheet$/;
  for (const background of [undefined, 'scene', 'transparent'])
    assert.throws(() => of({ format: 'mp4', background }), words);
  assert.equal(of({ format: 'mp4', stackedAlpha: true }).alpha, true);
  assert.equal(of({ format: 'mp4', background: '#101018' }).alpha, false);
  assert.equal(of({ format: 'mp4' }, { ...params, background: '#203040' }).alpha, false);
  assert.equal(of({ format: 'mp4' }, { ...params, backdrop: 'bricks' }).alpha, false);
  assert.throws(() => of({ format: 'mp4', background: 'transparent' }, { ...params, backdrop: 'bricks' }), words);
});

test('a film that exceeds the memory is refused with its estimate, unless a stream takes its file', () => {
  const film = of({ width: 4096, height: 4096, seconds: 10 });
  assert.throws(
    () => checkMemory(film, false),
    /would take about 1208 MB of memory, and 872 MB to draw; at most 500 MB are kept/,
  );
  assert.doesNotThrow(() => checkMemory(film, true));
  const gif = of({ format: 'gif', width: 1024, height: 1024, seconds: 20 });
  assert.throws(() => checkMemory(gif, true), /another format, which does not keep its pictures/);
  assert.doesNotThrow(() => checkMemory(of({ width: 512, height: 512 }), false));
});

test('a still has one picture, and a file of every format some size', () => {
  for (const format of Object.keys(FORMATS)) {
    const film = of({ format, width: 512, height: 512, background: '#000000' });
    assert.equal(film.count, format === 'png' ? 1 : format === 'gif' ? 125 : 150);
    const { bytes } = estimate(film);
    assert.ok(bytes > 1e5 && bytes < 2e7, `${format}: ${bytes}`);
  }
});
