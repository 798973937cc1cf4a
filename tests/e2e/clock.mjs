/**
 * A clock that a test sets in place of the page's own, so that a law about time needs no
 * fast machine: each frame lasts a sixtieth of a second, however long it really takes.
 */

/**
 * The HTML of a page whose engine runs on the page's thread, which has that clock.
 * @param {string} body
 */
export const onPageThread = (body) => `${body}<script type="module">
  import { HearthFire } from '/web/hearth-fire.js';
  HearthFire.engine = 'main';
</script>`;

/**
 * Runs in the page before its scripts: frames follow each other without a pause, and the
 * time comes from their number. `window.clock.cost` is how much time passes whenever a
 * script reads the clock [ms]: work that reads it takes so long. `window.clock.work` is the time
 * that passed within frames. Without `window.clock.runs`, a frame waits for `window.clock.next()`.
 */
export function simulateClock() {
  const FRAME = 1000 / 60;
  let [now, last] = [0, 0];
  /** @type {Map<number, FrameRequestCallback>} */
  let waiting = new Map();
  const { port1, port2 } = new MessageChannel();
  const clock = { cost: 0, frames: 0, work: 0, runs: true, next: () => port2.postMessage(undefined) };
  /** @type {any} */ (window).clock = clock;
  performance.now = () => (now += clock.cost);
  port1.onmessage = () => {
    const due = waiting;
    waiting = new Map();
    if (due.size === 0) return;
    clock.frames += 1;
    now = (Math.floor(now / FRAME + 1e-6) + 1) * FRAME;
    const start = now;
    for (const act of due.values()) act(now);
    clock.work += now - start;
  };
  window.requestAnimationFrame = (act) => {
    last += 1;
    waiting.set(last, act);
    if (waiting.size === 1 && clock.runs) clock.next();
    return last;
  };
  window.cancelAnimationFrame = (request) => void waiting.delete(request);
}
