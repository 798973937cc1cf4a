/**
 * Runs the tests two files at a time. `npm test`, or `npm test -- page viewport` for some
 * files.
 */
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { runTests } from '../files.mjs';

await runTests(path.dirname(fileURLToPath(import.meta.url)), 2);
