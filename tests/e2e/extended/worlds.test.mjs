/**
 * The examples in three.js, PixiJS, Phaser, Babylon.js and PlayCanvas burn in the built site, under its policy, on a desktop
 * and a phone. What a fire does in those engines is tested with the package, in `tests/consumers`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser, eventually } from '../driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

for (const [page, name] of [
  ['campsite', 'camp'],
  ['brazier', 'game'],
  ['torch', 'game'],
  ['pillars', 'game'],
  ['wisp', 'game'],
]) {
  for (const screen of [
    { width: 480, height: 320 },
    { width: 240, height: 480, touch: true },
  ]) {
    test(`${page}, ${screen.width} pixels wide`, async () => {
      const tab = await browser.open(`examples/worlds/${page}.html`, screen);
      await tab.until(
        'its fire burns',
        (of) => {
          const made = /** @type {any} */ (globalThis)[of];
          const fire = made?.fire ?? made?.scene?.scenes[0]?.fire;
          return fire?.fire.stats.time > 0 && fire.light.intensity > 0;
        },
        name,
      );
      // The flame of the wisp is pale blue.
      const isPale = (/** @type {number} */ red, /** @type {number} */ _, /** @type {number} */ blue) =>
        blue > 120 && blue >= red;
      await eventually(
        'it is on the screen',
        () => tab.picture(),
        (picture) => (page === 'wisp' ? picture.share(isPale) : picture.glowing()) > 0.001,
        () => tab.frames(3),
      );
      assert.deepEqual(await tab.problemsAfterFrame(), []);
    });
  }
}
