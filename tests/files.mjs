/**
 * Runs files of tests: `NAME.test.mjs`, all of a folder's or those that begin as the
 * command line says.
 */
import { readdirSync } from 'node:fs';
import path from 'node:path';
import { Readable } from 'node:stream';
import { run } from 'node:test';
import { spec as Spec } from 'node:test/reporters';

/** The longest that a file may take [ms]: several times what the longest takes. */
const FILE_TIMEOUT = 20 * 60_000;

/** Names of all test files of a folder, and of those that are asked for. */
export function testsIn(folder) {
  const wanted = process.argv.slice(2).filter((argument) => !argument.startsWith('-'));
  const all = readdirSync(folder)
    .filter((file) => file.endsWith('.test.mjs'))
    .map((file) => path.basename(file, '.test.mjs'));
  const chosen = all.filter((name) => wanted.length === 0 || wanted.some((start) => name.startsWith(start)));
  if (chosen.length === 0) throw new Error(`no test file begins with ${wanted.join(' or ')}`);
  return { all, chosen };
}

/**
 * Runs them in turns, each with its names and how many files at a time.
 *
 * @param {string} folder
 * @param {{ names: string[], concurrency: number }[]} turns
 */
export function runTests(folder, turns) {
  Readable.from(events(folder, turns)).compose(new Spec()).pipe(process.stdout);
}

/** What all turns tell, in order. */
async function* events(folder, turns) {
  for (const { names, concurrency } of turns) {
    const files = names.map((name) => path.join(folder, `${name}.test.mjs`));
    // Without files, all that Node finds would be run.
    if (files.length === 0) continue;
    for await (const event of run({ files, concurrency, timeout: FILE_TIMEOUT })) {
      if (event.type === 'test:fail') process.exitCode = 1;
      yield event;
    }
  }
}
