/**
 * Suggestions for unknown names, and warnings about unknown attributes. This code is loaded with the
 * first such name.
 */

import { DEFAULTS, OWN_ATTRIBUTES } from '../../generated/defaults.js';
import { cut } from '../../quoted.js';

/** Maximum number of suggestions. */
const MAX_SUGGESTIONS = 3;

/**
 * Attributes of every element, and attributes that frameworks and libraries add: with a prefix of one
 * or two letters, or with characters that HTML does not use.
 */
const FOREIGN = new RegExp(
  [
    '^(accesskey|autocapitalize|autocorrect|autofocus|class|contenteditable|dir|draggable|elementtiming|enterkeyhint',
    'exportparts|hidden|id|inert|inputmode|is|lang|nonce|part|popover|role|slot|spellcheck|style|tabindex|title',
    'translate|writingsuggestions)$|^(aria|data|astro|wire|jsaction|jscontroller|jsname)|^on|^item|^xml|^[a-z]{1,2}-',
    '^_|[^a-z0-9_-]',
  ].join('|'),
);

const KNOWN = [...OWN_ATTRIBUTES, ...Object.keys(DEFAULTS).map((id) => id.replaceAll('_', '-'))];

/** The names that have been warned about. */
const WARNED = new Set();

/**
 * Warns once about an attribute without an effect. Attributes of HTML, frameworks and libraries are left
 * out.
 * @param {string} name
 * @param {string} [element] the name of its element
 * @param {string[]} [known] the attributes of that element
 */
export function warnOnce(name, element = 'hearth-fire', known = KNOWN) {
  const key = `${element} ${name}`;
  if (WARNED.has(key) || FOREIGN.test(name)) return;
  WARNED.add(key);
  const size = ['width', 'height'].includes(name) ? ' Its style sets its size.' : '';
  console.warn(`<${element}>: it has no attribute ${cut(name)}${suggestion(name, known)}${size}`);
}

/** The fires that have been warned about. @type {WeakSet<Element>} */
const LOSING = new WeakSet();

/**
 * Warns once about content of a fire that it does not show: HTML has no self-closing elements, so that `<hearth-fire />`
 * contains the rest of the page.
 * @param {Element} fire
 */
export function warnOfContent(fire) {
  const objects = 'hearth-source,hearth-solid';
  const lost = [...fire.children].find(
    (child) => !child.matches(`[slot],${objects},link,noscript,script,style,template`) && !child.querySelector(objects),
  );
  if (!lost || LOSING.has(fire)) return;
  LOSING.add(fire);
  const name = cut(lost.localName);
  const near = name.startsWith('hearth-') && name !== 'hearth-fire' ? alike(name, objects.split(','), 3) : [];
  const remedy =
    near.length > 0
      ? `did you mean <${near[0]}>?`
      : 'close the fire by </hearth-fire> before it, or give it slot="poster" to show it until the fire burns.';
  console.warn(`<hearth-fire>: <${name}> inside it is not shown; ${remedy}`);
}

/**
 * A question for the names that may be meant, as the end of a sentence; a full stop if none is similar.
 * @param {string} name
 * @param {string[]} names
 */
export function suggestion(name, names) {
  const near = nearest(name, names);
  return near.length > 0 ? `; did you mean ${near.join(', ').replace(/, ([^,]*)$/, ' or $1')}?` : '.';
}

/**
 * The names that may be meant. In this order: equal but for case and separators; longer by words; with
 * few spelling mistakes; shorter by words.
 * @param {string} name
 * @param {string[]} names
 * @returns {string[]}
 */
export function nearest(name, names) {
  const [letters, words] = [plain(name), wordsOf(name)];
  const same = names.filter((known) => plain(known) === letters);
  const longer = names.filter((known) => words.every((word) => wordsOf(known).includes(word)));
  const shorter = names.filter((known) => wordsOf(known).every((word) => words.includes(word)));
  const found = [same, longer, alike(name, names, Math.max(1, Math.floor(letters.length / 4))), shorter];
  return (found.find(({ length }) => length > 0) ?? []).slice(0, MAX_SUGGESTIONS);
}

/**
 * The names with the fewest spelling mistakes.
 * @param {string} name
 * @param {string[]} names
 * @param {number} max the maximum number of mistakes
 */
export function alike(name, names, max) {
  const distances = names.map((known) => distance(plain(name), plain(known)));
  const min = Math.min(...distances, max);
  return names.filter((_, at) => distances[at] === min);
}

/** @param {string} name */
function wordsOf(name) {
  return name
    .toLowerCase()
    .replace(/color/g, 'colour')
    .split(/[-_\s]+/)
    .filter(Boolean);
}

/** @param {string} name */
function plain(name) {
  return wordsOf(name).join('');
}

/**
 * The Damerau–Levenshtein distance: letters that are missing, added, changed or transposed.
 * @type {(a: string, b: string) => number}
 */
function distance(a, b) {
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
