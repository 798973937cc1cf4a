/**
 * A wasm module with limited memory, as on a small device.
 */

const MEMORY_SECTION = 5;
const PAGE = 65_536;

/**
 * The same module with a maximum size of its memory.
 * @param {Uint8Array} wasm
 * @param {number} most in bytes
 */
export function confined(wasm, most) {
  const parts = [wasm.subarray(0, 8)];
  for (let at = 8; at < wasm.length; ) {
    const [length, content] = read(wasm, at + 1);
    const end = content + length;
    if (wasm[at] === MEMORY_SECTION) {
      // One memory; its flags, 0 for one without a largest size; its least size in pages.
      const [least] = read(wasm, content + 2);
      const section = [1, 1, ...write(least), ...write(Math.floor(most / PAGE))];
      parts.push(Uint8Array.of(MEMORY_SECTION, ...write(section.length), ...section));
    } else {
      parts.push(wasm.subarray(at, end));
    }
    at = end;
  }
  return Buffer.concat(parts);
}

/**
 * A number in LEB128, and the index after it.
 * @param {Uint8Array} wasm @param {number} at
 */
function read(wasm, at) {
  let number = 0;
  for (let scale = 1; ; scale *= 128) {
    const byte = wasm[at];
    at += 1;
    number += (byte & 127) * scale;
    if (byte < 128) return [number, at];
  }
}

function write(/** @type {number} */ number) {
  const bytes = [];
  for (; number >= 128; number = Math.floor(number / 128)) bytes.push((number % 128) + 128);
  return [...bytes, number];
}
