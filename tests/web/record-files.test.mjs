/**
 * The files of films: what a reader of their formats finds in them. Browsers decode them in `e2e/extended/record.test.mjs`.
 */
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { crc32 as checksum, inflateSync, deflateSync } from 'node:zlib';
import { bleed, stacked } from '../../web/record/alpha.js';
import { chunksOf, crc32, joined } from '../../web/record/bytes.js';
import { Gif, compressed, paletteOf, threshold } from '../../web/record/gif.js';
import { mix, loopOf, shareOfEarlier, startOf } from '../../web/record/loop.js';
import { Mp4 } from '../../web/record/mp4.js';
import { Apng, Still, WebP, Zip, ticks } from '../../web/record/pictures.js';
import { Sheet, atlasOf } from '../../web/record/sheet.js';
import { Samples, wav } from '../../web/record/wav.js';
import { WebM } from '../../web/record/webm.js';

const HEADER = { width: 4, height: 2, fps: 30, count: 3 };
const text = (/** @type {Uint8Array} */ bytes) => Buffer.from(bytes).toString('latin1');

/** The file of pieces. @param {import('../../web/record/bytes.js').Piece[]} pieces */
function fileOf(pieces) {
  const file = joined(...pieces.filter(({ at }) => at === undefined).map(({ bytes }) => bytes));
  for (const { bytes, at } of pieces) if (at !== undefined) file.set(bytes, at);
  return file;
}

/** A film of files. @param {any} film @param {Uint8Array[]} files */
const filmOf = (film, files) => fileOf([...files.flatMap((file, number) => film.add(file, number)), ...film.end()]);

test('pictures are shown at multiples of the rate, rounded, so that their times do not drift', () => {
  for (const fps of [24, 25, 30, 50, 60, 100 / 3]) assert.equal(ticks(600 * fps, fps, 1000), 600_000);
  assert.deepEqual(
    [0, 1, 2, 3].map((number) => ticks(number, 30, 1000)),
    [0, 33, 67, 100],
  );
});

/** A chunk of PNG. @type {(name: string, bytes: Uint8Array) => Buffer} */
function pngChunk(name, bytes) {
  const named = Buffer.concat([Buffer.from(name), bytes]);
  const ends = [Buffer.alloc(4), Buffer.alloc(4)];
  ends[0].writeUInt32BE(bytes.length);
  ends[1].writeUInt32BE(checksum(named));
  return Buffer.concat([ends[0], named, ends[1]]);
}

/** A PNG file of one grey, as browsers write them: with data in two chunks. @type {(grey: number, kind?: number) => Uint8Array<ArrayBuffer>} */
function png(grey, kind = 6) {
  const head = Buffer.from([0, 0, 0, 4, 0, 0, 0, 2, 8, kind, 0, 0, 0]);
  const data = deflateSync(Buffer.concat([0, 1].map(() => Buffer.from([0, ...Array(16).fill(grey)]))));
  const parts = [data.subarray(0, 5), data.subarray(5)].map((part) => pngChunk('IDAT', part));
  const file = Buffer.concat([
    Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'),
    pngChunk('IHDR', head),
    pngChunk('tEXt', Buffer.from('a\0b')),
    ...parts,
    pngChunk('IEND', Buffer.alloc(0)),
  ]);
  return new Uint8Array(file);
}

test('an APNG has the data of every picture, valid checksums, and its count and times', () => {
  const file = filmOf(new Apng(HEADER), [png(10), png(20), png(30)]);
  const chunks = chunksOf(file, 'png');
  for (let at = 8; at < file.length; ) {
    const view = new DataView(file.buffer, at);
    const length = view.getUint32(0);
    assert.equal(view.getUint32(8 + length), checksum(file.subarray(at + 4, at + 8 + length)));
    at += 12 + length;
  }
  const named = (/** @type {string} */ name) => chunks.filter((chunk) => chunk.name === name).map(({ bytes }) => bytes);
  assert.deepEqual(
    chunks.map(({ name }) => name).join(' '),
    'IHDR sRGB acTL fcTL IDAT IDAT fcTL fdAT fdAT fcTL fdAT fdAT IEND',
  );
  assert.deepEqual([...named('acTL')[0]], [0, 0, 0, 3, 0, 0, 0, 0]);
  const numbers = [...named('fcTL'), ...named('fdAT')].map((bytes) => Buffer.from(bytes).readUInt32BE());
  assert.deepEqual(numbers.sort(), [0, 1, 2, 3, 4, 5, 6]);
  assert.deepEqual(
    named('fcTL').map((bytes) => Buffer.from(bytes).readUInt16BE(20)),
    [33, 34, 33],
  );
  const [second] = [named('fdAT').slice(0, 2)];
  const pixels = inflateSync(joined(...second.map((bytes) => bytes.subarray(4))));
  assert.deepEqual([...pixels.subarray(1, 17)], Array(16).fill(20));
});

