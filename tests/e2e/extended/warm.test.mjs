/**
 * Warm start: a fire burns before it is shown, and the poster or the previous picture
 * stays until then. Tests count pictures and await events.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { recording } from '../assertions.mjs';
import { destroyedAndBack } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const small = { width: 240, height: 240 };

/** Runs in the page before anything of it: keeps how old the fire was in each picture. */
function keepPictures() {
  const page = /** @type {any} */ (window);
  page.pictures = 0;
  page.fades = 0;
  const { prototype } = ImageBitmapRenderingContext;
  const original = prototype.transferFromImageBitmap;
  prototype.transferFromImageBitmap = function transferFromImageBitmap(bitmap) {
    if (bitmap) page.pictures += 1;
    original.call(this, bitmap);
  };
  const animate = Element.prototype.animate;
  Element.prototype.animate = function animated(...how) {
    const animation = animate.apply(this, how);
    page.fades += 1;
    page.faded = `${this.className}: ${getComputedStyle(this).display}`;
    // It lasts as long as a test looks at it.
    if (page.holdFades) animation.pause();
    return animation;
  };
}

/** A page of its own. */
const open = (html, options = {}) => browser.open(recording(html), { ...small, before: keepPictures, ...options });

/** A fire whose pictures are counted from the first one. */
const show = (html, options = {}) =>
  browser.show(
    `<script>Object.assign(window, { pictures: 0, fades: 0, holdFades: false })</script>${recording(html)}`,
    { ...small, before: keepPictures, ...options },
  );

/** What the inside of the first fire shows. */
const seen = (tab) =>
  tab.fire((fire) => {
    const root = fire.shadowRoot;
    return {
      drawn: 'drawn' in root.querySelector('.root').dataset,
      poster: getComputedStyle(root.querySelector('.poster')).display !== 'none',
      before: root.querySelectorAll('.before').length,
      pictures: /** @type {any} */ (window).pictures,
    };
  });

/** What part of the picture's height has light. */
async function flame(tab) {
  const picture = await tab.firePicture();
  const rows = [...Array(20).keys()].filter((row) => picture.crop(0, row / 20, 1, (row + 1) / 20).glowing() > 0.01);
  return rows.length === 0 ? 0 : (rows[rows.length - 1] - rows[0] + 1) / 20;
}

test('the first picture is that of a fire that has burnt, and ready waits for it', async () => {
  const tab = await show('<hearth-fire warm="3" paused></hearth-fire>', { draws: true });
  await tab.ready();
  // The poster fades.
  const { drawn, pictures } = await seen(tab);
  assert.deepEqual({ drawn, pictures }, { drawn: true, pictures: 1 });
  const { time, paused } = await tab.fire((fire) => fire.stats);
  assert.ok(time >= 3 && time < 3.1, `${time} s`);
  assert.ok(paused);
  assert.ok((await flame(tab)) > 0.2, `${await flame(tab)} of the height`);
  assert.deepEqual(tab.problems, []);
});

test('a prewarmed scene burns on until it has a past to show', async () => {
  const tab = await show('<hearth-fire preset="fireside" warm quality="low" paused></hearth-fire>', { draws: true });
  await tab.ready();
  const burnt = (await tab.fire((fire) => fire.stats.time)) - (await keptTime(tab));
  assert.ok(burnt >= 0.5 && burnt < 0.6, `${burnt} s`);
  assert.ok((await flame(tab)) > 0.2);
  // The slices behind follow as the fire becomes as old as their moments.
  await tab.fire((fire) => fire.step(1000));
  await tab.until('slices', () => /** @type {any} */ (document.querySelector('hearth-fire')).stats.slices > 1);
  assert.deepEqual(tab.problems, []);
});

