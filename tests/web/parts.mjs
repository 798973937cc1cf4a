/** Modules as the build divides them: a base, which has the hash of its build, and parts. */

import { VERSION } from '../../web/generated/version.js';

const text = (/** @type {string} */ letters) => [letters.length, ...Buffer.from(letters)];
const section = (/** @type {number} */ id, /** @type {number[]} */ bytes) => [id, bytes.length, ...bytes];
const HEAD = [0, 97, 115, 109, 1, 0, 0, 0];
/** A type without parameters, and the import of a function from this version. */
const IMPORT = [...section(1, [1, 0x60, 0, 0]), ...section(2, [1, ...text(VERSION), ...text('a'), 0, 0])];

/** A module from which parts were taken: it exports "0". @param {number} build */
export const base = (build) =>
  new Uint8Array([
    ...HEAD,
    ...IMPORT,
    ...section(7, [1, ...text('0'), 0, 0]),
    ...section(0, [...text('build'), build]),
  ]);

/** A part. @type {(name: string, build: number) => Uint8Array<ArrayBuffer>} */
export const part = (name, build) =>
  new Uint8Array([...HEAD, ...IMPORT, ...section(0, [...text(`part:${name}`), build])]);
