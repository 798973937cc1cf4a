/**
 * `of`: a solid takes what is opaque in a picture, or the glyphs of a text, and follows them.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { BROWSER, Browser } from '../driver.mjs';
import { decoded } from '../masks.mjs';
import { serve } from '../server.mjs';
import { childUntil as until } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/**
 * How far a mask may be from the pixels on the screen: glyphs and the pixels of masks lie on grids, and lines of Firefox
 * too [CSS pixels].
 */
const NEAR = BROWSER === 'firefox' ? 2 : 1.5;

/** A disc at the left of a wide image, and a square without a transparent pixel. */
const svg = (/** @type {string} */ content, size = 'width="100" height="50"') =>
  `<svg xmlns="http://www.w3.org/2000/svg" ${size}>${content}</svg>`;
const asImage = (/** @type {string} */ text) => `data:image/svg+xml,${encodeURIComponent(text)}`;
const DISC = asImage(svg('<circle cx="25" cy="25" r="25"/>'));
const SQUARE = asImage(svg('<rect width="100" height="50"/>'));

/** A page with these elements and a fire over them. */
async function opened(target, children, { style = '', options = {} } = {}) {
  const page = `<style>body { margin: 0; background: white; color: black } #it { position: absolute; margin: 0; ${style} }
    hearth-fire { position: absolute; left: 0; top: 0; width: 300px; height: 300px }</style>${target}
    <hearth-fire autoplay="false" quality="low" max-pixels="10000">${children}</hearth-fire>`;
  const tab = await browser.show(page, options);
  await tab.ready();
  return tab;
}

const masked = (tab, what = 'the mask') => until(tab, what, (object) => object?.shape === 'mask');
const boxed = (tab, what = 'the box') => until(tab, what, (object) => object?.shape === 'box');
const gone = (tab, what = 'the solid is gone') => until(tab, what, (object) => object === null);
const another = (tab, what, mask) =>
  until(tab, what, (object, mask) => object?.shape === 'mask' && object.mask !== mask, mask);

/** Asserts which places in shares of a mask are opaque: `x y` with a plus sign before it, others with a minus sign. */
function assertOpaque({ mask }, places) {
  const pixels = decoded(mask);
  const seen = places.split(', ').map((place) => {
    const [x, y] = place.slice(1).split(' ').map(Number);
    return `${pixels.at(x, y) > 7 ? '+' : '-'}${x} ${y}`;
  });
  assert.equal(seen.join(', '), places);
}

const near = (box, wanted) =>
  assert.ok(
    box.every((side, at) => Math.abs(side - wanted[at]) < 0.1),
    `${box} instead of ${wanted}`,
  );

/** Changes the target. */
const restyle = (tab, style) =>
  tab.page.$eval('#it', (element, style) => void Object.assign(element.style, style), style);

/** Gives the image another address. */
const source = (tab, src) => tab.page.$eval('#it', (image, src) => void Object.assign(image, { src }), src);

/** Counts masks from now on, in `window.masks`. */
const counts = (tab) =>
  tab.evaluate(() => {
    const { prototype } = CanvasRenderingContext2D;
    const { getImageData } = prototype;
    const page = /** @type {any} */ (window);
    page.masks = 0;
    prototype.getImageData = function counted(...args) {
      page.masks += 1;
      return getImageData.apply(this, args);
    };
  });
const masks = (tab) => tab.evaluate(() => /** @type {any} */ (window).masks);

