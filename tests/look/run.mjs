/**
 * Runs the tests of the look one file after another. `node run.mjs`, or
 * `node run.mjs flashes format` for some files; `cargo xtask test goldens` runs all.
 */
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { runTests, testsIn } from '../files.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));
runTests(HERE, [{ names: testsIn(HERE).chosen, concurrency: 1 }]);
