/**
 * A test file or a stage that passed is left out until something that it may depend on changes.
 */
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const TESTS = fileURLToPath(new URL('..', import.meta.url));

/** A checkout, whose test files pass, skip and read a file. @type {string} */
let root;
const write = (/** @type {string} */ file, /** @type {string} */ text) => writeFileSync(path.join(root, file), text);

before(() => {
  root = mkdtempSync(path.join(tmpdir(), 'hearth-passed-'));
  for (const folder of ['tests/e2e', 'site', 'target']) mkdirSync(path.join(root, folder), { recursive: true });
  for (const file of ['files.mjs', 'passed.mjs']) copyFileSync(path.join(TESTS, file), path.join(root, 'tests', file));
  write('.gitignore', '/target\n/site\n');
  write('tests/e2e/run.mjs', "import { runTests } from '../files.mjs';\nawait runTests(import.meta.dirname, 2);\n");
  write('tests/e2e/shared.mjs', 'export const one = 1;\n');
  write('site/index.html', '<p>One');
  const file = (/** @type {string} */ body, options = '{}') => (
    `import { test } from 'node:test';\nimport { one } from './shared.mjs';\ntest('a law', ${options}, () => { ${body} });\n`
  );
  write('tests/e2e/passes.test.mjs', file(''));
  write('tests/e2e/skips.test.mjs', file('', '{ skip: true }'));
  write('tests/e2e/fails.test.mjs', file("throw new Error('broken')"));
  execFileSync('git', ['init', '--quiet'], { cwd: root });
});
after(() => rmSync(root, { recursive: true }));

/** Runs all or some files; returns how many tests ran and what was printed. */
function run(/** @type {string[]} */ ...names) {
  const { NODE_TEST_CONTEXT: _, ...inherited } = process.env;
  const env = { ...inherited, HEARTH_SITE: path.join(root, 'site'), HEARTH_PASSED: path.join(root, 'target/passed.json') };
  const { stdout, stderr, status } = spawnSync(process.execPath, ['tests/e2e/run.mjs', ...names], { cwd: root, env, encoding: 'utf8' });
  return { ran: Number(/tests (\d+)/.exec(stdout)?.[1] ?? 0), printed: stdout + stderr, status };
}

test('only a file that passed, and of which nothing was skipped, is left out', () => {
  const first = run();
  assert.deepEqual([first.ran, first.status], [3, 1], first.printed);
  assert.match(first.printed, /1 of 3 test files failed and run once more, alone/);
  assert.doesNotMatch(first.printed, /UNSTABLE/);
  const second = run();
  assert.deepEqual([second.ran, second.status], [2, 1], second.printed);
  assert.match(second.printed, /1 of 3 test files passed before, unchanged/);
  const third = run('passes');
  assert.deepEqual([third.ran, third.status], [0, 0], third.printed);
});

test('a file runs again after a change of the site, of a shared file, of itself or of a damaged store', () => {
  run('passes');
  for (const [file, text] of [
    ['site/index.html', '<p>Two'],
    ['site/new.html', '<p>New'],
    ['tests/e2e/shared.mjs', 'export const one = 2;\n'],
    ['tests/e2e/untracked.json', '{}'],
    ['tests/e2e/passes.test.mjs', "import { test } from 'node:test';\ntest('another law', () => {});\n"],
    ['target/passed.json', '{"damaged'],
  ]) {
    write(file, text);
    assert.equal(run('passes').ran, 1, `after a change of ${file}`);
  }
  assert.equal(run('passes').ran, 0);
  // Another test file is no input.
  write('tests/e2e/skips.test.mjs', '');
  assert.equal(run('passes').ran, 0);
});

test('a file that fails is forgotten, also when it is restored', () => {
  write('tests/e2e/shared.mjs', "throw new Error('broken');\n");
  const passes = 'tests/e2e/passes.test.mjs';
  write(passes, "import { test } from 'node:test';\nimport './shared.mjs';\ntest('a law', () => {});\n");
  assert.equal(run('passes').status, 1);
  write('tests/e2e/shared.mjs', 'export const one = 2;\n');
  assert.equal(run('passes').ran, 1);
  assert.equal(run('passes').ran, 0);
});

test('a file that fails by chance runs once more, is named, and is no pass to remember', () => {
  write('tests/e2e/chance.test.mjs', `import { test } from 'node:test';
    import { existsSync, writeFileSync } from 'node:fs';
    const mark = new URL('../../target/mark', import.meta.url);
    test('a law by chance', () => {
      if (existsSync(mark)) return;
      writeFileSync(mark, '');
      throw new Error('by chance');
    });`);
  const first = run('chance');
  assert.equal(first.status, 0, first.printed);
  assert.match(first.printed, /UNSTABLE: failed at first, passed when run once more:\n {2}chance.test.mjs: a law by chance/);
  assert.equal(run('chance').ran, 1);
  assert.equal(run('chance').ran, 0);
});

test('a stage has no digest to print once it passed with it', () => {
  const store = path.join(root, 'target/stages.json');
  const stage = (/** @type {string[]} */ ...words) => (
    execFileSync(process.execPath, ['tests/passed.mjs', store, 'native', ...words], { cwd: root, encoding: 'utf8' }).trim()
  );
  const digest = stage();
  assert.match(digest, /^[0-9a-f]{64}$/);
  assert.equal(stage(), digest, 'it has not passed yet');
  stage(digest);
  assert.equal(stage(), '');
  write('tests/law.rs', 'fn law() {}');
  assert.notEqual(stage(), '', 'a source is new');
  // An input that changed during the stage.
  stage(digest);
  assert.notEqual(stage(), '');
  // The pass with the first inputs is forgotten.
  rmSync(path.join(root, 'tests/law.rs'));
  assert.equal(stage(), digest);
});
