/**
 * Takes the picture that a link to Hearth shows, and the page until its fire burns: the
 * scene that the page opens with, always the same moment, 1200 × 630. `cargo xtask poster`
 * runs this with the path of the picture: `node poster.mjs file.jpg`.
 */
import { writeFileSync } from 'node:fs';
import { Browser } from './driver.mjs';
import { markOf, marked } from './scene-mark.mjs';
import { landingScene } from './site.mjs';
import { burnSteps } from './still.mjs';

const [file] = process.argv.slice(2);
if (file === undefined) throw new Error('usage: node poster.mjs file.jpg');

const WIDTH = 1200;
const HEIGHT = 630;

/** Most of the file [bytes]: some readers of links take no more time for it. */
const LARGEST = 60_000;

/** The qualities of a JPEG that are tried for it. */
const QUALITIES = [88, 84, 80, 75, 70];

/** How many steps the fire has burnt. */
const STEPS = 3000;

const scene = await landingScene();

const PAGE = `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<link rel="icon" href="data:,">
<style>
  body { margin: 0; background: #000; overflow: hidden }
  hearth-fire { display: block; width: ${WIDTH}px; height: ${HEIGHT}px }
</style>
<script type="module" src="/web/hearth-fire.js"></script>
<body><hearth-fire preset="${scene}" paused quality="high" max-pixels="4000000"></hearth-fire></body>
</html>`;

const browser = await Browser.launch();
try {
  const tab = await browser.open(PAGE, { width: WIDTH, height: HEIGHT });
  await tab.ready();
  await burnSteps(tab, STEPS);
  if (tab.problems.length > 0) throw new Error(tab.problems.join('\n'));
  const glow = (await tab.picture()).crop(0.35, 0.2, 0.65, 0.9).glowing();
  if (glow < 0.1) throw new Error(`only ${glow} of the picture's middle glows`);
  let taken = false;
  for (const quality of QUALITIES) {
    const jpeg = marked(await tab.page.screenshot({ type: 'jpeg', quality }), await markOf(scene));
    if (jpeg.length > LARGEST) continue;
    writeFileSync(file, jpeg);
    console.log(`${file}: ${scene}, ${WIDTH} × ${HEIGHT}, ${(jpeg.length / 1000).toFixed(1)} KB`);
    taken = true;
    break;
  }
  if (!taken) throw new Error(`the picture takes more than ${LARGEST} bytes`);
} finally {
  await browser.close();
}
