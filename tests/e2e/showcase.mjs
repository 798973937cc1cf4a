/**
 * Takes the animation that shows in documentation what Hearth draws. `cargo xtask showcase`
 * runs this: `node showcase.mjs frames-folder frames-a-second`. Into the folder go the frames:
 * five seconds of the scene that the page opens with.
 */
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { Browser } from './driver.mjs';
import { landingScene } from './site.mjs';

const [folder, rate] = process.argv.slice(2);
if (!(Number(rate) > 0)) throw new Error('usage: node showcase.mjs frames-folder frames-a-second');

/** How long the animation is [s], and its size. */
const SECONDS = 5;
const SIZE = { width: 480, height: 480 };

/** When the fire is first shown [s]: it burns as it always will. */
const BURNT = 4;

const PAGE = `<!doctype html>
<html lang="en">
<link rel="icon" href="data:,">
<style>body { margin: 0; background: #000; overflow: hidden } hearth-fire { width: ${SIZE.width}px; height: ${SIZE.height}px }</style>
<script type="module" src="/web/hearth-fire.js"></script>
<body><hearth-fire preset="${await landingScene()}" paused quality="high" max-particles="6700"></hearth-fire></body>
</html>`;

const browser = await Browser.launch();
try {
  const tab = await browser.open(PAGE, SIZE);
  await tab.ready();
  for (let at = 0; at < SECONDS * Number(rate); at += 1) {
    await tab.fire(
      async (fire, time) => {
        // In pieces that are drawn: the gas carries the fine structure from picture to picture.
        while ((fire.stats?.time ?? 0) < time) await fire.step(time - (fire.stats?.time ?? 0) > 0.5 ? 60 : 4);
      },
      BURNT + at / Number(rate),
    );
    await tab.frames(3);
    writeFileSync(join(folder, `${String(at).padStart(3, '0')}.png`), await tab.page.screenshot());
  }
  if (tab.problems.length > 0) throw new Error(tab.problems.join('\n'));
} finally {
  await browser.close();
}
