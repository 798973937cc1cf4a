/**
 * How many elements an SVG draws: a `<use>` draws again what it names, and nested ones multiply. Counting takes the
 * time of the text, drawing that of the product.
 */

/** The most elements that are drawn. */
export const MAX_DRAWN = 20_000;

/** @typedef {{children: Node[], use: string}} Node */

/** A tag: whether it closes, its attributes, and whether it is empty. */
const TAG = /<(\/?)([a-z_][\w:.-]*)((?:"[^"]*"|'[^']*'|[^"'>])*?)(\/?)>/gi;

/**
 * The number of elements that an SVG draws.
 * @param {string} svg  Its text.
 */
export function elementsDrawn(svg) {
  /** @type {Node} */
  const root = { children: [], use: '' };
  const open = [root];
  /** @type {Map<string, Node>} */
  const named = new Map();
  for (const [, closes, name, attributes, isEmpty] of svg
    .replace(/<!--[\s\S]*?-->|<!\[CDATA\[[\s\S]*?\]\]>/g, '')
    .matchAll(TAG)) {
    if (closes) {
      if (open.length > 1) open.pop();
      continue;
    }
    const attributeOf = (/** @type {RegExp} */ pattern) => attributes.match(pattern)?.[2] ?? '';
    const use = /^(\w+:)?use$/i.test(name) ? attributeOf(/[\s:]href\s*=\s*(["'])\s*#(.*?)\1/) : '';
    const node = { children: [], use };
    open[open.length - 1].children.push(node);
    const id = attributeOf(/\sid\s*=\s*(["'])(.*?)\1/);
    if (id && !named.has(id)) named.set(id, node);
    if (!isEmpty) open.push(node);
  }
  /** @type {Map<Node, number>} */
  const counts = new Map();
  /** @type {(node: Node | undefined) => number} */
  const count = (node) => {
    if (!node) return 0;
    const known = counts.get(node);
    if (known !== undefined) return known;
    // What shows itself is drawn once.
    counts.set(node, 0);
    let sum = 1 + count(named.get(node.use));
    for (const child of node.children) sum += count(child);
    counts.set(node, sum);
    return sum;
  };
  return count(root) - 1;
}
