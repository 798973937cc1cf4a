/**
 * Runs the end-to-end tests. `npm test` runs all, `npm test -- core` those of a folder, and
 * `npm test -- page viewport` some files.
 */
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { runTests } from '../files.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));
await runTests([path.join(here, 'core'), path.join(here, 'extended')]);
