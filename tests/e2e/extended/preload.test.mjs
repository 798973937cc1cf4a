/**
 * A page preloads exactly the modules that its script imports statically.
 */
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { test } from 'node:test';
import { SITE } from '../site.mjs';

const PRELOADS = /<link rel="modulepreload" href="([^"]+)">/g;
const ENTRIES = /<script type="module" src="([^"]+)">/g;
/** An import that is no call, and an export from another file. */
const IMPORTS = /\b(?:import|from)\s*["'](\.[^"']+)["']/g;

/** The files that one of the site names so. @type {(file: string, pattern: RegExp) => Promise<string[]>} */
async function named(file, pattern) {
  const text = await readFile(path.join(SITE, file), 'utf8');
  return [...text.matchAll(pattern)].map(([, name]) => path.posix.join(path.posix.dirname(file), name));
}

for (const page of ['index.html', 'web/embed.html']) {
  test(`${page} preloads the static imports of its script`, async () => {
    const entries = await named(page, ENTRIES);
    assert.equal(entries.length, 1);
    const wanted = new Set(entries);
    for (const file of wanted) for (const other of await named(file, IMPORTS)) wanted.add(other);
    const listed = await named(page, PRELOADS);
    assert.deepEqual(listed.sort(), [...wanted].filter((file) => !entries.includes(file)).sort());
  });
}
