/**
 * Time limits: a server may accept a request and never answer, and a worker may end without an event.
 */

/** The maximum time until a saved fire arrives [ms]. A fire without it burns for some seconds first. */
export const PREWARMED_MS = 5000;

/** The maximum time until code arrives [ms]. */
const CODE_MS = 30_000;

/** Time between two counts [ms]. */
const COUNT_MS = 1000;

/**
 * Calls `act` when a number of seconds have counted. Time counts while the page is visible and its
 * timers run: not in a hidden tab, in a suspended computer, at a breakpoint, or while the main thread is
 * busy.
 * @param {number} seconds
 * @param {() => void} act
 * @returns {() => void} cancels it
 */
export function countdown(seconds, act) {
  let last = performance.now();
  const timer = setInterval(() => {
    const passed = performance.now() - last;
    last += passed;
    if (document.hidden || passed > 2 * COUNT_MS) return;
    seconds -= 1;
    if (seconds > 0) return;
    cancel();
    act();
  }, COUNT_MS);
  const cancel = () => clearInterval(timer);
  return cancel;
}

/**
 * The same promise, which rejects if code does not arrive.
 * @template T
 * @param {Promise<T>} code
 * @returns {Promise<T>}
 */
export function timely(code) {
  /** @type {ReturnType<typeof setTimeout>} */
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`no answer within ${CODE_MS / 1000} s`)), CODE_MS);
  });
  return Promise.race([code, late]).finally(() => clearTimeout(timer));
}
