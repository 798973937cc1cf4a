/**
 * Time limits for whatever a browser may never finish.
 *
 * Time counts while the page is visible and its timers run: not in a hidden tab, in a suspended
 * computer, at a breakpoint, or while the main thread is busy.
 */

/** Time between two counts [ms]. */
const COUNT_MS = 1000;

/**
 * Calls `act` when a number of seconds have counted.
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
