/** What other programs do to an address on its way. */

/** What mail and chat programs, keyboards and editors put between letters. */
const UNSEEN = '\\u00ad\\u200b-\\u200f\\u2060\\ufeff';
export const BLANKS = RegExp(`[\\s${UNSEEN}]+`, 'g');
const WITHIN = RegExp(`[\\r\\n${UNSEEN}]+`, 'g');

/** What follows an address in a sentence. */
const AFTER = /[\s.,;:!?)>\]"'’”»]$/;

/** The brackets that a value may have itself, as that of a colour. */
const OPENING = new Map(Object.entries({ ')': '(', ']': '[', '>': '<' }));

/** The parameters whose texts may end so. */
const TEXTS = /^(alt|objects)$/;

/** A value without what follows an address. @param {string} text */
function withoutRest(text) {
  const count = (/** @type {string} */ letter) => text.split(letter).length;
  while (AFTER.test(text)) {
    const last = text.slice(-1);
    const opening = OPENING.get(last);
    if (opening && count(opening) >= count(last)) return text;
    text = text.slice(0, -1);
  }
  return text;
}

/**
 * The parameters of an address: `&amp;` is an ampersand, characters without a width and ends of lines are nothing, and
 * what follows an address in a sentence is no part of the last value.
 * @param {string | URLSearchParams} search
 */
export function parametersOf(search) {
  const all = [...new URLSearchParams(search)].map(([name, value]) => [
    name.replace(/^(amp;)+/, ''),
    value.replace(WITHIN, ''),
  ]);
  const last = all.at(-1);
  if (last && !TEXTS.test(last[0])) last[1] = withoutRest(last[1]);
  return new URLSearchParams(all);
}
