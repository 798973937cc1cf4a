/**
 * What *Embed* copies looks as what it shows: the page of the copied HTML and the preview, on the same ground and on average
 * over the same moments of the fire. `HEARTH_SCENES=candle,torch` compares these scenes on each ground, and `all` every one.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { table } from '../site.mjs';

const { PRESETS } = await table();

const GROUNDS = ['white', 'black', 'brick', 'picture'];

const { HEARTH_SCENES: named } = process.env;
const SCENES = PRESETS.map(({ name }) => name);
const wanted = named === 'all' ? SCENES : named?.split(',');
for (const name of wanted ?? []) assert.ok(SCENES.includes(name), `HEARTH_SCENES: there is no scene "${name}"`);

/** The scenes and their grounds. @type {[string, string][]} */
const CASES = wanted
  ? wanted.flatMap((name) => GROUNDS.map((ground) => /** @type {[string, string]} */ ([name, ground])))
  : [
      ['fireside', 'white'],
      ['candle', 'picture'],
      ['torch', 'black'],
      ['wooden-word', 'brick'],
    ];

/** The element, which the preview shows in its own size, and the moments at which they are compared, and their period [s]. */
const SIZE = { width: 200, height: 240 };
const MOMENTS = 20;
const PERIOD = 0.2;

/** The largest difference of two pictures (CIE76, on average over their pixels). */
const LIKE = 3;

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

/** L*a*b* of a colour of sRGB. @type {(r: number, g: number, b: number) => number[]} */
function lab(r, g, b) {
  const [red, green, blue] = [r, g, b].map((byte) =>
    byte <= 10 ? byte / 3295 : ((byte / 255 + 0.055) / 1.055) ** 2.4,
  );
  const root = (/** @type {number} */ share) => (share > 0.008856 ? Math.cbrt(share) : 7.787 * share + 16 / 116);
  const [x, y, z] = [
    (0.4124 * red + 0.3576 * green + 0.1805 * blue) / 0.9505,
    0.2126 * red + 0.7152 * green + 0.0722 * blue,
    (0.0193 * red + 0.1192 * green + 0.9505 * blue) / 1.089,
  ].map(root);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

/** @param {import('../picture.mjs').Picture} a @param {import('../picture.mjs').Picture} b */
function difference(a, b) {
  assert.deepEqual([a.width, a.height], [b.width, b.height]);
  let sum = 0;
  for (let at = 0; at < a.rgb.length; at += 3) {
    const [p, q] = [a, b].map(({ rgb }) => lab(rgb[at], rgb[at + 1], rgb[at + 2]));
    sum += Math.hypot(...p.map((value, axis) => value - q[axis]));
  }
  return sum / (a.rgb.length / 3);
}

/**
 * Restarts the fire of that selector: its mean picture over the moments, as tongues of two fires differ at any one.
 * @param {import('../driver.mjs').Tab} tab @param {string} selector
 */
async function pictureOf(tab, selector) {
  await tab.page.$eval(selector, async (element) => {
    const fire = /** @type {any} */ (element);
    await fire.ready;
    fire.pause();
    // The automatic choice depends on the machine.
    fire.quality = 'low';
    await fire.reset();
  });
  const pictures = [];
  // Before the first one, the page may still show the picture of other settings.
  for (let moment = -1; moment < MOMENTS; moment += 1) {
    await tab.page.$eval(selector, (fire, seconds) => /** @type {any} */ (fire).advance(seconds), PERIOD);
    await tab.frames(3);
    if (moment >= 0) pictures.push(await tab.picture(await tab.rectangle(selector)));
  }
  const mean = (/** @type {number} */ _, /** @type {number} */ at) =>
    pictures.reduce((sum, { rgb }) => sum + rgb[at], 0) / MOMENTS;
  return { ...pictures[0], rgb: pictures[0].rgb.map(mean) };
}

/** The last scene: a wall hides the ground, so that it looks alike on each. @type {{scene: string, preview: import('../picture.mjs').Picture} | undefined} */
let last;
for (const [scene, ground] of CASES) {
  test(`the copied HTML of ${scene} on a page that is ${ground} looks as the preview`, async (context) => {
    const tab = await browser.open(`index.html?scene=${scene}&paused`, { width: 800, height: 700, pixels: 4000 });
    await tab.ready();
    await tab.evaluate(() => document.querySelector('[data-opens="embed"]')?.dispatchEvent(new MouseEvent('click')));
    await tab.until('the dialog', () => document.querySelector('dialog[open] [data-code="html"]'));
    await tab.page.select('#embed [name=ground]', ground);
    for (const [side, length] of Object.entries(SIZE))
      await tab.page.$eval(
        `#embed [name=${side}]`,
        (field, length) => {
          /** @type {HTMLInputElement} */ (field).value = String(length);
          field.dispatchEvent(new Event('input', { bubbles: true }));
        },
        length,
      );
    const { height } = SIZE;
    await tab.until(
      'the code has the size',
      (height) => /** @type {any} */ (document.querySelector('#embed textarea')).value.includes(`height: ${height}px`),
      height,
    );
    const preview = await pictureOf(tab, '#embed .preview > hearth-fire');
    const { code, style } = await tab.evaluate(() => {
      const box = /** @type {HTMLElement} */ (document.querySelector('#embed .preview'));
      const fire = /** @type {HTMLElement} */ (box.firstElementChild);
      const { x, y } = fire.getBoundingClientRect();
      const { width, height } = box.getBoundingClientRect();
      const [left, top] = [
        x - box.getBoundingClientRect().x - box.clientLeft,
        y - box.getBoundingClientRect().y - box.clientTop,
      ];
      const { backgroundColor, backgroundImage, backgroundSize, backgroundPosition } = getComputedStyle(box);
      return {
        code: /** @type {HTMLTextAreaElement} */ (document.querySelector('#embed textarea')).value,
        style: `box-sizing: border-box; width: ${width - 2}px; height: ${height - 2}px; padding: ${top}px 0 0 ${left}px; background: ${backgroundColor}; background-image: ${backgroundImage}; background-size: ${backgroundSize}; background-position: ${backgroundPosition}`,
      };
    });
    const page = await browser.open(
      `<!doctype html><html lang="en"><title>A page</title><body style="margin: 0"><div style='${style}'>${code.replace('></hearth-fire>', ' id="copied"></hearth-fire>')}</div></body></html>`,
      { width: 800, height: 700 },
    );
    const copied = await pictureOf(page, 'hearth-fire');
    const found = difference(preview, copied);
    context.diagnostic(`ΔE ${found.toFixed(2)}`);
    assert.ok(found <= LIKE, `ΔE ${found.toFixed(2)}`);
    if (last && last.scene !== scene)
      assert.ok(difference(preview, last.preview) > LIKE, 'the test distinguishes scenes');
    last = { scene, preview };
    assert.deepEqual(page.problems, []);
  });
}
