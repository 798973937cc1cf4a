/**
 * The package under test and the projects that use it.
 *
 * `HEARTH_PACKAGE` names the folder of the package (`dist/npm` by default), `HEARTH_YARD`
 * the folder of the projects (`target/consumers` by default): a project outside the
 * checkout cannot reach its files.
 */
import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { cp, mkdir, readFile, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

const HERE = path.dirname(fileURLToPath(import.meta.url));
const ROOT = path.resolve(HERE, '../..');

/** The folder of the package. */
export const PACKAGE = path.resolve(process.env.HEARTH_PACKAGE ?? path.join(ROOT, 'dist/npm'));

const YARD = path.resolve(process.env.HEARTH_YARD ?? path.join(ROOT, 'target/consumers'));

/** A folder of static files that has a copy of the package in it, as `vendor/hearth-fire`. */
export async function copied() {
  const folder = path.join(YARD, 'plain');
  await rm(folder, { recursive: true, force: true });
  await cp(path.join(HERE, 'plain'), folder, { recursive: true });
  await cp(PACKAGE, path.join(folder, 'vendor/hearth-fire'), { recursive: true });
  return folder;
}

/** A folder that has nothing in it but these files of the package. @param {...string} names */
export async function alone(...names) {
  const folder = path.join(YARD, 'alone');
  await rm(folder, { recursive: true, force: true });
  for (const name of names) await cp(path.join(PACKAGE, name), path.join(folder, name));
  return folder;
}

/** What `docs/package.md` gives to `npm install`: the archive of `npm pack`, a copy of the folder, a link to it. */
export const WAYS = {
  archive: async () => [await packed()],
  copy: async () => ['--install-links', PACKAGE],
  link: async () => [PACKAGE],
};

/**
 * A project beside this file, with the packages of its lock file and the package
 * installed; gives its folder.
 * @param {string} name
 * @param {keyof typeof WAYS} [way]
 * @param {string} [from] the folder of the project
 */
export async function installed(name, way = 'archive', from = path.join(HERE, name)) {
  const folder = await project(name, from);
  // npm takes a package of a name and version that it has for the same one.
  await rm(path.join(folder, 'node_modules/hearth-fire'), { recursive: true, force: true });
  await npm(folder, 'install', '--no-save', '--no-package-lock', '--prefer-offline', ...(await WAYS[way]()));
  await writeFile(path.join(folder, MARKER), await readFile(path.join(folder, 'package-lock.json')));
  return folder;
}

/** A file of a project with the lock file of the packages that are there. */
const MARKER = 'node_modules/.installed-for';

/** A project beside this file, with the packages of its lock file; gives its folder. @param {string} name @param {string} [from] */
export async function project(name, from = path.join(HERE, name)) {
  const folder = path.join(YARD, name);
  const lock = await readFile(path.join(from, 'package-lock.json'), 'utf8');
  const marker = path.join(folder, MARKER);
  const fresh = (await readFile(marker, 'utf8').catch(() => '')) === lock;
  if (!fresh) await rm(folder, { recursive: true, force: true });
  await cp(from, folder, {
    recursive: true,
    filter: (file) => !file.split(path.sep).includes('node_modules'),
  });
  if (!fresh) {
    await npm(folder, 'ci');
    await writeFile(marker, lock);
  }
  return folder;
}

/** What npm packs of the package, in a file named after its contents. */
async function packed() {
  const folder = path.join(YARD, 'packed');
  await mkdir(folder, { recursive: true });
  const [{ filename }] = JSON.parse(await npm(PACKAGE, 'pack', '--json', '--pack-destination', folder));
  const bytes = await readFile(path.join(folder, filename));
  const file = path.join(folder, `${createHash('sha256').update(bytes).digest('hex').slice(0, 16)}.tgz`);
  await writeFile(file, bytes);
  return file;
}

/** The output of npm. @param {string} folder @param {...string} words */
async function npm(folder, ...words) {
  const windows = process.platform === 'win32';
  const { stdout } = await promisify(execFile)(windows ? 'npm.cmd' : 'npm', words, { cwd: folder, shell: windows });
  return stdout;
}
