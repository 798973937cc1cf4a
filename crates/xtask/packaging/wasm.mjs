/**
 * Runs wasm-opt over the engine and the headless library.
 *
 * -Os makes the engine 7 % smaller to parse and its download a quarter of a percent larger, with
 * the same bits, for a percent of a step; -O3 makes the download 0.9 % larger. The panel stays as
 * it is: 806 KB to download after -Oz instead of 776.
 */
import { execFile } from 'node:child_process';
import { readdir, rename, stat } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { promisify } from 'node:util';

const WASM_OPT = path.join(path.dirname(createRequire(import.meta.url).resolve('binaryen/package.json')), 'bin/wasm-opt');

/** Shrinks the modules in a folder. @param {string} folder */
export async function shrink(folder) {
  const names = (await readdir(folder)).filter((name) => name.endsWith('.wasm') && !name.startsWith('hearth-panel'));
  await Promise.all(names.map(async (name) => {
    const file = path.join(folder, name);
    const { size: before } = await stat(file);
    // It reads from the module which instructions browsers may be given.
    await promisify(execFile)(process.execPath, [WASM_OPT, '-Os', file, '-o', `${file}.opt`]);
    await rename(`${file}.opt`, file);
    const { size: after } = await stat(file);
    console.log(`wasm-opt: ${name} ${before} → ${after} bytes`);
  }));
}
