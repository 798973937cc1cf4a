/**
 * Makes the package of the site a second time: `node again.mjs SITE PACKAGE SCRATCH`. Its files
 * and npm's archive of them have the same bytes, and the site names no folder of this machine.
 */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdir, readFile, rm } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { differences, machinePaths } from './bytes.mjs';

const [site, folder, scratch] = process.argv.slice(2).map((name) => path.resolve(name));
if (!scratch) throw new Error('usage: node again.mjs SITE PACKAGE SCRATCH');

assert.deepEqual(await machinePaths(site), []);
await rm(scratch, { recursive: true, force: true });
const again = path.join(scratch, 'package');
const { version } = JSON.parse(await readFile(path.join(folder, 'package.json'), 'utf8'));
const build = fileURLToPath(new URL('build.mjs', import.meta.url));
execFileSync(process.execPath, [build, path.join(site, 'web'), again, version]);
assert.deepEqual(await differences(folder, again), []);
assert.deepEqual(await differences(await archive(folder, 'first'), await archive(again, 'second')), []);
console.log('The package and its archive have the same bytes when they are made again.');

/** A folder with npm's archive of the package. @param {string} packed @param {string} name */
async function archive(packed, name) {
  const target = path.join(scratch, name);
  await mkdir(target);
  execFileSync('npm', ['pack', '--silent', '--pack-destination', target], { cwd: packed, shell: process.platform === 'win32' });
  return target;
}
