/** The elements that an SVG draws are counted before it is drawn, with all that nested `<use>` multiply. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { MAX_DRAWN, elementsDrawn } from '../../web/mask/svg-elements.js';

const svg = (/** @type {string} */ inside) => `<svg xmlns="http://www.w3.org/2000/svg">${inside}</svg>`;
/** Groups that each show the one before four times. */
const nested = (/** @type {number} */ depth, use = '<use href="#@"/>') =>
  svg(
    `<g id="a0"><circle r="3"/></g>${Array.from(
      { length: depth },
      (_, at) => `<g id="a${at + 1}">${use.replaceAll('@', `a${at}`).repeat(4)}</g>`,
    ).join('')}`,
  );

for (const [about, text, count] of /** @type {[string, string, number][]} */ ([
  ['an empty one', svg(''), 1],
  ['shapes', svg('<g><path d="M0>1"/><rect></rect></g>'), 4],
  ['a use of a shape', svg('<path id="p"/><use href="#p"/>'), 4],
  ['a use before its target', svg('<use xlink:href="#p"/><path id="p"/>'), 4],
  ['single quotes and blanks', svg("<path id = 'p'/><use\n href = '#p'/>"), 4],
  ['a use of nothing', svg('<use href="#none"/>'), 2],
  ['a use of itself', svg('<g id="g"><use href="#g"/></g>'), 3],
  ['comments and data', svg('<!-- <g><g> --><style><![CDATA[<a>]]></style>'), 2],
  ['a text that is no SVG', 'hello > < world', 0],
  ['a tag that does not end', svg('<path d="M0 0'), 1],
])) {
  test(`the elements of ${about}`, () => assert.equal(elementsDrawn(text), count));
}

for (const use of [
  '<use href="#@"/>',
  '<use xlink:href="#@"></use>',
  '<svg:use href="#@"/>',
  '<g><use x="1" href="#@"/></g>',
]) {
  test(`nested elements multiply: ${use}`, () => {
    assert.ok(elementsDrawn(nested(12, use)) > MAX_DRAWN);
    assert.ok(elementsDrawn(nested(40, use)) > MAX_DRAWN);
    assert.ok(elementsDrawn(nested(3, use)) < MAX_DRAWN);
  });
}
