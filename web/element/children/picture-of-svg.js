/**
 * An inline SVG element as an image of its own, which has no style of the page, none of its elements and none of its
 * fonts: the copy carries the computed style and what it refers to elsewhere in the document, and texts in fonts of the
 * page are drawn over it.
 */

import { MAX_DRAWN, elementsDrawn } from '../../mask/svg-elements.js';

/** The most elements of a copy. */
const MAX_ELEMENTS = 1000;

/** The properties of the page's style that elements of an SVG inherit, and those that they do not. */
const INHERITED = beginning(
  'clip-rule|color$|direction|dominant-|(fill|font|marker|stroke)(-|$)|(letter|word)-sp|paint-o|text-[ar]|visib|white-',
  'writing',
);
const OWN = beginning(
  'alignment-|baseline-s|clip-path|[cr]?[xy]$|[dr]$|width|height|display|filter|(flood|mask|offset|overflow|stop)-',
  'isol|light|mix-|opacity|rotate|scale|trans(form|late)|vector-',
);

/** Elements that are drawn only where others refer to them, or not at all, whatever `display` is. */
const UNDRAWN = /^(clipPath|defs|desc|filter|(linear|radial)Gradient|marker|mask|metadata|pattern|symbol|title)$/;

/** A value that an element has by itself. */
const INITIAL = /^(none|auto|normal)$/;

