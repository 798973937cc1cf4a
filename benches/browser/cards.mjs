/**
 * Measures whether many small fires run in real time on one page: the time of all their
 * steps in a frame, without drawing, which a machine without a GPU does on the CPU.
 *
 * `node benches/browser/cards.mjs` measures twelve cards of 240 × 300 in the built site
 * (`HEARTH_SITE`, or `dist/site`) with the browser `HEARTH_CHROMIUM`.
 */
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { Browser } from '../../tests/e2e/driver.mjs';

/** The cards, and the frame that they share [s]. */
const CARDS = 12;
const FRAME = 1 / 60;

/** Rounds, and the steps of each card in a round: some half a second of fire. */
const ROUNDS = 9;
const STEPS = 150;

const PAGE = `<!doctype html>
<meta charset="utf-8">
<link rel="icon" href="data:,">
<style>
  body { margin: 0; display: grid; grid-template-columns: repeat(6, 240px) }
  hearth-fire { width: 240px; height: 300px }
</style>
<script type="module" src="/web/hearth-fire.js"></script>
<body>${'<hearth-fire paused warm="2"></hearth-fire>'.repeat(CARDS)}</body>`;

/**
 * What the steps of all cards take of a frame of 60 Hz in which each burns as long as the
 * clock: `steps` [ms], the median of the rounds and the best; and how many particles a card has.
 * The fires are paused and make the steps of `step()`, of which only the last is drawn.
 * @param {Browser} browser
 */
export async function cards(browser) {
  const tab = await browser.open(PAGE, { width: 1440, height: 600 });
  await tab.evaluate(() =>
    Promise.all([...document.querySelectorAll('hearth-fire')].map((fire) => /** @type {any} */ (fire).ready)),
  );
  const rounds = [];
  for (let round = 0; round < ROUNDS; round += 1) rounds.push(await tab.evaluate(oneRound, STEPS));
  const sums = rounds.map(({ rate }) => rate * FRAME).sort((a, b) => a - b);
  const { particles, quality } = rounds[0];
  return { cards: CARDS, steps: { median: sums[sums.length >> 1], best: sums[0] }, particles, quality };
}

/** Lets each fire make so many steps, and sums up what they take [ms for a second of fire]. */
async function oneRound(steps) {
  let rate = 0;
  let last;
  for (const fire of /** @type {any[]} */ ([...document.querySelectorAll('hearth-fire')])) {
    const reported = new Promise((resolve) =>
      fire.addEventListener('stats', ({ detail }) => resolve(detail), { once: true }),
    );
    await fire.step(steps);
    last = await reported;
    rate += last.stepMs / last.stepLength;
  }
  return { rate, particles: last.particles, quality: last.quality };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const browser = await Browser.launch();
  try {
    const { steps, particles, quality } = await cards(browser);
    console.log(`${CARDS} cards of 240 × 300, ${particles} particles each (quality ${quality})`);
    console.log(`steps of a 60 Hz frame: ${steps.median.toFixed(1)} ms, at best ${steps.best.toFixed(1)} ms`);
  } finally {
    await browser.close();
  }
}
