/**
 * Quality levels reach the fire and are reported, as are the times of stages and passes. How a level is chosen is tested
 * in `crates/hearth-engine/tests/engine/pacing`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { onPageThread, simulateClock } from '../clock.mjs';
import { assertBurns, events, recording } from '../assertions.mjs';
import { Panel, along } from '../panel.mjs';
import { table } from '../site.mjs';

const { DEFAULTS } = await table();

/** Particles of each quality, in the combustion model. */
const PARTICLES = { low: 1500, medium: 3000, high: 6700 };

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

const small = { width: 260, height: 260 };

/** Waits until the fire has about so many particles, and reports this quality. */
function settles(tab, quality, particles = PARTICLES[quality]) {
  return tab.until(
    `${quality}, ${particles} particles`,
    (name, count) => {
      const { stats } = /** @type {any} */ (document.querySelector('hearth-fire'));
      // The number fills the frame. Open air fills less at first, and in a wide view up to twice as many.
      return stats?.quality === name && stats.particles > 0.5 * count && stats.particles <= 2 * count;
    },
    quality,
    particles,
  );
}

test('a burning fire changes its quality and burns on', async () => {
  const tab = await browser.show(recording('<hearth-fire quality="medium"></hearth-fire>'), small);
  await tab.burnt(1);
  const time = await tab.fire((fire) => fire.stats.time);
  for (const [quality, change] of [
    ['low', (fire) => fire.setAttribute('quality', 'low')],
    [
      'medium',
      (fire) => {
        fire.quality = 'medium';
      },
    ],
  ]) {
    await tab.fire(change);
    await settles(tab, quality);
    assert.equal(await tab.fire((fire) => fire.quality), quality);
  }
  await tab.burnt(time + 0.5);
  await assertBurns(tab);
  const reported = (await events(tab, 'quality-change')).map(({ quality }) => quality);
  assert.deepEqual(reported, ['low', 'medium']);
  assert.deepEqual(await events(tab, 'params-change'), []);
  assert.deepEqual(tab.problems, []);
});

/** Sets the number of processor cores that a page reads, from which it chooses low or medium. */
const eightCores = () => Object.defineProperty(navigator, 'hardwareConcurrency', { value: 8 });

test('with quality auto, a fire that does not fit its frames gets a lower quality and reports why', async () => {
  const tab = await browser.open(
    // On a machine that does not begin with the lowest quality.
    `<script>(${eightCores})()</script>${onPageThread(
      recording('<hearth-fire max-pixels="10000" style="width: 1600px; height: 1200px"></hearth-fire>'),
    )}`,
    { width: 400, height: 300, before: simulateClock },
  );
  await tab.ready();
  await tab.evaluate(() => {
    /** @type {any} */ (window).clock.cost = 5;
  });
  await tab.until(
    'it is of low quality',
    () => /** @type {any} */ (document.querySelector('hearth-fire')).stats?.quality === 'low',
  );
  const { requested, reason, params } = await tab.fire((fire) => ({
    requested: fire.quality,
    reason: fire.stats.qualityReason,
    params: fire.params,
  }));
  assert.equal(requested, 'auto');
  assert.match(reason, /\d ms .*1,500 particles instead of [36],\d00$/);
  assert.deepEqual(params, DEFAULTS);
});

/** The passes from light to the picture. */
const LIGHT_TO_PICTURE = ['bloom_downsample', 'bloom_upsample', 'smoke_light', 'tone_map', 'composite'];

test('the stages of a step add up, and every pass is reported', async () => {
  for (const [model, passes] of [
    ['combustion', ['slices', 'ember', ...LIGHT_TO_PICTURE]],
    ['classic', ['splat', 'spread', 'shade', ...LIGHT_TO_PICTURE]],
  ]) {
    const tab = await browser.show(`<hearth-fire quality="low" model="${model}"></hearth-fire>`, small);
    await tab.plays(0.5);
    const areTimed = () => {
      const { passes } = /** @type {any} */ (document.querySelector('hearth-fire')).stats;
      return Object.values(passes).every((time) => time > 0);
    };
    await tab.until('every pass has a time', areTimed);
    const stats = await tab.fire((fire) => fire.stats);
    const { upload, ...stages } = stats.stages;
    assert.deepEqual(Object.keys(stages), ['sort', 'density', 'forces', 'integrate']);
    const sum = Object.values(stages).reduce((all, stage) => all + stage, 0);
    const steps = stats.stepMs * stats.stepsPerFrame;
    assert.ok(sum > 0 && Math.abs(sum / steps - 1) < 1e-6, `${sum} ms of stages, ${steps} ms of steps`);
    assert.ok(upload >= 0 && upload <= stats.drawMs + 0.1, `${upload} ms of ${stats.drawMs}`);
    assert.deepEqual(Object.keys(stats.passes), passes);
    assert.ok(['gpu', 'submit'].includes(stats.passTimer));
    assert.deepEqual(tab.problems, []);
  }
});

test('the panel and its accessible controls set the quality, and show a quality that is set elsewhere', async () => {
  const tab = await browser.open('index.html?scene=default&quality=medium', { width: 760, height: 600 });
  await tab.burnt(0.1);
  const panel = await new Panel(tab).mounted();
  const control = '[data-action="quality"]';
  const shown = () => tab.page.$eval(control, (element) => /** @type {any} */ (element).value);
  await tab.until(
    'the accessible control shows it',
    (selector) => /** @type {any} */ (document.querySelector(selector)).value === 'medium',
    control,
  );
  await panel.pointAt(control);
  await tab.click(along(await panel.rectangleOf('quality:low'), 0.5));
  await settles(tab, 'low');
  assert.equal(await shown(), 'low');
  await tab.page.select(control, 'medium');
  await settles(tab, 'medium');
  // Unfolded, the header lists the times of the stages and shifts the rows below it.
  const before = await panel.rectangleOf('quality');
  await tab.click(along(await panel.rectangleOf('action:times'), 0.3));
  await tab.frames(6);
  const unfolded = await panel.rectangleOf('quality');
  assert.ok(unfolded.y > before.y + 30, 'the times are shown');
  assert.deepEqual(tab.problems, []);
});
