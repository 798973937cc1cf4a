/**
 * The glyphs of a text as they are laid out: each word is drawn where the page shows it, in runs where the page breaks
 * it, mixes directions or takes letters one by one.
 *
 * @typedef {import('./child-picture.js').Drawing} Drawing
 * @typedef {import('../../mask/opacity.js').Context} Context
 * @typedef {{text: string, css: CSSStyleDeclaration, rect: DOMRect, more: {lang: string, direction: string}}} Piece
 *   a word or a part of it on one line
 */

import { contextOf } from '../../mask/opacity.js';

/** The most letters; more are illegible in a mask. */
const MAX_LETTERS = 1000;

/** A place where a word may break, which shows a hyphen there alone, and that hyphen. */
const BREAK = '\u00ad';
const HYPHEN = '\u2010';

/** Letters that run from right to left, and brackets, whose direction is that of the run around them. */
const LEFTWARD = /[\u0590-\u08ff\ufb1d-\ufefc]/;
const RUNS = /[\p{L}\p{M}\p{N}]+|./gsu;

/** The languages whose upper case is their own. */
const CASES = /^(az|el|lt|tr)\b/i;

/** Steps of a place along a side of a text that make it another one. */
const SHARES = 2000;

const CLEAR = /^rgba.*, 0\)$/;
const NOTHING = /^(|none|normal)$/;

/** What the page draws of a text that its mask lacks, and whether an element has it. @type {{[what: string]: (element: Element) => boolean}} */
const LACKED = {
  'lines at its letters': (element) => !NOTHING.test(getComputedStyle(element).textDecorationLine),
  'spaces of its ruby': (element) => element.localName === 'ruby',
  'marks of its lists': (element) => {
    const { display, listStyleType } = getComputedStyle(element);
    return /list-item/.test(display) && listStyleType !== 'none';
  },
  'content of its style': (element) =>
    ['::before', '::after'].some((part) => !NOTHING.test(getComputedStyle(element, part).content)),
  // WebKit's canvases have `small-caps` alone, as a part of their font.
  'small capitals': (element) =>
    !('fontVariantCaps' in CanvasRenderingContext2D.prototype) &&
    !/^(normal|small-caps)$/.test(getComputedStyle(element).fontVariantCaps),
  'features of its font': (element) => {
    const css = /** @type {any} */ (getComputedStyle(element));
    const features = ['FeatureSettings', 'VariantAlternates', 'VariantEastAsian', 'VariantNumeric', 'VariantPosition'];
    return features.some((name) => !NOTHING.test(css[`font${name}`] ?? '') && !withoutLigatures(css));
  },
};

/**
 * The box around the lines of a text; undefined if it is too long to be measured in each frame.
 * @param {Element} element
 */
export function extentOf(element) {
  return isLong(element) ? undefined : rangeOf(element, 0, element.childNodes.length).getBoundingClientRect();
}

/**
 * How to draw the glyphs of a text; null without one, as a string, the reason why it cannot be drawn.
 * @param {Element} element
 * @returns {Drawing | string | null}
 */
export function glyphsIn(element) {
  if (isLong(element)) return `its text has more than ${MAX_LETTERS} letters`;
  if (getComputedStyle(element).writingMode !== 'horizontal-tb') return 'its lines are vertical';
  const outer = element.getBoundingClientRect();
  const measure = contextOf(1, 1);
  const glyphs = piecesOf(element).map((piece) => laidOut(piece, measure));
  const [left, top, right, bottom] = [0, 1, 2, 3].map((side) =>
    Math[side < 2 ? 'min' : 'max'](...glyphs.map(({ ink }) => ink[side])),
  );
  if (!(right > left && bottom > top)) return null;
  const draw = (/** @type {Context} */ context) => {
    for (const { text, style, fills, x, y, wide, high } of glyphs) {
      context.save();
      context.translate(x, y);
      context.scale(wide, high);
      Object.assign(context, style);
      if (fills) context.fillText(text, 0, 0);
      if (style.lineWidth) context.strokeText(text, 0, 0);
      context.restore();
    }
  };
  // In shares, which a transform of the whole leaves.
  const key = glyphs.map(({ text, style, fills, x, y }) => [
    ...[text, style, fills],
    ...[(x - outer.left) / outer.width, (y - outer.top) / outer.height].map((share) => Math.round(share * SHARES)),
  ]);
  const parts = [element, ...element.querySelectorAll('*')];
  const lacks = Object.keys(LACKED).filter((what) => parts.some(LACKED[what]));
  const box = { left, top, width: right - left, height: bottom - top };
  return { outer, box, draw, key: JSON.stringify(key), lacks };
}

