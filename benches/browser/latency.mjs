/**
 * Measures the latency of tools: the time from an interaction to the next paint while 10,000 particles burn, the
 * time from the end of a brush stroke until its solid is in the fire and until the page gets the event, the time
 * from a move of a slider of the panel to the end of the engine's next frame with its value, and the time of a drag's
 * value without any frame, from the call to its answer and events, with and without 40 masks of lines of letters.
 *
 * `node benches/browser/latency.mjs` measures the built site.
 */
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { onPageThread } from '../../tests/e2e/clock.mjs';
import { Browser } from '../../tests/e2e/driver.mjs';
import { Panel, along } from '../../tests/e2e/panel.mjs';
import { openTools } from '../../tests/e2e/tools.mjs';

/** The window. */
const SIZE = { width: 1280, height: 800, pixels: Infinity };

/** A fire of about 10,000 particles. */
const MANY = 'scene=default&spacing=0.0115&max_particles=10000';

/** Interactions, strokes and moves of a slider, the time for the fire to burn up, and the time between two of them [ms]. */
const INTERACTIONS = 60;
const STROKES = 30;
const MOVES = 30;
const BURN_UP = 6000;
const PAUSE = 400;

/** Letters, of each of which a line is a mask, and values of a drag with them. */
const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmn';
const VALUES = 400;

/** Tools that are chosen in turn. */
const TOOLS = ['box', 'circle', 'line', 'brush', 'source', 'select', 'erase', 'ignite'];

/** Pauses differ, so that interactions occur in every phase of a frame. @param {number} turn */
const pause = (turn) => sleep(PAUSE + 37 * (turn % 5));

/** Runs in the page: keeps the longest event of each interaction (Event Timing). */
function watchInteractions() {
  /** @type {Map<number, number>} */
  const longest = new Map();
  Object.assign(window, { longest });
  new PerformanceObserver((list) => {
    for (const entry of /** @type {PerformanceEventTiming[]} */ (list.getEntries())) {
      const { interactionId: id } = /** @type {any} */ (entry);
      if (id) longest.set(id, Math.max(longest.get(id) ?? 0, entry.duration));
    }
  }).observe(/** @type {any} */ ({ type: 'event', durationThreshold: 16 }));
}

/** Runs in the page: notes when the pointer is released, and when the page gets the event of another solid. */
function watchPage() {
  /** @type {[number[], number[]]} */
  const [released, reported] = [[], []];
  Object.assign(window, { released, reported });
  addEventListener('pointerup', ({ timeStamp }) => released.push(performance.timeOrigin + timeStamp), true);
  document.querySelector('hearth-fire')?.addEventListener('objects-change', () => {
    reported.push(performance.timeOrigin + performance.now());
  });
}

/** Runs in the engine's worker: notes when a solid is in the fire. The engine's own listener comes first. */
function watchEngine() {
  /** @type {number[]} */
  const added = [];
  Object.assign(self, { added });
  addEventListener('message', ({ data }) => {
    if (Array.isArray(data) && JSON.stringify(data).includes('"stroke"'))
      added.push(performance.timeOrigin + performance.now());
  });
}

/** Runs in the page: notes when the pointer moves. */
function watchMoves() {
  /** @type {number[]} */
  const moved = [];
  Object.assign(window, { moved });
  addEventListener('pointermove', ({ timeStamp }) => moved.push(performance.timeOrigin + timeStamp), true);
}

/** Runs in the engine's worker: notes the end of the first frame after each value of `fuel_power`. */
function watchFrames() {
  const scope = /** @type {any} */ (self);
  /** @type {number[]} */
  const framed = [];
  Object.assign(scope, { framed });
  let waiting = 0;
  addEventListener('message', ({ data }) => {
    if (Array.isArray(data) && JSON.stringify(data).includes('"fuel_power"')) waiting += 1;
  });
  const next = scope.requestAnimationFrame;
  scope.requestAnimationFrame = (/** @type {FrameRequestCallback} */ act) =>
    next((/** @type {number} */ time) => {
      const due = waiting;
      act(time);
      for (let value = 0; value < due; value += 1) framed.push(performance.timeOrigin + performance.now());
      waiting -= due;
    });
}

/** Median, 98th percentile and maximum. @param {number[]} times */
function summary(times) {
  const sorted = times.toSorted((a, b) => a - b);
  const [median, p98, most] = [0.5, 0.98, 1].map(
    (share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))],
  );
  const mean = sorted.reduce((sum, time) => sum + time, 0) / sorted.length;
  return { count: sorted.length, median, mean, p98, most };
}

/**
 * Chooses tools in turn while 10,000 particles burn.
 * @param {Browser} browser
 */
export async function interactions(browser) {
  const tab = await openTools(browser, SIZE, MANY);
  await sleep(BURN_UP);
  await tab.evaluate(watchInteractions);
  for (let turn = 0; turn < INTERACTIONS; turn += 1) {
    await tab.page.click(`[data-tool="${TOOLS[turn % TOOLS.length]}"]`);
    await pause(turn);
  }
  const times = await tab.evaluate(() => [.../** @type {any} */ (window).longest.values()]);
  // An interaction below the threshold has no entry.
  const short = Array.from({ length: Math.max(0, INTERACTIONS - times.length) }, () => 16);
  const { particles } = await tab.fire((fire) => fire.stats);
  return { ...summary([...times, ...short]), particles };
}

