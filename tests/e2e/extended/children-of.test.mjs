/**
 * `of`: a child of a fire takes the border box of another element of the page and follows it.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { childUntil as until } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** The largest difference between a box and its body: the values of a body are rounded to 0.1 mm [CSS pixels]. */
const TOLERANCE = 0.1;

const HEADLINE = 'position: absolute; left: 60px; top: 120px; width: 80px; height: 30px; border-radius: 8px; margin: 0';

/** A page with a headline and a fire with these children. */
async function opened(children, attributes = '') {
  const tab = await browser.show(`<style>body { margin: 0 }</style><h1 id="headline" style="${HEADLINE}">Fire</h1>
    <hearth-fire autoplay="false" quality="low" max-pixels="10000" ${attributes} style="width: 200px; height: 300px">${children}</hearth-fire>
    <div style="height: 3000px"></div>`);
  await tab.ready();
  return tab;
}

/** Waits until the first child has the border box of the headline. */
async function follows(tab, what) {
  await until(
    tab,
    what,
    String((object, tolerance) => {
      const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
      const headline = /** @type {Element} */ (document.querySelector('#headline'));
      if (!object || !headline) return false;
      const [outer, box] = [fire.getBoundingClientRect(), headline.getBoundingClientRect()];
      const low = fire.toPixels(object.x - object.width / 2, object.y - object.height / 2);
      const high = fire.toPixels(object.x + object.width / 2, object.y + object.height / 2);
      const body = [low.x, high.y, high.x, low.y];
      const wanted = [box.left - outer.left, box.top - outer.top, box.right - outer.left, box.bottom - outer.top];
      return body.every((side, at) => Math.abs(side - wanted[at]) <= tolerance);
    }),
    TOLERANCE,
  );
}

/** Changes the page. */
const restyle = (tab, style) =>
  tab.evaluate((style) => {
    Object.assign(/** @type {HTMLElement} */ (document.querySelector('#headline')).style, style);
  }, style);

test('a solid has the border box of an element, and follows it while the fire is in sight', async () => {
  const tab = await opened('<hearth-solid x="0.5" thermal="fixed"></hearth-solid>', 'fit="contain" align="left top"');
  const reads = () =>
    tab.evaluate(async () => {
      const { prototype } = Element;
      const { getBoundingClientRect } = prototype;
      let count = 0;
      prototype.getBoundingClientRect = function counted() {
        // The fire reads its own box to know whether it is shown.
        count += this.localName === 'hearth-fire' ? 0 : 1;
        return getBoundingClientRect.call(this);
      };
      for (let frame = 0; frame < 10; frame += 1) await new Promise(requestAnimationFrame);
      prototype.getBoundingClientRect = getBoundingClientRect;
      return count;
    });
  const any = String((object) => object);
  await until(tab, 'the solid', any);
  assert.equal(await reads(), 0, 'no target, no box');
  await tab.fire((fire) => fire.firstElementChild.setAttribute('of', '#headline'));
  await follows(tab, 'the solid has the box');
  assert.ok((await reads()) > 0);
  const object = await until(tab, 'the solid', any);
  assert.deepEqual([object.shape, object.material, object.thermal, object.angle], ['box', 'none', 'fixed', 0]);
  // 300 pixels are 1.8 m.
  assert.ok(Math.abs(object.corner - (8 * 1.8) / 300) < 1e-4, `${object.corner}`);
  await tab.fire((fire) => fire.firstElementChild.setAttribute('material', 'wood'));
  await until(
    tab,
    'it is wood',
    String(({ material }) => material === 'wood'),
  );
  // Without `of` it is what its attributes state.
  await tab.fire((fire) => fire.firstElementChild.removeAttribute('of'));
  const plain = await until(
    tab,
    'its attribute',
    String(({ x }) => x === 0.5),
  );
  assert.deepEqual([plain.shape, plain.y, plain.width, plain.corner], ['circle', 0.5, 0.2, 0]);
  await tab.fire((fire) => fire.firstElementChild.setAttribute('of', '#headline'));
  await follows(tab, 'the solid has the box again');
  for (const style of [
    { left: '90px', top: '40px' },
    { width: '50px', padding: '5px', borderRadius: '50%' },
    { position: 'fixed' },
    { transform: 'translate(10px, 20px) scale(1.5)' },
  ]) {
    await restyle(tab, style);
    await follows(tab, JSON.stringify(style));
    if (style.borderRadius) {
      await until(
        tab,
        'it has another radius',
        String(({ corner, height }) => Math.abs(corner - height / 2) < 1e-3),
      );
    }
    await tab.evaluate(() => scrollTo(0, 50));
  }
  await follows(tab, 'the page is scrolled under it');
  await tab.fire((fire) => Object.assign(fire.style, { height: '240px', width: '300px' }));
  await follows(tab, 'the fire has another size');
  for (const [name, value] of [
    ['fit', 'width'],
    ['align', 'right center'],
    ['zoom', '2'],
    ['pan', '0.2 0.7'],
  ]) {
    await tab.fire((fire, name, value) => fire.setAttribute(name, value), name, value);
    await follows(tab, `${name} = ${value}`);
  }
  // The report of the height moves the solid, whose list the engine gets after the preset.
  await tab.fire((fire) => {
    fire.setAttribute('domain-height', '3');
    fire.setAttribute('preset', 'candle');
  });
  await tab.until('the scene', () => /** @type {any} */ (document.querySelector('hearth-fire')).objects.length === 4);
  await follows(tab, 'it has the box in the other scene');
  assert.deepEqual(tab.problems, []);
  await tab.fire((fire) => {
    fire.style.marginTop = '9000px';
  });
  await tab.frames(5);
  assert.equal(await reads(), 0, 'the fire is out of sight');
});