test('an APNG refuses pictures of several kinds', () => {
  assert.throws(() => filmOf(new Apng(HEADER), [png(10), png(10, 2)]), /several kinds/);
});

/** A WebP file of chunks. @param {[name: string, bytes: number[]][]} chunks */
function webp(chunks) {
  const parts = chunks.map(([name, bytes]) => {
    const size = Buffer.alloc(4);
    size.writeUInt32LE(bytes.length);
    return Buffer.concat([Buffer.from(name), size, Buffer.from(bytes), Buffer.alloc(bytes.length % 2)]);
  });
  return new Uint8Array(Buffer.concat([Buffer.from('RIFF....WEBP'), ...parts]));
}

test('an animated WebP has alpha and colours of every picture, sizes less one, and the size of the file', () => {
  const picture = webp([
    ['VP8X', Array(10).fill(0)],
    ['ALPH', [1, 2, 3]],
    ['VP8 ', [4, 5]],
    ['EXIF', [6]],
  ]);
  const file = filmOf(new WebP(HEADER), [picture, webp([['VP8L', [7]]]), picture]);
  assert.equal(new DataView(file.buffer).getUint32(4, true), file.length - 8);
  const [head, animation, ...frames] = chunksOf(file, 'riff');
  assert.deepEqual([head.name, animation.name], ['VP8X', 'ANIM']);
  assert.deepEqual([...head.bytes], [0x12, 0, 0, 0, 3, 0, 0, 1, 0, 0]);
  assert.deepEqual([...animation.bytes], [0, 0, 0, 0, 0, 0]);
  assert.deepEqual(
    frames.map(({ bytes }) => bytes[12]),
    [33, 34, 33],
  );
  assert.deepEqual([...frames[0].bytes.subarray(0, 12)], [0, 0, 0, 0, 0, 0, 3, 0, 0, 1, 0, 0]);
  const parts = chunksOf(joined(Array(12).fill(0), frames[0].bytes.subarray(16)), 'riff');
  assert.deepEqual(
    parts.map(({ name, bytes }) => [name, ...bytes]),
    [
      ['ALPH', 1, 2, 3],
      ['VP8 ', 4, 5],
    ],
  );
});

test('a zip archive lists each file with its checksum and place, and no time', () => {
  const files = [png(1), png(2)];
  const zip = Buffer.from(filmOf(new Zip(), files));
  const end = zip.subarray(-22);
  assert.equal(end.readUInt32LE(0), 0x06054b50);
  assert.deepEqual([end.readUInt16LE(8), end.readUInt32LE(12) + end.readUInt32LE(16) + 22], [2, zip.length]);
  let at = end.readUInt32LE(16);
  for (const [number, file] of files.entries()) {
    assert.equal(zip.readUInt32LE(at), 0x02014b50);
    assert.deepEqual([zip.readUInt16LE(at + 12), zip.readUInt16LE(at + 14)], [0, 0x21]);
    assert.equal(zip.readUInt32LE(at + 16), checksum(file));
    const local = zip.readUInt32LE(at + 42);
    assert.equal(text(zip.subarray(local + 30, local + 39)), `0000${number}.png`);
    assert.deepEqual(new Uint8Array(zip.subarray(local + 39, local + 39 + file.length)), file);
    at += 46 + 9;
  }
  assert.equal(crc32(files[0]), checksum(files[0]));
});

