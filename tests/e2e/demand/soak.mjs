/**
 * A page on which visitors do everything at random, some ten times as often as people: scenes, panel, tools, undo, children,
 * sound, films, lost contexts and a hidden tab. `cargo measure soak --page MINUTES` runs it. Six times it rests: memory of
 * heap and wasm has grown by a twentieth at most since the first rest, and nothing was reported but refusals and
 * lost contexts. The time of a frame is printed, for it depends on the machine.
 */
import { STAGE, installActors } from '../actors.mjs';
import { Browser } from '../driver.mjs';
import { held } from '../held.mjs';

/** Rests of a run, growth of memory, and the time between two actions [ms]. */
const [RESTS, GROWTH, BETWEEN_MS] = [6, 0.05, 100];

/** Pictures whose time is measured in a rest. */
const MEASURED = 120;

/** What visitors of this page cause: random values may be refused, and contexts are lost. */
const EXPECTED = /is refused|context (was|is) lost|CONTEXT_LOST|GPU stall|the fire was removed|AudioContext/;

/** Runs in the page before its scripts: the actors count frames of the real clock. */
function realClock() {
  /** @type {any} */ (window).clock = { next: () => undefined, cost: 0, runs: true };
}

/**
 * Runs in the page: acts for so long. Returns the number of actions.
 * @param {number} seed @param {number} milliseconds @param {number} between
 */
async function act(seed, milliseconds, between) {
  const { actions, fire, log, pick, random, sow } = /** @type {any} */ (window).actors;
  sow(seed);
  const extra = {
    sound: [() => (fire.sound = random(2) / 2)],
    films: [() => fire.record({ format: pick(['webp', 'gif', 'apng']), fps: 25, seconds: 0.1, width: 32, height: 32 })],
    playing: [() => fire.play(), () => fire.pause(), () => fire.stir(0, 0.4, 1, 0), () => fire.sparks(0, 0.3)],
  };
  // An engine that stops three times in a minute ends the fire: another file holds that.
  const { restart, ...others } = actions;
  const actors = Object.values({ ...others, ...extra });
  let done = 0;
  const wait = (/** @type {number} */ time) => new Promise((resolve) => setTimeout(resolve, time));
  for (const end = Date.now() + milliseconds; Date.now() < end; done += 1) {
    // What waits for an answer that a hidden page does not give does not hold the next action up.
    const acted = (async () => pick(pick(actors))())().catch(() => {});
    await Promise.race([acted, wait(20 * between)]);
    await wait(between);
    log.length = 0;
  }
  return done;
}

/** Runs in the page: the default fire again, without what the actors made; returns the mean time of a frame [ms]. */
async function rest(/** @type {number} */ measured) {
  const { fire, frames } = /** @type {any} */ (window).actors;
  fire.sound = 0;
  fire.replaceChildren();
  await fire.importConfig({ preset: 'default' });
  await fire.play();
  // A step that no move of the history leads to is forgotten.
  for (let step = 0; step < 210; step += 1) await fire.history.step(() => fire.set('wind', (step % 10) / 20));
  await fire.importConfig({ preset: 'default' });
  await frames(measured);
  const start = performance.now();
  await frames(measured);
  return (performance.now() - start) / measured;
}

const minutes = Number(process.argv[2]);
if (!(minutes > 0)) throw new Error(`the argument is a number of minutes, not "${process.argv[2]}"`);
const browser = await Browser.launch();
try {
  const tab = await browser.open(STAGE, { width: 680, height: 800, before: realClock });
  await tab.evaluate(installActors);
  const other = await browser.browser.newPage();
  await tab.page.bringToFront();
  const slice = (minutes * 60_000) / RESTS / 2;
  /** @type {any} */
  let first;
  const wrong = [];
  for (let round = 0; round <= RESTS; round += 1) {
    let actions = 0;
    for (const half of round === 0 ? [] : [0, 1]) {
      actions += await tab.evaluate(act, 2 * round + half, slice, BETWEEN_MS);
      if (half === 0) await tab.loseContext(300);
      await other.bringToFront();
      await new Promise((resolve) => setTimeout(resolve, 2000));
      await tab.page.bringToFront();
    }
    const frame = await tab.evaluate(rest, MEASURED);
    const { bytes, memory, objects } = await held(tab);
    // The objects of lost contexts are counted too, and so are printed alone.
    const now = { bytes, memory };
    console.log(
      `${actions} actions; heap ${bytes}, wasm ${memory} bytes, ${objects} objects; ${frame.toFixed(1)} ms a frame`,
    );
    // The first round loads code, and wasm grows to the largest scene.
    if (round === 1) first = now;
    const problems = tab.problems.splice(0).filter((problem) => !EXPECTED.test(problem));
    wrong.push(...problems);
    for (const [name, value] of Object.entries(first ?? {})) {
      const more = now[name] / value - 1;
      if (round === RESTS && more > GROWTH) wrong.push(`${name}: ${(100 * more).toFixed(1)} % more than ${value}`);
    }
  }
  if (wrong.length > 0) {
    console.log([...new Set(wrong)].join('\n'));
    process.exitCode = 1;
  }
} finally {
  await browser.close();
}
