/**
 * Films that the browser encodes as a stream: VP9 in WebM, H.264 in MP4 (WebCodecs).
 *
 * @typedef {import('./bytes.js').Piece} Piece
 * @typedef {import('./options.js').Film} Film
 * @typedef {import('./webm.js').Block} Block
 */

import { bleed, stacked } from './alpha.js';
import { Mp4, RATE } from './mp4.js';
import { WebM } from './webm.js';

/** Codecs in the order of choice: H.264 of level 5.1, baseline, main and high; VP9 of level 5.1. */
const CODECS = { mp4: ['avc1.420033', 'avc1.4d0033', 'avc1.640033'], webm: ['vp09.00.51.08'] };
const SOUNDS = /** @type {const} */ ({ mp4: ['mp4a.40.2', 'opus'], webm: ['opus'] });

/** Quantizers of VP9, from 0 to 63, of the colours and of the alpha; where a browser sets none, and of H.264, bits of a pixel. */
const QUANTIZERS = [28, 0];
const BITS = 0.4;
/** Bits of a second of sound. */
const SOUND_BITS = 160_000;
/** Seconds between two pictures with which a player can begin. */
const KEY_SECONDS = 2;
/** Pictures that wait in an encoder. */
const MAX_QUEUE = 4;
/** Samples that an encoder gets at once. */
const SAMPLES = 4800;

/**
 * What the browser encodes pictures as.
 * @type {(film: Film) => Promise<VideoEncoderConfig>}
 * @throws {Error} it encodes none as that
 */
async function configOf({ format, width, height, fps }) {
  const bitrate = Math.max(200_000, Math.round(width * height * fps * BITS));
  for (const codec of CODECS[/** @type {'mp4' | 'webm'} */ (format)]) {
    /** @type {VideoEncoderConfig} */
    const config = {
      codec,
      width,
      height,
      framerate: fps,
      bitrate,
      ...(format === 'mp4' && { avc: { format: 'avc' } }),
    };
    /** @type {VideoEncoderConfig[]} */
    const configs = format === 'webm' ? [{ ...config, bitrateMode: 'quantizer' }, config] : [config];
    for (const wanted of configs) {
      const { supported } = (await globalThis.VideoEncoder?.isConfigSupported(wanted).catch(() => undefined)) ?? {};
      if (supported) return wanted;
    }
  }
  const [name, other] = format === 'mp4' ? ['H.264', 'webm'] : ['VP9', 'mp4'];
  throw new Error(`this browser cannot encode ${name} of ${width} × ${height} pixels: try format "${other}" or "webp"`);
}

/** What the browser encodes the sound as. @param {Film} film @returns {Promise<AudioEncoderConfig>} */
async function soundConfigOf({ format }) {
  for (const codec of SOUNDS[/** @type {'mp4' | 'webm'} */ (format)]) {
    const config = { codec, sampleRate: RATE, numberOfChannels: 2, bitrate: SOUND_BITS };
    const { supported } = (await globalThis.AudioEncoder?.isConfigSupported(config).catch(() => undefined)) ?? {};
    if (supported) return config;
  }
  throw new Error(`this browser cannot encode the sound of a film as ${format}: record it without sound, or as "wav"`);
}

/** A film of a stream of pictures and, at its end, of sound. */
export class Video {
  #film;
  #soundConfig;
  /** Of the colours, and of the alpha. @type {VideoEncoder[]} */
  #encoders;
  /** What both have encoded and is not in the file. @type {Block[][]} */
  #blocks = [[], []];
  /** What a decoder of H.264 needs first. */
  #description = new Uint8Array(0);
  /** @type {WebM | Mp4 | undefined} */
  #file;
  /** @type {Error | undefined} */
  #failed;

  /** @param {Film} film */
  static async open(film) {
    const shown = film.stackedAlpha ? { ...film, height: 2 * film.height, alpha: false } : film;
    return new Video(shown, await configOf(shown), film.sound ? await soundConfigOf(film) : undefined);
  }

