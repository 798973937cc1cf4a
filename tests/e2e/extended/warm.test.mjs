/**
 * Warm start: a fire burns before it is shown, and the poster or the previous picture
 * stays until then. Tests count pictures and await events.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { assertBurns, events, recording } from '../assertions.mjs';
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

test('a prewarmed scene burns on until it has a past to show, in every quality', async () => {
  for (const quality of ['low', 'high']) {
    const tab = await show(`<hearth-fire preset="fireside" warm quality="${quality}" paused></hearth-fire>`, {
      draws: true,
    });
    await tab.ready();
    const { time, particles, limit } = await tab.fire((fire) => fire.stats);
    const burnt = time - (await keptTime(tab));
    assert.ok(burnt >= 0.5 && burnt < 0.6, `${burnt} s`);
    // A scene may have a number of its own. Open air fills somewhat less or more.
    const own = await tab.fire((fire) => fire.params.particles);
    const number = limit ? { low: 1200, high: 6700 }[quality] : own;
    assert.ok(Math.abs(particles / number - 1) < 0.45, `${particles} of ${number}`);
    assert.ok((await flame(tab)) > 0.2);
    // The slices behind follow as the fire becomes as old as their moments.
    await tab.fire((fire) => fire.step(1000));
    await tab.until('slices', () => /** @type {any} */ (document.querySelector('hearth-fire')).stats.slices > 1);
    assert.deepEqual(tab.problems, []);
  }
});

test('other values than those of the prewarmed fire burn first, and those of the look do not matter', async () => {
  for (const [attributes, kept] of [
    ['exposure="1" backdrop="none"', true],
    ['fuel-power="150"', false],
  ]) {
    const tab = await show(`<hearth-fire preset="fireside" warm="1" paused ${attributes}></hearth-fire>`);
    await tab.ready();
    const time = await tab.fire((fire) => fire.stats.time);
    assert.equal(time > 2, kept, `${time} s with ${attributes}`);
  }
});

test('a damaged stored fire is reported, a missing one is not, and the fire burns', async () => {
  const answers = {
    damaged: { before: damage },
    gone: { before: lose },
  };
  for (const [answer, options] of Object.entries(answers)) {
    const tab = await open('<hearth-fire preset="fireside" warm="1" paused></hearth-fire>', options);
    await tab.ready();
    const time = await tab.fire((fire) => fire.stats.time);
    assert.ok(time >= 1 && time < 1.1, `${time} s`);
    const kinds = (await events(tab, 'error')).map(({ kind }) => kind);
    assert.deepEqual(kinds, answer === 'damaged' ? ['load'] : []);
  }
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

test('a playing fire continues from a warm one, also on the page’s thread', async () => {
  for (const thread of ['worker', 'main']) {
    const tab = await open(`<script type="module">
      import { HearthFire } from '/web/hearth-fire.js';
      HearthFire.engine = '${thread}';
    </script><hearth-fire warm="1"></hearth-fire>`);
    await tab.ready();
    await tab.burnt(1.2);
    await assertBurns(tab);
    assert.equal(await tab.fire((fire) => fire.stats.slowed && fire.stats.time < 1.05), false);
    assert.deepEqual(tab.problems, []);
  }
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

test('an invalid warm time is rejected with the allowed range', async () => {
  const tab = await show('<hearth-fire warm="soon" paused></hearth-fire>');
  await tab.ready();
  assert.equal(await tab.fire((fire) => fire.warm), false);
  const [error] = await events(tab, 'error');
  assert.match(error.message, /warm = soon is refused: it must be a number of seconds from 0 to 30/);
  assert.deepEqual(
    await tab.fire((fire) => {
      const all = [];
      for (const warm of [true, 2.5, false, 31, null]) {
        fire.warm = warm;
        all.push(fire.warm, fire.getAttribute('warm'));
      }
      return all;
    }),
    [3, '', 2.5, '2.5', false, null, false, '31', false, null],
  );
});

test('a small fire has few particles and reports it, unless their number is set', async () => {
  const tab = await open('<hearth-fire style="width: 64px; height: 64px"></hearth-fire>', { width: 1000, height: 700 });
  const has = (count, limit) =>
    tab.until(
      `${count} particles by ${limit}`,
      (number, words) => {
        const { stats } = /** @type {any} */ (document.querySelector('hearth-fire'));
        // The number fills the frame. Open air fills less at first, and never more than twice as many.
        return stats?.limit === words && stats.particles > 0.5 * number && stats.particles <= 2 * number;
      },
      count,
      limit,
    );
  await has(300, 'size');
  await tab.fire((fire) => {
    fire.style.cssText = 'width: 240px; height: 300px';
  });
  await has(400, 'size');
  await tab.fire((fire) => {
    fire.quality = 'low';
  });
  await has(1200, 'quality low');
  await tab.fire((fire) => fire.set('particles', 800));
  await has(800, '');
  await tab.fire((fire) => {
    fire.quality = null;
  });
  await has(800, '');
  await tab.fire((fire) => fire.restore('particles'));
  await has(400, 'size');
});

/** Time at which the fire of the scene was saved, from its bytes [s]. */
function keptTime(tab) {
  return tab.evaluate(async () => {
    const response = await fetch('/web/prewarmed/fireside.fire');
    return new DataView(await response.arrayBuffer()).getFloat64(24, true);
  });
}

/** Run in the page before anything of it: what comes of a prewarmed fire is something else. */
function damage() {
  const real = fetch;
  window.fetch = (url, ...rest) =>
    String(url).endsWith('.fire') ? Promise.resolve(new Response(new Uint8Array(100))) : real(url, ...rest);
}
function lose() {
  const real = fetch;
  window.fetch = (url, ...rest) =>
    String(url).endsWith('.fire') ? Promise.reject(new TypeError('gone')) : real(url, ...rest);
}