/**
 * Draws strokes into the usual fire: the times until each is in the fire, and until the page gets the event.
 * @param {Browser} browser
 */
export async function strokes(browser) {
  const tab = await openTools(browser, SIZE, 'scene=default');
  const [worker] = tab.page.workers();
  if (!worker) throw new Error('the engine is in no worker');
  await tab.page.click('[data-tool="brush"]');
  await sleep(BURN_UP);
  await worker.evaluate(watchEngine);
  await tab.evaluate(watchPage);
  for (let turn = 0; turn < STROKES; turn += 1) {
    const [x, y] = [380 + 14 * turn, 150 + 11 * (turn % 7)];
    await tab.page.mouse.move(x, y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(x + 40, y + 8, { steps: 6 });
    await tab.page.mouse.up();
    await pause(turn);
  }
  const added = await worker.evaluate(() => /** @type {any} */ (self).added);
  const { released, reported } = await tab.evaluate(() => {
    const { released, reported } = /** @type {any} */ (window);
    return { released, reported };
  });
  if (added.length !== STROKES || reported.length !== STROKES)
    throw new Error(`${added.length} solids of ${STROKES} strokes`);
  const since = (/** @type {number[]} */ times) => summary(times.map((time, turn) => time - released[turn]));
  return { inFire: since(added), onPage: since(reported) };
}

/**
 * Drags a slider of the panel of the usual fire: the times until a frame of the engine with each value ends.
 * @param {Browser} browser
 */
export async function slides(browser) {
  const tab = await browser.open('index.html?scene=default', SIZE);
  await tab.ready();
  const panel = await new Panel(tab).mounted();
  const slider = await panel.reveal('fuel_power');
  const [worker] = tab.page.workers();
  if (!worker) throw new Error('the engine is in no worker');
  await tab.move(along(slider, 0.2));
  await tab.page.mouse.down();
  await tab.move(along(slider, 0.22));
  await sleep(BURN_UP);
  await worker.evaluate(watchFrames);
  await tab.evaluate(watchMoves);
  for (let turn = 0; turn < MOVES; turn += 1) {
    await tab.move(along(slider, 0.25 + 0.02 * turn));
    await pause(turn);
  }
  await tab.page.mouse.up();
  const framed = await worker.evaluate(() => /** @type {any} */ (self).framed.slice());
  const moved = await tab.evaluate(() => /** @type {any} */ (window).moved.slice());
  if (framed.length < MOVES || moved.length < MOVES)
    throw new Error(`${framed.length} values of ${moved.length} moves`);
  return summary(framed.slice(0, MOVES).map((time, turn) => time - moved[turn]));
}

/**
 * Sets values as a drag does, of a fire out of sight whose engine runs on the page's thread: the time of each, of which
 * nothing waits for another task, with these letters as solids.
 * @param {Browser} browser
 * @param {string} letters
 */
export async function values(browser, letters) {
  const tab = await browser.open(onPageThread('<hearth-fire paused></hearth-fire>'));
  await tab.ready();
  const times = await tab.fire(
    async (fire, { letters, count }) => {
      const { maskOfText } = await import(new URL('/web/mask.js', location.origin).href);
      for (const [at, letter] of [...letters].entries()) {
        const place = { x: 0.1 * (at % 10) - 0.45, y: 0.4 + 0.15 * Math.floor(at / 10) };
        await fire.addObject({ kind: 'solid', ...maskOfText(letter.repeat(24), '700 1em serif', 0.08), ...place });
      }
      await fire.step(1);
      fire.style.display = 'none';
      const times = [];
      for (let turn = 0; turn < count; turn += 1) {
        const start = performance.now();
        await fire.history.step(() => fire.set('fuel_power', 100 + turn / 10), 'drag');
        times.push(performance.now() - start);
      }
      return times;
    },
    { letters, count: VALUES },
  );
  return summary(times);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const browser = await Browser.launch();
  const text = (/** @type {ReturnType<typeof summary>} */ { median, p98, most }) =>
    `median ${median.toFixed(0)} ms, 98th percentile ${p98.toFixed(0)} ms, at most ${most.toFixed(0)} ms`;
  try {
    const of = await interactions(browser);
    console.log(`interaction to next paint beside ${of.particles} particles (${of.count}): ${text(of)}`);
    const { inFire, onPage } = await strokes(browser);
    console.log(`release of the brush to its solid in the fire (${inFire.count}): ${text(inFire)}`);
    console.log(`release of the brush to the event on the page (${onPage.count}): ${text(onPage)}`);
    const slid = await slides(browser);
    console.log(`move of a slider to the end of a frame with its value (${slid.count}): ${text(slid)}`);
    for (const letters of ['', LETTERS, '', LETTERS]) {
      const { count, median, p98 } = await values(browser, letters);
      const times = `median ${median.toFixed(2)} ms, 98th percentile ${p98.toFixed(2)} ms`;
      console.log(`value of a drag beside ${letters.length} masks (${count}): ${times}`);
    }
  } finally {
    await browser.close();
  }
}