  /**
   * @param {Film} film
   * @param {VideoEncoderConfig} config
   * @param {AudioEncoderConfig} [sound]
   */
  constructor(film, config, sound) {
    this.#film = film;
    this.#soundConfig = sound;
    this.#encoders = this.#blocks.slice(0, film.alpha ? 2 : 1).map((blocks) => {
      const encoder = new VideoEncoder({
        output: (chunk, about) => {
          this.#description = described(about?.decoderConfig) ?? this.#description;
          blocks.push({ bytes: bytesOf(chunk), isKey: chunk.type === 'key', ms: Math.round(chunk.timestamp / 1000) });
        },
        error: (error) => (this.#failed = error),
      });
      encoder.configure(config);
      return encoder;
    });
  }

  /**
   * Takes a picture.
   * @type {(canvas: OffscreenCanvas, pixels: () => Uint8ClampedArray, number: number) => Promise<Piece[]>}
   */
  async add(canvas, pixels, number) {
    const { width, height, fps, alpha, stackedAlpha } = this.#film;
    const timestamp = Math.round((number * 1e6) / fps);
    const about = { timestamp, codedWidth: width, codedHeight: height };
    if (alpha) {
      const rgba = pixels();
      const planes = new Uint8Array((width * height * 3) / 2).fill(128);
      for (let pixel = 0; pixel < width * height; pixel += 1) planes[pixel] = rgba[4 * pixel + 3];
      this.#encode(1, new VideoFrame(planes, { format: 'I420', ...about }), number);
      bleed(rgba, width);
      this.#encode(0, new VideoFrame(rgba, { format: 'RGBX', ...about }), number);
    } else if (stackedAlpha) {
      this.#encode(0, new VideoFrame(stacked(pixels(), width), { format: 'RGBX', ...about }), number);
    } else {
      this.#encode(0, new VideoFrame(canvas, { timestamp, alpha: 'discard' }), number);
    }
    for (const encoder of this.#encoders) {
      while (encoder.encodeQueueSize > MAX_QUEUE && !this.#failed)
        await new Promise((resolve) => encoder.addEventListener('dequeue', resolve, { once: true }));
    }
    return this.#film.sound ? [] : this.#written();
  }

  /** @type {(which: 0 | 1, frame: VideoFrame, number: number) => void} */
  #encode(which, frame, number) {
    try {
      if (this.#failed) throw new Error(`the browser's encoder has failed: ${this.#failed.message}`);
      const keyFrame = number % Math.round(KEY_SECONDS * this.#film.fps) === 0;
      // A browser that sets no quantizer ignores it.
      const options = { keyFrame, vp9: { quantizer: QUANTIZERS[which] } };
      this.#encoders[which].encode(frame, options);
    } finally {
      frame.close();
    }
  }

  /**
   * Writes what is encoded, with the sound up to there.
   * @param {Block[]} sounds in the order of their times
   */
  #written(sounds = [], opus = /** @type {Uint8Array | undefined} */ (undefined)) {
    const film = this.#film;
    const pieces = [];
    if (!this.#file) {
      this.#file = film.format === 'mp4' ? new Mp4(film) : new WebM({ ...film, opus });
      pieces.push(...this.#file.begin());
    }
    const file = this.#file;
    const [colours, alphas] = this.#blocks;
    const sound = (/** @type {Block} */ block, length = 0) =>
      pieces.push(...(file instanceof WebM ? file.add(block, 2) : file.add(block.bytes, 1, true, length)));
    const lengthOf = (/** @type {number} */ at) =>
      Math.round((((sounds[at + 1]?.ms ?? sounds[at].ms + 20) - sounds[at].ms) * RATE) / 1000);
    let heard = 0;
    while (colours.length > 0 && (!film.alpha || alphas.length > 0)) {
      const block = /** @type {Block} */ (colours.shift());
      for (; heard < sounds.length && sounds[heard].ms <= block.ms; heard += 1) sound(sounds[heard], lengthOf(heard));
      if (file instanceof WebM) pieces.push(...file.add(block, 1, film.alpha ? alphas.shift()?.bytes : undefined));
      else pieces.push(...file.add(block.bytes, 0, block.isKey, 1000));
    }
    for (; heard < sounds.length; heard += 1) sound(sounds[heard], lengthOf(heard));
    return pieces;
  }

  /** @param {Float32Array[]} [samples] those of both channels @returns {Promise<Piece[]>} */
  async end(samples) {
    for (const encoder of this.#encoders) await encoder.flush();
    if (this.#failed) throw new Error(`the browser's encoder has failed: ${this.#failed.message}`);
    for (const encoder of this.#encoders) encoder.close();
    const sound = samples && this.#soundConfig && (await encodedSound(samples, this.#soundConfig));
    const pieces = this.#written(sound?.blocks, sound?.description);
    const codec = this.#soundConfig?.codec === 'opus' ? 'opus' : 'aac';
    if (this.#file instanceof Mp4)
      pieces.push(...this.#file.end(this.#description, sound && { codec, description: sound.description }));
    else pieces.push(...(this.#file?.end() ?? []));
    return pieces;
  }
}

/** @type {(samples: Float32Array[], config: AudioEncoderConfig) => Promise<{blocks: Block[], description: Uint8Array}>} */
async function encodedSound(samples, config) {
  /** @type {Block[]} */
  const blocks = [];
  let description = new Uint8Array(0);
  /** @type {Error | undefined} */
  let failed;
  const encoder = new AudioEncoder({
    output: (chunk, about) => {
      description = described(about?.decoderConfig) ?? description;
      blocks.push({ bytes: bytesOf(chunk), isKey: true, ms: Math.max(0, chunk.timestamp / 1000) });
    },
    error: (error) => (failed = error),
  });
  encoder.configure(config);
  for (let at = 0; at < samples[0].length; at += SAMPLES) {
    const [left, right] = samples.map((channel) => channel.subarray(at, at + SAMPLES));
    const data = new Float32Array(2 * left.length);
    data.set(left);
    data.set(right, left.length);
    const timestamp = Math.round((at * 1e6) / RATE);
    const about = { format: /** @type {const} */ ('f32-planar'), sampleRate: RATE, numberOfChannels: 2, timestamp };
    encoder.encode(new AudioData({ ...about, numberOfFrames: left.length, data }));
  }
  await encoder.flush();
  if (failed) throw new Error(`the browser's encoder of sound has failed: ${failed.message}`);
  encoder.close();
  return { blocks, description };
}

/** @param {EncodedVideoChunk | EncodedAudioChunk} chunk */
function bytesOf(chunk) {
  const bytes = new Uint8Array(chunk.byteLength);
  chunk.copyTo(bytes);
  return bytes;
}

/** @param {{description?: AllowSharedBufferSource} | undefined} config */
function described(config) {
  const given = config?.description;
  if (!given) return undefined;
  return ArrayBuffer.isView(given)
    ? new Uint8Array(given.buffer, given.byteOffset, given.byteLength).slice()
    : new Uint8Array(given).slice();
}
