/**
 * `of` of an inline SVG: its mask is what the page draws of it, with all that it gets from elsewhere in the document.
 */
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { BROWSER, Browser, eventually } from '../driver.mjs';
import { decoded } from '../masks.mjs';

/** @typedef {ReturnType<typeof decoded>} Pixels */

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** Pixels of a mask that are compared along each side, and the share of them that may differ, at edges. */
const SIDE = 40;
const EDGES = 0.02;

const asImage = (/** @type {string} */ content) =>
  `data:image/svg+xml,${encodeURIComponent(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100" width="100" height="100">${content}</svg>`)}`;

/** A page with a drawing, a plain picture of the same and a fire with solids of both. */
async function opened(/** @type {string} */ style, elsewhere, drawing, plain) {
  const tab = await browser.show(`<style>
    body { margin: 0 } #it, #plain { position: absolute; left: 20px; top: 20px; width: 100px; height: 100px } #plain { left: 150px }
    hearth-fire { position: absolute; left: 0; top: 0; width: 300px; height: 300px } ${style}</style>
    ${elsewhere}<svg id="it" viewBox="0 0 100 100">${drawing}</svg>
    <img id="plain" src="${asImage(plain)}">
    <hearth-fire autoplay="false" quality="low" max-pixels="10000"><hearth-solid of="#it"></hearth-solid><hearth-solid of="#plain"></hearth-solid></hearth-fire>`);
  await tab.ready();
  return tab;
}

/** The masks of both solids. @param {import('../driver.mjs').Tab} tab */
async function masks(tab) {
  await tab.until('both solids are there', () => {
    const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
    const solids = fire.objects.filter((/** @type {any} */ { kind }) => kind === 'solid');
    return solids.length === 2 && solids.every((/** @type {any} */ { shape }) => shape !== 'circle');
  });
  return tab.fire((fire) =>
    [...fire.children].map(({ objectId }) => {
      const { shape, mask, width, height } = fire.objects.find(({ id }) => id === objectId);
      return { shape, mask, width, height };
    }),
  );
}

/** The share of places at which one mask is opaque and the other is not. */
function difference(/** @type {Pixels} */ mask, /** @type {Pixels} */ other) {
  const shares = Array.from({ length: SIDE }, (_, at) => (at + 0.5) / SIDE);
  const places = shares.flatMap((y) => shares.map((x) => [x, y]));
  return places.filter(([x, y]) => mask.at(x, y) > 7 !== other.at(x, y) > 7).length / places.length;
}

const STROKED = '<path d="M50 12 88 84H12Z" fill="none" stroke="red" stroke-width="8"/>';
const LEFT = '<rect width="50" height="100"/>';
const DISC = '<circle cx="50" cy="50" r="40"/>';
const outside = (/** @type {string} */ content) =>
  `<svg style="position: absolute; width: 0; height: 0">${content}</svg>`;
const hidden = (/** @type {string} */ content) => `<svg style="display: none">${content}</svg>`;

const FONT = await readFile(
  new URL('../../../crates/hearth-panel/font/Ubuntu-Light-derivative-Hearth.ttf', import.meta.url),
  'base64',
);
const OWN_FONT = `@font-face { font-family: Own; src: url(data:font/ttf;base64,${FONT}) }`;

/** @type {[about: string, style: string, elsewhere: string, drawing: string, plain: string][]} */
const DRAWINGS = [
  [
    'a colour that is a variable',
    ':root { --line: gold }',
    '',
    '<path style="fill: none; stroke: var(--line); stroke-width: 8" d="M50 12 88 84H12Z"/>',
    STROKED,
  ],
  [
    'the current colour, which may be transparent',
    '#it { color: transparent } #it .b { color: red }',
    '',
    `<rect x="50" width="50" height="100" fill="currentColor"/><g class="b"><rect width="50" height="100" style="fill: currentColor"/></g>`,
    LEFT,
  ],
  [
    'a style sheet inside that overrides',
    '',
    '',
    '<style>#it rect { fill: none !important } #it .c { fill: red !important; display: inline }</style><rect width="100" height="100" style="fill: red"/><circle class="c" cx="50" cy="50" r="40"/>',
    DISC,
  ],
  ['geometry of the style', '#it circle { r: 40px; cx: 50px; cy: 50px }', '', '<circle r="3"/>', DISC],
  [
    'transforms of the style',
    '#it rect { transform: translate(-50px) } #it .turned { transform: rotate(90deg); transform-origin: center; transform-box: fill-box }',
    '',
    '<rect x="50" width="50" height="100"/><rect class="turned" x="40" y="45" width="20" height="10" /><rect x="80" y="80" width="10" height="10" style="transform: none" transform="translate(90 0)"/>',
    `${LEFT}<rect x="45" y="40" width="10" height="20"/><rect x="30" y="80" width="10" height="10"/><rect x="80" y="80" width="10" height="10"/>`,
  ],
  [
    'a symbol elsewhere, with the fill of its use',
    '#it use { fill: none; stroke: gold; stroke-width: 8 }',
    hidden('<symbol id="s" viewBox="0 0 100 100"><path d="M50 12 88 84H12Z"/></symbol>'),
    '<use href="#s" width="100" height="100"/>',
    STROKED,
  ],
  [
    'a gradient elsewhere, whose stops are another’s',
    '.end { stop-opacity: 0 }',
    hidden(
      '<linearGradient id="stops"><stop offset="0.5" stop-color="red"/><stop class="end" offset="0.5"/></linearGradient>',
    ) + outside('<linearGradient id="g" href="#stops"/>'),
    '<rect width="100" height="100" fill="url(#g)"/>',
    LEFT,
  ],
  [
    'a clip path elsewhere',
    '#it rect { clip-path: url(#clip) }',
    outside('<clipPath id="clip"><circle cx="50" cy="50" r="40"/></clipPath>'),
    '<rect width="100" height="100"/>',
    DISC,
  ],
  [
    'a mask elsewhere, with the colour of the style',
    '#m circle { fill: white }',
    outside('<mask id="m"><circle cx="50" cy="50" r="40"/></mask>'),
    '<g mask="url(#m)"><rect width="100" height="100"/></g>',
    DISC,
  ],
  [
    'a pattern elsewhere, with what it inherits there',
    '.there { fill: none; stroke: red; stroke-width: 8 }',
    `<div class="there">${outside('<pattern id="p" width="1" height="1"><path d="M50 12 88 84H12Z"/></pattern>')}</div>`,
    '<rect width="100" height="100" style="fill: url(#p)"/>',
    STROKED,
  ],
  [
    'a marker elsewhere',
    '',
    outside(
      '<marker id="arrow" markerUnits="userSpaceOnUse" markerWidth="80" markerHeight="80" refX="40" refY="40"><circle cx="40" cy="40" r="40"/></marker>',
    ),
    '<path d="M50 50H50.1" marker-start="url(#arrow)"/>',
    DISC,
  ],
  [
    'a filter elsewhere',
    '',
    outside(
      '<filter id="f" x="0" y="0" width="1" height="1"><feFlood flood-color="red"/><feOffset dx="-50"/></filter>',
    ),
    '<rect width="100" height="100" filter="url(#f)"/>',
    LEFT,
  ],
  [
    'one of two elements of an id, as the page has it',
    '',
    outside('<clipPath id="twice"><rect width="50" height="100"/></clipPath>'),
    '<clipPath id="twice"><rect width="5" height="5"/></clipPath><rect width="100" height="100" clip-path="url(#twice)"/>',
    // WebKit's pages show the last one.
    BROWSER === 'webkit' ? '<rect width="5" height="5"/>' : LEFT,
  ],
  [
    'a text in a font of the page',
    `${OWN_FONT} #it text { font: 40px "Own", monospace }`,
    '',
    '<text x="10" y="60"><tspan>ab</tspan><tspan dx="5" style="fill: none; stroke: red; stroke-width: 3">y</tspan></text>',
    `<style>${OWN_FONT}</style><text x="10" y="60" style="font: 40px Own">ab<tspan dx="5" style="fill: none; stroke: red; stroke-width: 3">y</tspan></text>`,
  ],
  [
    'an image in it',
    '',
    '',
    `<image width="100" height="100" href="${asImage('<circle cx="50" cy="50" r="40"/>')}"/>`,
    DISC,
  ],
];

