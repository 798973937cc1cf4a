/**
 * The landing page: its scene, the strip of scenes, the hint, the panel and the dialogs.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { Browser, eventually } from '../driver.mjs';
import { Panel } from '../panel.mjs';
import { table } from '../site.mjs';
import { assertApart, assertReadable } from '../landing.mjs';
import { strip } from '../waits.mjs';

const { PRESETS } = await table();

const WIDE = { width: 1000, height: 640 };
const PHONE = { width: 390, height: 844, touch: true };
const LANDING = 'fireside';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** The scene that the strip marks. @param {import('../driver.mjs').Tab} tab */
const marked = (tab) =>
  tab.evaluate(() =>
    [...document.querySelectorAll('#scenes [aria-current="true"]')].map((tile) => tile.getAttribute('data-starts')),
  );

/** Which files of that name the page has loaded. @param {import('../driver.mjs').Tab} tab @param {string} name */
const loaded = (tab, name) =>
  tab.evaluate(
    (name) =>
      performance
        .getEntriesByType('resource')
        .map((entry) => entry.name)
        .filter((url) => url.includes(name)),
    name,
  );

/** @param {import('../driver.mjs').Tab} tab */
const panelIs = (tab) => tab.evaluate(() => document.documentElement.dataset.panel);

describe('the address', () => {
  for (const [query, scene] of [
    ['', LANDING],
    ['?wind=0.5', LANDING],
    ['?scene=candle&exposure=0.3', 'candle'],
  ]) {
    test(`“${query}” shows the scene ${scene}`, async () => {
      const tab = await browser.open(`index.html${query}`);
      await tab.ready();
      await strip(tab);
      assert.equal(await tab.fire((fire) => fire.preset), scene);
      assert.deepEqual(await marked(tab), [scene]);
      const still = await tab.evaluate(() => document.getElementById('still') !== null);
      assert.equal(still, query === '', 'the still picture is of the fire that comes');
      assert.deepEqual(tab.problems, []);
    });
  }
});

test('a page whose script fails shows the still picture of its fire', async () => {
  const tab = await browser.open('index.html', { ...WIDE, without: 'pages/main.js' });
  await tab.until('the picture', () => /** @type {any} */ (document.getElementById('still')).complete);
  const [stage, still] = [await tab.rectangle('#fire'), await tab.rectangle('#still')];
  assert.deepEqual([still.y, still.height], [stage.y, stage.height]);
  const middle = ({ x, width }) => x + width / 2;
  assert.ok(Math.abs(middle(still) - middle(stage)) < 1);
});

describe('the strip of scenes', () => {
  test('has every scene, the page’s own first, and a click starts one', async () => {
    const tab = await browser.open('index.html', WIDE);
    await tab.ready();
    await strip(tab);
    const names = await tab.evaluate(() =>
      [...document.querySelectorAll('#scenes button')].map((tile) => [
        tile.getAttribute('data-starts'),
        tile.getAttribute('aria-label'),
      ]),
    );
    assert.equal(names[0][0], LANDING);
    assert.deepEqual([...names].sort(), PRESETS.map(({ name, label }) => [name, label]).sort());
    await tab.page.click('[data-starts="candle"]');
    await tab.until('the address names the scene', () => location.search === '?scene=candle');
    assert.deepEqual(await marked(tab), ['candle']);
    await tab.page.click('[data-starts="default"]');
    await tab.until('the default is named', () => location.search === '?scene=default');
    await tab.page.click(`[data-starts="${LANDING}"]`);
    await tab.until('the address is empty again', () => location.search === '');
    assert.deepEqual(tab.problems, []);
  });

  test('shows a word whole on a phone, unless the address names another fit', async () => {
    /** The sides of the picture [m]. @param {import('../driver.mjs').Tab} tab */
    const seen = (tab) => tab.fire((fire) => [0, fire.clientWidth].map((x) => fire.toMetres(x, 0).x));
    const tab = await browser.open('index.html?scene=burning-word', PHONE);
    await tab.ready();
    const width = await tab.fire((fire) => fire.params.domainWidth ?? fire.params.domain_width);
    const [left, right] = await seen(tab);
    assert.ok(left <= -width / 2 + 1e-3 && right >= width / 2 - 1e-3, `${left} to ${right} m of ${width} m`);
    await strip(tab);
    await tab.page.click('[data-starts="candle"]');
    await tab.until('another scene fills the height', () => !document.getElementById('fire')?.hasAttribute('fit'));
    const other = await browser.open('index.html?scene=burning-word&fit=height', PHONE);
    await other.ready();
    const [start, end] = await seen(other);
    assert.ok(end - start < width - 0.1);
    assert.deepEqual([...tab.problems, ...other.problems], []);
  });

  test('is one stop of the Tab key, and arrows go through it', async () => {
    const tab = await browser.open('index.html?paused', WIDE);
    await tab.ready();
    await strip(tab);
    const focused = () => tab.evaluate(() => document.activeElement?.getAttribute('data-starts'));
    await tab.page.focus(`[data-starts="${LANDING}"]`);
    await tab.key('ArrowRight');
    const second = await focused();
    assert.ok(second && second !== LANDING);
    assert.equal(
      await tab.evaluate(() => document.querySelector('#scenes p')?.textContent),
      PRESETS.find(({ name }) => name === second).label,
    );
    await tab.key('End');
    await tab.key('Home');
    assert.equal(await focused(), LANDING);
    await tab.key('Tab');
    assert.equal(await focused(), null);
    assert.equal(await tab.evaluate(() => document.querySelectorAll('#scenes [tabindex="0"]').length), 1);
  });
});

