/** Writes the SHA-256 of every file below a folder into its file `SHA256SUMS`, as `sha256sum` does: `node checksums.mjs FOLDER`. */
import { createHash } from 'node:crypto';
import { rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { filesOf } from './bytes.mjs';

const [folder] = process.argv.slice(2);
if (folder === undefined) throw new Error('usage: node checksums.mjs FOLDER');

const sums = path.join(folder, 'SHA256SUMS');
await rm(sums, { force: true });
const lines = [...(await filesOf(folder))].map(
  ([name, bytes]) => `${createHash('sha256').update(bytes).digest('hex')}  ${name}\n`,
);
await writeFile(sums, lines.join(''));
