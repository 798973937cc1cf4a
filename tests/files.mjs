/**
 * Runs test files, `NAME.test.mjs`: all files of a folder, or those whose names begin with
 * the words on the command line.
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
export function runTests(folder, concurrency) {
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
  const clean = new Set(due);
  const ran = new Set();
  const events = run({ files: due, concurrency, timeout: FILE_TIMEOUT });
  events.on('test:fail', ({ file = '' }) => {
    process.exitCode = 1;
    // Without its file, a failure counts for all.
    if (!clean.delete(file)) clean.clear();
  });
  events.on('test:pass', ({ file = '', skip, todo }) => {
    if (skip !== undefined || todo !== undefined) clean.delete(file);
    else ran.add(file);
  });
  events.on('end', () => {
    if (!store) return;
    for (const file of due) delete passed[file];
    // A file that was edited during the run may have been read before or after.
    const after = digests(due);
    for (const file of clean) if (ran.has(file) && after[file] === now[file]) passed[file] = now[file];
    writePassed(store, passed);
  });
  events.compose(new Spec()).pipe(process.stdout);
}