/** The indices that the blocks of an image are. @param {Uint8Array} blocks */
function expanded(blocks) {
  const bytes = [];
  for (let at = 0; blocks[at] > 0; at += 1 + blocks[at]) bytes.push(...blocks.subarray(at + 1, at + 1 + blocks[at]));
  /** @type {number[][]} */
  let known = [];
  const indices = [];
  /** @type {number[] | undefined} */
  let last;
  for (let [bit, size] = [0, 9]; ; ) {
    let code = 0;
    for (let part = 0; part < size; part += 1, bit += 1) code |= ((bytes[bit >> 3] >> (bit & 7)) & 1) << part;
    if (code === 257) return { indices, rest: bytes.length * 8 - bit };
    if (code === 256) {
      known = Array.from({ length: 258 }, (_, value) => [value]);
      [size, last] = [9, undefined];
      continue;
    }
    const now = known[code] ?? [.../** @type {number[]} */ (last), /** @type {number[]} */ (last)[0]];
    if (last && known.length < 4096) known.push([...last, now[0]]);
    if (known.length === 1 << size && size < 12) size += 1;
    indices.push(...now);
    last = now;
  }
}

test('a reader of GIF finds the indices again, over every length of code and a full table', () => {
  for (const [count, values] of [
    [1, 1],
    [700, 2],
    [300, 256],
    [60_000, 256],
    [60_000, 3],
  ]) {
    let seed = 1;
    const random = () => (seed = Math.imul(seed, 1_103_515_245) + 12_345) >>> 16;
    const given = Array.from({ length: count }, () => random() % values);
    const { indices, rest } = expanded(compressed(Uint8Array.from(given)));
    assert.deepEqual(indices, given);
    assert.ok(rest < 8, `${rest} bits are left`);
  }
});

test('a GIF has one palette, in which a dithered grey keeps its mean, and transparent pixels stay so', () => {
  const header = { width: 8, height: 8, fps: 100 / 3, count: 3 };
  const grey = (/** @type {number} */ value) =>
    Uint8ClampedArray.from({ length: 256 }, (_, at) => (at % 4 === 3 ? 255 : value));
  const film = new Gif(header);
  for (const pixels of [grey(40), grey(48), new Uint8ClampedArray(256)]) film.add(pixels);
  const file = fileOf(film.end());
  assert.equal(text(file.subarray(0, 6)), 'GIF89a');
  const palette = file.subarray(13, 13 + 768);
  const images = [];
  const delays = [];
  for (let at = 13 + 768 + 19; file[at] !== 0x3b; ) {
    delays.push(file[at + 4]);
    at += 8 + 11;
    images.push(expanded(file.subarray(at)).indices);
    while (file[at] > 0) at += 1 + file[at];
    at += 1;
  }
  assert.deepEqual(delays, [3, 3, 3]);
  const mean = images[1].reduce((sum, index) => sum + palette[3 * index], 0) / 64;
  assert.ok(Math.abs(mean - 48) < 2, `${mean}`);
  assert.deepEqual(new Set(images[2]), new Set([255]));
});

test('the matrix of thresholds has each once', () => {
  const all = Array.from({ length: 64 }, (_, at) => threshold(at % 8, Math.floor(at / 8)) * 64);
  assert.deepEqual(
    all.sort((a, b) => a - b),
    Array.from({ length: 64 }, (_, at) => at),
  );
});

test('a palette has a colour near to each that is used', () => {
  const counts = new Float64Array(32 ** 3 + 1);
  for (let cell = 0; cell < 32 ** 3; cell += 97) counts[cell] = 1 + (cell % 5);
  const { colours, nearest } = paletteOf(counts);
  assert.equal(colours.length, 256);
  for (let cell = 0; cell < 32 ** 3; cell += 97) {
    const part = [cell >> 10, (cell >> 5) & 31, cell & 31].map((value) => (value * 255) / 31);
    const off = part.map((value, at) => Math.abs(value - colours[nearest[cell]][at]));
    assert.ok(Math.max(...off) < 50, `${part} is ${colours[nearest[cell]]}`);
  }
});

test('a loop begins where its end is like what was before it', () => {
  // The pictures have a period of 20 from number 30 on.
  const picture = (/** @type {number} */ number) =>
    Uint8ClampedArray.of(number < 30 ? 255 - number : (number % 20) * 5, 0, 0, 255);
  const { fade, searched } = loopOf(20, 10);
  assert.deepEqual([fade, searched], [3, 63]);
  assert.equal(
    startOf(
      Array.from({ length: searched }, (_, number) => picture(number)),
      20,
      10,
    ),
    33,
  );
  assert.deepEqual(
    [16, 17, 18, 19].map((number) => shareOfEarlier(number, 20, 3)),
    [0, 0.25, 0.5, 0.75],
  );
});

