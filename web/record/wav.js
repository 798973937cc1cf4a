/** The sound alone, as WAV: 16 bits, two channels. */

import { ascii, joined, little } from './bytes.js';

/** Samples in a second. */
export const RATE = 48_000;

/**
 * Collects the samples that the engine posts: those of the left channel, then as many of the right one.
 */
export class Samples {
  /** @type {Float32Array[]} */
  #parts = [];
  count = 0;

  /** @param {Float32Array} samples */
  add(samples) {
    this.#parts.push(samples);
    this.count += samples.length / 2;
  }

  /** The first of both channels. @param {number} count @returns {Float32Array[]} */
  channels(count) {
    const both = [new Float32Array(count), new Float32Array(count)];
    let at = 0;
    for (const part of this.#parts) {
      const half = part.length / 2;
      const taken = Math.min(half, count - at);
      for (const [side, channel] of both.entries()) channel.set(part.subarray(side * half, side * half + taken), at);
      at += taken;
    }
    return both;
  }
}

/** A file of samples. @param {Float32Array[]} channels */
export function wav([left, right]) {
  const data = new Int16Array(2 * left.length);
  const whole = (/** @type {number} */ sample) => Math.round(32_767 * Math.max(-1, Math.min(1, sample)));
  for (let at = 0; at < left.length; at += 1) {
    data[2 * at] = whole(left[at]);
    data[2 * at + 1] = whole(right[at]);
  }
  const bytes = new Uint8Array(data.buffer);
  const form = [
    ...little(1, 2),
    ...little(2, 2),
    ...little(RATE, 4),
    ...little(4 * RATE, 4),
    ...little(4, 2),
    ...little(16, 2),
  ];
  const head = [ascii('WAVEfmt '), little(16, 4), form, ascii('data'), little(bytes.length, 4)];
  return joined(ascii('RIFF'), little(36 + bytes.length, 4), ...head, bytes);
}
