/**
 * The glyphs of a text as they are laid out: each word is drawn where the page shows it.
 *
 * @typedef {import('./child-picture.js').Drawing} Drawing
 * @typedef {import('../../mask/opacity.js').Context} Context
 * @typedef {{text: string, css: CSSStyleDeclaration, rect: DOMRect}} Piece a word or a part of it on one line
 */

import { contextOf } from '../../mask/opacity.js';

/** The most letters; more are illegible in a mask. */
const MAX_LETTERS = 1000;

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
    for (const { text, css, x, y, wide, high } of glyphs) {
      context.save();
      context.translate(x, y);
      context.scale(wide, high);
      setFont(context, css);
      context.fillText(text, 0, 0);
      context.restore();
    }
  };
  return { outer, box: { left, top, width: right - left, height: bottom - top }, draw };
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

/** The words of an element, or their letters where a word continues on another line. @param {Element} element */
function piecesOf(element) {
  /** @type {Piece[]} */
  const pieces = [];
  const walker = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const parent = /** @type {HTMLElement} */ (node.parentElement);
    const css = getComputedStyle(parent);
    // Text for screen readers is in a box of a pixel.
    if (css.visibility !== 'visible' || (parent !== element && parent.offsetWidth <= 1)) continue;
    for (const { 0: word, index } of (node.nodeValue ?? '').matchAll(/\S+/g)) {
      let at = index;
      for (const text of rectOf(node, index, word) ? [word] : lettersOf(word)) {
        const rect = rectOf(node, at, text);
        if (rect) pieces.push({ text: transformed(text, css, at > index), css, rect });
        at += text.length;
      }
    }
  }
  return pieces;
}

/**
 * The box of a text on one line; undefined if it takes several.
 * @type {(node: Node, from: number, text: string) => DOMRect | undefined}
 */
function rectOf(node, from, { length }) {
  const range = rangeOf(node, from, from + length);
  const [first, ...more] = [...range.getClientRects()].filter(({ width, height }) => width > 0 && height > 0);
  return first && more.every(({ top }) => Math.abs(top - first.top) < 1) ? range.getBoundingClientRect() : undefined;
}

/** The letters of a word with their accents. @param {string} word */
function lettersOf(word) {
  return 'Segmenter' in Intl ? [...new Intl.Segmenter().segment(word)].map(({ segment }) => segment) : [...word];
}

/** @type {(text: string, css: CSSStyleDeclaration, inWord?: boolean) => string} */
function transformed(text, { textTransform }, inWord = false) {
  if (textTransform === 'uppercase') return text.toUpperCase();
  if (textTransform === 'lowercase') return text.toLowerCase();
  return textTransform === 'capitalize' && !inWord ? text.replace(/\p{L}/u, (letter) => letter.toUpperCase()) : text;
}

/** Sets the font of a style for later drawing. @param {Context} context @param {CSSStyleDeclaration} css */
function setFont(context, css) {
  const caps = css.fontVariantCaps === 'small-caps' ? 'small-caps' : '';
  context.font = `${css.fontStyle} ${caps} ${css.fontWeight} ${css.fontSize} ${css.fontFamily}`;
  Object.assign(context, {
    direction: css.direction,
    fontKerning: css.fontKerning,
    letterSpacing: css.letterSpacing === 'normal' ? '0px' : css.letterSpacing,
    textAlign: 'left',
  });
}

/**
 * Where a piece is drawn, and its ink, in pixels of the window.
 * @param {Piece} piece @param {Context} measure
 */
function laidOut({ text, css, rect }, measure) {
  setFont(measure, css);
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
  return { text, css, x, y, wide, high, ink: [x - left * wide, y - above * high, x + right * wide, y + below * high] };
}
