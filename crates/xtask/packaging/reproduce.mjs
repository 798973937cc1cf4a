/**
 * Builds the last commit in a temporary folder, with nothing compiled yet and with another path to
 * cargo's home, and compares the site, the npm package, its archive and the crates with those of
 * this checkout: `node reproduce.mjs`. `cargo xtask reproduce` builds this checkout first.
 */
import { execFileSync } from 'node:child_process';
import { cp, mkdir, mkdtemp, rm, symlink } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { differences } from './bytes.mjs';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
/** The crates that are published. */
const CRATES = ['hearth-fire-core', 'hearth-fire'];

const changed = run(ROOT, 'git', 'status', '--porcelain');
if (changed) throw new Error(`the checkout has changes, and reproduce builds the last commit:\n${changed}`);
// Not in the checkout: cargo would read the settings of both.
const scratch = await mkdtemp(path.join(os.tmpdir(), 'hearth-reproduce-'));
const copy = path.join(scratch, 'a-folder-of-another-name');
run(scratch, 'git', 'clone', '--quiet', ROOT, copy);
await symlink(process.env.CARGO_HOME ?? path.join(os.homedir(), '.cargo'), path.join(scratch, 'cargo'), 'junction');
run(copy, 'cargo', 'xtask', 'package');

const [here, there] = [path.join(scratch, 'here'), path.join(scratch, 'there')];
await release(ROOT, here);
await release(copy, there);
const found = await differences(here, there);
if (found.length)
  throw new Error(`another folder gives other bytes; both releases are in ${scratch}:\n${found.join('\n')}`);
console.log('Another folder gives the same bytes: site, npm package, archive, crates.');
await rm(scratch, { recursive: true, force: true });

/** Puts all that a checkout releases into a folder. @param {string} checkout @param {string} to */
async function release(checkout, to) {
  const archives = path.join(to, 'archives');
  await mkdir(archives, { recursive: true });
  for (const built of ['site', 'npm'])
    await cp(path.join(checkout, 'dist', built), path.join(to, built), { recursive: true });
  run(path.join(checkout, 'dist/npm'), 'npm', 'pack', '--silent', '--pack-destination', archives);
  const target = path.join(to, 'target');
  run(
    checkout,
    'cargo',
    'package',
    '--quiet',
    '--no-verify',
    '--target-dir',
    target,
    ...CRATES.flatMap((name) => ['--package', name]),
  );
  await cp(path.join(target, 'package'), archives, { recursive: true, filter: (file) => !file.includes('tmp-') });
  await rm(target, { recursive: true });
}

/** @param {string} cwd @param {string} program @param {string[]} options */
function run(cwd, program, ...options) {
  const { CARGO_TARGET_DIR: _, ...env } = process.env;
  if (!cwd.startsWith(ROOT)) env.CARGO_HOME = path.join(scratch, 'cargo');
  return execFileSync(program, options, {
    cwd,
    env,
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'inherit'],
    shell: process.platform === 'win32',
  }).trim();
}
