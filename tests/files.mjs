/**
 * Runs test files, `NAME.test.mjs`: all files of a folder, or those whose names begin with
 * the words on the command line.
 */
import { readdirSync } from 'node:fs';
import path from 'node:path';
import { run } from 'node:test';
import { spec as Spec } from 'node:test/reporters';

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
  const events = run({ files, concurrency, timeout: FILE_TIMEOUT });
  events.on('test:fail', () => (process.exitCode = 1));
  events.compose(new Spec()).pipe(process.stdout);
}
