/**
 * Runs the tests two files at a time, and one after another those whose fires must
 * not slow each other down. `npm test`, or `npm test -- page mirror` for some files.
 */
import { readdirSync } from 'node:fs';
import path from 'node:path';
import { Readable } from 'node:stream';
import { run } from 'node:test';
import { spec as Spec } from 'node:test/reporters';
import { fileURLToPath } from 'node:url';

/** Files that want the machine for themselves, and why. @type {{[name: string]: string}} */
const ALONE = {
  manners: 'counts the pictures of two seconds, and stirs a fire that burns meanwhile',
  many: 'watches for how long thirty fires hold the page up',
  memory: 'counts the objects of so many frames',
  mirror: 'moves the focus out of the page and back, which comes late on a busy machine',
  model: 'holds the time that a fire tells against the clock',
  page: 'holds the speed of a fire against the clock',
  phone: 'draws nine times as many pixels as others',
  quality: 'watches a fire find out what fits its frames',
};

const HERE = path.dirname(fileURLToPath(import.meta.url));
const wanted = process.argv.slice(2).filter((argument) => !argument.startsWith('-'));
const names = readdirSync(HERE)
  .filter((file) => file.endsWith('.test.mjs'))
  .map((file) => path.basename(file, '.test.mjs'));
const chosen = names.filter((name) => wanted.length === 0 || wanted.some((start) => name.startsWith(start)));
if (chosen.length === 0) throw new Error(`no test file begins with ${wanted.join(' or ')}`);
const gone = Object.keys(ALONE).filter((name) => !names.includes(name));
if (gone.length > 0) throw new Error(`there is no test file ${gone.join(', ')}`);

Readable.from(events()).compose(new Spec()).pipe(process.stdout);

/** What both runs tell, in order. */
async function* events() {
  for (const [alone, concurrency] of /** @type {const} */ ([[false, 2], [true, 1]])) {
    const files = chosen.filter((name) => name in ALONE === alone).map((name) => path.join(HERE, `${name}.test.mjs`));
    // Without files, all that Node finds would be run.
    if (files.length === 0) continue;
    for await (const event of run({ files, concurrency })) {
      if (event.type === 'test:fail') process.exitCode = 1;
      yield event;
    }
  }
}
