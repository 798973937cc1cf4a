/**
 * Runs the tests two files at a time, and one after another those whose fires must
 * not slow each other down. `npm test`, or `npm test -- page mirror` for some files.
 */
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { runTests, testsIn } from '../files.mjs';

/** Files that need the machine for themselves, and why. @type {{[name: string]: string}} */
const ALONE = {};

const HERE = path.dirname(fileURLToPath(import.meta.url));
const { all, chosen } = testsIn(HERE);
const gone = Object.keys(ALONE).filter((name) => !all.includes(name));
if (gone.length > 0) throw new Error(`there is no test file ${gone.join(', ')}`);
runTests(HERE, [
  { names: chosen.filter((name) => !(name in ALONE)), concurrency: 2 },
  { names: chosen.filter((name) => name in ALONE), concurrency: 1 },
]);
