/**
 * The element and `hearth render` show the same picture of a fire.
 */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { after, before, test } from 'node:test';
import { compare } from '../../look/compare.mjs';
import { Browser } from '../driver.mjs';
import { Picture } from '../picture.mjs';

/** Scenes of both models, with solids that move, burn and stand before a wall. */
const SCENES = ['default', 'classic', 'fireside', 'burning-logs', 'house-of-cards', 'smoke-stack'];

/** Age of the fires [s], and moments a second at which the state between pictures advances. */
const AT = 0.5;
const RATE = 60;

/** Most that the pictures differ by, in hundredths of OkLab in the mean: nobody sees a difference of 2. */
const DIFFERENCE = 1;

const BLACK = [0, 0, 0];

/** Pixels of a picture, and of one that nobody sees. */
const PIXELS = { shown: 60_000, hidden: 1000 };

/** The element, of the height from which on each level has all its particles. */
const page = (/** @type {string} */ scene, /** @type {number} */ pixels) => `<hearth-fire preset="${scene}" paused
  quality="low" max-pixels="${pixels}" style="width: 420px; height: 560px"></hearth-fire>`;

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

for (const scene of SCENES) {
  test(`the element and the command show the same picture of ${scene}`, async () => {
    // The fine structure moves from picture to picture: both draw at the same moments.
    const counts = await (await opened(scene, PIXELS.hidden)).fire(stepsBetween, AT, RATE);
    const tab = await opened(scene, PIXELS.shown);
    const png = await tab.fire(drawn, counts);
    const shown = Picture.decode(Buffer.from(png, 'base64'), BLACK);
    const { colour, shift, structure } = compare(rendered(scene, shown), shown);
    const differences = `colours differ by ${colour.toFixed(2)}, all by ${shift.toFixed(2)}`;
    const found = `${differences}, structure agrees by ${structure.toFixed(3)}`;
    console.log(`   ${scene}: ${found}`);
    assert.ok(shown.glowing() > 0.005);
    assert.ok(colour <= DIFFERENCE && structure > 0.98, found);
    assert.deepEqual(await tab.problemsAfterFrame(), []);
  });
}

/** @param {string} scene @param {number} pixels */
async function opened(scene, pixels) {
  const tab = await browser.open(page(scene, pixels), { width: 480, height: 600 });
  await tab.ready();
  return tab;
}

/** The number of steps to each moment. Runs in the page. @param {any} fire @param {number} at @param {number} rate */
async function stepsBetween(fire, at, rate) {
  const counts = [];
  for (let moment = 1; moment <= at * rate; moment += 1) {
    let count = 0;
    for (; (fire.stats?.time ?? 0) < moment / rate; count += 1) await fire.step();
    counts.push(count);
  }
  return counts;
}

/** The picture after so many steps, as PNG in base 64. Runs in the page. @param {any} fire @param {number[]} counts */
async function drawn(fire, counts) {
  for (const count of counts) await fire.step(count);
  let text = '';
  for (const byte of new Uint8Array(await (await fire.toBlob()).arrayBuffer())) text += String.fromCharCode(byte);
  return btoa(text);
}

/** The picture of the command, of the same size. @param {string} scene @param {Picture} size */
function rendered(scene, { width, height }) {
  const program = process.env.HEARTH_COMMAND;
  if (!program) throw new Error('HEARTH_COMMAND names no program: `cargo xtask test e2e` builds it');
  const options = ['--at', String(AT), '--size', `${width}x${height}`, '--quality', 'low', '--out', '-'];
  return Picture.decode(execFileSync(program, ['render', scene, ...options]), BLACK);
}