/** @param {Element} element */
const isLong = (element) => (element.textContent ?? '').length > MAX_LETTERS;

/** @param {Node} node @param {number} from @param {number} to */
function rangeOf(node, from, to) {
  const range = document.createRange();
  range.setStart(node, from);
  range.setEnd(node, to);
  return range;
}

/** The words of an element, or parts of them. @param {Element} element */
function piecesOf(element) {
  /** @type {Piece[]} */
  const pieces = [];
  const walker = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const parent = /** @type {HTMLElement} */ (node.parentElement);
    const css = getComputedStyle(parent);
    // Text for screen readers is in a box of a pixel.
    if (css.visibility !== 'visible' || (parent !== element && parent.offsetWidth <= 1)) continue;
    const lang = parent.closest('[lang]')?.getAttribute('lang') ?? '';
    const text = node.nodeValue ?? '';
    // Browsers differ in what begins a word, and tell the text that they show.
    const isAlone = css.textTransform !== 'none' && parent.childNodes.length === 1;
    const words = isAlone ? parent.innerText.match(/\S+/g) : undefined;
    for (const [number, { 0: word, index }] of [...text.matchAll(/\S+/g)].entries()) {
      let at = index;
      const told = words?.[number]?.length === word.length ? words[number] : undefined;
      const parts = partsOf(node, index, word, css).flatMap((part) => {
        const before = text[at - 1] ?? '';
        const own = told?.slice(at - index, at - index + part.length) ?? transformed(part, css, lang, before);
        const shown = part === BREAK ? hyphenOf(css) : own;
        const rects = rectsOf(node, at, part);
        const one = rectOf(node, at, part);
        at += part.length;
        const more = { lang, direction: css.direction };
        const piece = { text: shown, css, rect: one ?? rects.at(-1), more };
        // The first letter of a line has the box of the hyphen of the line before, too.
        const hyphen = { text: hyphenOf(css), css, rect: rects[0], more };
        return one || rects.length === 0 || before === BREAK ? [piece] : [hyphen, piece];
      });
      // A bracket alone has the direction of the run that it is in.
      parts.forEach(({ rect, more }, place) => {
        const before = parts[place - 1]?.rect;
        const [first, second] = before ? [before, rect] : [rect, parts[place + 1]?.rect];
        if (first && second) more.direction = first.left > second.left ? 'rtl' : 'ltr';
      });
      pieces.push(...parts.filter(/** @returns {part is Piece} */ (part) => part.rect !== undefined));
    }
  }
  return pieces;
}

/**
 * The parts of a word that are drawn as they are: its runs where text of both directions is mixed, its letters where it
 * continues on another line or has no ligatures.
 * @type {(node: Node, from: number, word: string, css: CSSStyleDeclaration) => string[]}
 */
function partsOf(node, from, word, css) {
  const isMixed = css.direction === 'rtl' || LEFTWARD.test(node.nodeValue ?? '');
  const runs = isMixed && rectsOf(node, from, word).length > 0 ? (word.match(RUNS) ?? []) : [word];
  let at = from;
  return runs.flatMap((run) => {
    const isOne = rectOf(node, at, run) && !(withoutLigatures(css) && !LEFTWARD.test(run));
    at += run.length;
    return isOne ? [run] : lettersOf(run);
  });
}

/** Whether letters stay apart. @param {CSSStyleDeclaration} css */
function withoutLigatures({ fontVariantLigatures, fontFeatureSettings }) {
  return /none|no-common/.test(fontVariantLigatures) || /"liga" 0/.test(fontFeatureSettings);
}

/** The boxes of a text. @type {(node: Node, from: number, text: string) => DOMRect[]} */
function rectsOf(node, from, { length }) {
  const rects = [...rangeOf(node, from, from + length).getClientRects()];
  return rects.filter(({ width, height }) => width > 0 && height > 0);
}

