/**
 * Runs the end-to-end tests in each browser of the run. `npm test` runs all, `npm test -- core` those of a folder, and
 * `npm test -- page viewport` some files.
 */
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { runTests } from '../files.mjs';
import { BROWSERS } from './driver.mjs';

/** @typedef {import('../files.mjs').Outcome & {browser: string}} Outcome */

const here = path.dirname(fileURLToPath(import.meta.url));

/** How each test ended in each browser. @returns {Promise<Outcome[]>} */
export async function runInBrowsers() {
  /** @type {Outcome[]} */
  const all = [];
  for (const browser of BROWSERS) {
    process.env.HEARTH_BROWSERS = browser;
    console.log(`In ${browser}:`);
    const outcomes = await runTests([path.join(here, 'core'), path.join(here, 'extended')]);
    all.push(...outcomes.map((outcome) => ({ ...outcome, browser })));
  }
  return all;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await runInBrowsers();
