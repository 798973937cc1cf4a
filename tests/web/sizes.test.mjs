/**
 * Download sizes are compared with the recorded ones, which documents name.
 */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { compared } from '../../crates/xtask/packaging/size-record.mjs';

const read = (/** @type {string} */ file) => readFileSync(new URL(`../../${file}`, import.meta.url), 'utf8');
/** @type {{[name: string]: number}} */
const recorded = JSON.parse(read('benches/sizes.json'));
const kilobytes = (/** @type {string} */ name) => `${Math.round(recorded[name] / 1000)} KB`;

test('the table of downloads in the README has the recorded sizes', () => {
  const [, table] = read('README.md').split(/\| download, compressed with brotli \|.*\n\|.*\n/);
  const rows = table
    .split('\n\n')[0]
    .split('\n')
    .map((row) =>
      row
        .split('|')
        .map((cell) => cell.trim())
        .slice(1, 3),
    );
  assert.ok(rows.length > 5);
  for (const [name, size] of rows) assert.equal(size, kilobytes(name), name);
});

test('the README of the package has the recorded sizes', () => {
  const text = read('crates/xtask/packaging/README.npm.md');
  const size = (/** @type {string} */ entry) => text.match(new RegExp(`\\| \`${entry}\` \\|.*\\| (\\d+ KB) \\|`))?.[1];
  assert.ok(text.includes(`${kilobytes('element and engine')} to download, engine included`));
  assert.equal(size('hearth-fire'), kilobytes('element and engine'));
  assert.equal(size('hearth-fire/react'), kilobytes('element and engine'));
  assert.equal(size('hearth-fire/panel'), kilobytes('panel, on request'));
  assert.equal(size('hearth-fire/sim'), kilobytes('headless library'));
});

test('a download fails that grows by more than 2 %, has no record or exceeds its ceiling', () => {
  const sizes = { kept: 1020, grown: 1021, fallen: 979, unknown: 1, large: 1001 };
  const recorded = { kept: 1000, grown: 1000, fallen: 1000, large: 1001 };
  assert.deepEqual(compared(sizes, recorded, { kept: undefined, large: 1000 }), {
    grown: [
      'grown: 1021 bytes, recorded 1000',
      'unknown: 1 bytes, recorded none',
      'large: 1001 bytes, at most 1000 are allowed',
    ],
    fallen: ['fallen: 979 bytes, recorded 1000'],
  });
});