const REFERENCE = /url\((["']?)(.*?)\1\)/g;
const XLINK = 'http://www.w3.org/1999/xlink';

/** Why a copy would differ. */
class Difference extends Error {}
const FOREIGN = 'it contains HTML';
const FILE = 'it refers to another file';
const FONT = 'a part of its text has a font that only the page has';
const LARGE = `it has more than ${MAX_ELEMENTS} elements, or draws more than ${MAX_DRAWN}`;

/** @typedef {import('../../mask/opacity.js').Context} Context */

/** The elements that animate others. */
const ANIMATIONS = 'animate,animateMotion,animateTransform,set';

/** Whether an animation of its own elements runs in an SVG. @param {Element} element */
export function isAnimated(element) {
  return [...element.querySelectorAll(ANIMATIONS)].some((animation) => {
    const { ownerSVGElement } = /** @type {SVGElement} */ (animation);
    const repeats = animation.getAttribute('repeatCount') ?? (animation.hasAttribute('repeatDur') ? 'indefinite' : '1');
    try {
      const { getStartTime, getSimpleDuration } = SVGAnimationElement.prototype;
      const since = (ownerSVGElement?.getCurrentTime() ?? 0) - getStartTime.call(animation);
      return (
        since >= 0 && (repeats === 'indefinite' || since < getSimpleDuration.call(animation) * parseFloat(repeats))
      );
    } catch {
      // It has not begun, or it sets a value without end.
      return false;
    }
  });
}

/** Gives the copy of what an animation changes the present value. @type {(animation: Element, clone: SVGElement) => void} */
function freeze(animation, clone) {
  const target = /** @type {any} */ (animation).targetElement;
  const name = animation.getAttribute('attributeName') ?? '';
  if (/Motion|Transform/.test(animation.localName)) {
    const { a, b, c, d, e, f } = target.parentElement.getScreenCTM().inverse().multiply(target.getScreenCTM());
    const none = { translate: 'none', rotate: 'none', scale: 'none', offset: 'none' };
    Object.assign(clone.style, none, { transform: `matrix(${[a, b, c, d, e, f]})`, transformOrigin: '0 0' });
  } else if (name === 'points') {
    const points = Array.from(target.animatedPoints, ({ x, y }) => [x, y]);
    clone.setAttribute(name, `${points}`);
  } else {
    const now = target[name]?.animVal;
    const value = now?.[0]?.value ?? now?.value ?? now;
    if (/number|string/.test(typeof value)) clone.setAttribute(name, value);
  }
}

/** Names that begin so. @param {...string} parts */
function beginning(...parts) {
  return RegExp(`^(${parts.join('|')})`);
}

/**
 * An image of an SVG element, and what draws the texts that it lacks; as a string, the reason why there is no image.
 * Undefined if its key is known.
 * @param {SVGSVGElement} svg
 * @param {{width: number, height: number}} size of its content box
 * @param {string} known
 * @returns {Promise<{image: HTMLImageElement, drawTexts: (context: Context) => void, key: string} | string | undefined>}
 */
export async function imageOfSvg(svg, size, known) {
  try {
    const { copy, texts } = copyOf(svg);
    const css = getComputedStyle(svg);
    if (!copy.hasAttribute('viewBox'))
      copy.setAttribute('viewBox', `0 0 ${parseFloat(css.width)} ${parseFloat(css.height)}`);
    copy.setAttribute('width', `${size.width}`);
    copy.setAttribute('height', `${size.height}`);
    const text = new XMLSerializer().serializeToString(copy);
    if (elementsDrawn(text) > MAX_DRAWN) return LARGE;
    const key = text + texts.map((element) => [getComputedStyle(element).fill, getComputedStyle(element).stroke]);
    if (key === known) return undefined;
    const image = new Image();
    image.src = `data:image/svg+xml,${encodeURIComponent(text)}`;
    await image.decode().catch(() => {});
    const drawTexts = (/** @type {Context} */ context) => {
      for (const element of texts) drawText(context, element);
    };
    return { image, drawTexts, key };
  } catch (error) {
    if (error instanceof Difference) return error.message;
    throw error;
  }
}

/**
 * A copy with its style and all that it refers to, and the texts that are left out of it.
 * @param {SVGSVGElement} svg
 * @throws {Difference}
 */
function copyOf(svg) {
  const root = /** @type {Document | ShadowRoot} */ (svg.getRootNode());
  const names = [...getComputedStyle(svg)].filter((name) => INHERITED.test(name) || OWN.test(name));
  const families = new Set([...document.fonts].map(({ family }) => unquoted(family)));
  /** @type {SVGElement[]} */
  const texts = [];
  /** What is copied, and whether a `<use>` gives it what it inherits. @type {Map<Element, boolean>} */
  const taken = new Map([[svg, false]]);
  const copies = [];
  let count = 0;
  /** The name of an element of this document, which is copied too; undefined for another address. */
  const local = (/** @type {string} */ address, isUse = false) => {
    const id = /^(.*?)#(.+)$/.exec(address);
    if (!id || (id[1] && id[1] !== document.URL.split('#')[0])) return undefined;
    const found = root.getElementById(id[2]);
    if (found && ![...taken.keys()].some((element) => element.contains(found))) taken.set(found, isUse);
    return `#${id[2]}`;
  };
  for (const [source, inherits] of taken) {
    const copy = /** @type {Element} */ (source.cloneNode(true));
    const elements = [source, ...source.querySelectorAll('*')];
    count += elements.length;
    if (count > MAX_ELEMENTS) throw new Difference(LARGE);
    const clones = /** @type {SVGElement[]} */ ([copy, ...copy.querySelectorAll('*')]);
    elements.forEach((element, at) => {
      const clone = clones[at];
      if (!(element instanceof SVGElement) || element.localName === 'style') return;
      const css = getComputedStyle(element);
      if (element.localName === 'foreignObject' && css.display !== 'none') throw new Difference(FOREIGN);
      refer(element, clone, local);
      const isFirst = element === source && !inherits;
      restyle(element, clone, css, isFirst ? undefined : element.parentElement, names, local);
      if (element === svg || !(element instanceof SVGTextContentElement)) return;
      if (!ofPage(css.fontFamily, families) || !ownText(element)) return;
      if (source !== svg || element.closest('defs,symbol,clipPath,mask,pattern,marker')) throw new Difference(FONT);
      if (glyphsOf(element) === undefined) throw new Difference(FONT);
      texts.push(element);
      clone.style.setProperty('fill', 'none');
      clone.style.setProperty('stroke', 'none');
    });
    for (const animation of source.querySelectorAll(ANIMATIONS)) {
      const clone = clones[elements.indexOf(/** @type {any} */ (animation).targetElement)];
      if (clone) freeze(animation, clone);
    }
    for (const unneeded of copy.querySelectorAll(`style,${ANIMATIONS}`)) unneeded.remove();
    copies.push(copy);
  }
  const [copy, ...others] = /** @type {SVGSVGElement[]} */ (copies);
  // As for images, the opacity of the whole does not count, nor does its place.
  for (const name of [...copy.style].filter((name) => OWN.test(name))) copy.style.removeProperty(name);
  copy.removeAttribute('opacity');
  // The first element of an id counts, as on the page.
  copy.prepend(document.createElementNS(svg.namespaceURI, 'defs'));
  copy.firstElementChild?.append(...others);
  return { copy, texts };
}

/**
 * Lets a copy have the style of an element. Values that it inherits in both are left out, because a `<use>` may give
 * others.
 * @param {SVGElement} element
 * @param {SVGElement} clone
 * @param {CSSStyleDeclaration} css
 * @param {Element | null | undefined} parent
 * @param {string[]} names
 * @param {(address: string) => string | undefined} local
 */
function restyle(element, clone, css, parent, names, local) {
  const above = parent && getComputedStyle(parent);
  const own = element.style;
  clone.removeAttribute('style');
  clone.removeAttribute('class');
  for (const name of names) {
    const value = css.getPropertyValue(name);
    const stated = element.hasAttribute(name) || own.getPropertyValue(name);
    if (INHERITED.test(name)) {
      if (above && !stated && value === above.getPropertyValue(name)) continue;
    } else if (INITIAL.test(value) && (name !== 'display' || UNDRAWN.test(element.localName))) {
      // Some browsers have no value for the attribute `transform`.
      if (!stated || name === 'transform' || UNDRAWN.test(element.localName)) continue;
    } else if (/^(width|height)$/.test(name) && /^(use|symbol)$/.test(element.localName)) {
      continue;
    }
    clone.style.setProperty(
      name,
      value.replace(REFERENCE, (_, _quote, address) => {
        const named = address.startsWith('data:') ? address : local(address);
        if (named === undefined) throw new Difference(FILE);
        return `url("${named}")`;
      }),
    );
  }
}

/**
 * Lets a copy refer to what the element refers to by its address.
 * @param {SVGElement} element
 * @param {SVGElement} clone
 * @param {(address: string, isUse: boolean) => string | undefined} local
 */
function refer(element, clone, local) {
  const address = element.getAttribute('href') ?? element.getAttributeNS(XLINK, 'href');
  if (!address || /^(a|script)$/.test(element.localName) || address.startsWith('data:')) return;
  const named = local(address, element.localName === 'use');
  if (named === undefined) throw new Difference(FILE);
  clone.removeAttributeNS(XLINK, 'href');
  clone.setAttribute('href', named);
}

/** A name of a font without its quotes. @param {string} family */
const unquoted = (family) => family.trim().replace(/^(["'])(.*)\1$/, '$2');

/** Whether a font of the page is in a list. @param {string} list @param {Set<string>} families */
const ofPage = (list, families) => list.split(',').some((family) => families.has(unquoted(family)));

/** The text that an element itself has, not its children. @param {Element} element */
const ownText = (element) =>
  [...element.childNodes].some(({ nodeType, nodeValue }) => nodeType === Node.TEXT_NODE && nodeValue?.trim());

/**
 * The characters of a text of an SVG that have a place each; undefined where they cannot be told apart.
 * @param {SVGTextContentElement} element
 */
function glyphsOf(element) {
  if (element.children.length > 0 || getComputedStyle(element).textTransform !== 'none') return undefined;
  const text = (element.textContent ?? '').replace(/\s+/g, ' ');
  const count = element.getNumberOfChars();
  return [text, text.trimStart(), text.trimEnd(), text.trim()].find(({ length }) => length === count);
}

/**
 * Draws the glyphs of a text where they are on the page.
 * @param {Context} context in pixels of the window
 * @param {SVGElement} element
 */
function drawText(context, element) {
  const text = /** @type {SVGTextContentElement} */ (element);
  const matrix = text.getScreenCTM();
  const { font, fill, stroke, strokeWidth } = getComputedStyle(text);
  if (!matrix) return;
  context.save();
  context.transform(matrix.a, matrix.b, matrix.c, matrix.d, matrix.e, matrix.f);
  Object.assign(context, { font, lineWidth: parseFloat(strokeWidth) });
  let at = 0;
  for (const glyph of glyphsOf(text) ?? '') {
    const { x, y } = text.getStartPositionOfChar(at);
    context.save();
    context.translate(x, y);
    context.rotate((text.getRotationOfChar(at) * Math.PI) / 180);
    if (fill !== 'none') context.fillText(glyph, 0, 0);
    if (stroke !== 'none') context.strokeText(glyph, 0, 0);
    context.restore();
    at += glyph.length;
  }
  context.restore();
}
