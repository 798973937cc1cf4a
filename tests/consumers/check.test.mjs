/**
 * The check of the package finds each kind of fault.
 */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { appendFile, readFile, rm, writeFile } from 'node:fs/promises';
import { homedir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { broken } from './package.mjs';

const CHECK = fileURLToPath(new URL('../../crates/xtask/packaging/check.mjs', import.meta.url));

/** @type {[string, (folder: string) => Promise<unknown>, RegExp][]} */
const FAULTS = [
  ['a file that an entry point names and that is not there', (folder) => rm(path.join(folder, 'share.js')), /"\.\/share"\] names .*share\.js/],
  ['a file that nothing needs', (folder) => writeFile(path.join(folder, 'stray.js'), ''), /stray\.js/],
  ['a folder of this machine', (folder) => appendFile(path.join(folder, 'README.md'), path.join(homedir(), 'x')), /README\.md contains/],
  ['a link that ends nowhere', (folder) => appendFile(path.join(folder, 'README.md'), '[a](gone.md)'), /links to gone\.md/],
  ['an event that custom-elements.json does not know', (folder) => edit(folder, 'hearth-fire.d.ts', 'ready: CustomEvent<null>;', 'steady: CustomEvent<null>;$&'), /steady/],
  ['a declaration that does not compile', (folder) => edit(folder, 'share.d.ts', 'URLSearchParams', 'URLSearchParms'), /URLSearchParms/],
  ['a package that may not be published', (folder) => edit(folder, 'package.json', '"version"', '"private": true, $&'), /private/],
];

for (const [fault, make, said] of FAULTS) {
  test(`${fault} is found`, async () => {
    const folder = await broken();
    await make(folder);
    const check = promisify(execFile)(process.execPath, [CHECK, folder, `${folder}-check`]);
    const { stderr } = await check.then(() => assert.fail('nothing was found'), (error) => error);
    assert.match(stderr, said);
  });
}

/** @type {(folder: string, name: string, from: string, to: string) => Promise<void>} */
async function edit(folder, name, from, to) {
  const file = path.join(folder, name);
  const text = await readFile(file, 'utf8');
  assert(text.includes(from), `${name} has no ${from}`);
  await writeFile(file, text.replace(from, to));
}