/**
 * The box of a text on one line; undefined if it takes several.
 * @type {(node: Node, from: number, text: string) => DOMRect | undefined}
 */
function rectOf(node, from, text) {
  const rects = rectsOf(node, from, text);
  if (!rects.length || rects.some(({ top }) => Math.abs(top - rects[0].top) >= 1)) return undefined;
  // The range's own box has the empty rectangle that WebKit leaves on the line before a letter that wraps.
  const [left, top] = [Math.min(...rects.map((rect) => rect.left)), Math.min(...rects.map((rect) => rect.top))];
  const [right, bottom] = [Math.max(...rects.map((rect) => rect.right)), Math.max(...rects.map((rect) => rect.bottom))];
  return new DOMRect(left, top, right - left, bottom - top);
}

/** The letters of a word with their accents. @param {string} word */
function lettersOf(word) {
  return 'Segmenter' in Intl ? [...new Intl.Segmenter().segment(word)].map(({ segment }) => segment) : [...word];
}

/** The hyphen where a word breaks. @param {CSSStyleDeclaration} css */
function hyphenOf({ hyphenateCharacter = 'auto' }) {
  return hyphenateCharacter === 'auto' ? HYPHEN : hyphenateCharacter.slice(1, -1);
}

/** @type {(text: string, css: CSSStyleDeclaration, lang: string, before: string) => string} */
function transformed(text, { textTransform }, lang, before) {
  const locale = CASES.exec(lang)?.[0] ?? 'und';
  if (textTransform === 'uppercase') return text.toLocaleUpperCase(locale);
  if (textTransform === 'lowercase') return text.toLocaleLowerCase(locale);
  if (textTransform !== 'capitalize') return text;
  // A word ends at a hyphen too, but not at an apostrophe.
  const first = /(?<![\p{L}\p{M}\p{N}'’])\p{L}/gu;
  return (before + text).replace(first, (letter) => letter.toLocaleUpperCase(locale)).slice(before.length);
}

/** What a canvas draws letters with. @type {(css: CSSStyleDeclaration, more: object) => {[name: string]: any}} */
function styleOf(css, more) {
  const caps = css.fontVariantCaps === 'small-caps' ? 'small-caps' : '';
  return {
    font: `${css.fontStyle} ${caps} ${css.fontWeight} ${css.fontSize} ${css.fontFamily}`,
    fontKerning: css.fontKerning,
    letterSpacing: css.letterSpacing === 'normal' ? '0px' : css.letterSpacing,
    lineWidth: CLEAR.test(css.webkitTextStrokeColor) ? 0 : parseFloat(css.webkitTextStrokeWidth) || 0,
    textAlign: 'left',
    ...more,
    // A canvas forgets it with a change of the others.
    fontVariantCaps: css.fontVariantCaps,
  };
}

/**
 * Where a piece is drawn, and its ink, in pixels of the window.
 * @param {Piece} piece @param {Context} measure
 */
function laidOut({ text, css, rect, more }, measure) {
  const style = styleOf(css, more);
  Object.assign(measure, style);
  const {
    width,
    fontBoundingBoxAscent: ascent,
    fontBoundingBoxDescent: descent,
    actualBoundingBoxLeft: left,
    actualBoundingBoxRight: right,
    actualBoundingBoxAscent: above,
    actualBoundingBoxDescent: below,
  } = measure.measureText(text);
  // The box of a text on a line is as high as its font, whatever the height of the line. A drop cap and a transform
  // have other sizes.
  const high = rect.height / (ascent + descent);
  const wide = width > 0 ? rect.width / width : high;
  const [x, y] = [rect.left, rect.top + ascent * high];
  const edge = style.lineWidth / 2;
  // Clear letters with an edge are drawn by that alone.
  const fills = !(edge && CLEAR.test(css.webkitTextFillColor));
  const ink = [
    x - (left + edge) * wide,
    y - (above + edge) * high,
    x + (right + edge) * wide,
    y + (below + edge) * high,
  ];
  return { text, style, fills, x, y, wide, high, ink };
}
