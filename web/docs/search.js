/** The search of the documentation: all its sections, which one file holds, by the words that are typed. */

/** A section: its anchor, its heading and its text. @typedef {[string, string, string]} Section */
/** @typedef {{name: string, title: string, sections: Section[]}} Page */
/** @typedef {{address: string, title: string, heading: string, text: string, score: number}} Found */

/** So many results are shown. */
const MOST = 20;
/** Characters before and behind the first word in the text of a result. */
const AROUND = 80;

/**
 * The sections that contain every word, best first: a word counts most in a heading, more as the beginning of a word
 * than within one, and more where it is frequent.
 * @param {Page[]} pages @param {string[]} words  In lower case.
 * @returns {Found[]}
 */
export function sectionsWith(pages, words) {
  const found = pages.flatMap(({ name, title, sections }) =>
    sections.map(([anchor, heading, text]) => {
      const scores = words.map((word) => 8 * weight(heading, word) + 2 * weight(title, word) + weight(text, word));
      const score = scores.includes(0) ? 0 : scores.reduce((sum, one) => sum + one, 0);
      return { address: `${name}.html#${anchor}`, title, heading, text, score };
    }),
  );
  return found.filter(({ score }) => score > 0).sort((one, other) => other.score - one.score);
}

/** @param {string} text @param {string} word */
function weight(text, word) {
  const parts = text.toLowerCase().split(word);
  const beginnings = parts.slice(0, -1).filter((before) => !/[\p{L}\p{N}]$/u.test(before)).length;
  return Math.min(beginnings, 3) + Math.min(parts.length - 1, 3) / 4;
}

/** The words of a query. @param {string} query */
export const wordsOf = (query) => query.toLowerCase().split(/\s+/).filter(Boolean);

/**
 * Searches while the reader types. The file of sections is fetched when the field is first used.
 * @param {HTMLFormElement} form @param {HTMLInputElement} field @param {HTMLElement} place  For the results.
 */
export function search(form, field, place) {
  const status = /** @type {HTMLElement} */ (place.querySelector('[role="status"]'));
  const list = /** @type {HTMLElement} */ (place.querySelector('ol'));
  const index = new URL(field.dataset.index ?? '', location.href);
  /** @type {Promise<Page[]> | undefined} */
  let loading;
  const pages = () => {
    loading ??= fetch(index, { signal: AbortSignal.timeout(30_000) }).then((answer) => {
      if (!answer.ok) throw new Error(`status ${answer.status}`);
      return answer.json();
    });
    return loading;
  };
  const show = async () => {
    const words = wordsOf(field.value);
    place.hidden = words.length === 0;
    if (place.hidden) return;
    try {
      const results = sectionsWith(await pages(), words);
      if (wordsOf(field.value).join() !== words.join()) return;
      const more = results.length > MOST ? `, the best ${MOST} of which follow` : '';
      status.textContent = `${results.length} ${results.length === 1 ? 'section' : 'sections'}${more}`;
      list.replaceChildren(...results.slice(0, MOST).map((result) => entry(result, words, index)));
    } catch {
      // The next key tries again.
      loading = undefined;
      status.textContent = 'The search did not load.';
      list.replaceChildren();
    }
  };
  field.addEventListener('focus', () => pages().catch(() => (loading = undefined)), { once: true });
  field.addEventListener('input', show);
  form.addEventListener('submit', (event) => event.preventDefault());
  list.addEventListener('click', () => {
    // The section that was looked for is not below its own results.
    place.hidden = true;
  });
  form.hidden = false;
}

/** @param {Found} found @param {string[]} words @param {URL} index */
function entry({ address, title, heading, text }, words, index) {
  const link = document.createElement('a');
  link.href = new URL(address, index).href;
  link.textContent = heading === title ? title : `${title}: ${heading}`;
  const excerpt = document.createElement('p');
  excerpt.append(...excerptOf(text, words));
  const item = document.createElement('li');
  item.append(link, excerpt);
  return item;
}

/** The text around the first word, with that word marked. @param {string} text @param {string[]} words */
function excerptOf(text, words) {
  const lower = text.toLowerCase();
  const word = words.find((one) => lower.includes(one)) ?? '';
  const at = Math.max(lower.indexOf(word), 0);
  const mark = document.createElement('mark');
  mark.textContent = text.slice(at, at + word.length);
  // Whole words.
  const start = at > AROUND ? text.indexOf(' ', at - AROUND) + 1 : 0;
  const end = at + word.length + AROUND;
  const before = (start > 0 ? '… ' : '') + text.slice(Math.min(start, at), at);
  return [before, mark, text.slice(at + word.length, end) + (end < text.length ? ' …' : '')];
}
