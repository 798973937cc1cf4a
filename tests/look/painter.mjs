/**
 * The painter: a native program that burns fires and draws them with a software renderer, whose pictures are the same
 * on every machine with the same version of it.
 */
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

/** The golden pictures. */
export const GOLDENS = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../goldens');

/** @typedef {{width: number, height: number, rgba: Uint8Array}} Pixels  Premultiplied sRGB. */
/**
 * What a test requests.
 * @typedef {object} PictureRequest
 * @property {string} lit  A preset to light.
 * @property {number} [burnt]  How long it has burnt [s].
 * @property {number} [particles]  Most particles that fill its domain.
 * @property {{[id: string]: string | number}} [values]  Other parameters.
 * @property {number} [width]
 * @property {number} [height]
 * @property {string} [format]  Format of the targets.
 * @property {string} [quality]  Which level.
 */

/** A fire that fills its height, of as many particles as on most machines. */
const STEADY = { burnt: 5, particles: 3000 };

/** An answer: JSON, and bytes. @typedef {{json: any, bytes: Buffer}} Answer */

export class Painter {
  /** @type {{resolve: (answer: Answer) => void, reject: (error: Error) => void}[]} */
  #waiting = [];
  /** @type {Buffer[]} */
  #chunks = [];
  #received = 0;
  #process;

  /**
   * Starts a painter.
   * @param {string[]} [without]  Extensions of OpenGL that its driver hides.
   */
  constructor(without = []) {
    const program = process.env.HEARTH_PAINTER;
    if (!program) throw new Error('HEARTH_PAINTER names no painter: `cargo xtask test goldens` makes one');
    const hidden = without.map((name) => `-GL_${name}`).join(' ');
    const env = { ...process.env, MESA_EXTENSION_OVERRIDE: hidden };
    this.#process = spawn(program, { env, stdio: ['pipe', 'pipe', 'inherit'] });
    this.#process.stdout.on('data', (chunk) => this.#receive(chunk));
    this.#process.on('error', (error) => this.#fail(error));
    this.#process.on('close', (code, signal) => this.#fail(new Error(`the painter ended: ${signal ?? code}`)));
    // Its end is the error that counts.
    this.#process.stdin.on('error', () => {});
  }

  /**
   * A fire that stands still.
   * @param {PictureRequest} request
   * @returns {Promise<Pixels>}
   */
  async still(request) {
    const { width = 320, height = 400 } = request;
    const { bytes } = await this.call('still', { ...STEADY, ...request, width, height });
    return { width, height, rgba: bytes };
  }

  /** The JSON that a call returns. @param {string} call @param {object} [request] @returns {Promise<any>} */
  async ask(call, request) {
    return (await this.call(call, request)).json;
  }

  /** Makes a call. Calls are answered in their order. @param {string} call @param {object} [request] */
  call(call, request = {}) {
    this.#process.stdin.write(`${JSON.stringify({ call, ...request })}\n`);
    return new Promise((/** @type {(answer: Answer) => void} */ resolve, reject) => {
      this.#waiting.push({ resolve, reject });
    });
  }

  async close() {
    if (this.#process.exitCode !== null || this.#process.signalCode !== null) return;
    this.#process.stdin.end();
    await once(this.#process, 'close');
  }

  /** @param {Buffer} chunk */
  #receive(chunk) {
    this.#chunks.push(chunk);
    this.#received += chunk.length;
    while (this.#received >= 8) {
      const head = this.#take(8, false);
      const [json, bytes] = [head.readUInt32LE(0), head.readUInt32LE(4)];
      if (this.#received < 8 + json + bytes) return;
      const answer = this.#take(8 + json + bytes, true);
      const waiting = this.#waiting.shift() ?? assert.fail('an answer without a call');
      const words = JSON.parse(answer.toString('utf8', 8, 8 + json));
      if (words?.error !== undefined) waiting.reject(new Error(words.error));
      else waiting.resolve({ json: words, bytes: answer.subarray(8 + json) });
    }
  }

  /** The first bytes that were received. @param {number} length @param {boolean} remove */
  #take(length, remove) {
    let first = this.#chunks[0];
    if (first.length < length) {
      first = Buffer.concat(this.#chunks);
      this.#chunks = [first];
    }
    if (remove) {
      this.#chunks[0] = first.subarray(length);
      if (first.length === length) this.#chunks.shift();
      this.#received -= length;
    }
    return first.subarray(0, length);
  }

  /** @param {Error} error */
  #fail(error) {
    for (const { reject } of this.#waiting.splice(0)) reject(error);
  }
}

/**
 * The names with one of these beginnings; all names without beginnings.
 * @param {string[]} names
 * @param {string[]} begins
 * @param {string} what the names are of
 * @throws {Error} no name has that beginning: a typing error must not look like success
 */
export function named(names, begins, what) {
  for (const begin of begins) {
    if (names.some((name) => name.startsWith(begin))) continue;
    throw new Error(`there is no ${what} "${begin}"; there are ${names.join(', ')}`);
  }
  return names.filter((name) => begins.length === 0 || begins.some((begin) => name.startsWith(begin)));
}
