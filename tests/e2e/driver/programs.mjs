/**
 * The browsers and the paths of their programs. A missing browser is a failure, never a
 * skipped test.
 */
import { accessSync, constants } from 'node:fs';
import path from 'node:path';

/** @typedef {'chromium' | 'firefox' | 'webkit'} Kind */

/** @type {Kind[]} */
const KINDS = ['chromium', 'firefox', 'webkit'];

/** The browsers under test: `HEARTH_BROWSERS=firefox,webkit` selects some. */
export const BROWSERS = chosen(process.env.HEARTH_BROWSERS);

/** @param {string | undefined} names */
function chosen(names) {
  if (!names) return KINDS;
  return names.split(',').map((name) => {
    const kind = KINDS.find((one) => one === name.trim());
    if (!kind) throw new Error(`HEARTH_BROWSERS names "${name}"; there are: ${KINDS.join(', ')}`);
    return kind;
  });
}

/**
 * A program: from the environment, else the first of these names on the PATH.
 * @param {string} variable @param {string[]} names @param {string} debian  Its package.
 */
export function program(variable, names, debian) {
  const named = process.env[variable];
  if (named) return named;
  const folders = (process.env.PATH ?? '').split(path.delimiter);
  for (const file of names.flatMap((name) => folders.map((folder) => path.join(folder, name)))) {
    try {
      accessSync(file, constants.X_OK);
      return file;
    } catch {
      // Not in this folder.
    }
  }
  throw new Error(`no ${names[0]}: install Debian's "${debian}" or name one in ${variable}`);
}