test('a mix is of light, weighted by alpha, and a picture mixed with itself stays', () => {
  const [white, black] = [Uint8ClampedArray.of(255, 255, 255, 255), Uint8ClampedArray.of(0, 0, 0, 255)];
  mix(black, white, 0.5);
  assert.deepEqual([...black], [188, 188, 188, 255]);
  const fire = Uint8ClampedArray.of(200, 100, 50, 255);
  mix(fire, Uint8ClampedArray.of(0, 0, 0, 0), 0.5);
  assert.deepEqual([...fire], [200, 100, 50, 128]);
  const greys = Uint8ClampedArray.from({ length: 1024 }, (_, at) => (at % 4 === 3 ? 255 : at >> 2));
  const before = greys.slice();
  mix(greys, before, 0.3);
  assert.deepEqual(greys, before);
});

test('colours go on where nothing is seen, and alpha stays', () => {
  const row = Uint8ClampedArray.from({ length: 4 * 40 }, (_, at) => (at >> 2 === 20 ? [90, 60, 30, 255][at % 4] : 0));
  bleed(row, 40);
  const at = (/** @type {number} */ pixel) => [...row.subarray(4 * pixel, 4 * pixel + 4)];
  for (const pixel of [12, 19, 21, 28]) assert.deepEqual(at(pixel), [90, 60, 30, 0]);
  for (const pixel of [0, 11, 29, 39]) assert.deepEqual(at(pixel), [0, 0, 0, 0]);
});

test('stacked alpha is a grey below the colours', () => {
  const pixels = Uint8ClampedArray.of(90, 60, 30, 255, 0, 0, 0, 0, 8, 7, 6, 5, 0, 0, 0, 0);
  const colours = [90, 60, 30, 255, 90, 60, 30, 255, 8, 7, 6, 255, 8, 7, 6, 255];
  const greys = [255, 255, 255, 255, 0, 0, 0, 255, 5, 5, 5, 255, 0, 0, 0, 255];
  assert.deepEqual([...stacked(pixels, 2)], [...colours, ...greys]);
});

/** The files of an archive. @param {Buffer} zip */
function entriesOf(zip) {
  const files = new Map();
  for (let at = 0; zip.readUInt32LE(at) === 0x04034b50; ) {
    const [size, length] = [zip.readUInt32LE(at + 18), zip.readUInt16LE(at + 26)];
    const start = at + 30 + length;
    files.set(text(zip.subarray(at + 30, start)), zip.subarray(start, start + size));
    at = start + size;
  }
  return files;
}

test('a sheet has each picture where its description says, and the description is that of the command', async () => {
  const known = JSON.parse(await readFile(new URL('sheet.json', import.meta.url), 'utf8'));
  assert.deepEqual(atlasOf({ width: 48, height: 32, fps: 30, count: 9, premultiplied: false }), known);
  for (const premultiplied of [false, true]) {
    const header = { width: 4, height: 2, fps: 30, count: 9, premultiplied, text: '{}' };
    const film = new Sheet(header);
    // A pixel of each picture is seen, half of it.
    for (let number = 0; number < header.count; number += 1) {
      const pixels = new Uint8ClampedArray(4 * 4 * 2);
      pixels.set([10 * number, 200, 0, 128], 4 * 5);
      film.add(pixels, number);
    }
    const files = entriesOf(Buffer.from(fileOf(await film.end())));
    const { frames, animations, meta } = JSON.parse(String(files.get('hearth.json')));
    const chunks = chunksOf(new Uint8Array(files.get('hearth.png')), 'png');
    assert.equal(chunks.map(({ name }) => name).join(' '), 'IHDR iTXt sRGB IDAT IEND');
    const { w, h } = meta.size;
    assert.deepEqual([...chunks[0].bytes.subarray(0, 8)], [0, 0, 0, w, 0, 0, 0, h]);
    const rows = inflateSync(chunks[3].bytes);
    const pixel = (/** @type {number} */ x, /** @type {number} */ y) =>
      Array.from({ length: 4 }, (_, part) => {
        // Each row has the differences from the one above.
        let value = 0;
        for (let row = 0; row <= y; row += 1) value += rows[row * (4 * w + 1) + 1 + 4 * x + part];
        return value % 256;
      });
    for (const [number, name] of animations.hearth.entries()) {
      const { x, y } = frames[name].frame;
      const red = 10 * number;
      const seen = premultiplied ? [Math.round((red * 128) / 255), 100, 0, 128] : [red, 200, 0, 128];
      assert.deepEqual(pixel(x + 1, y + 1), seen, name);
      // The colour goes on within the tile, and not beside it.
      assert.deepEqual(pixel(x, y), premultiplied ? [0, 0, 0, 0] : [red, 200, 0, 0]);
      assert.deepEqual(pixel(x - 1, y), [0, 0, 0, 0]);
    }
  }
});

