/**
 * Minified scripts keep every name that another file uses.
 */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const MINIFY = fileURLToPath(new URL('../../crates/xtask/scripts/minify.mjs', import.meta.url));

/** Files of a small site. */
const FILES = {
  'package.json': '{ "exports": { ".": "./a.js", "./open": "./open.js" } }',
  'a.js': `/*! A licence. */
import { one } from './one.js';
import './shared.js';
import './open.js';
/** @type {number} */
export const warmth = { perHour: one }; // Much.
export const ask = () => import('./asked.js');
`,
  'one.js': "import './in/two.js';\nimport './named.js';\nexport const one = 1;\n",
  'named.js': 'globalThis.alone = /named\\.js$/.test(import.meta.url);\n',
  'in/two.js': "import '../shared.js';\nglobalThis.style = new URL('../a.css', import.meta.url);\n",
  'open.js': 'globalThis.open = 1;\n',
  'asked.js': "import './shared.js';\n",
  'shared.js': 'globalThis.shared = 1;\n',
  'a.css': '/* Red. */\na {\n  color: red;\n}\n',
};

test('a minified script keeps every name that another file uses', async () => {
  const web = await mkdtemp(path.join(tmpdir(), 'hearth-minify-'));
  try {
    for (const [name, text] of Object.entries(FILES)) {
      await mkdir(path.dirname(path.join(web, name)), { recursive: true });
      await writeFile(path.join(web, name), text);
    }
    execFileSync(process.execPath, [MINIFY, web]);
    const script = await readFile(path.join(web, 'a.js'), 'utf8');
    for (const kept of [
      '/*! A licence. */', 'warmth', 'perHour', 'new URL("./a.css",import.meta.url)', '"./shared.js"', '"./open.js"',
      '"./named.js"', 'import("./asked.js")',
    ]) {
      assert.ok(script.includes(kept), `${kept} is not in ${script}`);
    }
    assert.doesNotMatch(script, /Much|@type/);
    assert.equal(await readFile(path.join(web, 'a.css'), 'utf8'), 'a{color:red}\n');
    // One file alone imported each of these.
    assert.ok(!existsSync(path.join(web, 'one.js')) && !existsSync(path.join(web, 'in/two.js')));
  } finally {
    await rm(web, { recursive: true });
  }
});