test('an image counts by its alpha, in its content box and as object-fit places it', async () => {
  const style =
    'left: 40px; top: 30px; width: 100px; height: 100px; padding: 10px; border: 5px solid red; object-fit: contain';
  const tab = await opened(`<img id="it" src="${DISC}">`, '<hearth-solid of="#it" x="0.5"></hearth-solid>', { style });
  const solid = await masked(tab);
  near(solid.box, [55, 45, 155, 145]);
  assert.deepEqual([solid.material, solid.angle, solid.corner], ['none', 0, 0]);
  // The disc has a diameter of 50 pixels at the left, in the middle of the height.
  assertOpaque(solid, '+0.25 0.5, +0.04 0.5, +0.46 0.5, -0.25 0.22, -0.75 0.5, -0.02 0.28');
  let last = solid;
  for (const [what, fit, places] of [
    ['it fills its box', { objectFit: 'fill' }, '+0.25 0.03, +0.25 0.97, -0.55 0.5'],
    // Of a picture of 200 x 100, the middle is seen: the right half of the disc.
    ['it covers its box', { objectFit: 'cover' }, '+0.03 0.5, +0.45 0.5, -0.55 0.5, -0.3 0.03'],
    ['its left part is seen', { objectPosition: 'left' }, '+0.03 0.5, +0.97 0.5, +0.5 0.03, -0.03 0.03'],
    [
      'it has its own size',
      { objectFit: 'none', objectPosition: '10px 100%' },
      '+0.12 0.75, +0.58 0.75, -0.05 0.75, -0.35 0.45',
    ],
  ]) {
    await restyle(tab, fit);
    last = await another(tab, what, last.mask);
    assertOpaque(last, places);
  }
  // Settings carry pixels, and no address.
  const config = JSON.stringify(await tab.fire((fire) => fire.exportConfig()));
  assert.ok(config.includes(last.mask) && !/data:|svg|http/.test(config));
  await tab.fire((fire) => fire.firstElementChild.removeAttribute('of'));
  const plain = await until(tab, 'its attributes', (object) => object?.shape === 'circle');
  assert.deepEqual([plain.x, plain.mask], [0.5, '16x16:7']);
  assert.deepEqual(tab.problems, []);
});

test('an image without a transparent pixel counts as its box with its corners, and another image as its own', async () => {
  const style = 'left: 40px; top: 30px; width: 100px; height: 50px; border-radius: 20px';
  const tab = await opened(
    `<picture id="outer"><img id="it" src="${SQUARE}"></picture>`,
    '<hearth-solid of="#outer"></hearth-solid>',
    { style },
  );
  const solid = await boxed(tab);
  near(solid.box, [40, 30, 140, 80]);
  assert.ok(Math.abs(solid.corner - (20 * 1.8) / 300) < 1e-4, `${solid.corner}`);
  await source(tab, DISC);
  const disc = await masked(tab, 'another image');
  assertOpaque(disc, '+0.25 0.5, -0.75 0.5');
  await source(tab, SQUARE);
  assert.deepEqual([(await boxed(tab, 'the first image again')).mask, tab.problems], ['16x16:7', []]);
});

test('an SVG element counts as the style of the page draws it, and a canvas by its pixels', async () => {
  const tab = await opened(
    `<style>#it .ring { fill: none; stroke: currentcolor; stroke-width: 4px } #it .hidden { display: none }</style>
    <svg width="0" height="0"><symbol id="bar" viewBox="0 0 10 10"><rect width="10" height="10"/></symbol></svg>
    <svg id="it" viewBox="0 0 40 20"><circle class="ring" cx="10" cy="10" r="8"/><rect class="hidden" x="18" width="4" height="20"/><use href="#bar" x="30" y="0" width="5" height="20" preserveAspectRatio="none"/></svg>
    <canvas id="canvas" width="40" height="20" style="position: absolute; left: 20px; top: 200px; width: 80px"></canvas>`,
    '<hearth-solid of="#it"></hearth-solid>',
    { style: 'left: 40px; top: 30px; width: 160px; height: 80px' },
  );
  const solid = await masked(tab);
  near(solid.box, [40, 30, 200, 110]);
  assertOpaque(solid, '+0.05 0.5, +0.25 0.1, -0.25 0.5, -0.5 0.5, +0.8125 0.5, -0.95 0.5');
  await tab.page.$eval('#it circle', (circle) => circle.setAttribute('r', '4'));
  const smaller = await another(tab, 'it follows a change', solid.mask);
  assertOpaque(smaller, '-0.05 0.5, +0.15 0.5, -0.25 0.5');
  await tab.evaluate(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('#canvas'));
    canvas.getContext('2d')?.fillRect(0, 0, 20, 20);
    document.querySelector('hearth-solid')?.setAttribute('of', '#canvas');
  });
  const half = await another(tab, 'the canvas', smaller.mask);
  near(half.box, [20, 200, 100, 240]);
  assertOpaque(half, '+0.25 0.5, -0.75 0.5');
  // Pixels of a canvas are read again when the attribute is set again.
  await tab.evaluate(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('#canvas'));
    canvas.getContext('2d')?.fillRect(20, 0, 10, 20);
    document.querySelector('hearth-solid')?.setAttribute('of', '#canvas');
  });
  assertOpaque(await another(tab, 'the canvas again', half.mask), '+0.6 0.5, -0.85 0.5');
  assert.deepEqual(tab.problems, []);
});

