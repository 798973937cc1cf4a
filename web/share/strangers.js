/** What other programs do to an address on its way. */

/** What mail and chat programs, keyboards and editors put between letters. */
const UNSEEN = '\\u00ad\\u200b-\\u200f\\u2060\\ufeff';
export const BLANKS = RegExp(`[\\s${UNSEEN}]+`, 'g');
const WITHIN = RegExp(`[\\r\\n${UNSEEN}]+`, 'g');

/** What follows an address in a sentence. */
const AFTER = /[\s.,;:!?)>\]"'’”»]+$/;

/** The parameters whose texts may end so. */
const TEXTS = /^(alt|objects)$/;

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
  if (last && !TEXTS.test(last[0])) last[1] = last[1].replace(AFTER, '');
  return new URLSearchParams(all);
}
