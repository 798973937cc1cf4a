/**
 * wasm-opt over the engine and the headless library.
 *
 * -O3 takes 6 % off the engine and half a percent off its download, and a step
 * takes as long as before, to the bit the same; -Os takes another half percent off
 * and costs a percent of a step. The panel is left as it is: whatever makes it
 * smaller to parse makes it compress worse, 806 KB after -Oz where it had 776.
 */
import { execFile } from 'node:child_process';
import { readdir, rename, stat } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { promisify } from 'node:util';

const WASM_OPT = path.join(path.dirname(createRequire(import.meta.url).resolve('binaryen/package.json')), 'bin/wasm-opt');

/** Makes the modules in a folder smaller. @param {string} folder */
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
