/**
 * The texts that the panel copies, files of settings, and the URLs of Hearth's own files.
 *
 * @typedef {import('../hearth-fire.js').HearthConfig} HearthConfig
 */

import { FILE as SHARE, elementCode, iframeCode, pageLink } from '../share.js';
import { MAX_SETTINGS } from '../share/fragment.js';

/**
 * A URL in the folder of `hearth-fire.js`. Bundlers merge modules or give them `file:` URLs, and drop
 * files that no module names. The folder is known if share.js still is the file that this module
 * imports.
 */
const FOLDER =
  /^https?:/.test(SHARE) && SHARE.split('?')[0] === new URL('../share.js', import.meta.url).href ? SHARE : undefined;

/** The URL of a file beside `hearth-fire.js`. @param {string} file */
export function urlBesideModule(file) {
  return FOLDER ? new URL(file, FOLDER) : undefined;
}

/**
 * A form in which the panel copies a fire.
 * @typedef {object} CopyForm
 * @property {string} name
 * @property {string} label  Its name in messages and on accessible buttons.
 * @property {string} button  The text of the panel's button.
 * @property {string} hint  The tooltip of that button.
 */

/** In the order of the buttons. @type {CopyForm[]} */
export const COPIES = [
  { name: 'link', label: 'link', button: 'Link', hint: 'A link to this fire' },
  { name: 'element', label: 'HTML of the element', button: 'HTML', hint: 'HTML that shows this fire on any page' },
  { name: 'iframe', label: 'HTML of an iframe', button: 'Iframe', hint: 'HTML that shows this fire in an iframe' },
  { name: 'json', label: 'settings as JSON', button: 'JSON', hint: 'The settings, to save or to paste' },
  {
    name: 'report',
    label: 'report for an issue',
    button: 'Copy for an issue',
    hint: 'Version, browser, settings, measurements and the last errors',
  },
];

/** The own attributes of a fire that change what it shows or does at first. */
const ATTRIBUTES = ['warm', 'interactive', 'fit', 'align', 'zoom', 'pan'];

/**
 * How a page shows a fire, for its HTML on another page.
 * @param {import('../hearth-fire.js').HearthFire} fire
 * @returns {import('../share.js').HearthShown}
 */
export function shownAs(fire) {
  const named = ATTRIBUTES.map((name) => [name, fire.getAttribute?.(name) ?? null]);
  const attributes = Object.fromEntries(named.filter(([, value]) => value !== null));
  const { offsetWidth: width, offsetHeight: height } = fire;
  return width > 0 && height > 0 ? { width, height, attributes } : { attributes };
}

/**
 * The settings of a fire in one of these forms.
 * @param {string} name  Of one of {@link COPIES}, but the report.
 * @param {HearthConfig} config
 * @param {{page?: string | URL, script?: string | URL, embed?: string | URL}} addresses
 * @param {import('../share.js').HearthShown} shown
 * @returns {Promise<string>}
 * @throws {RangeError} they are too long for an address
 */
export async function textOf(name, config, { page, script, embed }, shown) {
  switch (name) {
    case 'link':
      return pageLink(config, page ?? location.href);
    case 'element':
      return elementCode(config, script, shown);
    case 'iframe':
      return iframeCode(config, embed ?? '', shown);
    default: {
      const text = JSON.stringify(config, null, 2);
      if (text.length > MAX_SETTINGS)
        throw new RangeError(`The settings have more than ${MAX_SETTINGS / 1000} KB, and no fire takes that many.`);
      return text;
    }
  }
}

/** Whether a file is one of settings: some systems have no type for `.json`. @param {File} file */
export function isSettings({ name, type }) {
  return /\bjson\b/.test(type) || /\.json$/i.test(name);
}

/**
 * The settings of a file; a text that is not JSON stays a text, which the fire rejects with a message.
 * @param {Blob} file
 * @throws {Error} it is too large
 */
export async function settingsOf(file) {
  if (file.size > MAX_SETTINGS)
    throw new Error(`The file has ${Math.ceil(file.size / 1000)} KB; settings have at most ${MAX_SETTINGS / 1000} KB.`);
  const text = await file.text();
  try {
    return /** @type {HearthConfig} */ (JSON.parse(text));
  } catch {
    return text;
  }
}
