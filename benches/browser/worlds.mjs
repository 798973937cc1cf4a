/**
 * Measures fires in three.js beside the element, in turn: pictures and frames a second, what a frame takes of the page's
 * thread, and what a picture takes of the processor that draws.
 *
 * `node benches/browser/worlds.mjs` measures the package of `dist/npm`, with the packages of the examples; words behind it
 * choose cases.
 */
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { installed } from '../../tests/consumers/package.mjs';
import { Browser } from '../../tests/e2e/driver.mjs';

const ROUNDS = Number(process.env.HEARTH_ROUNDS ?? 3);
/** How long a fire burns up, and is measured [ms]. */
const BURN_UP = 5000;
const MEASURED = 8000;

const IMPORTS = {
  three: './node_modules/three/build/three.module.js',
  'hearth-fire': './node_modules/hearth-fire/hearth-fire.js',
  'hearth-fire/three': './node_modules/hearth-fire/three.js',
};

const page = (/** @type {string} */ script) => `<!doctype html>
<link rel="icon" href="data:,">
<script type="importmap">${JSON.stringify({ imports: IMPORTS })}</script>
<body style="margin: 0; background: black">
<script>
  window.counted = 0;
  requestAnimationFrame(function count() {
    window.counted += 1;
    requestAnimationFrame(count);
  });
</script>
<script type="module">${script}</script>`;

const ELEMENT = `
  const draw = ImageBitmapRenderingContext.prototype.transferFromImageBitmap;
  let pictures = 0;
  ImageBitmapRenderingContext.prototype.transferFromImageBitmap = function (picture) {
    pictures += 1;
    return draw.call(this, picture);
  };
  await import('hearth-fire');
  document.body.insertAdjacentHTML('beforeend',
    '<hearth-fire quality="low" loading="eager" style="display: block; width: 512px; height: 512px"></hearth-fire>');
  const fire = document.querySelector('hearth-fire');
  window.seen = () => ({ pictures, time: fire.stats?.time ?? 0 });`;

/** A scene of 512² pixels. @param {number} count of fires @param {number} side of their pictures @param {boolean} [onPicture] */
const scene = (count, side, onPicture = false) => `
  import * as THREE from 'three';
  import { FireObject } from 'hearth-fire/three';
  const renderer = new THREE.WebGLRenderer();
  renderer.setSize(512, 512);
  document.body.append(renderer.domElement);
  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 20);
  camera.position.set(0, 0.75, 2.1);
  let pictures = 0;
  const draw = () => renderer.render(scene, camera);
  const fires = Array.from({ length: ${count} }, (_, i) => {
    const fire = new FireObject({ quality: 'low', width: ${side}, height: ${side} });
    fire.position.x = 0.5 * (i - ${(count - 1) / 2});
    fire.addEventListener('picture', () => (pictures += 1));
    if (${onPicture}) fire.addEventListener('picture', draw);
    scene.add(fire);
    return fire;
  });
  if (!${onPicture}) renderer.setAnimationLoop(draw);
  window.seen = () => ({ pictures, time: fires[0] ? (fires[0].fire.stats.time ?? 0) : 1 });`;

/** Pages, and whether the processor draws: otherwise drawing is left out, as a graphics card would take it. @type {[string, string, boolean][]} */
const CASES = [
  ['element', ELEMENT, true],
  ['a fire in a scene that is drawn each frame', scene(1, 512), true],
  ['a fire in a scene that is drawn for each picture', scene(1, 512, true), true],
  ['three fires of 256², without drawing', scene(3, 256), false],
  ['a scene without a fire, without drawing', scene(0, 512), false],
];

const root = await installed('worlds', 'archive', fileURLToPath(new URL('../../examples/worlds', import.meta.url)));
const browser = await Browser.launch(root);
const session = await /** @type {any} */ (browser.engine).browser.target().createCDPSession();
const words = process.argv.slice(2);
const chosen = CASES.filter(([name]) => words.every((word) => name.includes(word)));
/** Figures of each case, a row for each round. @type {Map<string, number[][]>} */
const rounds = new Map(chosen.map(([name]) => [name, []]));
try {
  for (let round = 0; round < ROUNDS; round += 1)
    for (const [name, script, draws] of chosen) rounds.get(name)?.push(await measured(script, draws));
} finally {
  await browser.close();
}
console.log('medians: pictures/s, frames/s, page thread [ms/frame], drawing [ms/picture]');
for (const [name, rows] of rounds) {
  const medians = rows[0].map((_, at) => rows.map((row) => row[at]).sort((a, b) => a - b)[rows.length >> 1]);
  console.log(`${name}: ${medians.map((value) => value.toFixed(1)).join(', ')}`);
}

/** @param {string} script @param {boolean} draws */
async function measured(script, draws) {
  const tab = await browser.open(page(script), { width: 512, height: 512, draws });
  await tab.until('the fire burns', () => /** @type {any} */ (window).seen?.().time > 0);
  await sleep(BURN_UP);
  const look = async () => {
    const { TaskDuration, Timestamp } = await tab.page.metrics();
    const { processInfo } = await session.send('SystemInfo.getProcessInfo');
    const gpu = processInfo.find((/** @type {any} */ { type }) => type === 'GPU')?.cpuTime ?? 0;
    const [pictures, frames] = await tab.page.evaluate(() => {
      const { seen, counted } = /** @type {any} */ (window);
      return [seen().pictures, counted];
    });
    return { busy: TaskDuration ?? 0, now: Timestamp ?? 0, gpu, pictures, frames };
  };
  const from = await look();
  await sleep(MEASURED);
  const to = await look();
  const passed = (/** @type {keyof typeof from} */ what) => to[what] - from[what];
  await tab.page.goto('about:blank');
  const [seconds, pictures, frames] = [passed('now'), passed('pictures'), passed('frames')];
  return [
    pictures / seconds,
    frames / seconds,
    (1000 * passed('busy')) / frames,
    (1000 * passed('gpu')) / Math.max(pictures, 1),
  ];
}
