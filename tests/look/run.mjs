/**
 * Runs the tests of pictures two files at a time. `node run.mjs`, or `node run.mjs
 * flashes format` for some files; `cargo xtask test goldens` runs all.
 */
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { runTests } from '../files.mjs';

await runTests([path.dirname(fileURLToPath(import.meta.url))]);
