/**
 * Takes the pictures of the recipes into docs/recipes, of the built site in Chromium: `node tests/look/recipes.mjs`, or with
 * names for some. Each shows the example of the document that names the picture above it, at the level `high`.
 */
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { Browser } from '../e2e/driver.mjs';
import { Picture } from '../e2e/picture.mjs';

const DOCS = new URL('../../docs/', import.meta.url);
/** Most of a file [bytes], and the qualities that are tried for it. */
const LARGEST = 40_000;
const QUALITIES = [82, 75, 68, 60];
/** The window, which is as high as the example. */
const WIDTH = 640;
/** When the fire of a picture is shown [s]. */
const BURNT = 4;
/** Those that differ: another time or width, and where a visitor clicks first. */
const OTHERS = /** @type {{[name: string]: {burnt?: number, width?: number, clicks?: number[][]}}} */ ({
  card: { width: 280 },
  reveal: { width: 480, burnt: 8 },
  burst: { burnt: 0.3, clicks: [[30, 392]] },
  amount: { burnt: 9 },
  point: {
    clicks: [
      [180, 300],
      [340, 200],
      [500, 330],
    ],
  },
});

const wanted = process.argv.slice(2);
const text = readFileSync(new URL('recipes.md', DOCS), 'utf8');
const recipes = text.matchAll(/\]\(recipes\/(\w+)\.jpg\)[\s\S]*?```html[^\n]*\n([\s\S]*?)```/g);
mkdirSync(new URL('recipes', DOCS), { recursive: true });
const browser = await Browser.launch();
try {
  for (const [, name, html] of recipes) {
    if (wanted.length > 0 && !wanted.includes(name)) continue;
    const { burnt = BURNT, width = WIDTH, clicks = [] } = OTHERS[name] ?? {};
    const tab = await browser.open(html, { width, height: 420 });
    await tab.ready();
    await tab.evaluate(() => {
      Object.assign(document.body.style, { margin: '0', width: 'max-content', minWidth: '100%' });
    });
    for (const [x, y] of clicks) await tab.page.mouse.click(x, y);
    await tab.fire((fire) => Object.assign(fire, { quality: 'high' }).pause());
    await tab.fire((fire, seconds) => fire.advance(seconds), burnt);
    await tab.fire((fire) => fire.toBlob().then(() => undefined));
    await tab.frames(5);
    const height = await tab.evaluate(() => Math.min(420, document.body.scrollHeight || 420));
    const shown = Picture.decode(await tab.page.screenshot({ clip: { x: 0, y: 0, width, height } }));
    const input = Buffer.concat([Buffer.from(`P6 ${shown.width} ${shown.height} 255\n`), shown.rgb]);
    const sizes = QUALITIES.map((quality) =>
      execFileSync(process.env.HEARTH_CJPEG ?? 'cjpeg', ['-quality', `${quality}`, '-optimize', '-progressive'], {
        input,
      }),
    );
    const jpeg = sizes.find(({ length }) => length <= LARGEST);
    if (!jpeg) throw new Error(`${name}: the picture takes more than ${LARGEST} bytes`);
    writeFileSync(new URL(`recipes/${name}.jpg`, DOCS), jpeg);
    console.log(`${name}.jpg: ${shown.width} × ${shown.height}, ${(jpeg.length / 1000).toFixed(1)} KB`);
  }
} finally {
  await browser.close();
}
