/**
 * The markup of an example, which a reader may change and a link may bring: it is read, and only what is allowed becomes
 * elements. There is no script, no handler, no foreign address and no style sheet among it, so an example runs in its
 * page under the strict policy of that page.
 */

/** @typedef {{name: string, attributes: [string, string][], styles: [string, string][], children: Markup[]}} Tag */
/** A text, or an element with what it contains. @typedef {string | Tag} Markup */

/** The elements. */
const ELEMENTS = 'b div em h1 h2 h3 header hearth-fire hearth-solid hearth-source img p span strong'.split(' ');
/** The attributes of those that are not Hearth's, besides `style`; a fire checks its own. */
const ATTRIBUTES = 'alt height id slot src width'.split(' ');
/** The attributes with an address, of all elements. */
const ADDRESSES = ['poster', 'src'];
/** The functions in values of styles: none of them names a file. */
const FUNCTIONS = 'calc clamp hsl linear-gradient max min radial-gradient rgb rotate translate'.split(' ');
/** The most characters of a text, and the most elements and fires in it. */
export const LONGEST = 8192;
const MOST = { elements: 100, fires: 6 };

const NAME = /^[a-z][a-z0-9-]*/;
const ENTITIES = { amp: '&', gt: '>', lt: '<', quot: '"' };

/**
 * What a text says.
 * @param {string} text @returns {Markup[]}
 * @throws {RangeError} for what is not allowed, by its name and with what is
 */
export function markupOf(text) {
  if (text.length > LONGEST) throw new RangeError(`The text has ${text.length} characters; allowed are ${LONGEST}.`);
  const reader = new Reader(text);
  const markup = reader.children('');
  if (reader.fires === 0) throw new RangeError('There is no <hearth-fire>.');
  return markup;
}

/** Reads a text from its beginning to its end. */
class Reader {
  fires = 0;
  #elements = 0;
  #text;
  #at = 0;

  /** @param {string} text */
  constructor(text) {
    this.#text = text.trim();
  }