for (const [about, style, elsewhere, drawing, plain] of DRAWINGS) {
  test(`an SVG counts with ${about}`, async () => {
    const tab = await opened(style, elsewhere, drawing, plain);
    let differ = 1;
    // A mask follows the fonts of the page when they have loaded.
    for (let tries = 0; differ > EDGES && tries < 20; tries += 1) {
      if (tries > 0) await tab.frames(5);
      const [it, reference] = await masks(tab);
      assert.deepEqual([it.shape, it.width, it.height], [reference.shape, reference.width, reference.height]);
      differ = difference(decoded(it.mask), decoded(reference.mask));
    }
    assert.deepEqual(tab.problems, []);
    assert.ok(differ <= EDGES, `${differ} of the pixels differ`);
  });
}

/** A drawing, what changes it without a mutation of its own, and what it looks like then. @type {[string, string, string, () => void, string][]} */
const CHANGES = [
  [
    'a class of the page that hides a part',
    'body:has(.dark) #it circle { fill: none }',
    `${LEFT}<circle cx="75" cy="50" r="25"/>`,
    () => document.querySelector('#plain')?.classList.add('dark'),
    LEFT,
  ],
  [
    'an animation of the style until it ends',
    '@keyframes grow { to { stroke-dashoffset: 0 } } #it path { stroke-dashoffset: 1 } body:has(.dark) #it path { animation: grow 0.4s forwards }',
    '<path pathLength="1" d="M10 50H90" fill="none" stroke="red" stroke-width="40" stroke-dasharray="1"/><rect width="9" height="9"/>',
    () => document.querySelector('#plain')?.classList.add('dark'),
    '<path d="M10 50H90" fill="none" stroke="red" stroke-width="40"/><rect width="9" height="9"/>',
  ],
  [
    'a transition of the style until it ends',
    '#it g { transition: opacity 0.4s } body:has(.dark) #it g { opacity: 0 }',
    `${LEFT}<g><circle cx="75" cy="50" r="25"/></g>`,
    () => document.querySelector('#plain')?.classList.add('dark'),
    LEFT,
  ],
  [
    'its own animations',
    '',
    `<rect width="50" height="20"><animate attributeName="height" to="100" dur="0.4s" begin="indefinite" fill="freeze"/></rect>
     <polygon points="60,0 90,0 90,9"><animate attributeName="points" to="60,0 100,0 100,90" dur="0.4s" begin="indefinite" fill="freeze"/></polygon>
     <g transform="translate(0 4)"><rect width="9" height="9" transform="translate(60 50)"><animateTransform attributeName="transform" type="translate" to="60 80" dur="0.4s" begin="indefinite" fill="freeze"/></rect></g>`,
    () => {
      /** @type {any} */ for (const animation of document.querySelectorAll('#it animate, #it animateTransform'))
        animation.beginElement();
    },
    `${LEFT}<polygon points="60,0 100,0 100,90"/><rect x="60" y="84" width="9" height="9"/>`,
  ],
];

