/**
 * Remembers which test files and which stages of `cargo xtask test` passed, each with the digest of
 * everything that it depends on: what has the same digest need not run again.
 *
 * A digest covers too much rather than too little: the whole checkout (a test file leaves out
 * other test files, and Rust sources, which reach it as wasm), the built folders, the installed
 * packages, the environment, compiler and browsers, and the packages of the system.
 *
 * `node passed.mjs STORE STAGE` prints the digest of a stage, or nothing where the stage passed with
 * it. `node passed.mjs STORE STAGE DIGEST` stores a pass, unless an input changed since.
 */
import { execFileSync } from 'node:child_process';
import { createHash, randomUUID } from 'node:crypto';
import { mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

/** Variables that tests and builds read, and those that only name places of results. */
const VARIABLES = /^(HEARTH_|NODE_OPTIONS$|PATH$|RUST|CARGO_(BUILD|ENCODED|PROFILE|TARGET))/;
const RESULTS = ['HEARTH_PASSED', 'HEARTH_SHOWN'];

/** Programs that stages find on the PATH. */
const PROGRAMS = ['rustc', 'chromium', 'chromium-browser', 'google-chrome-stable', 'google-chrome', 'chromedriver', 'valgrind', 'npm'];

const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..');

/**
 * The digest of each test file.
 * @param {string[]} files  Absolute paths.
 * @returns {{[file: string]: string}}
 */
export function digests(files) {
  const hash = everywhere((file) => !/\.(rs|test\.mjs)$/.test(file));
  return Object.fromEntries(files.map((file) => [
    file,
    hash.copy().update(`${file}\n${contents(file)}`).digest('hex'),
  ]));
}

/** The digest of any stage. */
function digest() {
  const hash = everywhere(() => true);
  const { HOME = '', CARGO_HOME = path.join(HOME, '.cargo') } = process.env;
  hash.update(`${contents(path.join(CARGO_HOME, 'config.toml'))}`);
  for (const program of PROGRAMS) hash.update(`${version(program)}`);
  return hash.digest('hex');
}

/**
 * Hashes what every test may depend on.
 * @param {(file: string) => boolean} counts  Which files of the checkout do.
 */
function everywhere(counts) {
  const hash = createHash('sha256');
  const add = (/** @type {unknown} */ value) => hash.update(`${JSON.stringify(value)}\n`);
  add([process.version, process.platform, os.release()]);
  for (const [name, value = ''] of Object.entries(process.env).sort()) {
    if (!VARIABLES.test(name) || RESULTS.includes(name)) continue;
    add([name, value]);
    const kind = statSync(value, { throwIfNoEntry: false });
    // Others name the folders of compilers, whose versions count.
    if (name.startsWith('HEARTH_') && kind?.isDirectory()) for (const file of filesIn(value)) add([file, contents(file)]);
    if (kind?.isFile()) add([kind.size, kind.mtimeMs, version(value)]);
  }
  // Libraries and fonts that browsers draw with.
  add(contents('/var/lib/dpkg/status'));
  add(contents(path.join(ROOT, 'tests/e2e/node_modules/.package-lock.json')));
  for (const file of checkout()) if (counts(file)) add([file, contents(path.join(ROOT, file))]);
  return hash;
}

/**
 * The digests of what passed; none where nothing readable is stored.
 * @param {string} store
 * @returns {{[file: string]: string}}
 */
export function readPassed(store) {
  try {
    return Object(JSON.parse(readFileSync(store, 'utf8')));
  } catch {
    return {};
  }
}

/** @param {string} store @param {{[file: string]: string}} passed */
export function writePassed(store, passed) {
  mkdirSync(path.dirname(store), { recursive: true });
  writeFileSync(store, `${JSON.stringify(passed, null, 1)}\n`);
}

/**
 * Tracked files and those that `.gitignore` does not name, whatever a user's git ignores. Without
 * git, a name that never comes again: nothing is the same then.
 */
function checkout() {
  const list = ['ls-files', '-z', '--cached', '--others', '--exclude-per-directory=.gitignore'];
  try {
    const listed = execFileSync('git', list, { cwd: ROOT, encoding: 'utf8', maxBuffer: 2 ** 26 });
    return [...new Set(listed.split('\0'))].filter(Boolean).sort();
  } catch {
    return [randomUUID()];
  }
}

/** @param {string} folder @returns {string[]} */
function filesIn(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const file = path.join(folder, entry.name);
    return entry.isDirectory() ? filesIn(file) : [file];
  }).sort();
}

/** The digest of a file's bytes; null without the file. */
function contents(/** @type {string} */ file) {
  const kind = statSync(file, { throwIfNoEntry: false });
  return kind?.isFile() ? createHash('sha256').update(readFileSync(file)).digest('hex') : null;
}

/** What a program prints as its version; a script may start another program. */
function version(/** @type {string} */ program) {
  try {
    return execFileSync(program, ['--version'], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
  } catch {
    return null;
  }
}

const [, script, store, stage, before] = process.argv;
if (script === fileURLToPath(import.meta.url)) {
  const passed = readPassed(store);
  const now = digest();
  if (before !== undefined) {
    if (now === before) writePassed(store, { ...passed, [stage]: now });
  } else if (passed[stage] !== now) {
    delete passed[stage];
    writePassed(store, passed);
    console.log(now);
  }
}
