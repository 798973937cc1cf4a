/**
 * Uses the npm package as people do: packed by npm, installed or copied, and in a
 * real browser. One file after another, as the tests end to end: `node run.mjs`, or
 * `node run.mjs vite react` for some files.
 */
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { runTests, testsIn } from '../files.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));
runTests(HERE, [{ names: testsIn(HERE).chosen, concurrency: 1 }]);