test('a source burns along the upper side of an element; without the element there is no object', async () => {
  const tab = await opened(`<hearth-source of="#headline" power="100"></hearth-source>
    <hearth-solid id="lid" of="#none"></hearth-solid>`);
  await restyle(tab, { top: '220px' });
  const metres = (/** @type {number} */ pixels) => (pixels * 1.8) / 300;
  const source = await until(
    tab,
    'its place',
    String(({ y }) => y < 0.5 && y !== 0.25),
  );
  assert.deepEqual(
    [source.x, source.y, source.width, source.power].map((value) => value.toFixed(3)),
    [0, metres(80), metres(80), 100].map((value) => value.toFixed(3)),
  );
  assert.equal(await tab.fire((fire) => fire.params.source_width), source.width);
  await restyle(tab, { width: '190px', left: '0', top: '10px' });
  await until(
    tab,
    'its new width',
    String(({ width, y }) => Math.abs(width - 1.14) < 1e-3 && Math.abs(y - 1.74) < 1e-3),
  );
  const gone = (what) =>
    until(
      tab,
      what,
      String((object) => object === null),
    );
  await restyle(tab, { display: 'none' });
  await gone('the source is gone');
  assert.deepEqual(await tab.fire((fire) => fire.objects), []);
  await restyle(tab, { display: '' });
  await until(
    tab,
    'the source is back',
    String((object) => object),
  );
  await tab.evaluate(() => {
    const headline = document.querySelector('#headline');
    /** @type {any} */ (window).headline = headline;
    headline.remove();
  });
  await gone('the source is gone with its element');
  await tab.evaluate(() => document.body.append(/** @type {any} */ (window).headline));
  await until(
    tab,
    'the source is back with its element',
    String((object) => object),
  );
  await tab.evaluate(() =>
    document.body.insertAdjacentHTML(
      'beforeend',
      '<i id="none" style="position: absolute; left: 50px; top: 150px; width: 90px; height: 30px"></i>',
    ),
  );
  await tab.until('the solid has a place', () => /** @type {any} */ (document.querySelector('#lid')).objectId);
  assert.deepEqual(tab.problems.length, 2, tab.problems.join('\n'));
  const all = [...tab.problems].sort();
  assert.match(all[0], /<hearth-solid id="lid">: of = #none has no effect now: no element has that id/);
  assert.match(all[1], /<hearth-source>: of = #headline has no effect now: that element has no visible box/);
  await tab.fire((fire) => fire.firstElementChild.remove());
  await tab.until('the source of the settings is back', () => {
    const { objects } = /** @type {any} */ (document.querySelector('hearth-fire'));
    const source = objects.find(({ kind }) => kind === 'source');
    return source?.width === 0.4 && source.power === 220;
  });
});
