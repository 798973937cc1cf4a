/**
 * Download sizes are compared with the recorded ones, which documents name.
 */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { compared, documented } from '../../crates/xtask/packaging/size-record.mjs';

const read = (/** @type {string} */ file) => readFileSync(new URL(`../../${file}`, import.meta.url), 'utf8');
/** @type {{[name: string]: number}} */
const recorded = JSON.parse(read('benches/sizes.json'));

for (const file of ['README.md', 'docs/package.md', 'crates/xtask/packaging/README.npm.md']) {
  test(`${file} has the recorded sizes`, () => assert.equal(documented(read(file), recorded), read(file)));
}

test('sizes are written into rows and the sentence that name them, and nowhere else', () => {
  const sizes = { 'element and engine': 1600, 'sound, on request': 600, 'headless library': 4000 };
  const before =
    '9 KB to download, engine included.\n| `hearth-fire` | it | 9 KB |\n| `hearth-fire/sim` | `hearth-fire` | 9 KB |\n' +
    '| `hearth-fire/share` | it | 9 KB |\n| sound, on request | 9 KB |\n';
  const after =
    '2 KB to download, engine included.\n| `hearth-fire` | it | 2 KB |\n| `hearth-fire/sim` | `hearth-fire` | 4 KB |\n' +
    '| `hearth-fire/share` | it | 9 KB |\n| sound, on request | 1 KB |\n';
  assert.equal(documented(before, sizes), after);
});

test('a download fails that grows by more than 2 % or has no record', () => {
  const sizes = { kept: 1020, grown: 1021, fallen: 979, unknown: 1 };
  const recorded = { kept: 1000, grown: 1000, fallen: 1000 };
  assert.deepEqual(compared(sizes, recorded), {
    grown: ['grown: 1021 bytes, recorded 1000', 'unknown: 1 bytes, recorded none'],
    fallen: ['fallen: 979 bytes, recorded 1000'],
  });
});
