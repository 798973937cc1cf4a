/**
 * Pauses and slowness that are no fault: a breakpoint, a hidden tab, a suspended computer, a processor
 * that is twenty times slower. The same engine goes on, and no error is reported.
 */
import { readFileSync, readdirSync } from 'node:fs';
import { Browser } from '../../driver.mjs';
import { FIRE, outcome, sleep } from './outcome.mjs';

/** Longer than the time limits of an engine's answer and of a lost context [ms]. */
const PAUSE_MS = 25_000;

/** A slice of time of a slow processor, of which a twentieth is its own [ms]. */
const SLICE_MS = 200;

/** @typedef {{browser: Browser, tab: any}} Page */

/** @type {{[what: string]: (page: Page) => Promise<void>}} */
const PAUSES = {
  'a breakpoint': async ({ tab }) => {
    const session = await tab.page.createCDPSession();
    await session.send('Debugger.enable');
    const paused = new Promise((resolve) => session.once('Debugger.paused', resolve));
    await session.send('Debugger.pause');
    await paused;
    await sleep(PAUSE_MS);
    await session.send('Debugger.resume');
    await session.detach();
  },
  'a hidden tab': async ({ browser, tab }) => {
    const other = await browser.browser.newPage();
    await other.bringToFront();
    await tab.until('the page is hidden', () => document.hidden);
    await sleep(PAUSE_MS);
    await tab.page.bringToFront();
    await other.close();
  },
  'a suspended computer': async ({ browser }) => {
    signal(browser, 'SIGSTOP');
    await sleep(PAUSE_MS);
    signal(browser, 'SIGCONT');
  },
  'a processor that is twenty times slower': async ({ browser }) => {
    for (const end = Date.now() + 2 * PAUSE_MS; Date.now() < end; ) {
      signal(browser, 'SIGSTOP');
      await sleep((SLICE_MS * 19) / 20);
      signal(browser, 'SIGCONT');
      await sleep(SLICE_MS / 20);
    }
  },
};

/** Sends a signal to every process of a browser. @param {Browser} browser @param {NodeJS.Signals} name */
function signal(browser, name) {
  const family = new Set([browser.browser.process().pid]);
  const processes = readdirSync('/proc')
    .filter((entry) => /^\d+$/.test(entry))
    .map(Number)
    .sort((a, b) => a - b);
  for (const pid of processes) {
    try {
      // The fields of a process: its number, its name in parentheses, its state, its parent.
      const fields = readFileSync(`/proc/${pid}/stat`, 'utf8').split(') ').at(-1)?.split(' ') ?? [];
      if (family.has(Number(fields[1]))) family.add(pid);
    } catch {
      // It has ended.
    }
  }
  for (const pid of family) {
    try {
      process.kill(pid, name);
    } catch {
      // It has ended.
    }
  }
}

/** @returns {AsyncGenerator<import('./outcome.mjs').Finding>} */
export async function* patience() {
  for (const [fault, pause] of Object.entries(PAUSES)) {
    // The headless shell hides no tab.
    const browser = await Browser.start();
    try {
      const tab = await browser.open(`${FIRE}<script>
        window.reported = [];
        document.querySelector('hearth-fire').addEventListener('error', ({ detail }) => reported.push(detail.message));
      </script>`);
      await tab.burnt(0.3);
      await pause({ browser, tab });
      const finding = await outcome(tab, fault);
      const reported = await tab.evaluate(() => /** @type {any} */ (window).reported);
      yield reported.length === 0 ? finding : { fault, outcome: 'silent', detail: `reported: ${reported.join('; ')}` };
    } finally {
      await browser.close();
    }
  }
}
