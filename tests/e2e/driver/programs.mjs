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
    const kind = KINDS.find((known) => known === name.trim());
    if (!kind) throw new Error(`HEARTH_BROWSERS names "${name}"; there are: ${KINDS.join(', ')}`);
    return kind;
  });
}

/**
 * A program: from the environment, else the first of these names on the PATH.
 * @param {string} variable @param {string[]} names @param {string} debian  Its package.
 */
export function program(variable, names, debian) {
  const found = find(variable, names);
  if (found === undefined) throw new Error(`no ${names[0]}: install Debian's "${debian}" or name one in ${variable}`);
  return found;
}

/** Chromium. */
export function chromium() {
  return program(
    'HEARTH_CHROMIUM',
    ['chromium', 'chromium-browser', 'google-chrome-stable', 'google-chrome'],
    'chromium',
  );
}

/** Chromium's headless shell, or Chromium where there is none. */
export function headlessShell() {
  return find('HEARTH_HEADLESS_SHELL', ['chromium-headless-shell', 'chrome-headless-shell']) ?? chromium();
}

/** @param {string} variable @param {string[]} names */
function find(variable, names) {
  const named = process.env[variable];
  if (named) return named;
  const folders = (process.env.PATH ?? '').split(path.delimiter);
  return names
    .flatMap((name) => folders.map((folder) => path.join(folder, name)))
    .find((file) => {
      try {
        accessSync(file, constants.X_OK);
        return true;
      } catch {
        return false;
      }
    });
}
