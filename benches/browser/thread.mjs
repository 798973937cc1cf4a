/**
 * Measures what an engine takes of the page's own thread: the work of each frame, without the time inside of WebGL
 * calls, alone and beside a program that keeps a processor busy.
 *
 * `node benches/browser/thread.mjs` measures the built site; `node benches/browser/thread.mjs alone` leaves the busy
 * program out.
 */
import { spawn } from 'node:child_process';
import { setTimeout as sleep } from 'node:timers/promises';
import { Browser } from '../../tests/e2e/driver.mjs';
import { onPageThread } from '../../tests/e2e/clock.mjs';

/** Attributes of the fires. */
const FIRES = ['', 'model="classic"', 'preset="campfire"', 'particles="100000"'];

/** The longest frame of the target [ms]. */
const LONGEST = 50;

/** How long each fire burns up, and is measured [ms]. */
const BURN_UP = 3000;
const MEASURED = 20_000;

/** Runs in the page before its scripts: notes when each frame begins, and its work. */
function watchFrames() {
  const now = performance.now.bind(performance);
  let drawing = 0;
  /** @param {any} prototype @param {string} name */
  const watch = (prototype, name) => {
    const act = prototype[name];
    prototype[name] = function call(/** @type {unknown[]} */ ...args) {
      const start = now();
      const result = act.apply(this, args);
      drawing += now() - start;
      return result;
    };
  };
  const calls = Object.entries(Object.getOwnPropertyDescriptors(WebGL2RenderingContext.prototype));
  for (const [name, { value }] of calls) {
    if (typeof value === 'function' && name !== 'constructor') watch(WebGL2RenderingContext.prototype, name);
  }
  // They wait for what WebGL draws.
  watch(OffscreenCanvas.prototype, 'transferToImageBitmap');
  watch(ImageBitmapRenderingContext.prototype, 'transferFromImageBitmap');
  watch(CanvasRenderingContext2D.prototype, 'drawImage');
  /** @type {Map<number, number>} */
  const frames = new Map();
  Object.assign(window, { frames });
  const request = requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (act) =>
    request((time) => {
      const [start, drawn] = [now(), drawing];
      act(time);
      // Several callbacks of a frame are one task.
      frames.set(time, (frames.get(time) ?? 0) + now() - start - (drawing - drawn));
    });
}

/** The most work in any second that begins with a frame, as a share. @param {[number, number][]} frames */
function busiestSecond(frames) {
  const from = (/** @type {number} */ begin) => {
    const within = frames.filter(([at]) => at >= begin && at < begin + 1000);
    return within.reduce((sum, [, work]) => sum + work, 0);
  };
  return Math.max(...frames.map(([at]) => from(at))) / 1000;
}

/** @param {Browser} browser @param {string} attributes */
async function measure(browser, attributes) {
  const fire = `<hearth-fire ${attributes} style="display: block; width: 800px; height: 600px"></hearth-fire>`;
  const tab = await browser.open(onPageThread(fire), { width: 800, height: 600, before: watchFrames });
  await tab.ready();
  await sleep(BURN_UP);
  await tab.evaluate(() => /** @type {any} */ (window).frames.clear());
  await sleep(MEASURED);
  const { engine, particles } = await tab.fire((fire) => fire.stats);
  if (engine !== 'main') throw new Error(`the engine is in: ${engine}`);
  /** @type {[number, number][]} */
  const frames = await tab.evaluate(() => [.../** @type {any} */ (window).frames]);
  const long = frames.filter(([, work]) => work > LONGEST).length;
  const longest = Math.max(...frames.map(([, work]) => work));
  console.log(
    `${attributes || 'default'}: ${particles} particles, ${frames.length} frames, ${long} over ${LONGEST} ms, ` +
      `at most ${longest.toFixed(0)} ms, busiest second ${busiestSecond(frames).toFixed(2)}`,
  );
}

const browser = await Browser.launch();
try {
  for (const beside of process.argv.includes('alone') ? [false] : [false, true]) {
    console.log(beside ? 'beside a busy program' : 'alone');
    const busy = beside ? spawn(process.execPath, ['-e', 'for (;;);']) : undefined;
    try {
      for (const attributes of FIRES) await measure(browser, attributes);
    } finally {
      busy?.kill();
    }
  }
} finally {
  await browser.close();
}