test('every format but WAV has a place for a text, and none without one', async () => {
  const about = `{"hearth":3,"values":{"seed":7},"name":"<ä> & ${'long '.repeat(80)}"}`;
  const block = { bytes: Uint8Array.of(1), isKey: true, ms: 0 };
  for (const told of [about, undefined]) {
    const header = { width: 8, height: 8, fps: 25, count: 1, text: told };
    const gif = new Gif(header);
    gif.add(new Uint8ClampedArray(256));
    const [webm, mp4] = [new WebM({ ...header, alpha: false }), new Mp4(header)];
    const files = {
      apng: filmOf(new Apng(header), [png(1)]),
      png: filmOf(new Still(header), [png(1)]),
      zip: filmOf(new Zip(header), [png(1)]),
      webp: filmOf(new WebP(header), [webp([['VP8L', [7]]])]),
      gif: fileOf(gif.end()),
      webm: fileOf([...webm.begin(), ...webm.add(block, 1), ...webm.end()]),
      mp4: fileOf([...mp4.begin(), ...mp4.add(block.bytes, 0, true, 1000), ...mp4.end(block.bytes)]),
    };
    for (const [format, file] of Object.entries(files)) {
      let written = Buffer.from(file).toString('utf8');
      if (format === 'webp') written = written.replaceAll('&lt;', '<').replaceAll('&amp;', '&');
      // Blocks of a GIF have their lengths between them.
      const part = about.slice(0, format === 'gif' ? 200 : undefined);
      assert.equal(written.includes(part), told !== undefined, format);
      if (format === 'webp') assert.equal(new DataView(file.buffer).getUint32(4, true), file.length - 8);
    }
    assert.equal(chunksOf(files.webp, 'riff')[0].bytes[0], told ? 0x16 : 0x12);
    elements(files.webm);
  }
});

test('WAV has both channels in turn, from the first sample to the last', () => {
  const samples = new Samples();
  samples.add(Float32Array.of(0, 1, 0.5, -1));
  samples.add(Float32Array.of(0.25, 9, 0.125, 9));
  const file = Buffer.from(wav(samples.channels(3)));
  assert.deepEqual(
    [text(file.subarray(0, 4)), file.readUInt32LE(4), text(file.subarray(8, 16))],
    ['RIFF', 48, 'WAVEfmt '],
  );
  assert.deepEqual(
    [file.readUInt16LE(22), file.readUInt32LE(24), file.readUInt16LE(34), file.readUInt32LE(40)],
    [2, 48_000, 16, 12],
  );
  const all = Array.from({ length: 6 }, (_, at) => file.readInt16LE(44 + 2 * at));
  assert.deepEqual(all, [0, 16_384, 32_767, -32_767, 8192, 4096]);
});

/** The elements of WebM that contain others. */
const PARENTS = [
  0x1254c367, 0x7373, 0x67c8, 0x18538067, 0x114d9b74, 0x4dbb, 0x1549a966, 0x1654ae6b, 0xae, 0xe0, 0x1f43b675, 0xa0,
  0x75a1, 0xa6, 0x1c53bb6b, 0xbb, 0xb7,
];

/** The elements of a WebM file, with their places. @type {(file: Uint8Array, from?: number, to?: number) => {id: number, at: number, bytes: Uint8Array}[]} */
function elements(file, from = 0, to = file.length) {
  const found = [];
  for (let at = from; at < to; ) {
    const [idLength, start] = [Math.clz32(file[at]) - 23, at];
    const id = Buffer.from(file).readUIntBE(at, idLength);
    at += idLength;
    assert.equal(file[at], 1, 'sizes have eight bytes');
    const size = Buffer.from(file).readUIntBE(at + 2, 6);
    at += 8;
    assert.ok(at + size <= to, 'an element ends in its parent');
    found.push({ id, at: start, bytes: file.subarray(at, at + size) });
    if (PARENTS.includes(id)) found.push(...elements(file, at, at + size));
    at += size;
  }
  return found;
}

const blocks = Array.from({ length: 5 }, (_, at) => ({ bytes: Uint8Array.of(at), isKey: at % 3 === 0, ms: at * 40 }));