test('the chosen thumbnail shows that its scene begins', async () => {
  const tab = await browser.open('index.html', WIDE);
  await tab.ready();
  await strip(tab);
  const busy = await tab.page.$eval('[data-starts="candle"]', (tile) => {
    /** @type {HTMLElement} */ (tile).click();
    return [tile.getAttribute('aria-busy'), getComputedStyle(tile, '::after').animationName];
  });
  assert.deepEqual(busy, ['true', 'turn']);
  await tab.until('the scene', () => {
    const tile = document.querySelector('[data-starts="candle"]');
    return tile?.getAttribute('aria-current') === 'true' && !tile.hasAttribute('aria-busy');
  });
  assert.equal(await tab.evaluate(() => document.querySelector('#scenes [aria-busy]')), null);
});

test('buttons enlarge the picture and reduce it to its own size; fingers do so themselves', async () => {
  const tab = await browser.open('index.html?paused', WIDE);
  await tab.ready();
  await strip(tab);
  const zoom = () => tab.fire((fire) => fire.zoom);
  for (const expected of [1.25, 1.5625]) {
    await tab.page.click('#zoom [data-zooms="in"]');
    assert.equal(await zoom(), expected);
  }
  for (const expected of [1.25, 1, 1]) {
    await tab.page.click('#zoom [data-zooms="out"]');
    assert.equal(await zoom(), expected);
  }
  for (let press = 0; press < 12; press += 1) await tab.page.click('#zoom [data-zooms="in"]');
  assert.equal(await zoom(), 10);
  assert.deepEqual(tab.problems, []);
  const phone = await browser.open('index.html?paused', PHONE);
  await phone.ready();
  await strip(phone);
  assert.deepEqual(
    await phone.evaluate(() =>
      [...document.querySelectorAll('#zoom > *')].map((button) => [button.checkVisibility(), button.textContent]),
    ),
    [
      [false, '+'],
      [false, '−'],
      [true, 'A B'],
    ],
  );
});

test('where the system has a share sheet, a button gives it the link and nothing else', async () => {
  const offer = () => {
    const page = /** @type {any} */ (window);
    page.shared = [];
    Object.defineProperty(navigator, 'share', {
      value: async (/** @type {any} */ what) => {
        page.shared.push(what);
        // As by a visitor who closes the sheet.
        throw new DOMException('closed', 'AbortError');
      },
    });
  };
  const tab = await browser.open('index.html?scene=candle&exposure=0.3', { ...PHONE, before: offer });
  await tab.ready();
  await tab.page.tap('#share');
  const [shared] = await tab.until(
    'the sheet',
    () => /** @type {any} */ (window).shared.length && /** @type {any} */ (window).shared,
  );
  assert.deepEqual(Object.keys(shared), ['url']);
  assert.equal(new URL(shared.url).search, '?scene=candle&exposure=0.3');
  assert.equal(await tab.evaluate(() => document.getElementById('toast')?.textContent), '');
  assert.deepEqual(tab.problems, []);
  const other = await browser.open('index.html', PHONE);
  await other.ready();
  assert.equal(await other.page.$eval('#share', (button) => /** @type {HTMLElement} */ (button).hidden), true);
});

