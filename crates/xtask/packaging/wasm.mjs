/**
 * Runs wasm-opt over the engine and the headless library.
 *
 * -O3 makes the engine 6 % smaller and its download half a percent smaller, at the same speed
 * and with the same bits; -Os saves another half percent of the download and costs a percent
 * of a step. The panel stays as it is: what is smaller to parse compresses worse, 806 KB
 * after -Oz instead of 776.
 */
import { execFile } from 'node:child_process';
import { readdir, rename, stat } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { promisify } from 'node:util';

const WASM_OPT = path.join(path.dirname(createRequire(import.meta.url).resolve('binaryen/package.json')), 'bin/wasm-opt');

/** Shrinks the modules in a folder. @param {string} folder */
export async function shrink(folder) {
  for (const name of await readdir(folder)) {
    if (!name.endsWith('.wasm') || name.startsWith('hearth-panel')) continue;
    const file = path.join(folder, name);
    const { size: before } = await stat(file);
    // It reads from the module which instructions browsers may be given.
    await promisify(execFile)(process.execPath, [WASM_OPT, '-O3', file, '-o', `${file}.opt`]);
    await rename(`${file}.opt`, file);
    const { size: after } = await stat(file);
    console.log(`wasm-opt: ${name} ${before} → ${after} bytes`);
  }
}