test('a WebM has an alpha beside each picture, and its index leads to every cluster', () => {
  const film = new WebM({ ...HEADER, fps: 25, count: 5, alpha: true });
  const pieces = [
    ...film.begin(),
    ...blocks.flatMap((block) => film.add(block, 1, Uint8Array.of(100 + block.ms / 40))),
    ...film.end(),
  ];
  const file = fileOf(pieces);
  const all = elements(file);
  const of = (/** @type {number} */ id) => all.filter((found) => found.id === id);
  assert.deepEqual(
    of(0xa5).map(({ bytes }) => bytes[0]),
    [100, 101, 102, 103, 104],
  );
  assert.deepEqual(
    of(0xa1).map(({ bytes }) => bytes[4]),
    [0, 1, 2, 3, 4],
  );
  // A picture that needs the one before it says so.
  assert.equal(of(0xfb).length, 3);
  assert.deepEqual(
    of(0x53c0).map(({ bytes }) => [...bytes]),
    [[1]],
  );
  const segment = of(0x18538067)[0].at + 12;
  const places = (/** @type {number} */ id) =>
    of(id).map(({ bytes }) => Number(Buffer.from(bytes).readBigUInt64BE()) + segment);
  assert.deepEqual(
    places(0xf1),
    of(0x1f43b675).map(({ at }) => at),
  );
  assert.deepEqual(
    places(0x53ac),
    [0x1549a966, 0x1654ae6b, 0x1c53bb6b].map((id) => of(id)[0].at),
  );
  assert.deepEqual(
    of(0xe7).map(({ bytes }) => Buffer.from(bytes).readUInt32BE()),
    [0, 120],
  );
  assert.equal(new DataView(of(0x4489)[0].bytes.slice().buffer).getFloat64(0), 200);
});

test('an MP4 tells the size and the place of each picture and of each piece of the sound', () => {
  const film = new Mp4({ ...HEADER, fps: 25, count: 2 });
  const sound = { codec: /** @type {const} */ ('aac'), description: Uint8Array.of(0x11, 0x90) };
  const file = Buffer.from(
    fileOf([
      ...film.begin(),
      ...film.add(Uint8Array.of(1, 1, 1), 0, true, 1000),
      ...film.add(Uint8Array.of(9, 9), 1, true, 1024),
      ...film.add(Uint8Array.of(2), 0, false, 1000),
      ...film.end(Uint8Array.of(1, 66, 0, 51), sound),
    ]),
  );
  /** @type {(from: number, to: number) => {name: string, at: number, end: number}[]} */
  const boxes = (from, to) => {
    const found = [];
    for (let at = from; at < to; ) {
      const [short, name] = [file.readUInt32BE(at), text(file.subarray(at + 4, at + 8))];
      const size = short === 1 ? Number(file.readBigUInt64BE(at + 8)) : short;
      assert.ok(size >= 8 && at + size <= to, name);
      found.push({ name, at: at + 8, end: at + size });
      if (['moov', 'trak', 'mdia', 'minf', 'stbl'].includes(name)) found.push(...boxes(at + 8, at + size));
      at += size;
    }
    return found;
  };
  const all = boxes(0, file.length);
  assert.deepEqual(
    all.filter(({ name }) => /ftyp|mdat|moov|trak/.test(name)).map(({ name }) => name),
    ['ftyp', 'mdat', 'moov', 'trak', 'trak'],
  );
  const tables = all.filter(({ name }) => name === 'co64');
  const sizes = all.filter(({ name }) => name === 'stsz');
  const samples = tables.map(({ at }, track) =>
    Array.from({ length: file.readUInt32BE(at + 4) }, (_, number) => {
      const place = Number(file.readBigUInt64BE(at + 8 + 8 * number));
      return [...file.subarray(place, place + file.readUInt32BE(sizes[track].at + 12 + 4 * number))];
    }),
  );
  assert.deepEqual(samples, [[[1, 1, 1], [2]], [[9, 9]]]);
  const keys = all.find(({ name }) => name === 'stss')?.at ?? 0;
  assert.deepEqual([file.readUInt32BE(keys + 4), file.readUInt32BE(keys + 8)], [1, 1]);
  const head = all.find(({ name }) => name === 'mdhd')?.at ?? 0;
  assert.deepEqual([file.readUInt32BE(head + 12), file.readUInt32BE(head + 16)], [25_000, 2000]);
});
