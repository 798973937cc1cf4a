/**
 * The features of the platform that an element needs, and the message about the first that is missing.
 */

/** The smallest module that uses a SIMD instruction. */
const SIMD_MODULE = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
]);

/**
 * What an element needs of its platform besides WebGL2. Whatever else it uses has a replacement: it is absent from
 * some browsers since 2023, and from documents of other programs.
 */
export const NEEDED = [
  'AbortController',
  'AbortSignal.timeout',
  'Array.prototype.findLastIndex',
  'DOMMatrix',
  'Element.prototype.animate',
  'IntersectionObserver',
  'Object.hasOwn',
  'ResizeObserver',
  'URL',
  'WebAssembly.validate',
  'fetch',
  'navigator',
  'performance',
  'requestAnimationFrame',
];

/** The missing feature as a message; empty if only WebGL2 may be missing. */
export function missingFeature() {
  if (typeof WebAssembly !== 'object') {
    return 'This browser has no WebAssembly, or it is switched off.';
  }
  const missing = NEEDED.find(
    (path) => !path.split('.').reduce((/** @type {any} */ object, name) => object?.[name], globalThis),
  );
  if (missing) return `This browser has no ${missing}; every browser since 2023 has it.`;
  if (!WebAssembly.validate(SIMD_MODULE)) {
    return 'This browser has no WebAssembly SIMD; every browser since 2023 has it.';
  }
  return '';
}
