/**
 * Runs the end-to-end tests in each browser of the run. `npm test` runs all, `npm test -- core` those of a folder, and
 * `npm test -- page viewport` some files.
 */
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { runTests } from '../files.mjs';
import { BROWSERS } from './driver.mjs';

/** @typedef {import('../files.mjs').Outcome} Outcome */
/** @typedef {import('./driver/programs.mjs').Kind} Kind */

const here = path.dirname(fileURLToPath(import.meta.url));

/**
 * Runs the files in one browser after another.
 * @param {(browser: Kind, outcomes: Outcome[]) => void} [done]  Is called after each browser.
 */
export async function runInBrowsers(done = () => {}) {
  for (const browser of BROWSERS) {
    process.env.HEARTH_BROWSERS = browser;
    console.log(`In ${browser}:`);
    done(browser, await runTests([path.join(here, 'core'), path.join(here, 'extended')]));
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await runInBrowsers();
