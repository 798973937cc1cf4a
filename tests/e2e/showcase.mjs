/**
 * Takes the pictures that show in documentation what Hearth draws. `cargo xtask showcase`
 * runs this: `node showcase.mjs frames-folder frames-a-second [sheet.jpg picture.png…]`.
 *
 * Into the folder go the frames of an animation; into the sheet six moments of the
 * default fire, above what other systems draw, each at the size of its picture.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { Browser } from './driver.mjs';

const [folder, rate, sheet, ...others] = process.argv.slice(2);
if (!(Number(rate) > 0)) throw new Error('usage: node showcase.mjs frames-folder frames-a-second [sheet.jpg picture.png…]');

/** Of the animation: how long it is [s], and its size. */
const SECONDS = 5;
const ANIMATED = { width: 480, height: 480 };

/** Of the sheet: how many moments, how far apart they are [s], and the size of one. */
const MOMENTS = 6;
const APART = 0.7;
const STILL = { width: 240, height: 420 };

/** When it is first shown [s]: it burns as it always will. */
const BURNT = 4;

const page = ({ width, height }) => `<!doctype html>
<html lang="en">
<link rel="icon" href="data:,">
<style>body { margin: 0; background: #000; overflow: hidden } hearth-fire { width: ${width}px; height: ${height}px }</style>
<script type="module" src="/web/hearth-fire.js"></script>
<body><hearth-fire paused quality="high" max-particles="6700"></hearth-fire></body>
</html>`;

/** Pictures of a fire of these values, `apart` seconds one from the other. */
async function moments(browser, size, values, count, apart) {
  const tab = await browser.open(page(size), size);
  await tab.ready();
  await tab.fire((fire, set) => fire.set(set), values);
  const pictures = [];
  for (let at = 0; at < count; at += 1) {
    await tab.fire(async (fire, time) => {
      // In pieces that are drawn: the gas carries the fine structure from picture to picture.
      while ((fire.stats?.time ?? 0) < time) await fire.step(time - (fire.stats?.time ?? 0) > 0.5 ? 60 : 4);
    }, BURNT + at * apart);
    await tab.frames(3);
    pictures.push(await tab.page.screenshot());
  }
  if (tab.problems.length > 0) throw new Error(tab.problems.join('\n'));
  return pictures;
}

const source = (picture) => `data:image/png;base64,${Buffer.from(picture).toString('base64')}`;

const browser = await Browser.launch();
try {
  const frames = await moments(browser, ANIMATED, { backdrop: 'bricks', heat_haze: 0.5 }, SECONDS * rate, 1 / rate);
  frames.forEach((frame, at) => writeFileSync(join(folder, `${String(at).padStart(3, '0')}.png`), frame));

  if (sheet !== undefined) {
    const ours = await moments(browser, STILL, {}, MOMENTS, APART);
    const width = MOMENTS * STILL.width;
    const row = (name, pictures) => `<h1>${name}</h1><p>${pictures.map((one) => `<img src="${source(one)}">`).join('')}</p>`;
    const tab = await browser.open(`<!doctype html>
<html lang="en">
<link rel="icon" href="data:,">
<style>
  body { margin: 0; width: ${width}px; background: #000; color: #ccc; font: 16px sans-serif }
  h1 { margin: 0; padding: 8px 12px; font: inherit; background: #222 }
  p { margin: 0; display: flex; justify-content: center }
</style>
${row('Hearth: six moments of the default fire', ours)}
${others.map((file) => row(basename(file), [readFileSync(file)])).join('')}`, { width, height: 600 });
    await tab.page.evaluate(() => Promise.all([...document.images].map((image) => image.decode())));
    writeFileSync(sheet, await tab.page.screenshot({ type: 'jpeg', quality: 85, fullPage: true }));
  }
} finally {
  await browser.close();
}
