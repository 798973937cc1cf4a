/** Comparisons of the bytes of built files: with another build, and with the folders of this machine. */
import { readFile, readdir } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { order } from './crates.mjs';

/** Every file below a folder, by its path there. @param {string} folder @returns {Promise<Map<string, Buffer>>} */
export async function filesOf(folder) {
  const found = new Map();
  const entries = await readdir(folder, { withFileTypes: true });
  for (const { name } of entries.filter((entry) => entry.isFile()))
    found.set(name, await readFile(path.join(folder, name)));
  for (const { name } of entries.filter((entry) => entry.isDirectory())) {
    for (const [below, bytes] of await filesOf(path.join(folder, name))) found.set(`${name}/${below}`, bytes);
  }
  return new Map([...found].sort(([a], [b]) => order(a, b)));
}

/**
 * The files of two folders that differ, or that one of them lacks.
 * @param {string} ours
 * @param {string} theirs
 * @param {(name: string, bytes: Buffer) => Buffer | string} [essence]  What is compared of a file.
 */
export async function differences(ours, theirs, essence = (_, bytes) => bytes) {
  const [files, others] = [await filesOf(ours), await filesOf(theirs)];
  return [...new Set([...files.keys(), ...others.keys()])].flatMap((name) => {
    const [file, other] = [files.get(name), others.get(name)];
    if (!file) return [`${name} is added`];
    if (!other) return [`${name} is missing`];
    return Buffer.from(essence(name, file)).equals(Buffer.from(essence(name, other))) ? [] : [`${name} differs`];
  });
}

/** The files below a folder that name a folder of this machine, each with that folder. @param {string} folder */
export async function machinePaths(folder) {
  const found = [];
  for (const [name, bytes] of await filesOf(folder)) {
    for (const place of machineFolders()) if (bytes.includes(place)) found.push(`${name} contains ${place}`);
  }
  return found;
}

/** The checkout, and where this user's files, cargo's and rustup's are. */
function machineFolders() {
  const checkout = fileURLToPath(new URL('../../..', import.meta.url));
  const { CARGO_HOME, CARGO_TARGET_DIR, RUSTUP_HOME } = process.env;
  const folders = [os.homedir(), CARGO_HOME, CARGO_TARGET_DIR, RUSTUP_HOME, checkout].filter(
    (name) => name !== undefined,
  );
  // A folder at the root of a disk is too short to be sought.
  return [...new Set(folders.map((name) => path.resolve(name) + path.sep))].filter((name) => name.length > 3);
}
