/**
 * Runs test files, `NAME.test.mjs`: all files of a folder, or those whose names begin with
 * the words on the command line.
 *
 * Files that fail run once more, alone: a failure by chance is named and does not fail the run.
 *
 * Where `HEARTH_PASSED` names a store, files that passed before and whose inputs are the same
 * are left out.
 */
import { readdirSync } from 'node:fs';
import path from 'node:path';
import { run } from 'node:test';
import { spec as Spec } from 'node:test/reporters';
import { digests, readPassed, writePassed } from './passed.mjs';

/** The longest that a file may take [ms], several times what the longest takes. */
const FILE_TIMEOUT = 20 * 60_000;

/**
 * Runs the files of a folder, so many at a time.
 * @param {string} folder
 * @param {number} concurrency
 */
export async function runTests(folder, concurrency) {
  const prefixes = process.argv.slice(2).filter((argument) => !argument.startsWith('-'));
  const names = readdirSync(folder)
    .filter((file) => file.endsWith('.test.mjs'))
    .filter((file) => prefixes.length === 0 || prefixes.some((prefix) => file.startsWith(prefix)));
  // Without files, Node would run every test that it finds.
  if (names.length === 0) throw new Error(`no test file begins with ${prefixes.join(' or ')}`);
  const files = names.map((name) => path.join(folder, name));
  const store = process.env.HEARTH_PASSED;
  const passed = store ? readPassed(store) : {};
  const now = store ? digests(files) : {};
  const due = files.filter((file) => now[file] === undefined || passed[file] !== now[file]);
  if (due.length < files.length) {
    console.log(`${files.length - due.length} of ${files.length} test files passed before, unchanged`);
  }
  if (due.length === 0) return;
  const first = await runOnce(due, concurrency);
  const again = [...first.failed];
  if (again.length > 0 && !first.elsewhere) {
    console.log(`\n${again.length} of ${due.length} test files failed and run once more, alone\n`);
    const second = await runOnce(again, 1);
    const tests = first.tests.map((name) => `\n  ${name}`).join('');
    if (second.failed.size > 0 || second.elsewhere) process.exitCode = 1;
    else console.log(`\nUNSTABLE: failed at first, passed when run once more:${tests}\n`);
  } else if (first.failed.size > 0 || first.elsewhere) {
    process.exitCode = 1;
  }
  if (!store) return;
  for (const file of due) delete passed[file];
  // A file that was edited during the run may have been read before or after.
  const after = digests(due);
  for (const file of first.clean) if (after[file] === now[file]) passed[file] = now[file];
  writePassed(store, passed);
}

/**
 * What a run found: the files that failed, the failed tests, whether something failed that belongs to no file,
 * and the files that passed and skipped nothing.
 * @typedef {{failed: Set<string>, tests: string[], elsewhere: boolean, clean: string[]}} Found
 */

/** @type {(files: string[], concurrency: number) => Promise<Found>} */
function runOnce(files, concurrency) {
  /** @type {Set<string>} */
  const failed = new Set();
  /** @type {string[]} */
  const tests = [];
  let elsewhere = false;
  const partly = new Set();
  const ran = new Set();
  const events = run({ files, concurrency, timeout: FILE_TIMEOUT });
  events.on('test:fail', ({ file, name }) => {
    if (file !== undefined && files.includes(file)) failed.add(file);
    else elsewhere = true;
    tests.push(`${path.basename(file ?? '')}: ${name}`);
  });
  events.on('test:pass', ({ file = '', skip, todo }) => {
    if (skip !== undefined || todo !== undefined) partly.add(file);
    else ran.add(file);
  });
  const done = new Promise((resolve) => {
    events.on('end', () => resolve(undefined));
  });
  events.compose(new Spec()).pipe(process.stdout, { end: false });
  return done.then(() => ({
    failed, tests, elsewhere, clean: elsewhere ? [] : files.filter((file) => ran.has(file) && !failed.has(file) && !partly.has(file)),
  }));
}
