/** A hundred lost contexts on each thread that can run the engine. */
import { BROWSERS, Browser } from '../../driver.mjs';
import { onPageThread } from '../../clock.mjs';
import { FIRE, outcome, retry, sleep } from './outcome.mjs';

/** @typedef {import('./outcome.mjs').Finding} Finding */

const LOSSES = 100;

/** @type {{[browser: string]: string[]}} */
const THREADS = { chromium: ['worker', 'main'], firefox: ['worker', 'main'], webkit: ['main'] };

/** @returns {AsyncGenerator<Finding>} */
export async function* losses() {
  for (const kind of BROWSERS) {
    for (const thread of THREADS[kind]) {
      const browser = await Browser.start({ kind });
      try {
        const tab = await browser.open(thread === 'main' ? onPageThread(FIRE) : FIRE);
        for (let loss = 1; loss <= LOSSES; loss += 1) {
          const fault = `${kind}, ${thread}, loss ${loss}`;
          await tab.burnt((await tab.fire((fire) => fire.stats?.time ?? 0)) + 0.05);
          const found = await tab.fire((fire) => fire.stats.engine);
          if (found !== thread) throw new Error(`the engine of ${kind} runs on the thread ${found}, not ${thread}`);
          // A loss strikes anywhere in a frame; every tenth one lasts longer than a picture is awaited.
          await sleep((loss * 7) % 40);
          await tab.loseContext(loss % 10 === 0 ? 7000 : (loss * 13) % 300);
          yield await outcome(tab, fault);
          await retry(tab);
        }
      } finally {
        await browser.close();
      }
    }
  }
}