  /** Takes what matches next, or nothing. @param {RegExp} pattern  Begins with `^`. */
  #take(pattern) {
    const [found = ''] = this.#text.slice(this.#at).match(pattern) ?? [];
    this.#at += found.length;
    return found;
  }

  /** What an element contains, with its end. @param {string} name  Empty: the whole text. @returns {Markup[]} */
  children(name) {
    /** @type {Markup[]} */
    const children = [];
    for (;;) {
      const text = this.#take(/^[^<]+/);
      if (text) children.push(decoded(text));
      if (this.#at === this.#text.length) {
        if (name) throw new RangeError(`<${name}> is not closed.`);
        return children;
      }
      this.#at += 1;
      if (!this.#take(/^\//)) {
        children.push(this.#tag());
        continue;
      }
      const closed = this.#take(NAME);
      if (!this.#take(/^\s*>/)) throw new RangeError(`The tag </${closed} has no end.`);
      if (closed !== name) throw new RangeError(`</${closed}> closes ${name ? `<${name}>` : 'nothing'}.`);
      return children;
    }
  }

  /** An element, behind its `<`. @returns {Tag} */
  #tag() {
    const name = this.#take(NAME);
    if (!ELEMENTS.includes(name)) {
      const written = name || this.#take(/^[^\s>]{0,20}/);
      throw new RangeError(`<${written}> is not allowed; allowed are ${ELEMENTS.join(', ')}.`);
    }
    this.#elements += 1;
    this.fires += Number(name === 'hearth-fire');
    if (this.#elements > MOST.elements) throw new RangeError(`There are more than ${MOST.elements} elements.`);
    if (this.fires > MOST.fires) throw new RangeError(`There are more than ${MOST.fires} fires.`);
    /** @type {Tag} */
    const tag = { name, attributes: [], styles: [], children: [] };
    while (!this.#take(/^\s*>/)) {
      if (!this.#take(/^\s+/)) throw new RangeError(`The tag <${name} has no end.`);
      this.#attribute(tag);
    }
    if (name !== 'img') tag.children = this.children(name);
    return tag;
  }

  /** Adds an attribute to a tag. @param {Tag} tag */
  #attribute(tag) {
    const attribute = this.#take(NAME);
    const known = tag.name.startsWith('hearth-') || [...ATTRIBUTES, 'style'].includes(attribute);
    if (!attribute || !known || attribute.startsWith('on')) {
      const written = attribute || this.#take(/^[^\s>]{0,20}/);
      throw new RangeError(`<${tag.name}> has "${written}"; allowed are ${ATTRIBUTES.join(', ')} and style.`);
    }
    if (tag.attributes.some(([name]) => name === attribute)) throw new RangeError(`"${attribute}" is there twice.`);
    const quoted = this.#take(/^="[^"]*"/);
    if (!quoted && this.#take(/^\s*=/)) throw new RangeError(`The value of "${attribute}" needs double quotes.`);
    const value = decoded(quoted.slice(2, -1));
    if (attribute === 'style') tag.styles = stylesOf(value);
    else tag.attributes.push([attribute, ADDRESSES.includes(attribute) ? addressOf(value) : plain(attribute, value)]);
  }
}

/** The characters that a text means. @param {string} text */
function decoded(text) {
  return text.replace(/&(#?\w+);/g, (entity, name) => {
    if (Object.hasOwn(ENTITIES, name)) return ENTITIES[/** @type {keyof typeof ENTITIES} */ (name)];
    throw new RangeError(`${entity} is not known: write the character itself.`);
  });
}

/** The address, seen from a page of the documentation, of a file of the site. @param {string} value */
function addressOf(value) {
  if (/^\.\/web\/[\w./-]+$/.test(value) && !value.includes('..')) return `.${value}`;
  throw new RangeError(`"${value.slice(0, 100)}" is no file of ./web/.`);
}

/** A value that names no address. @param {string} attribute @param {string} value */
function plain(attribute, value) {
  if (!/\/\/|^\s*(data|blob|javascript):/i.test(value)) return value;
  throw new RangeError(`"${attribute}" must not contain an address.`);
}

/** The properties of a style. @param {string} style @returns {[string, string][]} */
function stylesOf(style) {
  const heads = new RegExp(`(?<![\\w-])(${FUNCTIONS.join('|')})\\(|\\)`, 'g');
  const declarations = style.split(';').filter((declaration) => declaration.trim());
  return declarations.map((declaration) => {
    const [property, value = '', ...more] = declaration.split(':').map((part) => part.trim());
    const rest = value.replace(heads, ' ').replace(/(^|[\s,])\(/g, ' ');
    if (/^[a-z]+(-[a-z]+)*$/.test(property) && /^[\w\s#%.,+*/-]+$/.test(rest) && !value.includes('//') && !more.length)
      return [property, value];
    throw new RangeError(`The style "${declaration.trim().slice(0, 100)}" is no property with a plain value.`);
  });
}

/**
 * Adds what a text says to a node of the page.
 * @param {Element} parent @param {Markup[]} markup
 */
export function build(parent, markup) {
  for (const part of markup) {
    if (typeof part === 'string') parent.append(part);
    else {
      const element = document.createElement(part.name);
      for (const [name, value] of part.attributes) element.setAttribute(name, value);
      setStyles(element, part.styles);
      build(element, part.children);
      // The children of a fire are there when it begins.
      parent.append(element);
    }
  }
}

/**
 * Changes elements from one text to another one, so that a fire burns on.
 * @param {Element} parent @param {Markup[]} before  What built them. @param {Markup[]} after
 */
export function change(parent, before, after) {
  if (!isAlike(before, after)) {
    parent.replaceChildren();
    build(parent, after);
    return;
  }
  for (const [at, part] of after.entries()) {
    const [node, was] = [parent.childNodes[at], before[at]];
    if (typeof part === 'string' || typeof was === 'string') {
      if (part !== was) node.textContent = String(part);
      continue;
    }
    const element = /** @type {HTMLElement} */ (node);
    const kept = part.attributes.map(([name]) => name);
    for (const [name] of was.attributes) if (!kept.includes(name)) element.removeAttribute(name);
    for (const [name, value] of part.attributes) {
      if (!was.attributes.some((other) => other[0] === name && other[1] === value)) element.setAttribute(name, value);
    }
    if (String(part.styles) !== String(was.styles)) setStyles(element, part.styles);
    change(element, was.children, part.children);
  }
}

/** The same elements around the same number of texts. @type {(one: Markup[], other: Markup[]) => boolean} */
function isAlike(one, other) {
  if (one.length !== other.length) return false;
  return one.every((part, at) => {
    const second = other[at];
    if (typeof part === 'string' || typeof second === 'string') return typeof part === typeof second;
    return part.name === second.name && isAlike(part.children, second.children);
  });
}

/**
 * The policy of the page refuses styles in attributes, not those that a script sets.
 * @param {HTMLElement} element @param {[string, string][]} styles
 */
function setStyles({ style }, styles) {
  style.cssText = '';
  for (const [property, value] of styles) style.setProperty(property, value);
}
