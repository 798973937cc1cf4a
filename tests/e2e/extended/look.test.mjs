/**
 * The same fire gives the same picture on screens with more pixels and after a lost
 * context.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { compare } from '../../look/compare.mjs';
import { Browser } from '../driver.mjs';
import { Picture } from '../picture.mjs';

/** A fire that stands still once it has burnt: the markup sets everything that a
    device may decide. Fine structure varies with the number of pictures, which depends on the browser. */
const still = (/** @type {string} */ model, detail = 0) => `<hearth-fire paused quality="medium"
  model="${model}" ${model === 'classic' ? 'max-particles' : 'particles'}="1000" seed="3" max-pixels="4000000" detail="${detail}"
  style="width: 240px; height: 300px"></hearth-fire>`;

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

/** Opens a fire and lets it burn. @param {string} page @param {object} [options] */
async function burnt(page, options) {
  const tab = await browser.open(page, { width: 320, height: 400, ...options });
  await tab.ready();
  await tab.fire((fire) => fire.step(300));
  await tab.frames(4);
  return tab;
}

for (const model of ['combustion', 'classic']) {
  test(`a ${model} fire is the same on screens of one, two and three pixels`, async () => {
    const pictures = [];
    for (const ratio of [1, 2, 3]) {
      const tab = await burnt(still(model), { ratio });
      const picture = await tab.firePicture();
      assert.equal(picture.width, 240 * ratio);
      pictures.push(shrunk(picture, ratio));
      assert.deepEqual(await tab.problemsAfterFrame(), []);
    }
    const [first, ...others] = pictures;
    assert.ok(first.glowing() > 0.02);
    for (const other of others) {
      const { colour, shift, structure } = compare(other, first);
      assert.ok(
        colour < 2 && shift < 1 && structure > 0.98,
        `colours differ by ${colour}, all by ${shift}, structure agrees by ${structure}`,
      );
    }
  });

  for (const lit of ['in steps', 'in pictures']) {
    test(`a ${model} fire that burnt ${lit} and is paused survives a lost context`, async () => {
      const tab = await burnt(still(model, 1));
      if (lit === 'in pictures') {
        await tab.fire((fire) => fire.play());
        await tab.burnt(2);
        await tab.fire((fire) => fire.pause());
        await tab.frames(4);
      }
      const first = await redrawn(tab);
      await tab.loseContext(300);
      await tab.until('the context is back', async () => (await /** @type {any} */ (window).driver.contexts()) > 0);
      const { shift, structure } = compare(await redrawn(tab), first);
      assert.ok(first.glowing() > 0.02);
      assert.ok(shift < 0.1 && structure > 0.999, `colours differ by ${shift}, structure agrees by ${structure}`);
    });
  }
}

/**
 * A new picture of a paused fire. Another exposure shows that the screen has reached it: the engine may draw many
 * pictures after the frames of the page.
 * @param {import('../driver.mjs').Tab} tab
 */
async function redrawn(tab) {
  const before = await tab.firePicture();
  await tab.fire((fire) => fire.set('exposure', 2));
  const bright = await tab.pictureUntil('the fire is brighter', (picture) => compare(picture, before).shift > 2);
  await tab.fire((fire) => fire.set('exposure', 0));
  return tab.pictureUntil('the fire is as dark as before', (picture) => compare(picture, bright).shift > 2);
}

/** A picture with the means of so many pixels each way. @param {Picture} picture @param {number} by */
function shrunk({ width, height, rgb }, by) {
  const [columns, rows] = [width / by, height / by].map(Math.floor);
  const small = new Uint8Array(columns * rows * 3);
  for (let at = 0; at < small.length; at += 1) {
    const [channel, x, y] = [at % 3, Math.floor(at / 3) % columns, Math.floor(at / 3 / columns)];
    let sum = 0;
    for (let dy = 0; dy < by; dy += 1) {
      for (let dx = 0; dx < by; dx += 1) sum += rgb[((y * by + dy) * width + x * by + dx) * 3 + channel];
    }
    small[at] = Math.round(sum / by / by);
  }
  return new Picture(columns, rows, small);
}
