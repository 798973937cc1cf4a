/** The first example of the documentation is valid TypeScript, strictly. */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { promisify } from 'node:util';
import { ROOT, WEB } from './library.mjs';

const COMPILER = path.join(ROOT, 'crates/xtask/scripts/node_modules/typescript/bin/tsc');
const OPTIONS = '--strict --noEmit --target esnext --module esnext --moduleResolution bundler --lib esnext,dom';

test('the first example passes the strict compiler of TypeScript', async () => {
  const text = readFileSync(path.join(ROOT, 'docs/simulation.md'), 'utf8');
  const [, example] = /<script type="module">\n(.*?)<\/script>/s.exec(text) ?? [];
  assert.ok(example);
  const folder = mkdtempSync(path.join(tmpdir(), 'hearth-types-'));
  try {
    symlinkSync(WEB, path.join(folder, 'web'), 'junction');
    writeFileSync(path.join(folder, 'example.ts'), example);
    const run = promisify(execFile)(process.execPath, [COMPILER, ...OPTIONS.split(' '), 'example.ts'], { cwd: folder });
    await run.catch(({ stdout }) => assert.fail(stdout));
  } finally {
    rmSync(folder, { recursive: true });
  }
});
