/**
 * `fit` and `align` select the part of a fire's world in its picture. `toPixels` agrees
 * with CSS and with the picture.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from './driver.mjs';
import { events, recording } from './assertions.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

const FITS = ['height', 'contain', 'cover', 'width'];
/** Words, and shares from left and from above. @type {[string, number, number][]} */
const ALIGNS = [['', 0.5, 1], ['left top', 0, 0], ['center right', 1, 0.5]];

for (const [width, height] of [[400, 150], [150, 400]]) {
  test(`a fire of ${width} × ${height} pixels is where its fit and its alignment put it`, async () => {
    // Particles that stand still, in the middle of a domain of 1.2 m by 1.5 m.
    const tab = await browser.open(`<hearth-fire paused model="classic" display-mode="paper" source-width="0.05"
      source-height="0.7" emission-speed="0" particle-size="0.03" lifetime-min="3" lifetime-max="3"
      style="width: ${width}px; height: ${height}px"></hearth-fire>`);
    await tab.ready();
    await tab.fire((fire) => fire.step(8));
    for (const fit of FITS) {
      for (const [words, right, below] of ALIGNS) {
        const seen = await tab.fire(async (fire, how, where) => {
          fire.fit = how;
          fire.align = where;
          await fire.step(1);
          const { domain_width: across, domain_height: up } = fire.params;
          return [[-across / 2, up], [across / 2, 0], [0, 0.7]].map(([x, y]) => fire.toPixels(x, y));
        }, fit, words);
        await tab.frames(3);
        const [corner, other, source] = seen;
        const [wide, high] = [width / 1.2, height / 1.5];
        const scale = { height: high, width: wide, contain: Math.min(wide, high), cover: Math.max(wide, high) }[fit];
        const expected = [
          (width - 1.2 * scale) * right, (height - 1.5 * scale) * below, 1.2 * scale, 1.5 * scale,
        ];
        const found = [corner.x, corner.y, other.x - corner.x, other.y - corner.y];
        const what = `${fit} “${words}” of ${width} × ${height}`;
        for (const [at, number] of found.entries()) {
          assert.ok(Math.abs(number - expected[at]) < 0.1, `${what}: ${found}, not ${expected}`);
        }
        const picture = await tab.firePicture();
        const lit = (part) => Math.round((1 - part.dark()) * part.width * part.height);
        const reach = 0.08 * scale + 3;
        const share = (x, y) => [
          Math.max(0, Math.min(1, x / width)), Math.max(0, Math.min(1, y / height)),
        ];
        const [left, top] = share(source.x - reach, source.y - reach);
        const [end, bottom] = share(source.x + reach, source.y + reach);
        const inside = source.x > 4 && source.x < width - 4 && source.y > 4 && source.y < height - 4;
        if (end > left && bottom > top) {
          const around = lit(picture.part(left, top, end, bottom));
          assert.ok(!inside || around > 4, `${what}: ${around} pixels are lit around the source`);
          assert.equal(lit(picture), around, `${what}: nothing is lit elsewhere`);
        } else {
          assert.equal(lit(picture), 0, `${what}: the source is out of sight`);
        }
      }
    }
    assert.deepEqual(tab.problems, []);
  });
}

test('an invalid fit or alignment is rejected by name, and the picture does not change', async () => {
  const tab = await browser.open(recording('<hearth-fire paused fit="cover" align="top left"></hearth-fire>'));
  await tab.ready();
  const corner = () => tab.fire((fire) => fire.toMetres(0, 0));
  const before = await corner();
  await tab.fire((fire) => {
    fire.setAttribute('fit', 'fill');
    fire.setAttribute('align', 'left right');
  });
  const errors = await events(tab, 'error');
  assert.deepEqual(errors.map(({ kind, id }) => `${kind} ${id}`), ['bad-parameter fit', 'bad-parameter align']);
  assert.match(errors[0].message, /fill.*height, contain, cover, width/);
  assert.match(errors[1].message, /left right.*center/);
  assert.deepEqual(await corner(), before);
  const usual = await tab.fire((fire) => {
    fire.removeAttribute('fit');
    fire.removeAttribute('align');
    return [fire.fit, fire.align, fire.toMetres(120, 240)];
  });
  assert.deepEqual(usual, ['height', '', { x: 0, y: 0 }]);
});
