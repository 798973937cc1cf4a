/**
 * Takes the picture that a link to Hearth shows: a fire of this project, always
 * the same one, 1200 × 630. `cargo xtask poster` runs this and says where it
 * goes: `node poster.mjs file.jpg`.
 */
import { writeFileSync } from 'node:fs';
import { Browser } from './driver.mjs';
import { burnAnew } from './still.mjs';

const [file] = process.argv.slice(2);
if (file === undefined) throw new Error('usage: node poster.mjs file.jpg');

const WIDTH = 1200;
const HEIGHT = 630;

/** Most of the file [bytes]: some readers of links take no more time for it. */
const LARGEST = 60_000;

/** The fire: a broad one on strong fuel, with a few embers more. */
const FIRE = {
  domain_width: 2,
  domain_height: 1.6,
  source_width: 0.72,
  source_height: 0.16,
  source_oxygen: 0.75,
  fuel_power: 360,
  ember_rate: 110,
  max_particles: 16000,
  smoke_opacity: 0.15,
  exposure: 0.35,
  bloom: 0.2,
  seed: 12,
};

/** How many steps it has burnt. */
const STEPS = 3600;

// Higher than the picture, so that the flame is cut and the top of its world is not seen.
const PAGE = `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<link rel="icon" href="data:,">
<style>
  html { height: 100%; background: radial-gradient(ellipse 60% 80% at 50% 90%, #36190c, #180c08 50%, #0a0605) }
  body { margin: 0; overflow: hidden }
  hearth-fire { position: fixed; left: 0; right: 0; bottom: -62px; height: 990px }
</style>
<script type="module" src="/web/hearth-fire.js"></script>
<body><hearth-fire paused quality="high" max-pixels="4000000"></hearth-fire></body>
</html>`;

const browser = await Browser.launch();
try {
  const tab = await browser.open(PAGE, { width: WIDTH, height: HEIGHT });
  await tab.ready();
  await tab.fire((fire, values) => fire.set(values), FIRE);
  await burnAnew(tab, STEPS);
  if (tab.problems.length > 0) throw new Error(tab.problems.join('\n'));
  const glow = (await tab.picture()).part(0.35, 0.2, 0.65, 0.9).glowing();
  if (glow < 0.3) throw new Error(`only ${glow} of the picture's middle glows`);
  const jpeg = await tab.page.screenshot({ type: 'jpeg', quality: 88 });
  if (jpeg.length > LARGEST) throw new Error(`the picture takes ${jpeg.length} bytes, more than ${LARGEST}`);
  writeFileSync(file, jpeg);
  console.log(`${file}: ${WIDTH} × ${HEIGHT}, ${(jpeg.length / 1000).toFixed(1)} KB`);
} finally {
  await browser.close();
}
