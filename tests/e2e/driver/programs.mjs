/**
 * The browsers and the paths of their programs. A missing browser is a failure, never a
 * skipped test.
 */
import { accessSync, constants } from 'node:fs';
import path from 'node:path';

/** @typedef {'chromium' | 'firefox' | 'webkit'} Kind */

/** @type {Kind[]} */
const KINDS = ['chromium', 'firefox', 'webkit'];

/** The browsers of a run: `HEARTH_BROWSERS=firefox,webkit` names others than Chromium. Each file runs once in each. */
export const BROWSERS = chosen(process.env.HEARTH_BROWSERS || 'chromium');

/** The browser of a test file. */
export const BROWSER = BROWSERS[0];

/** What the driver cannot do in a browser: the run counts a test that throws this as left out, and tells why. */
export class LeftOut extends Error {
  /** @param {string} reason */
  constructor(reason) {
    super(`left out: ${reason}`);
  }
}

/** Methods of puppeteer's page that Chromium's alone has, and what it does by them. */
export const CHROMIUM_ALONE = Object.fromEntries(
  Object.entries({
    createCDPSession: 'reads the memory, the time and the accessibility tree of a page',
    emulateMediaFeatures: 'changes a preference while a page runs',
    emulateMediaType: 'shows a page as it is printed',
    workers: 'looks into a worker',
  }).map(([method, does]) => [
    method,
    () => {
      throw new LeftOut(`only Chromium's driver ${does}`);
    },
  ]),
);

/**
 * Options of a test that holds in other browsers, with the reason for each one in which it does not.
 * @param {Partial<Record<Kind, string>>} reasons
 * @returns {{skip?: string}}
 */
export function except(reasons) {
  const reason = reasons[BROWSER];
  return reason === undefined ? {} : { skip: reason };
}

/** Where engines can run, and where they do by default. */
export const THREADS = /** @type {const} */ (['worker', 'main']).slice(BROWSER === 'webkit' ? 1 : 0);
export const [THREAD] = THREADS;

/** Options of a test that stops the thread of an engine. */
export const STOPPED = except({ webkit: 'its engine runs on the page’s thread, which no test can stop' });

/** Options of a test that shows another tab. */
export const TABS = except({ webkit: "WebKitGTK's driver has one tab" });

/** Options of a test that leaves a control backwards. */
export const BACKWARDS = except({ webkit: "Shift and Tab of WebKitGTK's driver are a key without a name" });

/** @param {string} names @returns {Kind[]} */
function chosen(names) {
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
