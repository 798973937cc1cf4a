/**
 * Runs test files, `NAME.test.mjs`: those of some folders, or only those whose names begin with the words on the
 * command line. A word that is a folder's name stands for all of its files.
 */
import { readdirSync } from 'node:fs';
import path from 'node:path';
import { run } from 'node:test';
import { spec as Spec } from 'node:test/reporters';

/** The longest that a file may take [ms], several times what the longest takes. */
const FILE_TIMEOUT = 20 * 60_000;

/**
 * Runs the files.
 * @param {string[]} folders  Absolute paths.
 * @param {number} [concurrency]  Files that run at a time.
 */
export async function runTests(folders, concurrency = 2) {
  const words = process.argv.slice(2).filter((argument) => !argument.startsWith('-'));
  const chosen = (/** @type {string} */ file) =>
    words.some((word) => path.basename(file).startsWith(word) || path.basename(path.dirname(file)) === word);
  const files = folders
    .flatMap((folder) => readdirSync(folder).map((name) => path.join(folder, name)))
    .filter((file) => file.endsWith('.test.mjs') && (words.length === 0 || chosen(file)));
  // Without files, Node would run every test that it finds.
  if (files.length === 0) throw new Error(`no test file begins with ${words.join(' or ')}`);
  const events = run({ files, concurrency, timeout: FILE_TIMEOUT });
  events.on('test:fail', () => {
    process.exitCode = 1;
  });
  events.compose(new Spec()).pipe(process.stdout, { end: false });
  await new Promise((resolve) => {
    events.on('end', resolve);
  });
}
