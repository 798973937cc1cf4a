/**
 * What built files say about the machine that built them, and whether two folders hold the same.
 */
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { differences, digest, machinePaths } from '../../crates/xtask/packaging/bytes.mjs';

const SAME = fileURLToPath(new URL('../../crates/xtask/packaging/same.mjs', import.meta.url));
const scratch = await mkdtemp(path.join(os.tmpdir(), 'hearth-bytes-'));
after(() => rm(scratch, { recursive: true }));

/** A folder with these files. @param {string} name @param {Record<string, string>} files */
async function folder(name, files) {
  for (const [file, text] of Object.entries(files)) {
    const target = path.join(scratch, name, file);
    await mkdir(path.dirname(target), { recursive: true });
    await writeFile(target, text);
  }
  return path.join(scratch, name);
}

test('two folders differ by a byte, a file that is added and one that is missing', async () => {
  const ours = await folder('ours', { 'a.js': '1', 'b.js': '1', 'web/c.wasm': '1' });
  const same = await folder('same', { 'a.js': '1', 'b.js': '1', 'web/c.wasm': '1' });
  const other = await folder('other', { 'a.js': '1', 'web/c.wasm': '2', 'web/d.js': '1' });
  assert.deepEqual(await differences(ours, same), []);
  assert.deepEqual(await differences(ours, other), ['b.js is missing', 'web/c.wasm differs', 'web/d.js is added']);
  assert.equal(await digest(ours), await digest(same));
  assert.notEqual(await digest(ours), await digest(other));
});

test('two sites may differ in the white space of pages, and in nothing else', async () => {
  const ours = await folder('site', { 'index.html': 'a\n\nb\n', 'a.js': '1' });
  const blanks = await folder('blanks', { 'index.html': 'a b', 'a.js': '1' });
  const words = await folder('words', { 'index.html': 'a c', 'a.js': '1 ' });
  const compared = (/** @type {string} */ theirs) => spawnSync(process.execPath, [SAME, ours, theirs], { encoding: 'utf8' });
  assert.deepEqual([compared(blanks).status, compared(blanks).stderr], [0, '']);
  assert.deepEqual([compared(words).status, compared(words).stderr], [1, 'a.js differs\nindex.html differs\n']);
});

test('a file that names a folder of this machine is found in binary files too', async () => {
  const built = await folder('built', {
    'clean.js': 'const root = "/";',
    'deep/a.wasm': `\0\xff${path.join(os.homedir(), 'x.rs')}\0`,
  });
  assert.deepEqual(await machinePaths(built), [`deep/a.wasm contains ${os.homedir()}${path.sep}`]);
});
