/** The engine's wasm with a limit of its memory. */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { SITE } from '../../site.mjs';

/** The section of a module that states its memory. */
const MEMORY = 5;

/** A number as LEB128. @param {number} number @returns {number[]} */
const leb = (number) => (number < 128 ? [number] : [(number & 127) | 128, ...leb(number >>> 7)]);

/** The number at a place, and the place after it. @type {(bytes: Uint8Array, at: number) => [number, number]} */
function read(bytes, at) {
  let [number, shift] = [0, 0];
  for (; ; at += 1, shift += 7) {
    number |= (bytes[at] & 127) << shift;
    if (bytes[at] < 128) return [number, at + 1];
  }
}

/** The pages that the engine begins with, and its module with so many at most. */
export function limited() {
  const bytes = readFileSync(path.join(SITE, 'web/wasm/hearth-engine_bg.wasm'));
  for (let at = 8; at < bytes.length; ) {
    const [size, start] = read(bytes, at + 1);
    if (bytes[at] === MEMORY) {
      const [least] = read(bytes, start + 2);
      const module = (/** @type {number} */ most) => {
        const content = [1, 1, ...leb(least), ...leb(most)];
        const section = [MEMORY, ...leb(content.length), ...content];
        return Buffer.concat([bytes.subarray(0, at), Uint8Array.from(section), bytes.subarray(start + size)]);
      };
      return { least, module };
    }
    at = start + size;
  }
  throw new Error('the module has no memory');
}