test('a fire whose source moves in every frame is shown', async () => {
  const tab = await browser.open('<!doctype html>');
  await tab.evaluate(async () => {
    const { FireSource } = await import(new URL('./web/worlds/source.js', location.href).href);
    const picture = (/** @type {ImageBitmap} */ bitmap) => {
      bitmap.close();
      Object.assign(window, { shown: true });
    };
    const fire = new FireSource({ warm: 5, width: 64, height: 64, thread: 'main' }, { picture, error: console.error });
    await fire.ready;
    let frame = 0;
    const move = () => {
      frame += 1;
      fire.set({ source_x: (frame % 2) / 10 });
      requestAnimationFrame(move);
    };
    move();
  });
  await tab.until('a picture', () => /** @type {any} */ (window).shown);
  assert.deepEqual(tab.problems, []);
});

test('the picture before stays until the new fire is warm, and fades into it', async () => {
  const tab = await show('<hearth-fire warm="1" paused></hearth-fire>', { draws: true });
  await tab.ready();
  await tab.evaluate(() => {
    /** @type {any} */ (window).holdFades = true;
  });
  for (const [at, change] of [
    (fire) => fire.setAttribute('preset', 'candle'),
    (fire) => fire.importConfig({ preset: 'torch' }),
    (fire) => fire.reset(),
  ].entries()) {
    const was = await tab.firePicture();
    await tab.fire(change);
    const { pictures, drawn } = await seen(tab);
    assert.ok(drawn);
    if (pictures === at + 1)
      assert.ok(was.difference(await tab.firePicture()) < 1 || (await seen(tab)).pictures > pictures);
    await tab.until('one picture of the new fire', (count) => /** @type {any} */ (window).pictures === count, at + 2);
    // The previous frame lies over it until it has faded.
    const { before: over } = await seen(tab);
    assert.equal(over, 1);
    await tab.fire((fire) =>
      fire.shadowRoot
        .querySelector('.before')
        .getAnimations()
        .forEach((animation) => {
          animation.finish();
        }),
    );
    await tab.until(
      'what has faded is gone',
      () => document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.before') === null,
    );
    const blob = await tab.fire(async (fire) => (await fire.toBlob()).size);
    assert.ok(blob > 500);
  }
  assert.deepEqual(tab.problems, []);
});

test('where less motion is wanted nothing fades, and the still is a warm fire', async () => {
  const tab = await open('<hearth-fire warm="2"></hearth-fire>', { reducedMotion: true });
  await tab.ready();
  assert.ok((await tab.fire((fire) => fire.paused && fire.stats.time)) >= 2);
  await tab.fire((fire) => {
    fire.preset = 'candle';
  });
  await tab.until('a second picture', () => /** @type {any} */ (window).pictures === 2);
  assert.equal(await tab.evaluate(() => /** @type {any} */ (window).fades), 0);
  assert.equal((await seen(tab)).before, 0);
});

test('a fire that is hidden, removed or loses its context while it warms is shown in the end', async () => {
  const hidden = await show('<hearth-fire warm="1" paused style="display: none"></hearth-fire>');
  await hidden.ready();
  assert.equal((await seen(hidden)).pictures, 0);
  await hidden.fire((fire) => {
    fire.style.display = '';
  });
  await hidden.until('its picture', () => /** @type {any} */ (window).pictures === 1);
  const time = await hidden.fire((fire) => fire.stats.time);
  assert.ok(time >= 1, `${time} s`);

  const tab = await show('<hearth-fire warm="1" paused></hearth-fire>');
  await tab.fire((fire) => {
    fire.remove();
    document.body.append(fire);
    return fire.ready;
  });
  await destroyedAndBack(tab);
  await tab.fire((fire) => fire.toBlob());
  assert.ok((await seen(tab)).drawn);

  const lost = await show('<hearth-fire warm="2" paused></hearth-fire>');
  await lost.ready();
  await lost.fire((fire) => {
    fire.reset();
  });
  await lost.loseContext(100);
  await lost.until('its picture', () => /** @type {any} */ (window).pictures >= 2);
});

/** Time at which the fire of the scene was saved, from its bytes [s]. */
function keptTime(tab) {
  return tab.evaluate(async () => {
    const response = await fetch('/web/prewarmed/fireside.fire');
    return new DataView(await response.arrayBuffer()).getFloat64(24, true);
  });
}
