/**
 * The crates of other people that cargo compiles into what is released, with the metadata of
 * their packages.
 */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';

/** What is released: packages and their target. @typedef {{packages: string[], target: string}} Release */

/** The wasm modules. @type {Release} */
export const WASM = {
  packages: ['hearth-engine', 'hearth-panel', 'hearth-sim'],
  target: 'wasm32-unknown-unknown',
};

/** The command `hearth`: the same notices on every machine, so those of one target. @type {Release} */
export const COMMAND = { packages: ['hearth-fire-cli'], target: 'x86_64-unknown-linux-gnu' };

/**
 * @typedef {object} Crate
 * @property {string} name
 * @property {string} version
 * @property {string} licence  An SPDX expression.
 * @property {string[]} authors
 * @property {string} folder  Where its files are.
 * @property {string} checksum  The SHA-256 of its archive.
 */

/**
 * The crates, by name and version.
 * @param {string} root  The checkout.
 * @param {Release} release
 * @returns {Crate[]}
 */
export function compiled(root, { packages: released, target }) {
  const cargo = (/** @type {string[]} */ ...options) =>
    execFileSync('cargo', options, {
      cwd: root,
      encoding: 'utf8',
      maxBuffer: 2 ** 28,
      stdio: ['ignore', 'pipe', 'inherit'],
    });
  const tree = cargo(
    'tree',
    '--target',
    target,
    '--edges',
    'normal,no-proc-macro',
    '--prefix',
    'none',
    '--no-dedupe',
    '--format',
    '{p}',
    ...released.flatMap((name) => ['--package', name]),
  );
  // A line is `name v1.2.3`, with a folder behind it for a crate of the workspace.
  const wanted = new Set(tree.split('\n').map((line) => line.split(' ').slice(0, 2).join(' ')));
  const { packages } = JSON.parse(cargo('metadata', '--format-version', '1', '--filter-platform', target));
  const checksums = checksumsOf(readFileSync(path.join(root, 'Cargo.lock'), 'utf8'));
  return packages
    .filter(({ name, version, source }) => source && wanted.has(`${name} v${version}`))
    .map(({ name, version, license, authors, manifest_path }) => ({
      name,
      version,
      licence: license?.replaceAll('/', ' OR '),
      authors: authors.map((author) => author.replace(/\s*<.*>/, '')),
      folder: path.dirname(manifest_path),
      checksum: checksums.get(`${name} ${version}`),
    }))
    .sort((a, b) => order(`${a.name} ${a.version}`, `${b.name} ${b.version}`));
}

/** The same order on every machine. @param {string} a @param {string} b */
export function order(a, b) {
  return a < b ? -1 : Number(a > b);
}

/** @param {string} lock @returns {Map<string, string>} */
function checksumsOf(lock) {
  const entry = /name = "(.*)"\r?\nversion = "(.*)"\r?\n(?:source = .*\r?\n)checksum = "(.*)"/g;
  return new Map([...lock.matchAll(entry)].map(([, name, version, sum]) => [`${name} ${version}`, sum]));
}
