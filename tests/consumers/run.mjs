/**
 * Uses the npm package as other projects do: packed by npm, installed or copied, in a
 * browser and in Node. `node run.mjs`, or `node run.mjs vite react` for some files.
 */
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { runTests } from '../files.mjs';

await runTests([path.dirname(fileURLToPath(import.meta.url))], 1);