test('the fire is grabbed anywhere below the middle of its flame, by a hand that the pointer shows', async () => {
  const tab = await browser.open('index.html?paused', { ...WIDE, draws: true });
  await tab.ready();
  await strip(tab);
  const picture = await tab.firePicture();
  const [stage, source] = [
    await tab.rectangle('#fire'),
    await tab.fire((fire) => fire.toPixels(fire.params.source_x, fire.params.source_height)),
  ];
  /** The rows in which a quarter of the flame’s width or more is bright. */
  const rows = [];
  for (let y = 0; y < picture.height; y += 1) {
    const row = picture.crop(
      source.x / stage.width - 0.12,
      y / picture.height,
      source.x / stage.width + 0.12,
      (y + 1) / picture.height,
    );
    if (row.share((r, g, b) => r > 200 && g > 120 && r > g && g > b) > 0.1) rows.push(y);
  }
  const [top, bottom] = [stage.y + rows[0], stage.y + source.y];
  assert.ok(bottom - top > 100, `the flame is from ${top} to ${bottom}`);
  const cursor = () => tab.fire((fire) => getComputedStyle(fire.shadowRoot.querySelector('.root')).cursor);
  const x = stage.x + source.x;
  for (const share of [0, 0.25, 0.5]) {
    await tab.move({ x, y: bottom - share * (bottom - top) });
    await tab.frames();
    assert.equal(await cursor(), 'grab', `at ${share} of the flame, which is ${bottom - top} px high`);
  }
  await tab.drag({ x, y: (top + bottom) / 2 }, { x: x + 60, y: (top + bottom) / 2 });
  await tab.until(
    'the source follows',
    () => /** @type {any} */ (document.getElementById('fire')).params.source_x > 0.05,
  );
  await tab.move({ x, y: stage.y + 140 });
  await tab.frames();
  assert.notEqual(await cursor(), 'grab', 'above the flame');
});

/** The link to the gallery is in sight and can be pressed. @param {import('../driver.mjs').Tab} tab @param {number} width @param {string} size */
async function assertGallery(tab, width, size) {
  const seen = () =>
    tab.page.$eval('#head a[href="./gallery.html"]', (link) => {
      const { x, y, width, height, right } = link.getBoundingClientRect();
      return { x, y, right, isOver: document.elementFromPoint(x + width / 2, y + height / 2) === link };
    });
  const isThere = ({ x, y, right, isOver }) => x >= 0 && y >= 0 && right <= width && isOver;
  // The words go while no pointer moves.
  let at = 0;
  const move = () => tab.move({ x: 4, y: 4 + (at++ % 2) });
  await eventually(`the link to the gallery, ${size}`, seen, isThere, move);
}

for (const [about, sizes] of /** @type {[string, number[][]][]} */ ([
  [
    'phones',
    [
      [320, 568],
      [390, 844],
      [667, 375],
    ],
  ],
  [
    'screens',
    [
      [844, 390],
      [768, 1024],
      [1280, 800],
      [1920, 1080],
    ],
  ],
])) {
  test(`on ${about} words, hint, buttons and scenes lie apart`, async () => {
    const touch = about === 'phones';
    const [[first, second]] = sizes;
    // With all buttons that a system may offer.
    const before = () => Object.defineProperty(navigator, 'share', { value: () => Promise.resolve() });
    const tab = await browser.open('index.html', { width: first, height: second, touch, draws: true, before });
    await tab.until('the hint', () => document.getElementById('hint')?.textContent);
    await tab.ready();
    await strip(tab);
    await tab.page.waitForSelector('#draw:not([hidden])');
    for (const [width, height] of sizes) {
      await tab.page.setViewport({ width, height, isMobile: touch, hasTouch: touch });
      await tab.frames(4);
      await assertApart(tab, width, `${width} × ${height}`);
      await assertGallery(tab, width, `${width} × ${height}`);
    }
    await assertReadable(tab);
  });
}

