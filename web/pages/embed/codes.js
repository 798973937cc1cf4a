/**
 * The code that shows a fire on another page, in the forms of different pages.
 *
 * @typedef {import('../../share.js').HearthSharedConfig} Config
 * @typedef {import('../../share.js').HearthShown} Shown
 * @typedef {{script: string | URL, embed: string | URL}} Addresses
 */

import { elementAttributes, escaped, iframeCode } from '../../share.js';

/** The longest line of an element; a longer one has a line for each attribute. */
const LINE = 100;

/** The name of the package, and of the file that contains everything. */
const PACKAGE = 'hearth-fire';
const FILE = 'hearth-fire.inline.js';

/** The forms: name, label, and what a page needs for it. @type {[name: string, label: string, note: string][]} */
export const FORMS = [
  ['html', 'HTML', 'A script and an element.'],
  ['iframe', 'Iframe', 'For sites that allow no scripts.'],
  ['react', 'React', `React 19. The package is ${PACKAGE}.`],
  ['vue', 'Vue', `Vue 3 with isCustomElement: (tag) => tag === 'hearth-fire'. The package is ${PACKAGE}.`],
  ['npm', 'npm', 'For bundlers, such as Vite.'],
  ['file', 'Single file', `A page that needs one file beside it, ${FILE} of the package; it works without a server.`],
];

/** What a fire shows on a white page, which is a lit room: things in their own colours, and no smoke. */
const LIT = { ambient_light: 1, smoke_opacity: 0 };

/**
 * The values of a fire on a page. A wall is a dark box on a white page, so the fire has none there.
 * @param {string} page  `white`, or another ground.
 * @param {boolean} alone  Whether the page is seen behind the fire.
 * @param {{[id: string]: unknown}} values  Those that differ from the scene's.
 * @param {{readonly [id: string]: unknown}} params  All that the fire has.
 */
export function valuesOn(page, alone, values, params) {
  const isLit = page === 'white';
  const without = ['backdrop', 'ground'].filter((id) => (isLit || alone) && params[id] !== 'none');
  return { ...values, ...(isLit && LIT), ...Object.fromEntries(without.map((id) => [id, 'none'])) };
}

/**
 * The code in a form.
 * @param {string} form  A name of {@link FORMS}.
 * @param {Config} config
 * @param {Shown} shown
 * @param {Addresses} addresses
 * @returns {Promise<string>}
 * @throws {RangeError} the settings are too long for an address
 */
export async function codeOf(form, config, shown, { script, embed }) {
  const attributes = elementAttributes(config, shown);
  const element = written(attributes, html);
  const load = (/** @type {string | URL} */ source, kind = 'type="module" ') =>
    `<script ${kind}src="${escaped(String(source))}"></script>`;
  switch (form) {
    case 'iframe':
      return iframeCode(config, embed, shown);
    case 'react':
      return `import '${PACKAGE}';\n\nexport function Fire() {\n  return (\n${indented(written(attributes, jsx, ' />'), 4)}\n  );\n}`;
    case 'vue':
      return `<script setup>\nimport '${PACKAGE}';\n</script>\n\n<template>\n${indented(element, 2)}\n</template>`;
    case 'npm':
      return `import '${PACKAGE}';\n\n${element}`;
    case 'file':
      return `<!doctype html>\n${load(FILE, 'type="module" ')}\n${element}`;
    default:
      return `${load(script)}\n${element}`;
  }
}

/** An attribute of HTML. @type {(name: string, value: string) => string} */
const html = (name, value) => (value === '' ? name : `${name}="${escaped(value)}"`);

/** An attribute of JSX: a style is an object, and a flag is one. @type {(name: string, value: string) => string} */
function jsx(name, value) {
  if (value === '') return name;
  if (name !== 'style') return /["\\{}&]/.test(value) ? `${name}={${JSON.stringify(value)}}` : `${name}="${value}"`;
  const sides = [...value.matchAll(/([\w-]+): ([^;]+)/g)].map(([, side, length]) => {
    const key = side.replace(/-(.)/g, (_, letter) => letter.toUpperCase());
    return `${key}: ${length.endsWith('px') ? parseFloat(length) : `'${length}'`}`;
  });
  return `style={{ ${sides.join(', ')} }}`;
}

/**
 * An element, on one line if it fits.
 * @type {(attributes: [string, string][], write: (name: string, value: string) => string, end?: string) => string}
 */
function written(attributes, write, end = '></hearth-fire>') {
  const named = attributes.map(([name, value]) => write(name, value));
  const line = `<hearth-fire ${named.join(' ')}${end}`;
  return line.length <= LINE ? line : `<hearth-fire\n${named.map((text) => `  ${text}`).join('\n')}\n${end.trim()}`;
}

/** @param {string} text @param {number} by */
const indented = (text, by) => text.replace(/^/gm, ' '.repeat(by));
