/**
 * The size of an element that its page gives none, and where its picture is.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';

/** @type {Browser} */
let browser;
/** @type {any} */
let tab;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
  tab = await browser.open('<!doctype html><script type="module" src="./web/hearth-fire.js"></script>', {
    height: 800,
  });
});
after(() => browser?.close());

/** The sizes of the first fire of `html`, and of its picture. */
const sizes = (/** @type {string} */ html) =>
  tab.evaluate(async (/** @type {string} */ body) => {
    await customElements.whenDefined('hearth-fire');
    document.body.innerHTML = body;
    const fire = document.querySelector('hearth-fire');
    const [outer, inner] = [fire, fire?.shadowRoot?.querySelector('canvas')].map((box) => box?.getBoundingClientRect());
    return [outer?.width, outer?.height, inner?.width, inner?.height];
  }, html);

const FIRE = '<hearth-fire paused></hearth-fire>';
const styled = (/** @type {string} */ style) => `<hearth-fire paused style="${style}"></hearth-fire>`;

for (const [place, html, width, height] of /** @type {[string, string, number, number][]} */ ([
  [
    'a centred flex item',
    `<div style="display: flex; justify-content: center; align-items: center">${FIRE}</div>`,
    300,
    375,
  ],
  [
    'an automatic column of a grid',
    `<div style="display: grid; grid: auto / auto 1fr">${FIRE}<p>Text</p></div>`,
    300,
    375,
  ],
  ['a float', styled('float: left'), 300, 375],
  ['an absolute box', styled('position: absolute'), 300, 375],
  ['a cell of a table', `<table cellpadding="0"><tr><td>${FIRE}</td><td>Text</td></tr></table>`, 300, 375],
  ['a narrow flex box', `<div style="width: 200px; display: flex; justify-content: center">${FIRE}</div>`, 200, 250],
  ['the least content', styled('width: min-content'), 80, 100],
  ['a block', `<div style="width: 400px">${FIRE}</div>`, 400, 500],
  [
    'a card of three in a row',
    `<div style="display: grid; width: 330px; grid: auto / repeat(3, 1fr)"><div>${FIRE}</div></div>`,
    110,
    137.5,
  ],
])) {
  test(`a fire has a size, and its picture is in it: ${place}`, async () => {
    assert.deepEqual(await sizes(html), [width, height, width, height]);
  });
}
