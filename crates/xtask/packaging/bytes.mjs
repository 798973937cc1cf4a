/** What the bytes of built files say about the machine that built them. */
import { createHash } from 'node:crypto';
import { readFile, readdir } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { order } from './crates.mjs';

/** Every file below a folder, by its path there. @param {string} folder @returns {Promise<Map<string, Buffer>>} */
export async function filesOf(folder) {
  const found = new Map();
  const entries = await readdir(folder, { withFileTypes: true });
  for (const { name } of entries.filter((entry) => entry.isFile())) found.set(name, await readFile(path.join(folder, name)));
  for (const { name } of entries.filter((entry) => entry.isDirectory())) {
    for (const [below, bytes] of await filesOf(path.join(folder, name))) found.set(`${name}/${below}`, bytes);
  }
  return new Map([...found].sort(([one], [other]) => order(one, other)));
}

/**
 * The files of two folders that differ, or that one of them lacks.
 * @param {string} one
 * @param {string} other
 * @param {(name: string, bytes: Buffer) => Buffer | string} [essence]  What is compared of a file.
 */
export async function differences(one, other, essence = (_, bytes) => bytes) {
  const [ours, theirs] = [await filesOf(one), await filesOf(other)];
  return [...new Set([...ours.keys(), ...theirs.keys()])].flatMap((name) => {
    const [mine, yours] = [ours.get(name), theirs.get(name)];
    if (!mine) return [`${name} is added`];
    if (!yours) return [`${name} is missing`];
    return Buffer.from(essence(name, mine)).equals(Buffer.from(essence(name, yours))) ? [] : [`${name} differs`];
  });
}

/** One number for all files of a folder. @param {string} folder */
export async function digest(folder) {
  const sum = createHash('sha256');
  for (const [name, bytes] of await filesOf(folder)) sum.update(`${name}\0${bytes.length}\0`).update(bytes);
  return sum.digest('hex');
}

/**
 * The files below a folder that name a folder of this machine, each with that folder.
 * @param {string} folder
 * @param {string[]} [machine]
 */
export async function machinePaths(folder, machine = machineFolders()) {
  const found = [];
  for (const [name, bytes] of await filesOf(folder)) {
    for (const place of machine) if (bytes.includes(place)) found.push(`${name} contains ${place}`);
  }
  return found;
}

/** The checkout, and where this user's files, cargo's and rustup's are. */
function machineFolders() {
  const checkout = fileURLToPath(new URL('../../..', import.meta.url));
  const { CARGO_HOME, CARGO_TARGET_DIR, RUSTUP_HOME } = process.env;
  const folders = [os.homedir(), CARGO_HOME, CARGO_TARGET_DIR, RUSTUP_HOME, checkout].filter((name) => name !== undefined);
  // A folder at the root of a disk is too short to be sought.
  return [...new Set(folders.map((name) => path.resolve(name) + path.sep))].filter((name) => name.length > 3);
}