describe('the panel', () => {
  test('is not loaded on a phone before it is opened', async () => {
    const tab = await browser.open('index.html', PHONE);
    await tab.ready();
    await strip(tab);
    await tab.burnt(1);
    assert.equal(await panelIs(tab), 'hidden');
    for (const part of ['/panel.js', 'hearth-panel']) assert.deepEqual(await loaded(tab, part), []);
    await new Panel(tab).mounted();
    assert.equal(await panelIs(tab), 'shown');
    assert.ok((await loaded(tab, 'hearth-panel')).length > 0);
    const sheet = await tab.rectangle('#panel');
    assert.ok(sheet.y > PHONE.height / 2, 'the fire stays in sight');
    assert.deepEqual(tab.problems, []);
  });

  test('is as it was left, in the next visit', async () => {
    const tab = await browser.open('index.html', WIDE);
    await tab.ready();
    assert.equal(await panelIs(tab), 'shown');
    await tab.key('h');
    assert.equal(await panelIs(tab), 'hidden');
    const again = await browser.open('index.html', { ...WIDE, remember: true });
    await again.ready();
    await strip(again);
    assert.equal(await panelIs(again), 'hidden');
    assert.deepEqual(await loaded(again, 'hearth-panel'), []);
    await new Panel(again).mounted();
    assert.equal(await again.evaluate(() => localStorage.getItem('hearth-page-panel')), 'shown');
  });
});

test('the panel has the letters of the page around it, and letters of its own where a browser hides what it draws', async () => {
  const hide = () => {
    const { getImageData } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.getImageData = function (...area) {
      const picture = getImageData.apply(this, area);
      picture.data.fill(255);
      return picture;
    };
  };
  const widths = [];
  for (const before of [() => {}, hide]) {
    const tab = await browser.open('index.html', { ...WIDE, before });
    await tab.ready();
    const label = await new Panel(tab).mounted().then((panel) => panel.rectangleOf('label:fuel_power'));
    const page = await tab.evaluate(() => {
      const context = /** @type {CanvasRenderingContext2D} */ (document.createElement('canvas').getContext('2d'));
      context.font = `100px ${getComputedStyle(document.body).fontFamily}`;
      return context.measureText('Strength').width / 100;
    });
    // The label ends four points before its rectangle does.
    widths.push((label.width - 4) / page);
    assert.deepEqual(tab.problems, []);
  }
  // The size of the panel's letters.
  assert.ok(Math.abs(widths[0] - 0.93 * 14.5) < 0.3, `${widths}`);
  assert.ok(Math.abs(widths[1] - widths[0]) > 0.5, `${widths}`);
});

describe('the hint', () => {
  /** Runs in the page before anything of it: keeps all texts of the hint. */
  const keep = () => {
    const page = /** @type {any} */ (window);
    page.hinted = [];
    new MutationObserver(() => {
      const words = document.getElementById('hint')?.textContent;
      if (words && page.hinted.at(-1) !== words) page.hinted.push(words);
    }).observe(document, { subtree: true, childList: true });
  };
  const hinted = (tab) => tab.evaluate(() => /** @type {any} */ (window).hinted);

  test('is shown once, and hidden by the first use', async () => {
    const tab = await browser.open('index.html', { ...WIDE, before: keep });
    await tab.until('the hint', () => document.getElementById('hint')?.textContent);
    assert.match((await hinted(tab))[0], /blow.*click.*drag/);
    await tab.click({ x: 330, y: 300 });
    assert.equal(await tab.evaluate(() => document.getElementById('hint')?.textContent), '');
    const again = await browser.open('index.html', { ...WIDE, before: keep, remember: true });
    await again.ready();
    await strip(again);
    assert.deepEqual(await hinted(again), []);
  });

  test('has its own text for touch, and is not shown with reduced motion', async () => {
    const touch = await browser.open('index.html', { ...PHONE, before: keep });
    await touch.until('the hint', () => document.getElementById('hint')?.textContent);
    assert.match((await hinted(touch))[0], /tap/);
    const still = await browser.open('index.html', { ...WIDE, reducedMotion: true, before: keep });
    await still.ready();
    await strip(still);
    assert.deepEqual(await hinted(still), []);
  });
});

