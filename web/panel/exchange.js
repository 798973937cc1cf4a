/**
 * What leaves the page and comes back: the texts that the panel copies, files, and the addresses of Hearth's own.
 *
 * @typedef {import('../hearth-fire.js').HearthConfig} HearthConfig
 */

import { FILE as SHARE, elementCode, iframeCode, pageLink } from '../share.js';

/**
 * A URL in the folder of `hearth-fire.js`. Bundlers merge modules or give them `file:` URLs, and drop
 * files that no module names. The folder is known if share.js still is the file that this module
 * imports.
 */
const FOLDER = /^https?:/.test(SHARE) && SHARE.split('?')[0] === new URL('../share.js', import.meta.url).href
  ? SHARE : undefined;

/** The URL of a file beside `hearth-fire.js`. @param {string} file */
export function beside(file) {
  return FOLDER ? new URL(file, FOLDER) : undefined;
}

/** What the panel copies, in the order of the buttons. */
export const COPIES = ['link', 'element', 'iframe', 'json', 'report'];

/** Their labels. @type {{[what: string]: string}} */
export const COPY_LABELS = {
  link: 'link', element: 'HTML of the element', iframe: 'HTML of an iframe', json: 'settings as JSON',
  report: 'report for an issue',
};

/**
 * The settings of a fire in one of these forms.
 * @param {string} what  One of {@link COPIES}, but the report.
 * @param {HearthConfig} config
 * @param {{page?: string | URL, script?: string | URL, embed?: string | URL}} addresses
 */
export function textOf(what, config, { page, script, embed }) {
  switch (what) {
    case 'link':
      return pageLink(config, page ?? location.href);
    case 'element':
      return elementCode(config, script);
    case 'iframe':
      return iframeCode(config, embed ?? '');
    default:
      return JSON.stringify(config, null, 2);
  }
}

/** Whether a file is one of settings: some systems know no type of `.json`. @param {File} file */
export function isSettings({ name, type }) {
  return /\bjson\b/.test(type) || /\.json$/i.test(name);
}

/** The largest file of settings [bytes]. */
const MAX_FILE = 400_000;

/**
 * The settings of a file; a text that is not JSON stays one, which the fire refuses in words.
 * @param {Blob} file
 * @throws {Error} it is too large
 */
export async function settingsOf(file) {
  if (file.size > MAX_FILE) throw new Error(`The file has ${Math.round(file.size / 1000)} KB; settings have at most ${MAX_FILE / 1000} KB.`);
  const text = await file.text();
  try {
    return /** @type {HearthConfig} */ (JSON.parse(text));
  } catch {
    return text;
  }
}
