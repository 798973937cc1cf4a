/**
 * Reads JSDoc: its text, and its tags with type, name and text.
 *
 * @typedef {{tag: string, type: string, name: string, optional: boolean, text: string}} Tag
 */

/** Tags whose text begins with a name. */
const NAMED = ['param', 'template', 'fires', 'slot', 'csspart', 'cssproperty', 'cssstate'];

/**
 * The JSDoc of a node of the compiler's syntax tree: its last comment, or that at `at`.
 * @param {any} node
 * @param {number} [at]
 */
export function read(node, at = -1) {
  const text = [...(node.jsDoc ?? [])].at(at)?.getText() ?? '';
  const [doc, ...tags] = text
    .replace(/^\/\*\*|\*\/$/g, '')
    .replace(/^[ \t]*\* ?/gm, '')
    .split(/(?<=^|\s)@(?=[a-z]+\b)/);
  const all = tags.map(tagOf);
  return {
    doc: joined(doc),
    /** @param {string} tag */
    all: (tag) => all.filter((entry) => entry.tag === tag),
    /** @param {string} tag */
    first: (tag) => all.find((entry) => entry.tag === tag),
  };
}

/** @type {(text: string) => Tag} */
function tagOf(text) {
  const [, tag, after] = /** @type {RegExpMatchArray} */ (/^([a-z]+)\s*([\s\S]*)$/.exec(text));
  const end = after.startsWith('{') ? closing(after) : 0;
  const type = end > 0 ? joined(after.slice(1, end - 1)) : '';
  const rest = joined(after.slice(end));
  if (!NAMED.includes(tag)) return { tag, type, name: '', optional: false, text: rest };
  const [, bracketed, plain, words] = /** @type {RegExpMatchArray} */ (/^(?:\[([^\]]*)\]|(\S+))\s*(.*)$/.exec(rest));
  return { tag, type, name: bracketed ?? plain, optional: bracketed !== undefined, text: words };
}

/** Where the first brace of a text is closed. @param {string} text */
function closing(text) {
  let depth = 0;
  for (let at = 0; at < text.length; at += 1) {
    if (text[at] === '{') depth += 1;
    if (text[at] === '}') depth -= 1;
    if (depth === 0) return at + 1;
  }
  throw new Error(`a brace is open: ${text}`);
}

/** The lines as a single line. @param {string} text */
function joined(text) {
  return text.replace(/\s+/g, ' ').trim();
}
