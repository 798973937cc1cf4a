/** Time limits of what a page loads: a server may accept a request and never answer. */

/** The maximum time until code arrives [ms]. */
const CODE_MS = 30_000;

/**
 * The same promise, which rejects if code does not arrive.
 * @template T
 * @param {Promise<T>} code
 * @returns {Promise<T>}
 */
export function timely(code) {
  return Promise.race([code, new Promise((_, reject) => {
    setTimeout(() => reject(new Error(`no answer within ${CODE_MS / 1000} s`)), CODE_MS);
  })]);
}
