/**
 * Texts of others as messages repeat them.
 */

/** Characters that control a terminal, have no width or turn a text around. */
const UNSEEN = /[\p{Cc}\p{Bidi_Control}\u200b-\u200d\u2028\u2029\u2060-\u206f\ufeff]/gu;

/** The longest list of names in a message, in characters. */
const LONGEST_LIST = 160;

/** The start of a text, in which unseen characters are escaped. @param {string} text @param {number} [longest] */
export function cut(text, longest = 40) {
  // A letter outside of the basic plane is two characters, and half of it is none.
  const end = text.length > longest ? longest - Number(/[\ud800-\udbff]/.test(text[longest - 1])) : text.length;
  const start = text
    .slice(0, end)
    .replace(UNSEEN, (letter) => `\\u${letter.charCodeAt(0).toString(16).padStart(4, '0')}`);
  return end < text.length ? `${start}…` : start;
}

/** The first of many names and the number of the others. @param {readonly string[]} names */
export function listed(names) {
  let all = names.length;
  while (names.slice(0, all).join(', ').length > LONGEST_LIST) all -= 1;
  const shown = names.slice(0, all).join(', ');
  return all < names.length ? `${shown} and ${names.length - all} more` : shown;
}
