/**
 * Takes the small picture of each scene, 120 × 160, always the same ones.
 * `cargo xtask thumbnails` runs this with their folder:
 * `node thumbnails.mjs folder [scene…]`; without a name, all of them.
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { WHOLE } from '../../web/pages/framing.js';
import { Browser } from './driver.mjs';
import { markOf, marked } from './scene-mark.mjs';
import { table } from './site.mjs';
import { burnSteps } from './still.mjs';

const [folder, ...names] = process.argv.slice(2);
if (folder === undefined) throw new Error('usage: node thumbnails.mjs folder [scene…]');

const WIDTH = 120;
const HEIGHT = 160;
/** Drawn so many times as large: a flame's edge is finer than a pixel. */
const FINER = 2;

/** Most of a file [bytes], and the qualities that are tried for it. */
const LARGEST = 6000;
const QUALITIES = [0.9, 0.85, 0.8, 0.7, 0.6];

/** How many steps each model has burnt: some three seconds. */
const STEPS = { combustion: 1800, classic: 600 };

const PAGE = `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<link rel="icon" href="data:,">
<style>
  html { background: #0c0a09 }
  body { margin: 0; overflow: hidden }
  hearth-fire { display: block; width: ${WIDTH * FINER}px; height: ${HEIGHT * FINER}px }
</style>
<script type="module" src="/web/hearth-fire.js"></script>
<body><hearth-fire paused quality="medium"></hearth-fire></body>
</html>`;

const { PRESETS } = await table();
const wanted = PRESETS.filter(({ name }) => names.length === 0 || names.includes(name));
for (const name of names) {
  if (!wanted.some((preset) => preset.name === name)) throw new Error(`there is no scene "${name}"`);
}

mkdirSync(folder, { recursive: true });
const browser = await Browser.launch();
try {
  for (const { name } of wanted) {
    const jpeg = await taken(name);
    const file = path.join(folder, `${name}.jpg`);
    writeFileSync(file, jpeg);
    console.log(`${file}: ${(jpeg.length / 1000).toFixed(1)} KB`);
  }
} finally {
  await browser.close();
}

/** @param {string} name of a scene */
async function taken(name) {
  const tab = await browser.open(PAGE, { width: WIDTH * FINER, height: HEIGHT * FINER });
  await tab.ready();
  const model = await tab.fire(
    async (fire, preset, whole) => {
      if (whole) fire.fit = 'contain';
      await fire.importConfig({ preset });
      return fire.params.model;
    },
    name,
    WHOLE.includes(name),
  );
  await burnSteps(tab, STEPS[model]);
  const seen = await tab.page.screenshot({ encoding: 'base64' });
  for (const quality of QUALITIES) {
    const jpeg = marked(
      Buffer.from(await tab.evaluate(shrunk, seen, WIDTH, HEIGHT, quality), 'base64'),
      await markOf(name),
    );
    if (tab.problems.length > 0) throw new Error(tab.problems.join('\n'));
    if (jpeg.length <= LARGEST) return jpeg;
  }
  throw new Error(`${name}: the picture takes more than ${LARGEST} bytes`);
}

/**
 * A PNG, smaller and as JPEG, both in base 64.
 * @param {string} png @param {number} width @param {number} height @param {number} quality
 */
async function shrunk(png, width, height, quality) {
  const bytes = Uint8Array.from(atob(png), (letter) => letter.charCodeAt(0));
  const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.imageSmoothingQuality = 'high';
  context.drawImage(image, 0, 0, width, height);
  return canvas.toDataURL('image/jpeg', quality).split(',')[1] ?? '';
}