test('glyphs lie where the page shows them', async () => {
  const headline = 'left: 10px; top: 20px; width: 200px';
  const tab = await opened('<h1 id="it">Fire</h1>', '<hearth-solid of="#it" of-text></hearth-solid>', {
    style: headline,
    options: { draws: true },
  });
  let last = (await masked(tab)).mask;
  for (const [style, text] of [
    ['font: 700 44px/1.2 serif; text-align: center; letter-spacing: 2px', 'Fire in the <em>hearth</em>'],
    ['font: italic 400 38px/1 sans-serif; text-align: justify; text-transform: uppercase', 'jagged embers fly'],
    ['font: 700 40px/1.4 monospace; direction: rtl; overflow-wrap: anywhere', 'extraordinarily'],
    ['font: 600 30px/1.3 serif; transform: scale(1.3) translate(12px, 30px)', 'of-text<br><small>quite</small> close'],
    ['font: 700 40px/1.1 serif; width: 110px', 'Feuer&shy;wehr&shy;auto'],
    // Firefox draws another hyphen there.
    ...(BROWSER === 'firefox'
      ? []
      : [['font: 700 40px/1.1 serif; width: 130px; hyphens: auto', '<span lang="en">extraordinary</span>']]),
    // A canvas of WebKit has neither.
    ...(BROWSER === 'webkit'
      ? []
      : [
          ['font: 700 36px serif; font-variant-caps: all-small-caps; width: 280px', 'Winter Menu'],
          ['font: 700 36px serif; font-variant: unicase; width: 280px', 'Winter Menu'],
        ]),
    ['font: 700 40px serif; text-transform: uppercase', '<span lang="tr">istiridye</span>'],
    ['font: 700 40px serif; text-transform: capitalize', 'half-way'],
    // A canvas of Firefox mirrors no bracket that is drawn alone.
    ...(BROWSER === 'firefox'
      ? []
      : [
          ['font: 700 40px serif; direction: rtl', 'Fire (1)!'],
          ['font: 700 40px serif; direction: rtl', 'אש (אחת) [2]'],
        ]),
    ['font: 700 60px serif; -webkit-text-stroke: 4px black; color: transparent', 'HOT'],
    ['font: 700 40px serif; font-variant-ligatures: none', 'Office fig'],
    ['font: 700 40px serif; font-feature-settings: "liga" 0', 'fine flat'],
  ]) {
    await tab.page.$eval(
      '#it',
      (element, style, text) => {
        element.style = style;
        element.innerHTML = text;
      },
      style,
      text,
    );
    const {
      box: [left, top, right, bottom],
      mask,
    } = await another(tab, style, last);
    last = mask;
    const drawn = decoded(mask);
    const inside = (x, y) =>
      x > left &&
      x < right &&
      y > top &&
      y < bottom &&
      drawn.at((x - left) / (right - left), (y - top) / (bottom - top)) > 7;
    await tab.fire((fire) => void fire.style.setProperty('visibility', 'hidden'));
    const size = 300;
    const { rgb } = await tab.picture({ x: 0, y: 0, width: size, height: size });
    const dark = (x, y) => x >= 0 && y >= 0 && x < size && y < size && rgb[3 * (y * size + x)] < 128;
    const grid = Array.from({ length: size * size }, (_, at) => [at % size, Math.floor(at / size)]);
    const shown = grid.filter(([x, y]) => dark(x, y));
    const solid = grid.filter(([x, y]) => inside(x + 0.5, y + 0.5));
    const extents = [shown, solid].map((places) =>
      [0, 1].flatMap((axis) => [Math.min, Math.max].map((most) => most(...places.map((place) => place[axis])))),
    );
    assert.ok(
      extents[0].every((side, at) => Math.abs(side - extents[1][at]) <= NEAR),
      `${style}: ink from ${extents[0]} on the page and ${extents[1]} in the mask`,
    );
    // A pixel beside the edge of a glyph may be on either side of it.
    const around = [-1, 0, 1].flatMap((x) => [-1, 0, 1].map((y) => [x, y]));
    const lost = shown.filter(([x, y]) => !around.some(([dx, dy]) => inside(x + dx + 0.5, y + dy + 0.5)));
    const extra = solid.filter(([x, y]) => !around.some(([dx, dy]) => dark(x + dx, y + dy)));
    // Firefox moves lines to whole pixels; WebKit kerns the letters of a word that it breaks, which are drawn one by one.
    const few = (BROWSER === 'chromium' ? 0.01 : 0.02) * shown.length;
    assert.ok(
      shown.length > 500 && lost.length < few && extra.length < few,
      `${style}: ${shown.length} pixels of ink, ${lost.length} lost, ${extra.length} too many`,
    );
    await tab.fire((fire) => void fire.style.removeProperty('visibility'));
  }
  assert.deepEqual(tab.problems, []);
});

