/**
 * Makes the release of the last commit in a temporary folder, with nothing compiled yet and with another path to cargo's
 * home, and compares it with that of this checkout: `node reproduce.mjs`. `cargo xtask reproduce` makes that first.
 */
import { execFileSync } from 'node:child_process';
import { mkdtemp, rm, symlink } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { differences } from './bytes.mjs';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));

// Not in the checkout: cargo would read the settings of both.
const scratch = await mkdtemp(path.join(os.tmpdir(), 'hearth-reproduce-'));
const copy = path.join(scratch, 'a-folder-of-another-name');
const cargo = path.join(scratch, 'cargo');
run(scratch, 'git', 'clone', '--quiet', ROOT, copy);
await symlink(process.env.CARGO_HOME ?? path.join(os.homedir(), '.cargo'), cargo, 'junction');
run(copy, 'cargo', 'xtask', 'publish');

const found = await differences(path.join(ROOT, 'dist/release'), path.join(copy, 'dist/release'));
if (found.length) throw new Error(`another folder gives other bytes, in ${copy}/dist/release:\n${found.join('\n')}`);
console.log('Another folder gives the same bytes: site, npm package, crates.');
await rm(scratch, { recursive: true, force: true });

/** @param {string} cwd @param {string} program @param {string[]} options */
function run(cwd, program, ...options) {
  const { CARGO_TARGET_DIR: _, ...env } = process.env;
  env.CARGO_HOME = cargo;
  execFileSync(program, options, {
    cwd,
    env,
    stdio: ['ignore', 'inherit', 'inherit'],
    shell: process.platform === 'win32',
  });
}