test('the embed dialog shows the code of the current fire, and Escape closes it', async () => {
  const tab = await browser.open('index.html?scene=candle&exposure=0.3', WIDE);
  await tab.ready();
  await tab.page.click('[data-opens="embed"]');
  await tab.until('the dialog', () => document.querySelector('dialog[open] [data-code="html"]'));
  const code = () => tab.page.$eval('#embed textarea', (field) => /** @type {HTMLTextAreaElement} */ (field).value);
  const chooses = async (name, value) => {
    await tab.page.select(`#embed [name=${name}]`, value);
    await tab.frames();
  };
  const style = 'width: 320px; max-width: 100%; height: 400px';
  const element = `<hearth-fire preset="candle" exposure="0.3" warm interactive style="${style}"></hearth-fire>`;
  assert.ok((await code()).replace(/\s+/g, ' ').replace('" >', '">').endsWith(`</script> ${element}`), await code());
  await chooses('fit', 'contain');
  await chooses('ground', 'white');
  assert.equal(
    await tab.page.$eval('#embed label:has([name=behind])', (label) => /** @type {any} */ (label).hidden),
    true,
  );
  /** The attributes of the code, and those of the preview, which differ in its size and place alone. */
  const shown = await tab.evaluate(() => {
    const fire = /** @type {HTMLElement} */ (document.querySelector('#embed .preview hearth-fire'));
    const names = fire.getAttributeNames().filter((name) => !['style', 'loading'].includes(name));
    const { width, height } = fire.style;
    return { width, height, ...Object.fromEntries(names.map((name) => [name, fire.getAttribute(name)])) };
  });
  const [tag] = /<hearth-fire[^>]*>/.exec(await code()) ?? [''];
  const named = [...tag.matchAll(/\s([\w-]+)(?:="([^"]*)")?/g)].map(([, name, value = '']) => [name, value]);
  const { style: size, ...written } = Object.fromEntries(named);
  const [width, height] = ['width', 'height'].map((side) => RegExp(`(?:^| )${side}: (\\d+px)`).exec(size)?.[1]);
  assert.deepEqual(shown, { width, height, ...written });
  assert.deepEqual([written.fit, written['ambient-light']], ['contain', '1']);
  await chooses('ground', 'black');
  await chooses('form', 'iframe');
  const address = 'embed.html?scene=candle&amp;exposure=0.3&amp;warm&amp;interactive&amp;fit=contain';
  await tab.until('the iframe', () =>
    /** @type {any} */ (document.querySelector('#embed textarea')).value.includes('<iframe'),
  );
  assert.ok((await code()).includes(`/${address}" width="320" height="400"`), await code());
  assert.match(await tab.page.$eval('#embed .note', (note) => String(note.textContent)), /about \d+ KB/);
  // The page ignores keys in a dialog.
  const before = await panelIs(tab);
  await tab.key('h');
  assert.equal(await panelIs(tab), before);
  await tab.key('Escape');
  assert.equal(await tab.evaluate(() => document.querySelector('dialog[open]')), null);
  assert.equal(await tab.evaluate(() => document.activeElement?.getAttribute('data-opens')), 'embed');
  assert.equal(await tab.fire((fire) => fire.paused), false, 'the fire of the page goes on');
});

test('the picture that links show looks like the page', async () => {
  const tab = await browser.open(
    `<hearth-fire preset="${LANDING}" warm paused style="width: 1200px; height: 630px"></hearth-fire><img src="/web/poster.jpg" alt="">`,
    { draws: true, width: 1200, height: 630 },
  );
  await tab.ready();
  const differences = await tab.fire(async (fire) => {
    /** Colours of the parts of a picture, so few that the flame of another moment changes little. */
    const coarse = (/** @type {CanvasImageSource} */ source) => {
      const context = /** @type {any} */ (new OffscreenCanvas(24, 12).getContext('2d'));
      context.imageSmoothingQuality = 'high';
      context.drawImage(source, 0, 0, 24, 12);
      return context.getImageData(0, 0, 24, 12).data;
    };
    const image = /** @type {HTMLImageElement} */ (document.querySelector('img'));
    await image.decode();
    // Until all slices of the stored fire have a past.
    await fire.step(1000);
    const stored = coarse(image);
    const mean = async () => {
      const shown = coarse(await createImageBitmap(await fire.toBlob({ background: 'scene' })));
      return stored.reduce((sum, value, at) => sum + Math.abs(value - shown[at]), 0) / stored.length;
    };
    const same = await mean();
    await fire.set('exposure', fire.params.exposure + 2.5);
    const brighter = await mean();
    await fire.set({ exposure: fire.params.exposure - 2.5, backdrop: 'none' });
    return { same, brighter, other: await mean() };
  });
  const seen = JSON.stringify(differences);
  // Another moment of the scene differs by 5 to 7 of 255.
  assert.ok(differences.same < 9, seen);
  assert.ok(differences.brighter > 9 && differences.other > 9, `the test distinguishes another scene: ${seen}`);
});