test('a mask is made again when the text, its style or its size changes, and kept when the element moves', async () => {
  const tab = await opened('<h1 id="it">Fire</h1>', '<hearth-solid of="#it" of-text></hearth-solid>', {
    style: 'left: 40px; top: 30px; font: 700 40px serif',
  });
  const first = await masked(tab);
  await counts(tab);
  await restyle(tab, { left: '90px', transform: 'translateY(20px) scale(1.5)' });
  const moved = await until(tab, 'it has moved', (object, width) => object.width > 1.4 * width, first.width);
  await tab.fire((fire) => fire.setAttribute('zoom', '2'));
  await until(tab, 'it is seen closer', (object, width) => object.width < 0.6 * width, moved.width);
  assert.deepEqual([moved.mask === first.mask, await masks(tab)], [true, 0]);
  await tab.page.$eval('#it', (headline) => {
    headline.firstChild.data = 'Embers';
  });
  const words = await another(tab, 'another text', first.mask);
  await restyle(tab, { fontStyle: 'italic' });
  const italic = await another(tab, 'another style', words.mask);
  await restyle(tab, { width: '20px', overflowWrap: 'anywhere' });
  const narrow = await another(tab, 'more lines', italic.mask);
  const before = await masks(tab);
  await tab.evaluate(() => document.fonts.dispatchEvent(new Event('loadingdone')));
  await tab.until('it is read again with another font', (before) => /** @type {any} */ (window).masks > before, before);
  await tab.fire((fire) => fire.firstElementChild.removeAttribute('of-text'));
  await boxed(tab, 'the box without of-text');
  assert.ok(narrow.height > italic.height);
  assert.deepEqual(tab.problems, []);
});

test('a text without a letter, and a picture without an opaque pixel, make no solid', async () => {
  const tab = await opened(
    '<h1 id="it"> </h1><canvas id="canvas"></canvas>',
    '<hearth-solid of="#it" of-text></hearth-solid><hearth-solid of="#canvas"></hearth-solid>',
    { style: 'left: 40px; top: 30px; width: 100px; height: 50px; font: 40px serif' },
  );
  await until(tab, 'nothing', (object) => object === null);
  while (tab.problems.length < 2) await tab.frames(1);
  assert.deepEqual(await tab.fire((fire) => fire.objects.map(({ kind }) => kind)), ['source']);
  for (const [at, name] of ['it', 'canvas'].entries()) {
    assert.match(
      [...tab.problems].sort().reverse()[at],
      new RegExp(`<hearth-solid>: of = #${name} has no effect now: nothing of that element is opaque`),
    );
  }
  await tab.page.$eval('#it', (headline) => {
    headline.textContent = 'Fire';
  });
  await masked(tab, 'the text');
  await restyle(tab, { display: 'none' });
  await gone(tab, 'it is hidden');
  await restyle(tab, { display: '' });
  await masked(tab, 'it is back');
});