for (const [what, style, drawing, change, plain] of CHANGES) {
  test(`an SVG follows ${what}, and is looked at while something changes`, async () => {
    const tab = await opened(style, '', drawing, plain);
    const [before] = await masks(tab);
    await tab.evaluate(() => {
      const page = /** @type {any} */ (window);
      const { serializeToString } = XMLSerializer.prototype;
      page.looks = 0;
      XMLSerializer.prototype.serializeToString = function counted(node) {
        page.looks += 1;
        return serializeToString.call(this, node);
      };
    });
    await tab.evaluate(change);
    await eventually(
      'the mask is that of the last picture',
      () => masks(tab),
      ([it, last]) => it.mask !== before.mask && difference(decoded(it.mask), decoded(last.mask)) <= EDGES,
      () => tab.frames(5),
    );
    const looks = () => tab.evaluate(() => /** @type {any} */ (window).looks);
    let [last, now] = [-1, await looks()];
    // The last look may still be due.
    for (let tries = 0; now !== last && tries < 3; tries += 1) {
      await tab.frames(90);
      [last, now] = [now, await looks()];
    }
    assert.equal(now, last);
    assert.deepEqual(tab.problems, []);
  });
}

for (const [why, drawing, elsewhere = '', style = ''] of [
  ['it contains HTML', '<foreignObject width="100" height="50"><p>Fire</p></foreignObject>'],
  ['it refers to another file', '<image href="/web/poster.jpg" width="50" height="100"/>'],
  [
    'it refers to another file',
    '<filter id="photo"><feImage href="/web/poster.jpg"/></filter><rect width="50" height="50" filter="url(#photo)"/>',
  ],
  ['it contains HTML', '<use href="#label"/>', hidden('<g id="label"><foreignObject><b>Fire</b></foreignObject></g>')],
  [
    'a part of its text has a font that only the page has',
    '<use href="#word"/>',
    hidden('<text id="word" y="60" font-family="Own">ab</text>'),
    OWN_FONT,
  ],
  [
    'it has more than 1000 elements, or draws more than 20000',
    '<use href="#many"/>',
    hidden(`<g id="many">${LEFT.repeat(1000)}</g>`),
  ],
]) {
  test(`an SVG counts as its box, because ${why}: ${drawing.slice(0, 60)}`, async () => {
    const tab = await opened(style, elsewhere, drawing, LEFT);
    const [it] = await masks(tab);
    assert.equal(it.shape, 'box');
    const warnings = tab.problems.filter((problem) => problem.includes('hearth-solid'));
    assert.deepEqual(warnings, [`console.warn: <hearth-fire>: <hearth-solid>: of = #it counts as a box: ${why}.`]);
  });
}
