/**
 * The recipes of the documentation, as a reader runs them there: in both motion settings, both themes and two widths. What
 * their markup may contain is tested in `tests/web/docs-markup.test.mjs`; as pages of their own they run in `embedding`.
 */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { Browser, eventually } from '../driver.mjs';

const DOC = readFileSync(new URL('../../../docs/recipes.md', import.meta.url), 'utf8');
const RECIPES = [...DOC.matchAll(/^## (.*)$(?:(?!^## )[\s\S])*?^```html live$/gm)].map(([, heading]) => heading);
const WIDTHS = [
  { width: 1280, height: 800 },
  { width: 390, height: 844, touch: true },
];
/** Contrast of large and of small words that guidelines ask for. */
const [LARGE, SMALL] = [3, 4.5];
/** What hides its words until it has burnt away [s of fire]. */
const COVERED = { Reveal: 20 };

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

/** @param {number[]} rgb */
function luminance(rgb) {
  const [r, g, b] = rgb.map((value) => (value <= 10 ? value / 3295 : ((value / 255 + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/**
 * The words of the example that burns, but those that burn themselves: what they are, whether they are large, and their
 * contrast with what lies behind 95 % of their box.
 * @param {import('../driver.mjs').Tab} tab
 */
async function words(tab) {
  const texts = await tab.evaluate(() => {
    const burn = [...document.querySelectorAll('[burning]')].map((solid) => solid.getAttribute('of'));
    const elements = [...document.querySelectorAll('.burning :is(h1, h2, h3, p)')];
    return elements
      .filter(({ id }) => !burn.includes(`#${id}`))
      .map((element) => {
        const range = document.createRange();
        range.selectNodeContents(element);
        const { x, y, width, height } = range.getBoundingClientRect();
        const { color, fontSize, fontWeight } = getComputedStyle(element);
        const size = Number.parseFloat(fontSize);
        const large = size >= 24 || (size >= 18.66 && Number(fontWeight) >= 700);
        /** @type {HTMLElement} */ (element).style.setProperty('-webkit-text-fill-color', 'transparent');
        return {
          text: element.textContent ?? '',
          clip: { x: x + scrollX, y: y + scrollY, width, height },
          color,
          large,
        };
      });
  });
  await tab.frames(3);
  const found = [];
  for (const { text, clip, color, large } of texts) {
    const own = luminance([...color.matchAll(/[\d.]+/g)].slice(0, 3).map(Number));
    const { rgb } = await tab.picture(clip);
    const behind = Array.from({ length: rgb.length / 3 }, (_, at) => luminance([...rgb.subarray(3 * at, 3 * at + 3)]));
    const contrasts = behind.map((one) => (Math.max(one, own) + 0.05) / (Math.min(one, own) + 0.05));
    found.push({ text, large, contrast: contrasts.toSorted((a, b) => a - b)[Math.floor(0.05 * contrasts.length)] });
  }
  return found;
}

/** The fire as it is on the screen of a page that has scrolled. @param {import('../driver.mjs').Tab} tab */
async function firePicture(tab) {
  const { x, y, ...size } = await tab.rectangle('hearth-fire');
  const [left, top] = await tab.evaluate(() => [scrollX, scrollY]);
  return tab.picture({ x: x + left, y: y + top, ...size });
}

/** Presses the button of an example, and brings its fire into view. @param {import('../driver.mjs').Tab} tab @param {number} at */
async function press(tab, at) {
  await tab.evaluate((number) => {
    const example = document.querySelectorAll('.example')[number];
    example.querySelector('button')?.click();
    // A software renderer computes each pixel.
    for (const fire of example.querySelectorAll('hearth-fire')) fire.setAttribute('max-pixels', '60000');
    example.querySelector('.burning')?.scrollIntoView({ block: 'center' });
  }, at);
}

for (const reducedMotion of [false, true]) {
  for (const theme of ['light', 'dark']) {
    for (const size of WIDTHS) {
      const name = `${size.width} pixels, ${theme}, ${reducedMotion ? 'reduced motion' : 'motion'}`;
      test(`each recipe is drawn, fits and is legible: ${name}`, async () => {
        const tab = await browser.open('docs/recipes.html', { ...size, reducedMotion, scheme: theme });
        await tab.until('the buttons', () => document.querySelector('.example button'));
        assert.ok(RECIPES.length >= 8, `${RECIPES}`);
        for (const [at, recipe] of RECIPES.entries()) {
          await press(tab, at);
          await tab.until(
            `${recipe} is ready`,
            () => /** @type {any} */ (document.querySelector('hearth-fire'))?.stats,
          );
          await tab.ready();
          const plays = await tab.fire(({ stats }) => !stats.paused);
          assert.equal(plays, !reducedMotion, `${recipe} ${plays ? 'plays' : 'stands'}`);
          await tab.fire(
            async (fire, seconds) => {
              fire.pause();
              if (seconds > 0) await fire.advance(seconds);
              await fire.toBlob();
            },
            reducedMotion ? 0 : (COVERED[recipe] ?? 0.5),
          );
          const picture = await eventually(
            `${recipe} glows`,
            () => firePicture(tab),
            (seen) => recipe in COVERED || seen.glowing() > 0.002,
            () => tab.frames(3),
            (seen) => seen.glowing(),
          );
          assert.ok(picture.width > 100, recipe);
          const wide = await tab.evaluate(() => ({
            page: document.documentElement.scrollWidth - window.innerWidth,
            outside: [...document.querySelectorAll('.burning *')].filter((element) => {
              const place = element.closest('.burning')?.getBoundingClientRect();
              return place && element.getBoundingClientRect().right > place.right + 1;
            }).length,
          }));
          assert.deepEqual({ recipe, ...wide, page: Math.max(wide.page, 0) }, { recipe, page: 0, outside: 0 });
          const covered = recipe in COVERED && reducedMotion;
          for (const { text, large, contrast } of await words(tab)) {
            const least = large ? LARGE : SMALL;
            const legible = contrast >= least;
            assert.ok(
              legible || covered,
              `${recipe}: "${text}" has a contrast of ${contrast.toFixed(1)}, less than ${least}`,
            );
          }
          assert.deepEqual(tab.problems, [], recipe);
          await press(tab, at);
        }
      });
    }
  }
}

test('a click lights a fire at its point', async () => {
  const [, html] = DOC.match(/^## A fire at a point$[\s\S]*?```html\n([\s\S]*?)```/m) ?? [];
  const tab = await browser.open(html, { width: 600, height: 400, draws: false });
  await tab.ready();
  assert.equal(await tab.fire((fire) => fire.objects.length), 0);
  await tab.page.mouse.click(150, 100);
  await tab.until('a source', () => /** @type {any} */ (document.querySelector('hearth-fire')).objects.length === 1);
  const place = await tab.fire((fire) => fire.toPixels(fire.objects[0].x, fire.objects[0].y));
  assert.ok(Math.hypot(place.x - 150, place.y - 100) < 1, JSON.stringify(place));
  assert.deepEqual(tab.problems, []);
});
