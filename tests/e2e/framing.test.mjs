/**
 * The framing of the landing page's fire in the narrowest and in the widest page. The
 * height of a fire fits its stage, so sizes between show the same picture; `node
 * framing.mjs` measures all sizes and more moments.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from './driver.mjs';
import { BARS, SIZES, measure } from './framing.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

for (const size of [SIZES[0], /** @type {[number, number]} */ (SIZES.at(-1))]) {
  test(`the fire of a page of ${size.join(' × ')} fills its stage`, async () => {
    const { linear: { height, base } } = await measure(browser, size);
    const [[low, high], [near, far]] = [BARS.height, BARS.base];
    assert.ok(height >= low && height <= high, `it is bright on ${height} of the stage's height`);
    assert.ok(base >= near && base <= far, `its base is ${base} of it above the lower edge`);
  });
}
