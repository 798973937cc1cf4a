/**
 * Suggestions for unknown names, and warnings about unknown attributes: loaded with the first such
 * name.
 */

import { DEFAULTS, OWN_ATTRIBUTES } from '../generated/defaults.js';

/** Most names that are offered. */
const MOST = 3;

/**
 * Attributes that every element may have, and those that frameworks and libraries put on
 * elements: with a prefix of one or two letters, with signs that HTML has no use for.
 */
const FOREIGN = new RegExp([
  '^(accesskey|autocapitalize|autocorrect|autofocus|class|contenteditable|dir|draggable|elementtiming|enterkeyhint',
  'exportparts|hidden|id|inert|inputmode|is|lang|nonce|part|popover|role|slot|spellcheck|style|tabindex|title',
  'translate|writingsuggestions)$|^(aria|data|astro|wire|jsaction|jscontroller|jsname)|^on|^item|^xml|^[a-z]{1,2}-',
  '^_|[^a-z0-9_-]',
].join('|'));

const KNOWN = [...OWN_ATTRIBUTES, ...Object.keys(DEFAULTS).map((id) => id.replaceAll('_', '-'))];

/** Those that were told. */
const TOLD = new Set();

/**
 * Warns once that an attribute has no effect, unless it is HTML's, a framework's or a library's.
 * @param {string} name
 */
export function tell(name) {
  if (TOLD.has(name) || FOREIGN.test(name)) return;
  TOLD.add(name);
  const size = ['width', 'height'].includes(name) ? ' Its size is what its style says.' : '';
  console.warn(`<hearth-fire>: it has no attribute ${name.slice(0, 40)}${meant(name, KNOWN)}${size}`);
}

/**
 * The question whether one of these was meant, as the end of a sentence; a full stop where none is near.
 * @param {string} name
 * @param {string[]} names
 */
export function meant(name, names) {
  const near = nearest(name, names);
  return near.length > 0 ? `; did you mean ${near.join(', ').replace(/, ([^,]*)$/, ' or $1')}?` : '.';
}

/**
 * The names that may be meant: the same but for its signs; with its words; one written with
 * few mistakes; one whose words are in it.
 * @param {string} name
 * @param {string[]} names
 * @returns {string[]}
 */
export function nearest(name, names) {
  const [letters, words] = [plain(name), wordsOf(name)];
  const same = names.filter((one) => plain(one) === letters);
  const longer = names.filter((one) => words.every((word) => wordsOf(one).includes(word)));
  const shorter = names.filter((one) => wordsOf(one).every((word) => words.includes(word)));
  const found = [same, longer, alike(name, names, Math.max(1, Math.floor(letters.length / 4))), shorter];
  return (found.find(({ length }) => length > 0) ?? []).slice(0, MOST);
}

/**
 * Those that are written with the fewest mistakes, and no more than so many.
 * @param {string} name
 * @param {string[]} names
 * @param {number} most
 */
export function alike(name, names, most) {
  const far = names.map((one) => mistakes(plain(name), plain(one)));
  const least = Math.min(...far, most);
  return names.filter((_, at) => far[at] === least);
}

/** @param {string} name */
function wordsOf(name) {
  return name.toLowerCase().replace(/color/g, 'colour').split(/[-_\s]+/).filter(Boolean);
}

/** @param {string} name */
function plain(name) {
  return wordsOf(name).join('');
}

/**
 * How many letters are left out, added, changed, or changed places with the next one.
 * @type {(a: string, b: string) => number}
 */
function mistakes(a, b) {
  /** @type {number[]} */
  let before = [];
  let row = Array.from({ length: b.length + 1 }, (_, at) => at);
  for (let i = 1; i <= a.length; i += 1) {
    const next = [i];
    for (let j = 1; j <= b.length; j += 1) {
      const changed = row[j - 1] + Number(a[i - 1] !== b[j - 1]);
      const swapped = a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1] ? before[j - 2] + 1 : Infinity;
      next[j] = Math.min(changed, row[j] + 1, next[j - 1] + 1, swapped);
    }
    [before, row] = [row, next];
  }
  return row[b.length];
}