test('where pixels may not be read the box counts, with one warning', async () => {
  const other = await serve();
  other.replace({ '/disc.svg': { type: 'image/svg+xml', body: svg('<circle cx="25" cy="25" r="25"/>') } });
  const style = 'style="position: absolute; left: 40px; top: 30px; width: 60px; height: 40px"';
  const cases = [
    [`<img id="NAME" ${style} src="${other.origin}/disc.svg">`, 'the page may not read its pixels'],
    [`<img id="NAME" ${style} src="data:image/png,nothing">`, 'it has no pixels'],
    [`<img id="NAME" ${style}>`, 'it has no pixels'],
    [`<canvas id="NAME" ${style} width="0" height="10"></canvas>`, 'it has no pixels'],
    [`<canvas id="NAME" ${style} width="16384" height="16384"></canvas>`, 'it has more than 67108864 pixels'],
    [
      `<svg id="NAME" ${style}>${'<g/>'.repeat(1000)}</svg>`,
      'it has more than 1000 elements, or draws more than 20000',
    ],
    [`<div id="NAME" ${style}>${'letters '.repeat(12_500)}</div>`, 'its text has more than 1000 letters', 'of-text'],
    [
      `<div id="NAME" ${style.replace('left', 'writing-mode: vertical-rl; left')}>Fire</div>`,
      'its lines are vertical',
      'of-text',
    ],
    [
      `<div style="transform: rotate(20deg)"><div id="NAME" ${style}>Fire</div></div>`,
      'it is turned or mirrored',
      'of-text',
    ],
  ];
  const named = cases.map(([target], at) => target.replace('NAME', `target${at}`));
  const children = cases.map(
    ([, , attribute = ''], at) => `<hearth-solid id="lid${at}" of="#target${at}" ${attribute}></hearth-solid>`,
  );
  const tab = await opened(named.join(''), children.join(''));
  const boxes = () =>
    tab.until(
      'each has a box',
      (count) =>
        /** @type {any} */ (document.querySelector('hearth-fire')).objects.filter(({ shape }) => shape === 'box')
          .length === count,
      cases.length,
    );
  await boxes();
  await tab.evaluate(() => {
    for (const target of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('[id^=target]')))
      Object.assign(target.style, { marginLeft: '9px', width: '70px' });
  });
  await tab.frames(12);
  await boxes();
  const warnings = tab.problems.filter((problem) => !/data:image|net::/.test(problem));
  const wanted = cases.map(
    ([, why], at) =>
      `console.warn: <hearth-fire>: <hearth-solid id="lid${at}">: of = #target${at} counts as a box: ${why}.`,
  );
  assert.deepEqual(warnings.sort(), wanted);
  await tab.burnt(0.05);
  await other.close();
});

test('what the page draws of a text and its mask lacks is named once', async () => {
  const list = '<ul id="it"><li>Logs</li></ul><style>#it::after { content: "!" }</style>';
  const tab = await opened(list, '<hearth-solid of="#it" of-text></hearth-solid>', { style: 'left: 40px; top: 30px' });
  const { mask } = await masked(tab);
  await restyle(tab, { textDecoration: 'underline', fontStyle: 'italic', fontVariant: 'ordinal petite-caps' });
  await another(tab, 'another style', mask);
  const capitals = BROWSER === 'webkit' ? ['small capitals'] : [];
  const what = [
    'marks of its lists',
    'content of its style',
    'lines at its letters',
    ...capitals,
    'features of its font',
  ];
  assert.deepEqual(
    tab.problems.splice(0),
    what.map((what) => `console.warn: <hearth-fire>: <hearth-solid>: of = #it counts without the ${what}.`),
  );
});

test('an image that never loads, and a text whose font does not, are not waited for', async () => {
  const files = { '/late.svg': { silent: true }, '/late.woff2': { silent: true } };
  const image = await opened('<img id="it">', '<hearth-solid of="#it"></hearth-solid>', {
    style: 'left: 40px; top: 30px; width: 60px; height: 40px',
    options: { files },
  });
  await boxed(image, 'it has no address yet');
  await source(image, '/late.svg');
  await image.fire((fire) => fire.firstElementChild.setAttribute('of', '#it '));
  while (image.problems.length < 2) await image.frames(1);
  assert.match(image.problems[1], /of = #it counts as a box: it has not loaded\./);
  await source(image, DISC);
  await masked(image, 'it has loaded');
  const text = await opened('<h1 id="it">Fire</h1>', '', {
    style: 'left: 40px; top: 30px; font: 40px late, serif',
    options: { files },
  });
  await text.fire((fire) => {
    const late = new FontFace('late', 'url(/late.woff2)');
    document.fonts.add(late);
    late.load();
    fire.innerHTML = '<hearth-solid of="#it" of-text></hearth-solid>';
  });
  await text.frames(10);
  assert.equal(await text.fire((fire) => fire.objects.length), 1, 'it waits for the font');
  await masked(text, 'the glyphs of another font');
});
